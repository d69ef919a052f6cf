#!/usr/bin/env bash
# The manual can be built, strictly, and tools/check_manual finds nothing wrong with it; and it would: each kind of mistake, put
# into a copy of a good small manual, is named.
#   manual_test.sh PROJECT_FOLDER SCRATCH_FOLDER
set -euo pipefail
project=$1
scratch=$2
fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }

"$project/tools/manual" || fail "the manual cannot be built"
"$project/tools/check_manual" "$project/build/manual" || fail "the manual is not right"
for page in index docs/guide docs/studies docs/tutorials/friction-study docs/theory; do
  [[ -s $project/build/manual/$page.html ]] || fail "the manual has no page $page"
done
grep -q '"location":"docs/guide.html' "$project/build/manual/search/search_index.js" || fail "the search does not know the guide"

# given_a_manual HTML: a page that leads to another one, with HTML in it
given_a_manual() {
  rm -rf -- "$scratch"
  mkdir -p -- "$scratch/docs"
  printf '<p>Text <a href="docs/other.html#there">link</a> <a href="https://toml.io">abroad</a></p>%s' "$1" >"$scratch/index.html"
  printf '<h2 id="there">A place</h2><a href="../index.html">back</a>' >"$scratch/docs/other.html"
}
then_it_reports() {
  local said status=0
  said=$("$project/tools/check_manual" "$scratch") || status=$?
  [[ $status == 1 && $said == "$1" ]] || fail "expected \"$1\", got status $status and \"$said\""
}

given_a_manual ''
"$project/tools/check_manual" "$scratch" || fail "a good manual was refused"
given_a_manual '<img src="docs/none.png">'
then_it_reports 'index.html leads to docs/none.png, which is not there'
given_a_manual '<a href="docs/other.html#nowhere">x</a>'
then_it_reports 'index.html leads to docs/other.html#nowhere, but there is no such place on that page'
given_a_manual '<script src="https://example.org/x.js"></script>'
then_it_reports 'index.html loads https://example.org/x.js from the network'
given_a_manual '<link rel="stylesheet" href="//example.org/x.css">'
then_it_reports 'index.html loads //example.org/x.css from the network'
given_a_manual '<p>```</p>'
then_it_reports 'index.html shows ``` as text: a listing inside a list must be indented by four spaces'
given_a_manual '<p>These:
* one</p>'
then_it_reports 'index.html shows a list as text, for want of an empty line before it or four spaces after it: * one'
given_a_manual ''
printf '@import "https://example.org/font.css";' >"$scratch/style.css"
then_it_reports 'style.css loads something from the network'

echo "The manual is whole and asks nothing of the network."
