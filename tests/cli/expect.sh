# What the scripts of this folder share. They are called as: bash new.sh PROGRAM CHECKOUT
set -u
PROGRAM=$1
CHECKOUT=$2
FAILURES=0
FOLDER=$(mktemp -d)
trap 'rm -rf "$FOLDER"' EXIT
cd "$FOLDER" || exit 1

failed() {
  echo "FAILED: $*"
  FAILURES=$((FAILURES + 1))
}

# knitmech ARGUMENTS...: runs the program; leaves the files out and err, and its exit code in CODE.
knitmech() {
  "$PROGRAM" "$@" >"$FOLDER/out" 2>"$FOLDER/err"
  CODE=$?
  LAST="knitmech $*"
}

expect_code() {
  [ "$CODE" -eq "$1" ] || failed "$LAST: exit code $CODE instead of $1; $(cat "$FOLDER/err")"
}

# expect_in FILE WORDS...: each of the words stands in the file.
expect_in() {
  local file=$1
  shift
  for words in "$@"; do
    grep -qF -- "$words" "$file" || failed "$LAST: \"$words\" is not in $file: $(head -c 600 "$file")"
  done
}

expect_empty() {
  [ ! -s "$1" ] || failed "$LAST: $1 is not empty: $(head -c 300 "$1")"
}

expect_file() {
  [ -s "$1" ] || failed "$LAST: there is no $1"
}

expect_no_file() {
  [ ! -e "$1" ] || failed "$LAST: $1 is there"
}

expect_same() {
  cmp -s "$1" "$2" || failed "$LAST: $1 and $2 differ: $(diff "$1" "$2" | head -5)"
}

# The main case made so small that it is simulated at once: 3 x 2 stitches, 2 % strain.
tiny_case() {
  "$PROGRAM" new | sed -e 's/^wales = 9/wales = 3/; s/^courses = 15/courses = 2/' \
    -e 's/^# strain = 0.22/strain = 0.02/; s/^# speed = "5 mm\/s"/speed = "20 mm\/s"/' \
    -e 's/^# ramp = "0.5 s"/ramp = "10 ms"/; s/^# mass_scaling = "auto"/mass_scaling = 1e4/' \
    -e 's/^# frames_at = .*/frames_at = [0.01]/; s/^# history_points = 1000 /history_points = 20/' >"$1"
}

finish() {
  [ "$FAILURES" -eq 0 ] || exit 1
  echo "all as expected"
}
