# Shared by the scripts of this project, which read it with `source`: packages, configuring, building.
# shellcheck shell=bash
set -euo pipefail

project_dir=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
cd -- "$project_dir"

say() { printf '%s\n' "$*"; }
fail() { printf '%s\n' "$*" >&2; exit 1; }

# quietly NAME COMMAND...: the output goes to build/NAME.log and is shown only if the command fails.
quietly() {
  local log="build/$1.log"
  shift
  mkdir -p build
  "$@" >"$log" 2>&1 </dev/null || { cat -- "$log" >&2; fail "This command failed, its output is above: $*"; }
}

# Fills the array `missing` with the packages that packages.txt names and that are neither installed nor provided by an
# installed one: Node.js from another source than Debian brings its own npm.
find_missing_packages() {
  local native package architecture status provided rest
  declare -A is_there=()
  native=$(dpkg --print-architecture)
  while read -r package architecture status provided; do
    [[ $status == installed && ($architecture == "$native" || $architecture == all) ]] || continue
    is_there[$package]=yes
    for package in ${provided//,/ }; do  # names, some with a version: perl-base, libnet-perl (= 1:3.13)
      [[ $package == *[\(\)]* ]] || is_there[$package]=yes
    done
  done < <(dpkg-query --show --showformat '${Package} ${Architecture} ${db:Status-Status} ${Provides}\n')
  missing=()
  while read -r package rest; do
    [[ -z $package || $package == '#'* || -n ${is_there[$package]:-} ]] || missing+=("$package")
  done <packages.txt
}

# Fills the array `as_root` with what a command needs before it to run as root; fails where nothing would do.
find_way_to_root() {
  as_root=()
  ((EUID != 0)) || return 0
  command -v sudo >/dev/null || return 1
  as_root=(sudo)
  # sudo may ask for a password only where somebody can type one
  sudo -n true 2>/dev/null || { [[ -t 0 ]] && sudo -v; }
}

# Installs what packages.txt names and is missing; asks for nothing when all is in place.
install_packages() {
  local missing as_root root_shell='su - -c'
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    fail "This script installs packages with apt, as on Debian 12. CONTRIBUTING.md says how to build without it."
  find_missing_packages
  ((${#missing[@]})) || return 0

  if ! find_way_to_root; then
    ((${#as_root[@]})) && root_shell='sudo sh -c'
    fail "Some packages are missing, and only root may install them. Run this command once, then this script again:

  $root_shell 'apt-get update && apt-get install -y --no-install-recommends ${missing[*]}'
"
  fi
  say "Installing these Debian packages, which takes a few minutes: ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
  quietly apt-get-update "${apt[@]}" update
  quietly apt-get-install "${apt[@]}" install --no-install-recommends "${missing[@]}"
}

# configure PRESET: prepares build/PRESET, afresh where that was made for a checkout at another place.
configure() {
  local preset=$1 fresh=()
  local cache="build/$preset/CMakeCache.txt"
  if [[ -e $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$project_dir" "$cache"; then
    fresh=(--fresh)
  fi
  quietly "configure-$preset" cmake --preset "$preset" "${fresh[@]}"
}

# build PRESET [TARGET...]: one line of progress on a terminal; elsewhere only warnings and errors.
build() {
  local preset=$1 targets=() quiet=()
  shift
  (($# == 0)) || targets=(--target "$@")
  [[ -t 1 ]] || quiet=(-- --quiet)
  NINJA_STATUS='[%f/%t] ' cmake --build --preset "$preset" "${targets[@]}" "${quiet[@]}"
}
