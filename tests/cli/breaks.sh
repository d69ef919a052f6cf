# knitmech run with a yarn that breaks: the test stops, or goes on.
. "$(dirname "$0")/expect.sh" "$@"
tiny_case tiny.toml

# with_yarn KEYS...: the case with more keys of the yarn, and a test far enough for them.
with_yarn() {
  for key in "$@"; do printf '%s\n' "$key"; done >keys
  sed -e '/^\[yarn\]/r keys' -e 's/^strain = 0.02/strain = 0.3/; s/^frames_at = .*/frames_at = [0.2]/' tiny.toml
}
LAW=('curve_strains = [0, 0.01, 0.02, 0.05]' 'curve_forces = ["0 N", "0.19 N", "0.3 N", "0.5 N"]')

# Stop: completed, and the break is the reason.
with_yarn 'strength = "20 mN"' >stop.toml
knitmech run stop.toml --no-pictures
expect_code 0
expect_in out "Stopped at" "Break: a yarn broke in course" "mm along the yarn, at"
expect_empty err
expect_in results/stop/summary.json '"status": "completed"' '"reason": "The test ended at' 'because a yarn broke, in course'
grep -A 13 '"breaks": \[' results/stop/summary.json >breaks.json
expect_in breaks.json '"axial_force_N": 0.02' '"axial_strain": ' '"course": ' '"wale": ' '"part": "' '"place_mm": '

# Go on: to the end of the test, with what was lost in a column of the history.
with_yarn 'strength = "20 mN"' | sed 's/^# on_break = .*/on_break = "go on"/' >on.toml
expect_in on.toml 'on_break = "go on"'
knitmech run on.toml --no-pictures
expect_code 0
expect_in out "Reached 30 % strain" "Break"
expect_in results/on/summary.json '"status": "completed"' '"reason": ""' '"break_loss_mJ": '
column=$(head -1 results/on/history.csv | tr ',' '\n' | grep -nx break_loss_mJ | cut -d: -f1)
[ "$(tail -1 results/on/history.csv | cut -d, -f"${column:-1}")" != 0 ] || failed "no break loss in the last row"

# A yarn that is never loaded so far breaks nowhere.
with_yarn 'strength = "50 N"' >strong.toml
knitmech run strong.toml --no-pictures
expect_code 0
expect_in results/strong/summary.json '"breaks": []'

# A measured curve in place of E; a strength above a curve that ends flat is a mistake.
with_yarn "${LAW[@]}" | sed '/^youngs_modulus/d' >curve.toml
knitmech run curve.toml --no-pictures
expect_code 0
expect_empty err
knitmech check curve.toml
expect_in out "along a measured curve to 5 % and 0.5 N"
knitmech check stop.toml
expect_in out "breaks at 20 mN, which ends the test"
with_yarn "${LAW[@]}" 'strength = "0.6 N"' | sed '/^youngs_modulus/d; s/"0.3 N", "0.5 N"/"0.3 N", "0.3 N"/' >flat.toml
knitmech check flat.toml
expect_code 2
expect_in err "flat.toml, line " "yarn.strength" "0.6 N is never reached"
finish
