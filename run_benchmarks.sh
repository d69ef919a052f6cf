#!/usr/bin/env bash
# Installs what is missing, builds KnitMech and runs its benchmarks one after the other, on an otherwise idle machine please.
# Arguments go to each of them: ./run_benchmarks.sh --benchmark_filter=contact
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/tools/set_up.sh"

install_packages
say "Building KnitMech and its benchmarks."
configure release
build release
for program in build/release/bench/bench_*; do
  [[ -x $program ]] || fail "No benchmark was built; see bench/CMakeLists.txt."
  say ""
  "$program" --benchmark_counters_tabular=true "$@"
done
