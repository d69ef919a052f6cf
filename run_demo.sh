#!/usr/bin/env bash
# Installs what is missing, builds KnitMech and runs the main example: a jersey of 9 wales and 15 courses, pulled wale-wise.
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/tools/set_up.sh"

install_packages
say "Building KnitMech."
configure release
build release knitmech

say "Running examples/02-wale-tension/case.toml."
exec build/release/knitmech run examples/02-wale-tension/case.toml -o "$project_dir/results/02-wale-tension"
