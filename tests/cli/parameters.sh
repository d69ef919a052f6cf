# knitmech parameters: every key; the page of the documentation is what the program writes.
. "$(dirname "$0")/expect.sh" "$@"

knitmech parameters
expect_code 0
expect_in out "loop.height" "H: height of one loop" "solver.mass_scaling"

knitmech parameters --markdown
expect_code 0
expect_same out "$CHECKOUT/docs/input-reference.md"
finish
