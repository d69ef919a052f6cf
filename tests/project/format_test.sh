#!/usr/bin/env bash
# tools/format --check accepts a formatted file and names one that is not, and leaves both as they are.
#   format_test.sh PROJECT_FOLDER SCRATCH_FOLDER
set -euo pipefail
project=$1
scratch=$2
fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }

rm -rf -- "$scratch"
mkdir -p -- "$scratch/src/knit"
cp -- "$project/.clang-format" "$scratch"

printf 'int n_wales = 9;\n' >"$scratch/src/knit/good.cpp"
"$project/tools/format" --check "$scratch" || fail "a formatted file was refused"

printf 'int   n_courses=15 ;\n' >"$scratch/src/knit/bad one.h"
status=0
said=$("$project/tools/format" --check "$scratch" 2>&1) || status=$?
[[ $status == 1 ]] || fail "an unformatted file was accepted (status $status)"
[[ $said == "src/knit/bad one.h is not in the project's format; tools/format puts it right" ]] || fail "it said: $said"
[[ $(<"$scratch/src/knit/bad one.h") == 'int   n_courses=15 ;' ]] || fail "the check changed a file"

echo "tools/format --check tells formatted files from others."
