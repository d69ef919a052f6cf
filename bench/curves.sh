#!/usr/bin/env bash
# Runs the fabric of the main example to 22 and 42 % strain on three meshes and prints a table of what each run took. Takes
# some fifteen minutes.
#
#   bench/curves.sh [PROGRAM] [THREADS] [FILE]
#
# writes the rows to FILE as well, tab separated with a line of titles.
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
program=$(readlink -f -- "${1:-$here/build/release/knitmech}")
threads=${2:-2}
file=${3:-/dev/null}
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

# value KEY: what the summary of the run says of a key that stands in it once.
value() {
  sed -n "s/^ *\"$1\": \([^,]*\),\{0,1\}\$/\1/p" "$scratch/run/summary.json" | head -n 1
}

printf '| N | strain | steps | time | element steps | kinetic energy | balance | quasi-static |\n'
printf '|--:|--:|--:|--:|--:|--:|--:|---|\n'
printf '%s\t' N 'strain [%]' steps 'time [s]' 'million element-steps/s' 'kinetic energy [%]' 'balance [%]' >"$file"
printf 'quasi-static\n' >>"$file"
for elements in 10 20 30; do
  for strain in 0.22 0.42; do
    sed -e "s/^elements_per_erc = .*/elements_per_erc = $elements/" -e "s/^strain = .*/strain = $strain/" \
      -e "s/^frames_at = .*/frames_at = [$strain]/" "$here/examples/02-wale-tension/case.toml" >"$scratch/case.toml"
    "$program" run "$scratch/case.toml" --quiet --no-pictures --threads "$threads" --output "$scratch/run" || true
    awk -v n="$elements" -v strain="$strain" -v steps="$(value steps)" -v wall="$(value wall_s)" \
      -v rate="$(value element_steps_per_s)" -v kinetic="$(value kinetic_ratio)" -v balance="$(value energy_balance)" \
      -v good="$(value quasi_static)" -v file="$file" 'BEGIN {
        good = good == "true" ? "yes" : "no"
        printf "| %d | %.0f %% | %d | %.0f s | %.1f million/s | %.1f %% | %.3f %% | %s |\n", n, 100 * strain, steps, wall,
          rate / 1e6, 100 * kinetic, 100 * balance, good
        printf "%d\t%.0f\t%d\t%.1f\t%.1f\t%.1f\t%.3f\t%s\n", n, 100 * strain, steps, wall, rate / 1e6, 100 * kinetic,
          100 * balance, good >> file }'
  done
done
