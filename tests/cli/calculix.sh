# The CalculiX deck, run by ccx: a loop of one stitch without contact is pulled, by solids and by KnitMech.
. "$(dirname "$0")/expect.sh" "$@"
command -v ccx >/dev/null || { echo "ccx is missing; the Debian package calculix-ccx has it"; exit 1; }
export OMP_NUM_THREADS=1

# Quasi-static in KnitMech: a small mass at a slow, fixed speed.
"$PROGRAM" new | sed -e 's/^wales = 9/wales = 1/; s/^courses = 15/courses = 1/' \
  -e 's|^# out_of_plane = .*|out_of_plane = "0.02 /mm"|; s/^# elements_per_erc = 10/elements_per_erc = 20/' \
  -e 's/^# strain = 0.22/strain = 0.01/; s|^# speed = .*|speed = "1 mm/s"|; s/^# ramp = .*/ramp = "20 ms"/' \
  -e 's/^# mass_scaling = .*/mass_scaling = 20/; s/^# frames_at = .*/frames_at = [0.005]/' >loop.toml

# The pull at the end of a step in a deck's .dat file [N].
pull_of() {
  awk '/TOP_HEADS and time  0.1000000E\+01/ { getline; getline; print $2 }' "$1.dat"
}
# Fails unless two numbers are within a share of the second.
expect_near() {
  awk -v a="$1" -v b="$2" -v share="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(b > 0 && d <= share * b) }' ||
    failed "$4: $1 is not within $3 of $2"
}

knitmech export loop.toml -f calculix-solids -o loop.inp
expect_code 0
ccx -i loop >ccx.log 2>&1 || failed "ccx does not run loop.inp: $(tail -3 ccx.log)"
grep -q '\*ERROR' ccx.log && failed "ccx finds an error in loop.inp: $(grep -A2 -m1 '\*ERROR' ccx.log)"
knitmech run loop.toml -o loop --no-pictures --quiet
expect_code 0
own=$(tail -1 loop/history.csv | cut -d, -f4)
expect_near "$(pull_of loop)" "$own" 0.03 "the pull of CalculiX beside KnitMech's"
echo "pull at 1 % strain: CalculiX $(pull_of loop) N, KnitMech $own N"

# A yarn that is no solid circle is refused.
sed 's/^youngs_modulus = .*/axial_stiffness = "19 N"/; s/^poissons_ratio = .*/bending_stiffness = "5e-6 N mm^2"/' loop.toml >soft.toml
echo >>soft.toml
knitmech export soft.toml -f calculix-solids -o soft.inp
expect_code 2
expect_no_file soft.inp
finish
