# knitmech check: what would be run.
. "$(dirname "$0")/expect.sh" "$@"

# The counts of 9 x 15 stitches: elements = 2 N W C, nodes = 2 N W C + C, six degrees of freedom each.
expect_counts() {
  "$PROGRAM" new | sed "s/^# elements_per_erc = 10/elements_per_erc = $1/" >jersey.toml
  knitmech check jersey.toml
  expect_code 0
  expect_in out "$2 elements, $3 nodes, $4 degrees of freedom"
  knitmech check --json jersey.toml
  expect_code 0
  expect_in out "\"elements\": $2" "\"nodes\": $3" "\"degrees_of_freedom\": $4"
}
expect_counts 10 2700 2715 16290
expect_counts 20 5400 5415 32490
expect_counts 30 8100 8115 48690

knitmech check jersey.toml
expect_in out "loop length" "least gap" "g/m^2" "EA 19.2265 N, EI 0.0173039 N mm^2, GJ 0.0124488 N mm^2"
expect_empty err

# It runs nothing and leaves nothing.
expect_no_file results

# Every named case of the checkout can be checked.
for case in "$CHECKOUT"/cases/*.toml "$CHECKOUT"/examples/*/case.toml; do
  knitmech check "$case"
  expect_code 0
done
finish
