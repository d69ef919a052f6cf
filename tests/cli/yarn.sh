# knitmech yarn: tensile curves in, the section of a case out.
. "$(dirname "$0")/expect.sh" "$@"

expect_error() {
  local code=$1
  shift
  expect_code "$code"
  expect_in err "knitmech: error:" "$@"
  expect_empty out
  [ "$(wc -l <err)" -eq 1 ] || failed "$LAST: more than one line: $(cat err)"
  expect_no_file results
}

# A laboratory's file: Latin-1, semicolons, decimal commas, lines of text, five specimens of different length.
# Its formula (tests/data/yarn/README.md) gives strengths of 5.1647, 5.4781, 5.1700, 5.7872 and 5.7224 N at 33 to 37 %. Over
# 0 to 10 % the least-squares slope of 1 - exp(-e / 0.04) is 8.346, so that EA = 14 N + 0.55 N * 8.346 = 18.59 N and
# E = 1643.7 MPa; the points of the file are 0.5 % apart, which makes a thousandth.
five="$CHECKOUT/tests/data/yarn/five-specimens.csv"
knitmech yarn "$five" --diameter "0.12 mm" --density "1140 kg/m^3"
expect_code 0
expect_in out "5 specimens" "strength       5.46 N (5.16 N to 5.79 N) at 35.1 % (33 % to 37 %)" "EA             18.6 N" \
  "R^2" "results/five-specimens"
for file in yarn.toml yarn.svg mean-curve.csv; do expect_file results/five-specimens/$file; done
expect_in results/five-specimens/yarn.toml "[yarn]" 'diameter = "0.12 mm"' 'density = "1140 kg/m^3"' \
  'youngs_modulus = "' 'poissons_ratio = 0.39  # assumed' 'strength = "5.46446 N"'
awk -F'"' '/youngs_modulus/ { exit !($2 + 0 > 1643.7 * 0.999 && $2 + 0 < 1643.7 * 1.001) }' results/five-specimens/yarn.toml ||
  failed "$LAST: E is $(grep youngs_modulus results/five-specimens/yarn.toml)"
expect_in results/five-specimens/yarn.svg "<svg" "5 specimens" "fit, EA 18.6 N"
[ "$(wc -l <results/five-specimens/mean-curve.csv)" -eq 514 ] || failed "$LAST: the mean curve has not 513 points"
tail -1 results/five-specimens/mean-curve.csv >last-point
expect_in last-point "0.33,"

# The section in place of that of a case: a case with the EA of the test.
paste_section() {
  "$PROGRAM" new | awk '/^\[/ { skip = $0 == "[yarn]" } !skip' >pasted.toml
  cat "$1" >>pasted.toml
}
paste_section results/five-specimens/yarn.toml
knitmech check pasted.toml
expect_code 0
expect_in out "EA 18.60"
rm -r results

