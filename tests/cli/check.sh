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

# The side edges, and the yarn that they are made of.
expect_in out "basic: free side edges"
sed 's/^# structure = "basic"/structure = "tied"/' jersey.toml >tied.toml
knitmech check tied.toml
expect_code 0
expect_in out "tied: 112 crossings of the edge stitches are tied" # 14 pairs of courses x 2 edges x 4
sed 's/^# structure = "basic"/structure = "adjusted"/; s/^# edge_friction = "auto"/edge_friction = 0.25/' \
  jersey.toml >adjusted.toml
knitmech check adjusted.toml
expect_code 0
expect_in out "adjusted: 14 turning arcs of 6.54 mm, one yarn of 2.4 m" "edge yarn     EA 19.2265 N, EI 5e-06 N mm^2" \
  "friction 0.1 (edge yarn 0.25)"
knitmech check --json adjusted.toml
expect_code 0
expect_in out '"name": "adjusted"' '"yarns": 1' '"turning_arcs": 14' '"bending_stiffness_N_mm2": 5e-06' '"friction": 0.25'

# A yarn of filaments says so.
sed 's/^poissons_ratio = .*/shear_modulus = "700 MPa"\nfilaments = 34\nfilament_diameter = "16 um"\ntwist = "0.4 \/mm"/' \
  jersey.toml >filaments.toml
knitmech check filaments.toml
expect_code 0
expect_in out "34 filaments of 0.016 mm, 0.4 turns per mm"

# It runs nothing and leaves nothing.
expect_no_file results

# Every named case of the checkout can be checked.
for case in "$CHECKOUT"/cases/*.toml "$CHECKOUT"/examples/*/case.toml; do
  knitmech check "$case"
  expect_code 0
done
finish
