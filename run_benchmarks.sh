#!/usr/bin/env bash
# Installs what is missing, builds KnitMech and runs its benchmarks one after the other, on an otherwise idle machine please.
# That takes some twenty minutes and renews the tables and the picture of docs/performance.md. With arguments, which go to the
# small benchmarks, only these run:
# ./run_benchmarks.sh --benchmark_filter=contact
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
(($# == 0)) || exit 0

say "
Tables and picture of docs/performance.md:"
bench/renew_document.sh

say "
Ways to the curve:"
build/release/bench/schemes/bench_schemes --budget 60
