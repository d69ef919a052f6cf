# knitmech lint: the syntax of an Abaqus deck.
. "$(dirname "$0")/expect.sh" "$@"
tiny_case tiny.toml
for structure in basic tied adjusted; do
  sed "s/^# structure = \"basic\"/structure = \"$structure\"/" tiny.toml >case.toml
  knitmech export case.toml -f abaqus -o deck.inp
  expect_code 0
  knitmech lint deck.inp
  expect_code 0
  expect_in out "deck.inp: 0 errors, 0 notes"
done

sed 's/SECTION=CIRC/SECTION=ROUND/; s/^\*BULK VISCOSITY/*RESTART, WRITE\n&/' deck.inp >wrong.inp
knitmech lint wrong.inp
expect_code 2
expect_in out "SECTION=ROUND is not possible" "note: *RESTART" "1 error, 1 notes" "wrong.inp, line"

knitmech lint no-such.inp
expect_code 4
expect_in err "no-such.inp"
finish
