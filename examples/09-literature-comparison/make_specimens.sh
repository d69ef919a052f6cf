#!/usr/bin/env bash
# Makes specimens.csv: no measurement, but three simulated fabrics whose loops and friction differ as those of three
# specimens might, with one per cent of slack, as a file of a tensile tester. Takes half a minute.
#   examples/09-literature-comparison/make_specimens.sh PROGRAM
set -euo pipefail
program=$(readlink -f -- "$1")
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

sed 's/^elements_per_erc = 10/elements_per_erc = 16/' case.toml >"$folder/case.toml"
cat >"$folder/study.toml" <<'END'
base = "case.toml"
plan = "sobol"
samples = 3
[contact.friction]
from = 0.17
to = 0.23
[loop.height]
from = "8.15 mm"
to = "8.25 mm"
END
"$program" study "$folder/study.toml" -o "$folder/out" >/dev/null

gauge_length=43
slack=0.01
{
  echo "specimen,displacement [mm],force [mN]"
  for run in 1 2 3; do
    awk -F, -v run="$run" -v gauge="$gauge_length" -v slack="$slack" '
      NR > 1 && NR % 10 == 1 { printf "synthetic %d,%.3f,%.4f\n", run, ($3 + slack) * gauge, 500 * ($4 + $5) }' \
      "$folder/out/runs/sample-00$run/history.csv"
  done
} >specimens.csv
wc -l specimens.csv
