# knitmech new: the commented case file.
. "$(dirname "$0")/expect.sh" "$@"

# It is written, and what is written can be checked.
knitmech new jersey.toml
expect_code 0
expect_in out "jersey.toml"
expect_in jersey.toml "[loop]" 'height = "7 mm"' "# R1: radius of the head arc" '# strain = 0.22'
knitmech check jersey.toml
expect_code 0

# A file that is there is never overwritten unasked.
echo "mine" >mine.toml
knitmech new mine.toml
expect_code 4
expect_in err "knitmech: error:" "mine.toml" "--force"
expect_in mine.toml "mine"
knitmech new --force mine.toml
expect_code 0
expect_same mine.toml jersey.toml

# Without a name it goes to standard output.
knitmech new
expect_code 0
expect_same out jersey.toml

# A folder that is not there, or is one.
knitmech new no/such/folder/jersey.toml
expect_code 4
expect_in err "no/such/folder/jersey.toml"
knitmech new "$FOLDER"
expect_code 4
expect_in err "is a folder"
finish
