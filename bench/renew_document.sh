#!/usr/bin/env bash
# Measures and writes what it finds into docs/performance.md, between the comments that name the tables there, and draws
# docs/pictures/performance.svg anew. The machine should be idle otherwise.
#
#   bench/renew_document.sh [PART...]
#
# PART is throughput (some four minutes), roofline (two), large-fabrics (two) or curves (fifteen); all if none is given. Tables
# that are not measured are left as they are. The tables stay in build/release/bench/measured, tab separated; the picture
# needs those of throughput, roofline and curves.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
programs=build/release/bench
measured=$programs/measured
document=docs/performance.md
threads=$(nproc)
mkdir -p "$measured"

fail() { printf '%s\n' "$*" >&2; exit 1; }

# titles TITLE...: a line of titles for a table, tab separated.
titles() { local IFS=$'\t'; printf '%s\n' "$*"; }

# put NAME: the table NAME.tsv into the document, between <!-- NAME: begin --> and <!-- NAME: end -->.
put() {
  awk -F '\t' -v table="$measured/$1.tsv" -v begin="<!-- $1: begin -->" -v end="<!-- $1: end -->" '
    function row(  i, line) { line = "|"; for (i = 1; i <= NF; ++i) line = line " " $i " |"; return line }
    function put_table(  i, head, line) {
      head = ""
      while ((getline < table) > 0) {
        if (head == "") { head = row(); continue }
        if (head != "done") {  # numbers to the right
          line = "|"; for (i = 1; i <= NF; ++i) line = line ($i ~ /^[-0-9.]+$/ ? "--:|" : "---|")
          print head "\n" line; head = "done"
        }
        print row()
      }
    }
    $0 == begin { print; print ""; put_table(); print ""; inside = found = 1; next }
    $0 == end { inside = 0; ended = found }
    !inside { print }
    END { exit !ended }' "$document" >"$measured/document.md" || fail "$document has no place for the table $1."
  cat -- "$measured/document.md" >"$document"
  rm -- "$measured/document.md"
}

measure_throughput() {
  local centreline n size
  {
    titles wales courses N centreline threads 'strain [%]' elements contacts 'million element-steps/s'
    for centreline in chords smooth; do
      for n in 1 "$threads"; do
        "$programs/throughput/throughput" 9 15 10 "$centreline" "$n" 16 10000
        "$programs/throughput/throughput" 9 15 10 "$centreline" "$n" 0 5000
        for size in 30:2000 100:400 300:100; do
          "$programs/throughput/throughput" "${size%:*}" "${size%:*}" 10 "$centreline" "$n" 0 "${size#*:}"
        done
      done
    done
  } >"$measured/throughput.tsv"
  put throughput
}

measure_roofline() {
  "$programs/throughput/roofline" "$measured"
  put machine
  put kernels
}

measure_large_fabrics() {
  {
    titles wales courses centreline elements 'set-up [s]' '200 steps [s]' 'ns per element and step' contacts \
      'bytes per element' 'at most'
    "$programs/scale" 100 100 smooth 200
    "$programs/scale" 300 300 smooth 200
    "$programs/scale" 100 100 chords 200
  } >"$measured/large-fabrics.tsv"
  put large-fabrics
}

measure_curves() {
  bench/curves.sh build/release/knitmech "$threads" "$measured/curves.tsv"
  put curves
}

draw() {
  local table
  for table in throughput machine kernels curves; do
    [[ -e $measured/$table.tsv ]] || { printf 'No picture yet: %s is not measured.\n' "$table"; return; }
  done
  "$programs/throughput/performance_plot" "$measured" docs/pictures/performance.svg
}

(($#)) || set -- throughput roofline large-fabrics curves
for part in "$@"; do
  printf 'Measuring: %s\n' "$part"
  case $part in
    throughput | roofline | curves) "measure_$part" ;;
    large-fabrics) measure_large_fabrics ;;
    *) fail "usage: bench/renew_document.sh [throughput|roofline|large-fabrics|curves]..." ;;
  esac
done
draw
