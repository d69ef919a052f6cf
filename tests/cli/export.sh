# knitmech export: the Abaqus deck.
. "$(dirname "$0")/expect.sh" "$@"
tiny_case tiny.toml

knitmech export tiny.toml -f abaqus -o tiny.inp
expect_code 0
expect_in tiny.inp "*NODE" "TYPE=B31" "bottom_feet" "*DYNAMIC, EXPLICIT"

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
knitmech export tiny.toml -f abaqus --strain 0.1
expect_code 2
expect_in err "no folder of a run"
knitmech export tiny.toml -f ansys
expect_code 2
expect_in err "there is no format" "abaqus"
finish
