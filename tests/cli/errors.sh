# What a user gets wrong: the exit code, and one sentence on standard error.
. "$(dirname "$0")/expect.sh" "$@"

expect_error() {
  local code=$1
  shift
  expect_code "$code"
  expect_in err "knitmech: error:" "$@"
  expect_empty out
  [ "$(wc -l <err)" -eq 1 ] || failed "$LAST: more than one line: $(cat err)"
}

# The command line.
knitmech
expect_error 2 "--help"
knitmech fly jersey.toml
expect_error 2 "no command \"fly\"" "new, check, run, report, render, compare, study, yarn, export, lint, ui, parameters, completion or man"
knitmech chek jersey.toml
expect_error 2 "did you mean check?"
knitmech check
expect_error 2 "CASE" "knitmech check --help"
knitmech check --colour jersey.toml
expect_error 2 "--colour"
"$PROGRAM" new jersey.toml >out
knitmech export jersey.toml
expect_error 2 "--format"
knitmech export jersey.toml -f ansys
expect_error 2 "ansys" "abaqus"

# Help and version are no errors.
knitmech --help
expect_code 0
expect_in out "Examples:" "knitmech run jersey.toml" "Exit codes"
knitmech run --help
expect_code 0
expect_in out "--output"
knitmech --version
expect_code 0
expect_in out "knitmech "

# Files that are not there or are no case.
knitmech check missing.toml
expect_error 4 "missing.toml" "no such file"
knitmech check "$FOLDER"
expect_error 4 "folder"
knitmech check "$PROGRAM"
expect_error 2 "case file"
: >empty.toml
knitmech check empty.toml
expect_error 2 "empty.toml" "is empty"

# Standard output that takes nothing.
LAST="knitmech parameters to a full device"
"$PROGRAM" parameters >/dev/full 2>err
CODE=$?
expect_code 4
expect_in err "standard output"

# Mistakes in a case: file, line, key.
sed 's/^height = "7 mm"/height = "7 s"/' jersey.toml >wrong.toml
line=$(grep -n '^height' wrong.toml | cut -d: -f1)
for command in check run "export -f abaqus"; do
  knitmech $command wrong.toml
  expect_error 2 "wrong.toml, line $line: loop.height" "mm, um, cm, m"
done
expect_no_file results

# A geometry that cannot be is reported the same way.
sed 's/^head_radius = "1.1 mm"/head_radius = "3 mm"/' jersey.toml >impossible.toml
knitmech check impossible.toml
expect_error 2 "impossible.toml, line " "loop."
sed 's/^# out_of_plane = "auto"/out_of_plane = "0.001 \/mm"/' jersey.toml >overlap.toml
knitmech check overlap.toml
expect_error 2 "overlap.toml, line " "loop.out_of_plane"

# With --json the error is JSON as well.
knitmech check --json wrong.toml
expect_code 2
expect_in err '"error"' '"exit_code": 2' "\"line\": $line" '"key": "loop.height"' '"file": "wrong.toml"'
knitmech check --json missing.toml
expect_code 4
expect_in err '"exit_code": 4'
knitmech check --json
expect_code 2
expect_in err '"exit_code": 2'
finish
