# knitmech run: the run folder.
. "$(dirname "$0")/expect.sh" "$@"
tiny_case tiny.toml

# The results lie in results/<name of the case>.
knitmech run tiny.toml
expect_code 0
expect_in out "120 elements, 122 nodes, 732 degrees of freedom" "loop length" "mass scaling" "Quality:" "results/tiny"
expect_in out "100 %" "Stages: toe to 2 % strain, slope "
expect_empty err
for file in case.toml summary.json history.csv frames/frames.pvd frames/frame_0002.vtp frames/contacts.pvd \
  frames/contacts_0002.vtp frames/contacts_0002.csv pictures/force-strain.svg pictures/frame_0002.png \
  report.html figures/force-strain.svg figures/contact-force-0002.png; do
  expect_file "results/tiny/$file"
done
expect_in results/tiny/summary.json '"status": "completed"'
[ "$(wc -l <results/tiny/history.csv)" -eq 22 ] || failed "history.csv has $(wc -l <results/tiny/history.csv) lines, not 22"

# Contacts: their number in the last row of the history is what is printed; the tables of the frames begin with the names
# of their columns, and the summary counts the lines of the last one.
column=$(head -1 results/tiny/history.csv | tr ',' '\n' | grep -nx contacts | cut -d: -f1)
expect_in out "Contact: $(tail -1 results/tiny/history.csv | cut -d, -f"${column:-1}") contacts with " \
  "largest elastic slip of the run"
expect_in results/tiny/history.csv ",contacts,contact_normal_force_N,largest_elastic_slip_mm,"
expect_in results/tiny/frames/contacts_0000.csv "first_yarn,first_course,first_place_mm,second_yarn,"
expect_in results/tiny/frames/contacts.pvd 'file="contacts_0002.vtp"'
grep -A 5 '"contact": {' results/tiny/summary.json >contact.json
expect_in contact.json "\"contacts\": $(($(wc -l <results/tiny/frames/contacts_0002.csv) - 1))," \
  '"normal_force_N"' '"slipping_share"' '"elastic_slip_mm"' '"elastic_slip_ratio"'

# The case of the run folder has all defaults filled in and gives the same run, into the same folder.
expect_in results/tiny/case.toml 'step_factor = 0.9' 'out_of_plane = "auto"'
cp results/tiny/history.csv first.csv
cp results/tiny/case.toml first.toml
knitmech run results/tiny/case.toml --no-pictures
expect_code 0
expect_in out "replaces the run that is there"
expect_same results/tiny/history.csv first.csv
expect_same results/tiny/case.toml first.toml
# Pictures of the earlier run do not stay beside results that they do not show.
expect_no_file results/tiny/pictures
expect_no_file results/tiny/report.html
expect_no_file results/tiny/figures

# The report needs no other file and no network, and the command makes it again.
knitmech run tiny.toml --quiet
cp results/tiny/report.html first.html
grep -oE '(src|href)="[^"]{0,40}' first.html | grep -vE 'src="data:image/png;base64|href="#' >foreign
expect_empty foreign
expect_in first.html "Monofilament jersey" "<svg" "test.strain" "knitmech run"
knitmech report results/tiny
expect_code 0
expect_in out "results/tiny/report.html"
expect_same results/tiny/report.html first.html
knitmech report jersey
expect_code 2
expect_in err "jersey"

# A case called case.toml is named by its folder.
mkdir -p jersey
cp tiny.toml jersey/case.toml
knitmech run jersey/case.toml --no-pictures --quiet
expect_code 0
expect_empty out
expect_file results/jersey/history.csv
expect_no_file results/jersey/pictures

# Any number of threads gives the same run; small fabrics are run on one unless more are asked for.
expect_in results/tiny/summary.json '"threads": 1,'
knitmech run tiny.toml -o threads --no-pictures --threads 3
expect_code 0
expect_in out "threads       3"
expect_in threads/summary.json '"threads": 3,'
expect_same threads/history.csv first.csv
for frame in 0000 0001 0002; do
  expect_same threads/frames/frame_$frame.vtp results/tiny/frames/frame_$frame.vtp
done
knitmech run tiny.toml --threads 0
expect_code 2
expect_in err "--threads"

# Another folder can be asked for; --json gives the summary.
knitmech run tiny.toml -o some/where --json --no-pictures
expect_code 0
expect_in out '"status": "completed"' '"folder": "some/where"' '"quasi_static"'
expect_same some/where/history.csv first.csv

# The structure stands at the head of a run, and what ties gave way at its end.
expect_no_words() {
  for words in "${@:2}"; do
    ! grep -qF -- "$words" "$1" || failed "$LAST: \"$words\" is in $1"
  done
}
sed 's/^# structure = "basic"/structure = "tied"/' tiny.toml >tied.toml
knitmech run tied.toml --no-pictures
expect_code 0
expect_in out "tied: 8 crossings of the edge stitches are tied" "Ties: gave way by at most " "of the yarn diameter."
grep '"tie_stretch_mm": [0-9]' results/tied/summary.json >/dev/null || failed "no tie_stretch_mm in summary.json"
sed 's/^# structure = "basic"/structure = "adjusted"/' tiny.toml >adjusted.toml
knitmech run adjusted.toml --no-pictures
expect_code 0
expect_in out "adjusted: 1 turning arc of 6.54 mm, one yarn of " "edge yarn     EA 19.2265 N, EI 5e-06 N mm^2, GJ 3.59712e-06 N mm^2, friction 0.1"
expect_no_words out "Ties:"
expect_in results/adjusted/summary.json '"tie_stretch_mm": null'

# A folder that is no run folder is never touched.
mkdir mine
echo "mine" >mine/notes.txt
knitmech run tiny.toml -o mine
[ "$CODE" -ne 0 ] || failed "a folder with other files was taken"
expect_in err "knitmech: error:" "mine"
[ "$(ls mine)" = "notes.txt" ] || failed "a folder with other files was changed"

# A wrong case leaves an earlier run as it was.
sed -i 's/^friction = 0.1/friction = -1/' tiny.toml
knitmech run tiny.toml
expect_code 2
expect_same results/tiny/history.csv first.csv
finish
