# The CalculiX decks, run by ccx beside KnitMech: a loop without contact, as solids and as beams, and two arcs of yarn
# hooked into each other.
. "$(dirname "$0")/expect.sh" "$@"
command -v ccx >/dev/null || { echo "ccx is missing; the Debian package calculix-ccx has it"; exit 1; }
export OMP_NUM_THREADS=1

# The pull at the end of a step in a deck's .dat file [N].
pull_of() {
  awk '/TOP_HEADS and time  0.1000000E\+01/ { getline; getline; print $2 }' "$1.dat"
}
# Fails unless two numbers are within a share of the second.
expect_near() {
  awk -v a="$1" -v b="$2" -v share="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(b > 0 && d <= share * b) }' ||
    failed "$4: $1 is not within $3 of $2"
}
# Pulls a case in both programs: compare_pulls CASE SHARE
compare_pulls() {
  knitmech export "$1.toml" -f calculix-solids -o "$1.inp"
  expect_code 0
  ccx -i "$1" >"$1.log" 2>&1 || failed "ccx does not run $1.inp: $(tail -3 "$1.log")"
  grep -q '\*ERROR' "$1.log" && failed "ccx finds an error in $1.inp: $(grep -A2 -m1 '\*ERROR' "$1.log")"
  knitmech run "$1.toml" -o "$1" --no-pictures --quiet
  expect_code 0
  own=$(tail -1 "$1/history.csv" | cut -d, -f4)
  echo "pull of $1: CalculiX $(pull_of "$1") N, KnitMech $own N"
  expect_near "$(pull_of "$1")" "$own" "$2" "the pull of CalculiX beside KnitMech's"
}

# Quasi-static in KnitMech: a small mass at a slow, fixed speed.
"$PROGRAM" new | sed -e 's/^wales = 9/wales = 1/; s/^courses = 15/courses = 1/' \
  -e 's|^# out_of_plane = .*|out_of_plane = "0.02 /mm"|; s/^# elements_per_erc = 10/elements_per_erc = 40/' \
  -e 's/^# strain = 0.22/strain = 0.01/; s|^# speed = .*|speed = "1 mm/s"|; s/^# ramp = .*/ramp = "20 ms"/' \
  -e 's/^# mass_scaling = .*/mass_scaling = 20/; s/^# frames_at = .*/frames_at = [0.005]/' >loop.toml
compare_pulls loop 0.01

# As beams: the same loop; then a flat one, whose pull as a planar rod that is as stiff in shear as the yarn comes from
# shooting with Runge-Kutta over the exact arcs, 0.042949 N.
pull_beams() {
  knitmech export "$1.toml" -f calculix-beams -o "$1-beams.inp"
  expect_code 0
  ccx -i "$1-beams" >"$1-beams.log" 2>&1 || failed "ccx does not run $1-beams.inp: $(tail -3 "$1-beams.log")"
  grep -q '\*ERROR' "$1-beams.log" && failed "ccx finds an error in $1-beams.inp: $(grep -A2 -m1 '\*ERROR' "$1-beams.log")"
  echo "pull of $1 by beams: CalculiX $(pull_of "$1-beams") N, reference $2 N"
  expect_near "$(pull_of "$1-beams")" "$2" 0.01 "the pull of CalculiX' beams in $1"
}
pull_beams loop "$own"
sed '/^out_of_plane/d' loop.toml >flat.toml
pull_beams flat 0.042949
sed 's/^courses = 1/courses = 2/' loop.toml >loose.toml
knitmech export loose.toml -f calculix-beams -o loose.inp
expect_code 2
expect_no_file loose.inp

# One crossing: an arc that stands on its ends, and one at right angles to it that hangs in it beside its top, where
# contact is oblique and slips. The contact is a hundred times harder than usual, so that its own give counts in neither.
awk 'BEGIN {
  pi = atan2(0, -1); radius = 1.5; diameter = 0.12; x = 0.3; n = 60
  print "yarn,x_mm,y_mm,z_mm"
  for (i = 0; i <= n; ++i) {
    angle = pi - pi * i / n
    printf "standing,%.9f,%.9f,0\n", radius * cos(angle), radius * sin(angle)
  }
  share = 1 - 1.0005 * diameter / radius; y = sqrt(radius * radius - x * x) * share + radius
  for (i = 0; i <= n; ++i) {
    angle = pi + pi * i / n
    printf "hanging,%.9f,%.9f,%.9f\n", x * share, y + radius * sin(angle), radius * cos(angle)
  }
}' >arcs.csv
for friction in 0.0 0.1; do
  cat >"arcs-$friction.toml" <<END
title = "Two arcs of yarn hooked into each other"
[fabric]
yarns = "arcs.csv"
element_length = "0.12 mm"
grip_depth = "0.13 mm"
[yarn]
diameter = "0.12 mm"
density = "1140 kg/m^3"
youngs_modulus = "1700 MPa"
poissons_ratio = 0.39
[contact]
friction = $friction
stiffness = "1600 N/mm"
[test]
strain = 0.04
speed = "1 mm/s"
ramp = "10 ms"
[solver]
mass_scaling = 20
[output]
history_points = 40
frames_at = [0.02]
END
  compare_pulls "arcs-$friction" 0.02
done
awk -v with="$(pull_of arcs-0.1)" -v without="$(pull_of arcs-0.0)" 'BEGIN { exit !(with > 1.03 * without) }' ||
  failed "friction of 0.1 adds less than 3 % to the pull in CalculiX"

# A yarn that is no solid circle is refused, and so are grips that slide.
sed 's/^youngs_modulus = .*/axial_stiffness = "19 N"/; s/^poissons_ratio = .*/bending_stiffness = "5e-6 N mm^2"/' loop.toml >soft.toml
knitmech export soft.toml -f calculix-solids -o soft.inp
expect_code 2
expect_no_file soft.inp
sed 's/^\[test\]/[test]\ngrips = "sliding"/; s/^# grips = .*//' loop.toml >sliding.toml
knitmech export sliding.toml -f calculix-solids -o sliding.inp
expect_code 2
expect_in err "grips that slide"
expect_no_file sliding.inp
finish
