#!/usr/bin/env bash
# Installs what is missing, builds KnitMech and runs all its tests; those of the code's layers and format are among them.
# Arguments go to ctest: ./run_tests.sh -R knit
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/tools/set_up.sh"

install_packages
say "Building KnitMech and its tests."
configure release
build release
ctest --preset release --output-on-failure -j2 "$@"
