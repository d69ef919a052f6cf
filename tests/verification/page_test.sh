#!/usr/bin/env bash
# docs/verification.md has the text of page.md and names every case and quantity that the tests recorded, in their order.
# The numbers may differ: they change in the last digits with the compiler.
#   page_test.sh PROJECT_FOLDER ROWS_FOLDER
set -euo pipefail
project=$1
rows=$2
generated=$("$project/tools/verification_page" --print "$rows")
named() { cut -d '|' -f 1-3; }
if ! diff <(named <"$project/docs/verification.md") <(named <<<"$generated"); then
  echo "FAILED: docs/verification.md (<) is not the page of these tests (>); tools/verification_page writes it anew" >&2
  exit 1
fi
echo "docs/verification.md names every case."
