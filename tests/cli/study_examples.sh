# The studies of the examples: each can be read, and those that take seconds give what their pages promise.
. "$(dirname "$0")/expect.sh" "$@"

for study in "$CHECKOUT"/examples/*/study.toml; do
  knitmech study "$study" --list
  expect_code 0
  ! grep -q impossible out || failed "$study: $(cat out)"
done

# value_of RUN COLUMN: of the table of a study, whose fields hold no commas but in the last.
value_of() {
  awk -F, -v run="$1" -v name="$2" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i }
    $1 == run { print $column }' study/table.csv
}
# expect_order WORDS... < ...: numbers that ascend.
expect_ascending() {
  printf '%s\n' "$@" | awk 'NR > 1 && !($1 > before) { exit 1 } { before = $1 + 0 } $1 !~ /^-?[0-9]/ { exit 1 }' ||
    failed "$LAST: $* do not ascend"
}

# Edges: tied is the stiffest by far and moves least out of plane, with its contacts at the edges; basic and adjusted are close.
knitmech study "$CHECKOUT/examples/05-boundary-study/study.toml" -o study
expect_code 0
expect_in out "3 of 3 runs completed"
[ "$(grep -c ",completed," study/table.csv)" -eq 3 ] || failed "$(cat study/table.csv)"
[ "$(cut -d, -f4 study/table.csv | tr '\n' ' ')" = "quasi_static 1 1 1 " ] || failed "not all are quasi-static"
basic=$(value_of structure-basic work_mJ_at_22_percent)
adjusted=$(value_of structure-adjusted work_mJ_at_22_percent)
expect_ascending "$basic" "$adjusted" "$(awk "BEGIN { print 1.15 * $basic }")" "$(value_of structure-tied work_mJ_at_22_percent)"
expect_ascending "$(value_of structure-tied out_of_plane_mm)" 1.5 "$(value_of structure-basic out_of_plane_mm)"
expect_ascending "$(value_of structure-tied contact_force_in_middle_third)" 0.3334 0.5 \
  "$(value_of structure-basic contact_force_in_middle_third)"
expect_ascending 0.5 "$(value_of structure-adjusted contact_force_in_middle_third)"
expect_in study/report.html "Boundary study" "Shape and contact" "<svg" "data:image/png;base64,"
expect_file study/figures/force-strain.svg

# Beside measured curves: that with the friction of the specimens is nearest to them.
rm -rf study
knitmech study "$CHECKOUT/examples/09-literature-comparison/study.toml" -o study
expect_code 0
expect_in study/report.html "Beside measurements" "RMS"
for friction in 0.1 0.2 0.3; do
  knitmech compare "study/runs/friction-$friction" "$CHECKOUT/examples/09-literature-comparison/specimens.csv" \
    --gauge-length "43 mm" --width "23 mm" --offset auto --json
  expect_code 0
  grep -oE '"rms_ratio": [0-9.e-]+' out | head -1 | cut -d' ' -f2 >"rms-$friction"
done
expect_ascending "$(cat rms-0.2)" "$(cat rms-0.1)" "$(cat rms-0.3)" 0.01
finish
