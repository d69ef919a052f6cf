# Ctrl-C while a simulation runs: it ends cleanly and keeps what was computed.
. "$(dirname "$0")/expect.sh" "$@"

expect_clean_end_after() {
  "$PROGRAM" run "$CHECKOUT/examples/02-wale-tension/case.toml" -o run --no-pictures >out 2>err &
  local process=$!
  # The run is under way when its first frame is there.
  until [ -s run/frames/frame_0000.vtp ] || ! kill -0 "$process" 2>/dev/null; do sleep 0.1; done
  kill -s "$1" "$process"
  wait "$process"
  CODE=$?
  LAST="knitmech run, ended by $1"
  expect_code 3
  expect_in err "interrupted at" "kept in run"
  expect_in run/summary.json '"status": "interrupted"'
  expect_in run/history.csv "time_s"
  expect_file run/frames/frame_0001.vtp
  expect_file run/frames/contacts_0001.csv
  rm -r run
}
expect_clean_end_after INT
expect_clean_end_after TERM
finish
