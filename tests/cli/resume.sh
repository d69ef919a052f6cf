# knitmech run --resume: runs that were killed or interrupted go on to the bitwise same result.
. "$(dirname "$0")/expect.sh" "$@"

# A test that takes half a second, with more checkpoints than a user would ask for.
tiny_case tiny.toml
sed -e 's/^strain = 0.02/strain = 0.12/; s/^mass_scaling = .*/mass_scaling = "auto"/; s/^history_points = .*/history_points = 200/' \
  -e 's/^frames_at = .*/frames_at = [0.02, 0.04, 0.06, 0.08, 0.1]/; s/^# structure = "basic"/structure = "adjusted"/' \
  -e 's/^# checkpoint_every = "60 s"/checkpoint_every = "10 ms"/' tiny.toml >case.toml
expect_in case.toml 'checkpoint_every = "10 ms"' 'structure = "adjusted"' 'mass_scaling = "auto"' 'strain = 0.12'
knitmech run case.toml -o whole --no-pictures
expect_code 0
expect_no_file whole/checkpoint.bin

without_wall_time() {
  sed '/"wall_s"/d; /"element_steps_per_s"/d' "$1/summary.json"
}
expect_same_run() {
  expect_same "$1/history.csv" whole/history.csv
  expect_same "$1/case.toml" whole/case.toml
  diff <(without_wall_time "$1") <(without_wall_time whole) || failed "$LAST: the summaries differ"
  diff -r "$1/frames" whole/frames || failed "$LAST: the frames differ"
  expect_no_file "$1/checkpoint.bin"
  [ -z "$(find "$1" -name '*.partial')" ] || failed "$LAST: a temporary file is left: $(find "$1" -name '*.partial')"
}
# Every file that is there is whole.
expect_whole_files() {
  if [ -e "$1/history.csv" ]; then
    awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' "$1/history.csv" || failed "history.csv has a line that is cut off"
    [ -z "$(tail -c 1 "$1/history.csv")" ] || failed "history.csv has a last line that is cut off"
  fi
  for file in "$1"/frames/*.vtp; do
    [ ! -e "$file" ] || tail -n 1 "$file" | grep -qF '</VTKFile>' || failed "$file is cut off"
  done
}

# Killed at any moment, again and again. Where no checkpoint was there yet the message says so.
# run_and_kill FILE PAUSE ARGUMENTS...: killed a pause after a file is there; it is over by itself before that or not.
run_and_kill() {
  local file=$1 pause=$2
  shift 2
  "$PROGRAM" "$@" --no-pictures >out 2>err &
  local process=$!
  until [ -e "$file" ] || ! kill -0 "$process" 2>/dev/null; do sleep 0.01; done
  sleep "$pause"
  kill -KILL "$process" 2>/dev/null
  wait "$process" 2>/dev/null
  CODE=$?
  LAST="knitmech $*, killed after $pause s"
}
can_go_on() {
  [ -e killed/checkpoint.bin ] && ! grep -qF '"completed"' killed/summary.json
}
RANDOM=4711
n_resumed=0
for file in . killed/frames killed/frames/frame_0001.vtp killed/checkpoint.bin killed/checkpoint.bin; do
  run_and_kill "$file" "0.$((RANDOM % 3))$((RANDOM % 10))" run case.toml -o killed
  for again in 1 2; do
    expect_whole_files killed
    can_go_on || break
    run_and_kill . "0.$((RANDOM % 3))$((RANDOM % 10))" run --resume killed
    n_resumed=$((n_resumed + 1))
  done
  if can_go_on; then
    knitmech run --resume killed --no-pictures
    expect_code 0
    expect_in out "goes on from" "Reached 12 % strain"
    n_resumed=$((n_resumed + 1))
  elif [ -e killed/summary.json ] && grep -qF '"running"' killed/summary.json; then
    knitmech run --resume killed
    expect_code 2
    expect_in err "ended before its first checkpoint.bin" "knitmech run \"killed/case.toml\""
    rm -r killed
  fi
  [ ! -e killed/summary.json ] || expect_same_run killed
  rm -rf killed
done
[ "$n_resumed" -gt 0 ] || failed "no run was killed where it could be resumed"

# Ctrl-C leaves a checkpoint even if none is asked for, and says how to go on.
sed 's/^checkpoint_every = .*/checkpoint_every = "0 s"/' case.toml >none.toml
"$PROGRAM" run none.toml -o stopped --quiet --no-pictures >out 2>err &
process=$!
until [ -s stopped/frames/frame_0002.vtp ] || ! kill -0 "$process" 2>/dev/null; do sleep 0.01; done
expect_no_file stopped/checkpoint.bin
kill -INT "$process"
wait "$process"
CODE=$?
LAST="knitmech run, interrupted"
expect_code 3
expect_in err "interrupted at" "to go on: knitmech run --resume stopped"
expect_in stopped/summary.json '"status": "interrupted"'
expect_file stopped/checkpoint.bin
cp -r stopped untouched

# The case must be the same, but for the interval.
sed -i 's/^friction = 0.1 /friction = 0.2 /' stopped/case.toml
knitmech run --resume stopped
expect_code 2
expect_in err "stopped/case.toml: contact.friction is 0.2, but was 0.1 when the run began"
sed -i 's/^friction = 0.2 /friction = 0.1 /; s/^checkpoint_every = .*/checkpoint_every = "10 ms"/' stopped/case.toml
knitmech run --resume stopped --json --no-pictures
expect_code 0
expect_in out '"status": "completed"' '"folder": "stopped"'
cp whole/case.toml stopped/case.toml
expect_same_run stopped

# Nothing to resume.
knitmech run --resume stopped
expect_code 2
expect_in err 'The run in "stopped" is complete; there is nothing to resume.'
knitmech run --resume nowhere
expect_code 2
expect_in err '"nowhere" is no folder of a KnitMech run'
knitmech run
expect_code 2
expect_in err "CASE is required"
knitmech run case.toml --resume stopped
expect_code 2
expect_in err "excludes"

# Damaged: one byte, or cut off anywhere.
size=$(stat -c %s untouched/checkpoint.bin)
for length in 0 10 60 $((size / 2)) $((size - 1)); do
  cp untouched/checkpoint.bin damaged.bin
  truncate -s "$length" untouched/checkpoint.bin
  knitmech run --resume untouched --no-pictures
  expect_code 2
  expect_in err 'The run in "untouched" cannot go on: its checkpoint.bin is damaged; start it anew'
  mv damaged.bin untouched/checkpoint.bin
done
printf 'x' | dd of=untouched/checkpoint.bin bs=1 seek=$((size / 3)) conv=notrunc status=none
knitmech run --resume untouched
expect_code 2
expect_in err "is damaged"
expect_in untouched/summary.json '"status": "interrupted"'

# A new run in the folder takes the old checkpoint away.
knitmech run case.toml -o untouched --no-pictures
expect_code 0
expect_same_run untouched

# The pictures of frames from before the checkpoint are there as well: drawn before it counts. A test of minutes.
sed 's/^mass_scaling = .*/mass_scaling = 1/; s/^speed = .*/speed = "0.2 mm\/s"/' case.toml >long.toml
"$PROGRAM" run long.toml -o pictured --quiet &
process=$!
until [ -s pictured/checkpoint.bin ] || ! kill -0 "$process" 2>/dev/null; do sleep 0.01; done
kill -KILL "$process"
wait "$process" 2>/dev/null
LAST="knitmech run, killed while it drew"
expect_file pictured/pictures/frame_0000.png
cp pictured/checkpoint.bin first.bin
"$PROGRAM" run --resume pictured --quiet 2>err &
process=$!
while cmp -s pictured/checkpoint.bin first.bin && kill -0 "$process" 2>/dev/null; do sleep 0.01; done
kill -INT "$process"
wait "$process"
CODE=$?
LAST="knitmech run --resume, interrupted"
expect_code 3
expect_in err "interrupted at" "to go on: knitmech run --resume pictured"
for file in force-strain.svg frame_0000.png frame_0001.png; do expect_file "pictured/pictures/$file"; done
finish
