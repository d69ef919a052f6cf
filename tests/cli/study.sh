# knitmech study: many cases from one file; what is done is not done again, what cannot be is said and kept.
. "$(dirname "$0")/expect.sh" "$@"

tiny_case base.toml
cat >study.toml <<'END'
title = "Two loops and one that cannot be"
base = "base.toml"
strains = [0.01]
[loop.height]
values = ["7 mm", "7.1 mm", "4 mm"]
END

# The plan alone.
knitmech study study.toml --list
expect_code 0
expect_in out "3 runs" "height-7.1mm: loop.height = 7.1 mm"
expect_no_file results

# The whole study: the impossible case does not stop the others, and the exit code tells of it.
knitmech study study.toml -o out-study --jobs 2
expect_code 3
expect_in out "2 of 3 runs completed, 1 impossible" "do not interlock"
expect_in out-study/table.csv "height-7mm,completed,7 mm" "height-4mm,impossible,4 mm" "force_N_at_1_percent"
expect_file out-study/runs/height-7mm/history.csv
expect_no_file out-study/runs/height-4mm
cp out-study/table.csv first.csv

# Again: nothing is run.
knitmech study study.toml -o out-study
expect_in out "was done before"
expect_same out-study/table.csv first.csv

# As JSON, for scripts.
knitmech study study.toml -o out-study --json
expect_in out '"format": "knitmech-study"' '"standing": "impossible"'

# Mistakes are one sentence, and nothing is written.
echo 'base = "nowhere.toml"' >wrong.toml
knitmech study wrong.toml -o wrong
expect_code 4
expect_in err "nowhere.toml"
expect_no_file wrong
printf 'base = "base.toml"\n[loop.hight]\nvalues = [1]\n' >wrong.toml
knitmech study wrong.toml -o wrong
expect_code 2
expect_in err "wrong.toml, line 2" "did you mean loop.height?"
mkdir mine && echo thesis >mine/thesis.txt
knitmech study study.toml -o mine
expect_code 2
expect_in err "not a KnitMech study"
expect_file mine/thesis.txt

finish
