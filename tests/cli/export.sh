# knitmech export: decks for Abaqus, OpenRadioss and LS-DYNA.
. "$(dirname "$0")/expect.sh" "$@"
tiny_case tiny.toml

knitmech export tiny.toml -f abaqus -o tiny.inp
expect_code 0
expect_in tiny.inp "*NODE" "TYPE=B31" "bottom_feet" "*DYNAMIC, EXPLICIT"

# Whoever compares the other program's run is told how; not if the case is as it should be.
expect_in err "Note:" 'contact.centreline = "chords"'
sed -e 's/^mass_scaling = .*//' tiny.toml >auto.toml
knitmech export auto.toml -f abaqus -o auto.inp
expect_in err 'contact.centreline = "chords" and a number for solver.mass_scaling'
sed -e 's/^\[contact\]/&\ncentreline = "chords"/' tiny.toml >chords.toml
for format in abaqus lsdyna; do
  knitmech export chords.toml -f $format -o chords.out
  expect_code 0
  expect_empty err
done

# Without a name it goes to standard output, the same bytes.
knitmech export tiny.toml -f abaqus
expect_code 0
expect_same out tiny.inp

# The case itself is never overwritten, and a folder that is not there is an error.
cp tiny.toml before.toml
knitmech export tiny.toml -f abaqus -o tiny.toml
expect_code 2
expect_same tiny.toml before.toml
knitmech export tiny.toml -f abaqus -o no/such/folder/tiny.inp
expect_code 4
# OpenRadioss: two files of one name, which is that of the run in both of them.
knitmech export tiny.toml -f openradioss -o jersey_0000.rad
expect_code 0
expect_in out "jersey_0000.rad" "jersey_0001.rad"
expect_in jersey_0000.rad "/BEGIN" "jersey" "/INTER/TYPE11/1" "/END"
expect_in jersey_0001.rad "/RUN/jersey/1" "/TFILE"
knitmech export tiny.toml -f openradioss
expect_code 2
expect_in err "makes 2 files" "-o tiny_0000.rad"
knitmech export tiny.toml -f openradioss -o "my jersey_0000.rad"
expect_code 2
expect_in err "bear the name of the run"

# LS-DYNA: one keyword deck.
knitmech export tiny.toml -f lsdyna -o tiny.k
expect_code 0
expect_in tiny.k "*KEYWORD" "*ELEMENT_BEAM" "*CONTACT_AUTOMATIC_GENERAL_ID" "*END"
knitmech export tiny.toml -f abaqus --strain 0.1
expect_code 2
expect_in err "no folder of a run"
knitmech export tiny.toml -f ansys
expect_code 2
expect_in err "there is no format" "abaqus"
finish
