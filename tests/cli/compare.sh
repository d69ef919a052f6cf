# knitmech compare: measured curves of a fabric against the curve of a run.
. "$(dirname "$0")/expect.sh" "$@"
# Tied edges, so that the force climbs from the start.
tiny_case tiny.toml
sed -i 's/^# structure = .*/structure = "tied"/' tiny.toml
knitmech run tiny.toml --no-pictures --quiet
expect_code 0

expect_error() {
  local code=$1
  shift
  expect_code "$code"
  expect_in err "knitmech: error:" "$@"
  expect_empty out
  [ "$(wc -l <err)" -eq 1 ] || failed "$LAST: more than one line: $(cat err)"
  expect_no_file results/tiny/compare
}

# number KEY: the first number of that name in compare.json.
number() {
  grep -m1 "\"$1\":" "${2:-results/tiny/compare}/compare.json" | sed 's/.*: *//; s/,$//'
}
expect_near() {
  awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN { exit !(a != "" && a - b <= t && b - a <= t) }' || failed "$LAST: $1 is $2, not $3"
}

# Specimens made from the run itself: three curves whose force per width is 0.8, 1 and 1.2 times the simulated one.
# width: of the fabric at the start; the force is the mean of both grips.
specimens() {
  awk -F, -v factors="$1" -v slack="$2" '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print "Specimen,Strain [%],Load per width [N/mm]"; next }
    NR == 2 { width = $at["width_mm"] }
    {
      n = split(factors, factor, " ")
      for (k = 1; k <= n; k++) line[k] = line[k] sprintf("F%s,%.12g,%.12g\n", factor[k], 100 * ($at["strain"] + slack),
        factor[k] * ($at["force_top_N"] + $at["force_bottom_N"]) / 2 / width)
    }
    END { for (k = 1; k <= n; k++) printf "%s", line[k] }' results/tiny/history.csv
}
specimens "0.8 1 1.2" 0 >three.csv

# Mistakes leave nothing behind.
knitmech compare results/tiny
expect_error 2 "CURVE" "knitmech compare --help"
knitmech compare tiny.toml three.csv
expect_error 2 "tiny.toml" "no folder of a KnitMech run"
knitmech compare results/none three.csv
expect_error 4 "results/none" "no such folder"
knitmech compare results/tiny missing.csv
expect_error 4 "missing.csv" "no such file"
knitmech compare results/tiny three.csv --sample F7
expect_error 2 '"F7"' "F0.8, F1 or F1.2"
knitmech compare results/tiny three.csv --at 0.5
expect_error 2 "0.5" "in common"
knitmech compare results/tiny three.csv --offset 1%
expect_error 2 "--offset" '"1%"' "auto"
knitmech compare results/tiny three.csv --offset 0.9
expect_error 2 "no strains in common" "less the offset"
knitmech compare results/tiny three.csv --width 50
expect_error 2 "--width" "no unit"
knitmech compare results/tiny three.csv --width "0 mm"
expect_error 2 "--width" "more than 0"
printf 'Strain,Force [N]\n0,0\n0.1,1\n' >no-unit.csv
knitmech compare results/tiny no-unit.csv
expect_error 2 "no-unit.csv" "line 1" '"Strain" has no unit' "--extension-column"
printf 'Strain [%%],Stress [MPa]\n0,0\n1,1\n' >stress.csv
knitmech compare results/tiny stress.csv
expect_error 2 "stress.csv" "line 1" "N/mm"

# The mean of the three is the simulated curve; 0.8 and 1.2 are their range.
knitmech compare results/tiny three.csv --at 0.01 0.02
expect_code 0
expect_empty err
expect_in out "3 measured curves" "RMS difference" "within the specimens" "force at 1 %" "force at 2 %" "initial slope" \
  "slope after locking" "locking strain" "results/tiny/compare" "compare.csv, compare.json, compare.svg"
for file in csv json svg; do expect_file results/tiny/compare/compare.$file; done
expect_near "the RMS" "$(number rms_ratio)" 0 0.01
expect_in results/tiny/compare/compare.svg "<svg" "<polygon" "mean of 3 measured" "simulated" "Force per width [mN/mm]"
[ "$(wc -l <results/tiny/compare/compare.csv)" -eq 502 ] || failed "compare.csv has not 501 strains"
awk -F, 'NR == 1 { if ($0 != "strain,simulated_N_per_mm,mean_N_per_mm,lowest_N_per_mm,highest_N_per_mm") exit 1 }
  NR == 502 { exit !($4 > 0 && $4 < 0.81 * $3 && $5 > 1.19 * $3) }' results/tiny/compare/compare.csv ||
  failed "$LAST: compare.csv is not what was measured"

# One specimen by its name, JSON for scripts, another folder.
knitmech compare results/tiny three.csv --sample F1.2 --json -o one
expect_code 0
expect_same out one/compare.json
expect_in out '"name": "three.csv, specimen F1.2"' '"share_in_range": null'
# Reference: a curve 1.2 times another differs from it by a sixth of itself.
grep -A 6 '"at": \[' one/compare.json >first-strain
expect_near "the difference" "$(awk -F'[:,]' '/simulated/ { s = $2 } /mean/ { m = $2 } END { print s / m }' first-strain)" 0.83333 0.001

# Forces in N of specimens that are three times as wide are per width what the same curve per width is.
width=$(number fabric_width_mm one)
awk -F, -v w="$width" 'NR == 1 { print "Elongation [mm];Force [mN]"; next }
  /^F1,/ { printf "%.12g;%.12g\n", $2 / 100 * 200, 1000 * $3 * 3 * w }' three.csv >wide.csv
knitmech compare results/tiny wide.csv --gauge-length "200 mm" --width "$(awk -v w="$width" 'BEGIN { print 3 * w }') mm" -o wide
expect_code 0
expect_in out "200 mm between the grips"
expect_near "the RMS" "$(number rms_ratio wide)" 0 0.01
expect_in wide/compare.svg "Force per width"

# Slack is told, or found.
specimens 1 0.003 >late.csv
knitmech compare results/tiny late.csv --offset 0.003 -o late
expect_code 0
expect_in out "0.3 % taken from the measured strains"
expect_near "the RMS" "$(number rms_ratio late)" 0 0.01
knitmech compare results/tiny late.csv --offset auto -o late
expect_code 0
expect_near "the offset" "$(number offset late)" 0.003 0.0002

# A curve is never overwritten; a comparison does not stay beside a new run that it was not made with.
cp three.csv late/compare.csv
knitmech compare results/tiny late/compare.csv -o late
expect_code 2
expect_in err "would be overwritten"
knitmech run tiny.toml --no-pictures --quiet
expect_code 0
expect_no_file results/tiny/compare
finish
