#!/usr/bin/env bash
# check_layers accepts the includes that the layers allow, and names the file and line of any other.
#   check_layers_test.sh CHECK_LAYERS SCRATCH_FOLDER
set -euo pipefail
check_layers=$1
scratch=$2

# A small source tree in which all is well.
given_a_good_tree() {
  rm -rf -- "$scratch"
  mkdir -p -- "$scratch"/{base,knit,model}
  printf '#pragma once\n#include <string>\n' >"$scratch/base/errors.h"
  printf '#pragma once\n#include "base/errors.h"\n' >"$scratch/knit/loop.h"
  printf '#include "knit/loop.h"\n\n#include <fmt/core.h>\n' >"$scratch/knit/loop.cpp"
  printf '#include "base/errors.h"\n#include "knit/loop.h"\n' >"$scratch/model/model.h"
}

then_it_passes() {
  "$check_layers" "$scratch" || { echo "FAILED: $1: a good tree was refused" >&2; exit 1; }
}

# then_it_reports CASE MESSAGE: exit status 1, and this message alone
then_it_reports() {
  local said status=0
  said=$("$check_layers" "$scratch" 2>&1) || status=$?
  [[ $status == 1 && $said == "$2" ]] || { printf 'FAILED: %s: expected "%s", got status %d and "%s"\n' "$1" "$2" "$status" "$said" >&2; exit 1; }
}

given_a_good_tree
then_it_passes "only allowed includes"

given_a_good_tree
printf '#include "model/model.h"\n' >>"$scratch/knit/loop.cpp"
then_it_reports "against the arrows" 'src/knit/loop.cpp:4: knit may not include model/model.h'

given_a_good_tree
printf '  #  include <knit/loop.h>\n' >>"$scratch/base/errors.h"
then_it_reports "in angle brackets" 'src/base/errors.h:3: base may not include knit/loop.h'

given_a_good_tree
printf '#include "loop.h"\n' >"$scratch/knit/stitch.h"
then_it_reports "without the folder" 'src/knit/stitch.h:1: loop.h is not the path of a file from src/ on; libraries are written in <>'

given_a_good_tree
printf '#include <knit/../model/model.h>\n' >>"$scratch/knit/loop.cpp"
then_it_reports "around the corner" 'src/knit/loop.cpp:4: knit/../model/model.h is not the path of a file from src/ on; libraries are written in <>'

given_a_good_tree
mkdir -- "$scratch/misc"
then_it_reports "a folder of no layer" 'src/misc: a folder without a line in the table of tools/check_layers'

echo "check_layers tells good trees from bad ones."
