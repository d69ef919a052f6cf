# knitmech completion: what the Tab key offers in each shell; and knitmech man.
. "$(dirname "$0")/expect.sh" "$@"
knitmech new jersey.toml
mkdir -p results/jersey
touch curve.csv notes.txt

# What bash offers for the last word of a command line.
offered() {
  bash --norc -c '
    source completion.bash
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    COMPREPLY=()
    _knitmech
    printf "%s\n" "${COMPREPLY[@]}"' bash "$@" >offered 2>offered.err
  expect_empty offered.err
}

knitmech completion bash
expect_code 0
cp out completion.bash
bash -n completion.bash || failed "bash does not read the completion"
offered knitmech ""
for command in $("$PROGRAM" --help | sed -n '/^Subcommands/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
  grep -qx "$command" offered || failed "bash does not offer the command $command"
done
offered knitmech exp
expect_in offered "export"
offered knitmech export -f aba
expect_in offered "abaqus"
offered knitmech export --for
expect_in offered "--format"
offered knitmech run ""
expect_in offered "jersey.toml" "results"
grep -q notes.txt offered && failed "bash offers notes.txt as a case"
offered knitmech run jersey.toml --threads ""
[ "$(tr -d '\n' <offered)" = "" ] || failed "bash offers $(cat offered) as a number of threads"
offered knitmech compare results/jersey re
expect_in offered "results"
offered knitmech render results/
expect_in offered "results/jersey"
offered knitmech render results/jersey --colour axial
expect_in offered "axial-force" "axial-strain"

# Every option that the help of a command tells is offered, and none besides.
for command in check run render export; do
  "$PROGRAM" "$command" --help | grep -o '^  -[-a-z,]*' | tr ',' '\n' | tr -d ' ' | sort -u >told
  offered knitmech "$command" -
  sort -u offered >offered.sorted
  expect_same offered.sorted told
done

knitmech completion zsh
expect_code 0
cp out _knitmech
zsh -n _knitmech || failed "zsh does not read the completion"
zsh -f -c 'fpath=($PWD $fpath); autoload -Uz compinit; compinit -D -u; [[ ${_comps[knitmech]} == _knitmech ]]' ||
  failed "zsh does not take the file for the completion of knitmech"

knitmech completion fish
expect_code 0
cp out knitmech.fish
export HOME="$PWD" XDG_CONFIG_HOME="$PWD" XDG_DATA_HOME="$PWD"
fish --no-config -c 'source knitmech.fish; complete -C "knitmech "' >offered || failed "fish does not read the completion"
expect_in offered "export" "check"
fish --no-config -c 'source knitmech.fish; complete -C "knitmech export -f "' >offered
expect_in offered "abaqus"
fish --no-config -c 'source knitmech.fish; complete -C "knitmech run "' >offered
expect_in offered "jersey.toml"

knitmech completion tcsh
expect_code 2
expect_in err "bash" "fish"

# The manual page, without a warning of groff.
knitmech man
expect_code 0
cp out knitmech.1
groff -man -Tutf8 -ww -z knitmech.1 2>warnings
expect_empty warnings
groff -man -Tascii -P-cbou knitmech.1 >page
expect_in page "EXIT STATUS" "--poissons-ratio" "export CASE" "One of: abaqus"
finish
