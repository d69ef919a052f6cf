# knitmech export: the yarns as tubes and lines, of a case and of the frames of a run.
. "$(dirname "$0")/expect.sh" "$@"
tiny_case tiny.toml

for format in vtp gltf obj stl step csv bcc yarns; do
  knitmech export tiny.toml -f $format -o tiny.$format
  expect_code 0
  expect_empty err
  expect_file tiny.$format
  expect_in out "Wrote tiny.$format"
  mv tiny.$format expected
  knitmech export tiny.toml -f $format  # without a name it goes to standard output, the same bytes
  expect_code 0
  expect_same out expected
done
knitmech export --help
expect_in out vtp gltf obj stl step csv bcc yarns .glb

# Of a run the last frame unless another is asked for; the first is the fabric as it was knitted.
knitmech run tiny.toml --no-pictures
expect_code 0
for frame in 0 1 2; do
  knitmech export results/tiny -f csv --frame $frame -o frame$frame.csv
  expect_code 0
done
knitmech export results/tiny -f csv -o last.csv
expect_same last.csv frame2.csv
knitmech export results/tiny -f csv --strain 0.011 -o near.csv
expect_in err "Frame 1 at" "nearest to 1.1 %"
expect_same near.csv frame1.csv
knitmech export tiny.toml -f csv -o start.csv
expect_same start.csv frame0.csv
cmp -s start.csv last.csv && failed "the last frame is the fabric as it was knitted"

# More sides, more triangles.
knitmech export tiny.toml -f stl --sides 3 -o few.stl
knitmech export tiny.toml -f stl --sides 24 -o many.stl
[ "$(wc -c <many.stl)" -gt "$((6 * $(wc -c <few.stl)))" ] || failed "24 sides make no more triangles than 3"

# A CAD program reads solids named after their yarns; sizes are told in units that suit them.
knitmech export tiny.toml -f step -o tiny.step
expect_in out "tiny.step: Yarns as solids for CAD programs, STEP" kB
[ "$(grep -c "MANIFOLD_SOLID_BREP" tiny.step)" = "$(grep -c " PRODUCT('yarn " tiny.step)" ] || failed "a solid has no name"

# refused WORDS... : knitmech export with them is wrong input, and no file is left.
refused() {
  local complaint=$1
  shift
  knitmech export "$@" -o refused.out
  expect_code 2
  expect_in err "$complaint"
  expect_no_file refused.out
}
refused "a tube has 3 to 256 sides, not 2" tiny.toml -f stl --sides 2
refused "a tube has 3 to 256 sides, not 257" tiny.toml -f gltf --sides 257
refused "sides" tiny.toml -f obj --sides round
refused "is no folder of a run" tiny.toml -f stl --frame 0
refused "is no folder of a run" tiny.toml -f vtp --strain 0.01
refused "99" results/tiny -f gltf --frame 99
refused "has no frames" results/tiny -f abaqus --frame 1
refused "excludes" results/tiny -f gltf --frame 1 --strain 0.01
refused "there is no format" tiny.toml -f iges
knitmech export tiny.toml -f gltf -o no/such/folder/tiny.glb
expect_code 4
cp tiny.toml before.toml
knitmech export tiny.toml -f csv -o tiny.toml
expect_code 2
expect_same tiny.toml before.toml
finish
