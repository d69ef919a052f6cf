# An example gives the figures that its README promises: each row of the table there, `key` | figure | tolerance.
# The first one, or the one named as third argument: bash examples.sh PROGRAM CHECKOUT 02-wale-tension
. "$(dirname "$0")/expect.sh" "$@"
EXAMPLE=$CHECKOUT/examples/${3:-01-first-loop}

# rows: key, expected figure and tolerance in per cent of every row of the table, one row a line.
rows() {
  sed -nE 's/^\| `([a-z]+\.[A-Za-z_]+)` \| ([0-9.e+-]+)[^|]* \| ([0-9.]+) % \|.*/\1 \2 \3/p' "$EXAMPLE/README.md"
}

# value_of BLOCK.KEY: the number in summary.json, which has one key a line.
value_of() {
  awk -v block="${1%%.*}" -v key="${1#*.}" '
    /^  "/ { inside = index($0, "  \"" block "\": {") == 1 }
    inside && index($0, "    \"" key "\": ") == 1 { sub(/,$/, ""); print $2 }' run/summary.json
}

expect_within() {
  local value
  value=$(value_of "$1")
  awk -v value="$value" -v expected="$2" -v tolerance="$3" 'BEGIN {
    difference = value - expected
    if (difference < 0) difference = -difference
    exit !(value ~ /^[0-9]/ && difference <= tolerance / 100 * expected)
  }' || failed "$LAST: $1 is ${value:-not there}, but README.md says $2 within $3 %"
}

knitmech run "$EXAMPLE/case.toml" -o run --no-pictures --quiet
expect_code 0
expect_in run/summary.json '"status": "completed"' '"quasi_static": true' '"crossings_kept": true'

# As many rows as are read as stand in the table, so that a row in another form is not passed over.
n_rows=$(grep -c '^| `' "$EXAMPLE/README.md")
[ "$n_rows" -ge 5 ] && [ "$(rows | wc -l)" -eq "$n_rows" ] || failed "README.md: $(rows | wc -l) of $n_rows rows can be read"
while read -r key expected tolerance; do
  expect_within "$key" "$expected" "$tolerance"
done < <(rows)
finish
