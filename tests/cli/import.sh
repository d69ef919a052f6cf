# A fabric from a file of yarns: check, run, resume, report, render and export, and the messages for files that are wrong.
. "$(dirname "$0")/expect.sh" "$@"
EXAMPLE=$CHECKOUT/examples/10-other-geometry
mkdir cases
cp "$EXAMPLE/jersey-3x3.bcc" cases/
sed -e 's/^strain = .*/strain = 0.1/; s/^frames_at = .*/frames_at = [0.05]\ncheckpoint_every = "10 ms"/' \
  "$EXAMPLE/case.toml" >cases/swatch.toml

knitmech check cases/swatch.toml
expect_code 0
expect_in out "3 yarns from a file with" "cases/jersey-3x3.bcc" "180 elements" "least gap     0.00" "nodes in the lowest"
knitmech check cases/swatch.toml --json
expect_code 0
expect_in out '"structure": null' '"yarns": 3' '"half_stitch_mm": 8.6' '"diameter_in_file_mm": null'

# The run folder needs nothing but itself.
knitmech run cases/swatch.toml -o run --no-pictures
expect_code 0
expect_in out "3 yarns from a file" "Reached 10 % strain"
expect_same run/yarns.bcc cases/jersey-3x3.bcc
expect_in run/case.toml 'yarns = "yarns.bcc"' 'yarns_checksum = "'
mkdir elsewhere
mv run elsewhere/
knitmech report elsewhere/run
expect_code 0
expect_in elsewhere/run/report.html "read from a file, which does not say what its courses and wales are"
knitmech render elsewhere/run -o picture.png --colour course --width 200
expect_code 0
expect_file picture.png
knitmech render elsewhere/run --contact-map -o map.svg
expect_code 0
expect_file map.svg
knitmech run elsewhere/run/case.toml -o again --no-pictures
expect_code 0
expect_same again/history.csv elsewhere/run/history.csv
expect_same again/case.toml elsewhere/run/case.toml

# Another file of yarns in its place is noticed, and so is a missing one.
cp again/yarns.bcc kept.bcc
printf 'x' | dd of=again/yarns.bcc bs=1 seek=40 conv=notrunc status=none
knitmech report again
expect_code 2
expect_in err "again/case.toml, line 4: again/yarns.bcc is not the file that the case was written for"
rm again/yarns.bcc
knitmech report again
expect_code 4
expect_in err 'cannot read "again/yarns.bcc": there is no such file'
cp kept.bcc again/yarns.bcc

# A run that is stopped goes on to the same result.
"$PROGRAM" run cases/swatch.toml -o stopped --quiet --no-pictures >out 2>err &
process=$!
until [ -s stopped/checkpoint.bin ] || ! kill -0 "$process" 2>/dev/null; do sleep 0.01; done
kill -KILL "$process" 2>/dev/null
wait "$process" 2>/dev/null
if [ -e stopped/checkpoint.bin ]; then
  knitmech run --resume stopped --no-pictures
  expect_code 0
  expect_in out "goes on from"
fi
expect_same stopped/history.csv again/history.csv

# A run of loops in the same folder takes the file of yarns away.
tiny_case tiny.toml
knitmech run tiny.toml -o stopped --quiet --no-pictures
expect_code 0
expect_no_file stopped/yarns.bcc

knitmech export cases/swatch.toml -f abaqus -o deck.inp
expect_code 0
expect_in deck.inp "ELSET=YARN_1" "ELSET=YARN_3" "NSET=bottom_feet"

# A study of it: what is varied must mean something for a fabric from a file.
printf 'base = "cases/swatch.toml"\nplan = "grid"\n[contact.friction]\nvalues = [0.1, 0.3]\n' >study.toml
knitmech study study.toml -o study
expect_code 0
expect_same study/runs/friction-0.3/yarns.bcc cases/jersey-3x3.bcc
expect_same study/yarns.bcc cases/jersey-3x3.bcc
printf 'base = "cases/swatch.toml"\nplan = "grid"\n[loop.height]\nvalues = ["7 mm", "8 mm"]\n' >study.toml
knitmech study study.toml -o other
expect_code 2
expect_in err "loop.height: has no meaning for the base case, whose fabric is read from a file"

# refused WORDS... : cases/wrong.toml is refused with exit code 2 and one line that has the words.
refused() {
  knitmech check cases/wrong.toml
  expect_code 2
  expect_in err "$@"
  [ "$(wc -l <err)" -eq 1 ] || failed "$LAST: more than one line: $(cat err)"
}
sed 's/^file_unit.*//' cases/swatch.toml >cases/wrong.toml
refused "fabric.file_unit is missing" 'file_unit = "1 mm"'
sed 's/^file_unit.*/&\nwales = 3/' cases/swatch.toml >cases/wrong.toml
refused "line 7: fabric.wales: is given beside fabric.yarns"
sed 's/^diameter = "0.12 mm"/diameter = "0.16 mm"/' cases/swatch.toml >cases/wrong.toml
refused "the yarns overlap by 0.03" "of yarn.diameter = 0.16 mm" "where yarn" "thinner yarn"
head -c 1000 cases/jersey-3x3.bcc >cases/cut.bcc
sed 's/jersey-3x3.bcc/cut.bcc/' cases/swatch.toml >cases/wrong.toml
refused "cases/cut.bcc: is damaged or cut off"
printf 'yarn,x_mm,y_mm,z_mm\n1,0,0,0\n1,1,0\n' >cases/short.csv
sed 's/jersey-3x3.bcc/short.csv/; s/^file_unit.*//' cases/swatch.toml >cases/wrong.toml
refused "cases/short.csv: line 3: has 3 cells"
sed 's/jersey-3x3.bcc/missing.bcc/' cases/swatch.toml >cases/wrong.toml
knitmech check cases/wrong.toml
expect_code 4
expect_in err "cases/wrong.toml, line 5: fabric.yarns: cannot read"
finish
