# knitmech render: pictures of a finished run.
. "$(dirname "$0")/expect.sh" "$@"
tiny_case tiny.toml
knitmech run tiny.toml --no-pictures
expect_code 0

# The size of a PNG as "WIDTH HEIGHT".
size_of() {
  od -An -tu1 -j16 -N8 "$1" | awk '{ print $1 * 16777216 + $2 * 65536 + $3 * 256 + $4, $5 * 16777216 + $6 * 65536 + $7 * 256 + $8 }'
}

# The last frame, from the front, into the pictures of the run.
knitmech render results/tiny --height 200
expect_code 0
expect_in out "Wrote results/tiny/pictures/frame_0002-plain-front.png: frame 2, 2 % strain, "
expect_file results/tiny/pictures/frame_0002-plain-front.png

# A frame by its strain, with colours and a view.
knitmech render results/tiny --strain 0.012 --color contact --view oblique --same-range --width 320 --height 240 -o a.png
expect_code 0
expect_in out "Frame 1 at 1.01 % strain is the stored one nearest to 1.2 %." "Wrote a.png: frame 1, 1.01 % strain"
[ "$(size_of a.png)" = "320 240" ] || failed "a.png is $(size_of a.png) px, not 320 240"
knitmech render results/tiny --frame 1 --colour contact --view oblique --same-range --width 320 --height 240 -o b.png
expect_code 0
expect_same a.png b.png

# A part of the fabric, with a range.
knitmech render results/tiny --window 0 0.5 0.5 1 --colour torque --range -0.001 0.001 --height 200 -o part.png
expect_code 0
expect_file part.png

# A map of the contacts and the fabric from the side, as drawings.
knitmech render results/tiny --contact-map
expect_code 0
expect_in results/tiny/pictures/frame_0002-contact-map.svg "x [mm]" "y [mm]" "stick: " "slip: " "2 % strain, "
knitmech render results/tiny --side-profile --frame 0 -o side.svg
expect_code 0
expect_in side.svg "z [mm]" "highest z" "0 % strain, "

# Films: as many pictures as are asked for, and a last one that stays.
pictures_in() {
  grep -ao ANMF "$1" | wc -l
}
knitmech render results/tiny --animate stretch --colour contact --seconds 0.5 --fps 10 --height 150 -o stretch.webp
expect_code 0
expect_in out "3 frames are stored" "output.frames_at" "Wrote stretch.webp: "
[ "$(pictures_in stretch.webp)" -eq 5 ] || failed "stretch.webp has $(pictures_in stretch.webp) pictures, not 5"
knitmech render results/tiny --animate turn --seconds 0.4 --fps 10 --height 150
expect_code 0
film=results/tiny/pictures/film-turn-plain-front-frame_0002.webp
[ "$(pictures_in $film)" -eq 4 ] || failed "$film has $(pictures_in $film) pictures, not 4"
knitmech render results/tiny --animate turn -o film.gif
expect_code 2
expect_in err '"film.gif"' ".webp"
knitmech render results/tiny --animate turn --seconds 0 -o film.webp
expect_code 2
knitmech render results/tiny --animate turn --fps 1000 -o film.webp
expect_code 2
knitmech render results/tiny --animate turn --contact-map
expect_code 2

# What cannot be drawn.
knitmech render nothing
expect_code 2
expect_in err "There is no folder nothing."
knitmech render .
expect_code 2
expect_in err "is not the folder of a run"
knitmech render results/tiny --frame 9
expect_code 2
expect_in err "has no frame 9; it has 0 to 2"
knitmech render results/tiny --colour contakt
expect_code 2
expect_in err 'there is no colour "contakt"; did you mean contact?'
knitmech render results/tiny --view up
expect_code 2
expect_in err "front, back, side, top or oblique"
knitmech render results/tiny -o picture.jpg
expect_code 2
expect_in err '"picture.jpg"' ".png"
knitmech render results/tiny --range 1 0 --colour torque -o c.png
expect_code 2
knitmech render results/tiny -o no/such/folder/c.png
expect_code 4
head -c 3000 results/tiny/frames/frame_0002.vtp >cut.vtp
mv cut.vtp results/tiny/frames/frame_0002.vtp
knitmech render results/tiny
expect_code 2
expect_in err "results/tiny/frames/frame_0002.vtp was cut off"

# A new run takes the pictures of the old one away, and nothing else.
echo "mine" >results/tiny/pictures/notes.txt
knitmech run tiny.toml --no-pictures
expect_code 0
[ "$(ls results/tiny/pictures)" = "notes.txt" ] || failed "pictures/ holds $(ls results/tiny/pictures)"
finish