# The measured curve in place of E: as many strains as forces, from 0 to the end of the mean curve.
knitmech yarn "$five" --diameter "0.12 mm" --linear-density "12.9 tex" --poissons-ratio 0.35 --curve -o curve
expect_code 0
expect_in out "measured curve 33 points to 33 %"
expect_in curve/yarn.toml "curve_strains = [" '"0 N", ' "poissons_ratio = 0.35" 'density = "1140.61 kg/m^3"'
if grep -q "youngs_modulus\|assumed" curve/yarn.toml; then failed "$LAST: E beside the curve"; fi
expect_in curve/yarn.svg "law of the yarn"
paste_section curve/yarn.toml
knitmech check pasted.toml
expect_code 0
expect_in out "EA 27.2"
[ "$(grep -o '" N"\| N"' curve/yarn.toml | wc -l)" -eq 34 ] || failed "$LAST: not 33 forces and a strength"

# What it cannot know it does not write, and it takes an older section away.
knitmech yarn "$five" -o curve
expect_code 0
expect_in out "not known without --diameter" "needs two of --diameter, --density and --linear-density"
expect_no_file curve/yarn.toml
expect_file curve/mean-curve.csv

# Several files, a displacement and a force per tex, a range that is not reached; JSON for scripts.
printf 'Extension (mm),Tenacity (cN/tex)\n0,0\n2.5,10\n5,20\n' >one.csv
printf 'Weg in mm;Kraft in N\n0;0\n5;4\n' >two.csv
knitmech yarn one.csv two.csv --gauge-length "100 mm" --linear-density "20 tex" --json -o two
expect_code 0
expect_in out '"name": "two.csv"' '"axial_stiffness_N": 80' '"youngs_modulus_MPa": null' '"section": null' '"folder": "two"' \
  "all curves are there only from 0 % to 5 %"
expect_empty err

# Slack: half of the test without force, taken away if asked.
printf 'Strain [%%];Force [N]\n0;0\n5;0\n10;0.001\n15;1\n20;2\n' >slack.csv
knitmech yarn slack.csv --diameter "0.12 mm" --density "1140 kg/m^3" --curve
expect_error 2 "does not rise from strain 0" "slack"
knitmech yarn slack.csv --from-force "1 mN" --diameter "0.12 mm" --density "1140 kg/m^3" --curve -o slack
expect_code 0
expect_in out "EA             20 N"

# Mistakes on the command line.
knitmech yarn
expect_error 2 "CURVE" "knitmech yarn --help"
knitmech yarn "$five" --diameter 0.12
expect_error 2 "--diameter" "no unit"
knitmech yarn "$five" --range 0.1 0
expect_error 2 "--range"
knitmech yarn "$five" --range 0.5 0.6
expect_error 2 "no strains from 50 % to 60 %"
knitmech yarn "$five" --poissons-ratio 0.7
expect_error 2 "--poissons-ratio"
knitmech yarn "$five" --from-force "0 N"
expect_error 2 "--from-force"
knitmech yarn "$five" --diameter "0.12 mm" --density "1140 kg/m^3" --linear-density "20 tex"
expect_error 2 "give two of the three"
knitmech yarn two.csv
expect_error 2 "--gauge-length"

# Mistakes in a file: one sentence with file and line.
broken() {
  local complaint=$1
  printf "$2" >broken.csv
  knitmech yarn broken.csv
  expect_error 2 "broken.csv: " "$complaint"
}
broken "is empty" ''
broken "line 1: names the columns of a curve, but no numbers follow" 'Strain [%%];Force [N]\n'
broken "no line names the columns" 'hello\nworld\n'
broken 'line 4: "abc" is no number' 'Test 7\nStrain [%%];Force [N]\n0;0\n1;abc\n'
broken 'line 3: "nan" is no finite number' 'Strain [%%];Force [N]\n0;0\n1;nan\n'
broken "line 3: there is a number for the extension, but none for the load" 'Strain [%%];Force [N]\n0;0\n1\n'
broken "line 2: has 3 cells" 'Strain [%%],Force [N]\n0,5,1\n'
broken "must rise with the test" 'Strain [%%];Force [N]\n3;0\n2;1\n1;2\n'
broken "has 1 points" 'Strain [%%];Force [N]\n3;1\n'
broken 'the unit "lbf"' 'Strain [%%];Force [lbf]\n0;0\n1;1\n'
broken "not a text file" 'Strain\0Force\n'
head -c 100000 "$PROGRAM" >broken.csv
knitmech yarn broken.csv
expect_error 2 "not a text file"
knitmech yarn /dev/zero
expect_error 2 "is larger than"

# Files that cannot be read or written; a curve is never overwritten.
knitmech yarn missing.csv
expect_error 4 "missing.csv" "no such file"
knitmech yarn "$FOLDER"
expect_error 4 "folder"
knitmech yarn one.csv --linear-density "20 tex" --gauge-length "100 mm" -o two.csv
expect_error 4 "two.csv"
cp two/mean-curve.csv before.csv
knitmech yarn two/mean-curve.csv -o two
expect_error 2 "would be overwritten"
expect_same two/mean-curve.csv before.csv
finish
