# knitmech ui: the page is served, ends cleanly, and wrong words are answered.
. "$(dirname "$0")/expect.sh" "$@"

# The address that the program prints, in ADDRESS; its process in SERVER.
serve() {
  "$PROGRAM" ui --no-browser --port 0 "$@" >served 2>served.err &
  SERVER=$!
  for _ in $(seq 600); do
    ADDRESS=$(grep -o 'http:[^ ]*' served) && return
    kill -0 $SERVER 2>/dev/null || break
    sleep 0.1
  done
  failed "knitmech ui $*: no address; $(cat served served.err)"
}

# stop CODE: ends the program as Ctrl-C does.
stop() {
  kill -INT $SERVER
  wait $SERVER
  local code=$?
  [ $code -eq "$1" ] || failed "knitmech ui: exit code $code instead of $1; $(cat served.err)"
}

# A GET without any tool but bash: the status line and the body.
get() {
  local rest=${1#http://}
  local place=${rest%%/*}
  exec 3<>"/dev/tcp/${place%:*}/${place##*:}"
  printf 'GET /%s HTTP/1.1\r\nHost: %s\r\nConnection: close\r\n\r\n' "${rest#*/}" "$place" >&3
  cat <&3 >answer
  exec 3>&-
}

# It serves the page, only to those who know the address, and ends with 0.
serve
get "$ADDRESS"
expect_in answer "200 OK" "Content-Security-Policy"
get "${ADDRESS}api/program"
expect_in answer "200 OK" '"opened":{"case":null,"run":null}' "\"folder\":\"$FOLDER\""
get "${ADDRESS%/*/}/"
expect_in answer "403" "this address is not complete"
stop 0

# It begins with a case, or with a run; runs are beside the one that is named.
tiny_case jersey.toml
serve jersey.toml
get "${ADDRESS}api/program"
expect_in answer '"case":"jersey.toml"'
stop 0
mkdir elsewhere
mv jersey.toml elsewhere/
serve elsewhere/jersey.toml
get "${ADDRESS}api/program"
expect_in answer '"case":"elsewhere/jersey.toml"'
stop 0
mkdir inner
cd inner
serve ../elsewhere/jersey.toml
get "${ADDRESS}api/program"
expect_in answer '"case":"jersey.toml"' "\"folder\":\"$FOLDER/elsewhere\""
stop 0
cd ..
knitmech run elsewhere/jersey.toml -o results/tiny --quiet --no-pictures
expect_code 0
serve results/tiny
get "${ADDRESS}api/program"
expect_in answer '"run":"tiny"'
get "${ADDRESS}api/runs"
expect_in answer '"id":"tiny"' '"status":"completed"'
stop 0

# Wrong words.
expect_error() {
  local code=$1
  shift
  expect_code "$code"
  expect_in err "knitmech: error:" "$@"
  expect_empty out
}
knitmech ui nowhere.toml --no-browser
expect_error 4 "there is no such file"
knitmech ui elsewhere --no-browser
expect_error 2 "not of a run" "--folder"
knitmech ui results/tiny/history.csv --no-browser
expect_error 2 "no case file"
knitmech ui --folder nowhere --no-browser
expect_error 4 "is not a folder"
knitmech ui --port 70000 --no-browser
expect_error 2 "--port"
serve
port=${ADDRESS#http://127.0.0.1:}
knitmech ui --no-browser --port "${port%%/*}"
expect_error 2 "another program may"
stop 0
finish
