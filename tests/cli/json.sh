# --json: one JSON document on standard output, and nothing else.
. "$(dirname "$0")/expect.sh" "$@"
tiny_case tiny.toml

# The value at a path of the document in `out`, as JSON.
value() {
  python3 -c 'import json, sys
document = json.load(open("out"))
for key in sys.argv[1:]:
    document = document[int(key) if key.lstrip("-").isdigit() else key]
print(json.dumps(document))' "$@"
}
expect_value() {
  local wanted=$1
  shift
  [ "$(value "$@")" = "$wanted" ] || failed "$LAST: $* is $(value "$@"), not $wanted"
}

knitmech new --json other.toml
expect_code 0
expect_value '"other.toml"' files 0
knitmech new --json
expect_code 2

knitmech check --json tiny.toml
expect_code 0
expect_value '"basic"' structure name

knitmech run --json --no-pictures tiny.toml
expect_code 0
expect_value '"completed"' status
expect_empty err

knitmech render --json results/tiny --strain 0.01 --height 200
expect_code 0
expect_value '"results/tiny/pictures/frame_0001-plain-front.png"' files 0
knitmech render --json results/tiny --animate turn --seconds 0.2 --height 120 -o turn.webp
expect_code 0
expect_value '"turn.webp"' files 0

knitmech report --json results/tiny
expect_code 0
expect_value '"results/tiny/report.html"' files 0

knitmech export --json tiny.toml -f abaqus -o tiny.inp
expect_code 0
expect_value '"tiny.inp"' files 0
knitmech export --json tiny.toml -f abaqus
expect_code 2
expect_in err '"exit_code": 2'

knitmech lint --json tiny.inp
expect_code 0
expect_value '[]' findings
sed -i 's/^\*FRICTION/*FRICTON/' tiny.inp
knitmech lint --json tiny.inp
expect_code 2
expect_value '"error"' findings 0 kind

knitmech parameters --json
expect_code 0
value parameters 0 >/dev/null || failed "there is no list of parameters"
finish
