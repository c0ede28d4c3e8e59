#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The row as a picture: dominoes where the model has them, captions, moments, animations; what cannot be drawn.

load common

dir=$BATS_TEST_DIRNAME
root=$(cd "$dir/../.." && pwd)
csv() { "$DOMINO" -e "set output csv; $1"; }
one_line() { # PART COMMANDS: fails with one line, that has the part
    run -1 "$DOMINO" --keep-going -e "$2"
    same "$2: one line" 1 "${#lines[@]}"
    [[ $output == *"$1"* ]] || same "$2" "$1" "$output"
}
record="effect row \"$root/examples/record.csv\""

@test "draw: the dominoes of the row in the svg are where the model has them, standing, at a time and at the end" {
    cd "$BATS_TEST_TMPDIR" || false
    while IFS='|' read -r count row what; do
        "$DOMINO" -e "$row; $what > a.svg"
        xmllint --noout a.svg
        same "$row; $what" "$count" "$("$DOMINO" -e "set output json; $row; $what" | "$dir/polygons" a.svg)"
    done <<END
10|$record|draw
10|$record|draw at 3.9 s
10|$record|draw at domino 8
10|$record|draw at end
12|set r 1; effect row 12; effect push 5|draw at 0.2
5|set r 1.4; effect row 5; effect friction 0.2; effect slope 1 deg|draw at domino 4
200|set r 1; effect row 200|draw
END
}

@test "draw: no text of the svg is written over another, and a height that repeats is written once" {
    cd "$BATS_TEST_TMPDIR" || false
    for row in "$record" 'set r 1.5; effect row 12' 'set q 4; set r 1.7; effect row 8' 'set r 1; effect row 60; effect push 3'; do
        "$DOMINO" -e "$row; draw > a.svg"
        "$dir/labels" a.svg >texts || same "$row" 'texts apart' "$(cat texts)"
        [ "$(grep -c ' 4.8 cm$' texts)" -lt 2 ]
        same "$row: the tape begins at domino 1" '(nothing)' "$(cut -d ' ' -f 5- texts | grep '^-[0-9]')"
    done
}

@test "draw: data of the row stands as 'row' says, leans on the tape measure, and moves in time" {
    "$DOMINO" -e "set output json; $record; row" >"$BATS_TEST_TMPDIR/row"
    "$DOMINO" -e "set output json; $record; draw" >"$BATS_TEST_TMPDIR/draw"
    python3 - "$BATS_TEST_TMPDIR/row" "$BATS_TEST_TMPDIR/draw" <<'END'
import json, sys
row, draw = ([r for r in map(json.loads, open(path)) if "i" in r or "gap" in r] for path in sys.argv[1:])
at = 0
assert len(row) == len(draw) == 10
for k, (own, seen) in enumerate(zip(row, draw)):
    at += own["gap"] if k else 0
    assert seen["i"] == k + 1 and seen["theta"] == 0 and abs(seen["foot_back_x"] - at) < 1e-12
    at += own["thickness"]
    assert abs(seen["x"] - at) < 1e-12 and abs(seen["top_front_z"] - own["height"]) < 1e-12
END
    # When domino 8 is hit, domino 7 touches it: as far up as the cosine of its tilt says.
    hit=$(csv "$record; fall" | awk -F, '$1 == 8 { print $3 }')
    same 'a time or its domino' "$(csv "$record; draw at domino 8" | cut -d, -f 4 | cut -c 1-9)" \
        "$(csv "$record; draw at $hit s" | cut -d, -f 4 | cut -c 1-9)"
    csv "$record; draw at domino 8" | awk -F, '$1 == 7 { seventh = $4 } $1 == 8 { eighth = $4 } NR > 9 && $4 != 0 { bad = 1 }
        END { exit bad || eighth != 0 || !(sin(seventh) * 1.9 - 0.64 < 1e-9 && sin(seventh) * 1.9 - 0.64 > -1e-9) }'
    # Each tilt grows with time.
    for t in 1 2 3 4 5 6 7; do csv "$record; draw at $t" | sed 1d | cut -d, -f 4 | paste -sd ' ' -; done |
        awk '{ for (k = 1; k <= 10; k++) { if ($k < before[k]) bad = 1; moved += $k > before[k]; before[k] = $k } } END { exit bad || moved < 20 }'
}

@test "draw: captions say how the row ends, which domino is the weakest, and what falls" {
    cd "$BATS_TEST_TMPDIR" || false
    while IFS='|' read -r row what words; do
        "$DOMINO" -e "$row; $what > a.svg; $what > b.txt"
        for file in a.svg b.txt; do
            grep -qF -- "$words" <(tr '\n' ' ' <"$file") || same "$row; $what" "$words" "$(cat "$file")"
        done
    done <<END
$record|draw|10 dominoes, 24 cm to 5.5 m tall, on 8.85 m of floor.
$record|draw|All 10 fall: the last lies 7.65 s after the first hit.
$record|draw|Weakest: domino 8 (
$record|draw at domino 8|3.348 s after the first hit: domino 8 falls, 2 still stand.
$record|draw at -0.1|0.100 s before the first hit: domino 1 falls, 9 still stand.
$record|draw at end|all lie.
set r 1.6; effect row 12|draw|stops the row: it has 96 % of the energy that it needs.
set r 1.6; effect row 12|draw at end|the row has ended at domino 2, 10 still stand.
set s 0.9; set r 1.2; effect row 4|draw|The row ends at domino 1 (
effect row 1; effect push 5|draw at end|it lies.
END
    share=$(json 'set r 1.6; effect row 12; fall' | tail -n 1)
    awk -v k="$(values kinetic <<<"$share")" -v b="$(values barrier <<<"$share")" 'BEGIN { p = 100 * k / b; exit !(p > 95.5 && p < 96.5) }'
    # A picture is nothing but a picture.
    for ending in svg png pdf; do
        same "silent, $ending" '(nothing)' "$("$DOMINO" -e "$record; draw > a.$ending; draw train > b.$ending" 2>&1)"
        "$DOMINO" -e "$record; draw 0.3 > c.$ending" 2>said
        grep -q 'endless train' said
        run -1 grep -qa 'endless train at these' c.$ending
    done
    xmllint --noout a.svg b.svg c.svg
}

@test "draw: 'train' is the endless train, with a row and without" {
    plain=$("$DOMINO" -e 'draw 0.3')
    same 'with a row' "$plain" "$("$DOMINO" -e 'effect row 5; draw train 0.3')"
    same 'without' "$plain" "$("$DOMINO" -e 'draw train 0.3')"
    differ 'the row' "$plain" "$("$DOMINO" -e 'effect row 5; draw')"
    same forces "$("$DOMINO" -e 'draw forces')" "$("$DOMINO" -e 'effect row 5; draw train forces')"
}

@test "draw: the row in characters has every domino, fits the terminal, and needs no gnuplot" {
    mkdir "$BATS_TEST_TMPDIR/empty"
    run -0 env PATH="$BATS_TEST_TMPDIR/empty" "$DOMINO" -e "$record; draw"
    [ "${#lines[@]}" -le 23 ]
    awk 'length > 79 { exit 1 }' <<<"$output"
    same 'no blanks at the ends' '(nothing)' "$(grep ' $' <<<"$output")"
    for mark in 1 2 3 4 5 6 7 '\*' 9 0; do grep -q " *$mark" <<<"$(sed -n '4,/ 0 -/p' <<<"$output")"; done
    grep -q '^domino  1 .* 10$' <<<"$output"
    # To scale: domino 10 is 5.5 / 2.9 times as tall as domino 8, a line being 2 columns.
    awk '/0000/ { tall++ } /\*\*\*/ { eighth++ } END { exit !(tall / eighth > 1.6 && tall / eighth < 2.2) }' <<<"$output"
    differ 'it falls' "$output" "$("$DOMINO" -e "$record; draw at 4")"
}

@test "draw: on a terminal with UTF-8 the row is of braille, in colour, and has its size" {
    terminal() { env -u NO_COLOR -u DOMINO_GRAPHICS LC_ALL=C.UTF-8 TERM=xterm-256color "$@" python3 "$dir/terminal.py" 100 30 '62;22' "$DOMINO" -e "$record; draw at 5"; }
    terminal >"$BATS_TEST_TMPDIR/seen"
    grep -q $'\u28ff' "$BATS_TEST_TMPDIR/seen" || same braille 'a full cell' "$(cat "$BATS_TEST_TMPDIR/seen")"
    grep -q $'\e\[' "$BATS_TEST_TMPDIR/seen"
    grep -q 'Weakest: domino 8 (red)' "$BATS_TEST_TMPDIR/seen"
    lines=$(wc -l <"$BATS_TEST_TMPDIR/seen")
    [ "$lines" -le 29 ] && [ "$lines" -ge 15 ]
    sed 's/\x1b\[[0-9;]*m//g; s/<asked>//' "$BATS_TEST_TMPDIR/seen" | python3 -c 'import sys; widths = [len(l.rstrip("\n")) for l in sys.stdin]; sys.exit(not 85 < max(widths) < 100)'
    terminal NO_COLOR=1 >"$BATS_TEST_TMPDIR/grey"
    grep -q 'Weakest: domino 8 (filled)' "$BATS_TEST_TMPDIR/grey"
    same 'no colour' 0 "$(grep -c $'\e\[[0-9]' "$BATS_TEST_TMPDIR/grey")"
    terminal LC_ALL=C | grep -q 'Weakest: domino 8 (\*)'
}

@test "draw: every domino of a row of 14 has its number and its height in the picture, or in the line that says which do not" {
    cd "$BATS_TEST_TMPDIR" || false
    local row sentence numbers
    while IFS='|' read -r row sentence numbers; do
        "$DOMINO" -e "$row; draw > a.svg"
        "$dir/labels" a.svg | cut -d ' ' -f 5- >texts
        same "$row" "$sentence" "$(grep '^Too small' texts)"
        for k in $numbers; do
            grep -qx "$k" texts || same "$row" "domino $k" "$(cat texts)"
        done
    done <<'END'
effect row 14|Too small for labels: domino 1 (4.8 cm), 3 to 6 (10.8 cm to 36.5 cm).|2 7 8 9 10 11 12 13 14
set r 1.3; effect row 14|Too small for labels: domino 1 (4.8 cm), 3 and 4 (8.11 cm and 10.5 cm).|2 5 6 7 8 9 10 11 12 13 14
set r 1; effect row 14; effect push 3|(nothing)|1 2 3 4 5 6 7 8 9 10 11 12 13 14
END
}

@test "animate: the row in real time from before the first hit to the end, held for a second" {
    cd "$BATS_TEST_TMPDIR" || false
    same silent '(nothing)' "$("$DOMINO" -e "$record; animate a.gif rate 10" 2>&1)"
    read -r width height frames delay rest <<<"$("$dir/gif" a.gif)"
    same 'one delay of a tenth of a second' '10 ' "$delay $rest"
    [ "$width" -eq 640 ] && [ "$height" -ge 170 ] && [ "$(stat -c %s a.gif)" -lt 300000 ]
    csv "$record; animate a.gif rate 10" >data
    same keys 'time,domino,theta' "$(head -n 1 data)"
    same 'a frame each row, and ten more' "$frames" "$(($(wc -l <data) - 1 + 10))"
    # Equally far apart, up to the end, which is that of 'fall'.
    awk -F, -v end="$(json "$record; verdict" | values seconds)" 'NR == 2 && !($1 < 0) { bad = 1 }
        NR > 3 && before < end - 0.1 { d = $1 - before - 0.1; if (d > 1e-9 || d < -1e-9) bad = 1 }
        NR > 2 && $2 < domino { bad = 1 } { before = $1; domino = $2 }
        END { d = before / end - 1; exit bad || domino != 10 || d > 1e-9 || d < -1e-9 }' data
    # A push starts the clock; half as fast takes twice as many frames.
    set_push='set r 1; effect row 12; effect push 6'
    same 'from the push' 0 "$(csv "$set_push; animate a.gif" | sed -n '2s/,.*//p')"
    "$DOMINO" -e "$set_push; animate a.gif speed 0.5; animate b.gif speed 0.25"
    read -r _ _ fast _ <<<"$("$dir/gif" a.gif)"
    read -r _ _ slow _ <<<"$("$dir/gif" b.gif)"
    awk -v a=$((fast - 25)) -v b=$((slow - 25)) 'BEGIN { exit !(b / a > 1.9 && b / a < 2.1) }'
    # Also a row that stops, and one whose view follows the front.
    "$DOMINO" -e 'set r 1.6; effect row 12; animate a.gif; set r 1.5; effect row 12; animate b.gif rate 5'
    "$dir/gif" a.gif
    "$dir/gif" b.gif
    same 'the train, with a row on' "$(csv 'animate a.gif 2')" "$(csv 'effect row 3; animate a.gif train 2')"
}

@test "animate: .webm and .mp4 by ffmpeg, which gets every frame as a png" {
    cd "$BATS_TEST_TMPDIR" || false
    mkdir bin none
    ln -s "$(command -v gnuplot)" none/gnuplot
    cat >bin/ffmpeg <<'END'
#!/bin/sh
echo "$@" >"$FRAMES.said"
cat >"$FRAMES"
echo made
END
    chmod +x bin/ffmpeg
    for ending in webm mp4; do
        FRAMES=$PWD/frames PATH=$PWD/bin:$PATH "$DOMINO" -e "set r 1; effect row 5; effect push 6; animate a.$ending rate 20"
        same "$ending" made "$(cat a.$ending)"
        grep -q -- '-framerate 100/5 .*-f '"$ending"' file:/proc/self/fd/1' frames.said
        frames=$(grep -aoc 'IHDR' frames)
        same 'a png each frame' "$(csv 'set r 1; effect row 5; effect push 6; animate a.gif rate 20' | sed 1d | wc -l)" \
            "$(($(grep -ao 'IEND' frames | wc -l) - 20))"
        rm a.$ending
        run -1 env PATH="$PWD/none" "$DOMINO" --keep-going -e "effect row 5; animate a.$ending"
        [[ $output == *".$ending needs ffmpeg, which is not installed: 'apt install ffmpeg', or a name that ends in .gif"* ]]
    done
    printf '#!/bin/sh\ncat >/dev/null\necho "Unknown encoder" >&2\nexit 1\n' >bin/ffmpeg
    run -1 env PATH="$PWD/bin:$PATH" "$DOMINO" --keep-going -e 'effect row 5; animate a.mp4 speed 10'
    [[ $output == *"ffmpeg did not make 'a.mp4': Unknown encoder"* ]]
    [ ! -e a.mp4 ]
}

@test "what cannot be drawn of a row: one line that says what works" {
    cd "$BATS_TEST_TMPDIR" || false
    one_line "'draw at' shows a moment of a row; first enter 'effect row N', for example 'effect row 10'" 'draw at 2 s'
    one_line "the motion ends at 7.648 s; 'draw at end' shows that" "$record; draw at 8 s > a.svg"
    one_line "there is no domino 11: this row has 10; 'draw at domino 10' shows the last" "$record; draw at domino 11"
    one_line 'there is no domino 0: this row has 10;' "$record; draw at domino 0"
    one_line 'there is no domino 2.5: this row has 10;' "$record; draw at domino 2.5"
    one_line "domino 5 is never hit: the row ends at domino 2; 'draw at end' shows that" 'set r 1.6; effect row 12; draw at domino 5'
    one_line "the clock starts at 0 s, with the push; 'draw at 0' shows that moment" 'effect row 5; effect push 5; draw at -1'
    one_line "the moment is a time in s, not a length; an example is 'draw at 2.5 s'" "$record; draw at 2 m"
    one_line 'the moment is missing; usage: draw, draw at 2.5 s, ' "$record; draw at"
    one_line "'never' is neither a value nor one of the words; usage: draw" "$record; draw at never"
    one_line "'2' is one argument too many; usage: draw" "$record; draw at end 2"
    one_line "the number of the domino is missing, as in 'draw at domino 8'" "$record; draw at domino"
    one_line "'a.mov' is not the name of an animation: use the ending .gif, .webm or .mp4" "$record; animate a.mov"
    one_line 'the speed is a number in 0.001 .. 1000; 1 is real time, 0.5 half as fast' "$record; animate a.gif speed 0"
    one_line 'the rate is a number of frames in a second in 1 .. 50' "$record; animate a.gif rate 1000"
    one_line 'at most 3000 are drawn; a larger speed' "$record; animate a.gif speed 0.01"
    one_line "'speed' and 'rate' are of a row; first enter 'effect row N'" 'animate a.gif speed 2'
    one_line "'quickly' is neither a value nor one of the words; usage: animate row.gif" "$record; animate a.gif quickly"
    same 'nothing is left' '(nothing)' "$(ls)"
}

@test "completion and help: the words of draw and animate, and no word twice" {
    complete() { "$DOMINO" -e "complete $1" | sort | paste -sd ' ' -; }
    same draw 'at forces train' "$(complete 'draw ')"
    same 'draw at' 'domino end' "$(complete 'draw at ')"
    same 'draw forces' '(nothing)' "$(complete 'draw forces ')"
    same 'draw train' forces "$(complete 'draw train ')"
    same 'animate a.gif' 'rate speed train' "$(complete 'animate a.gif ')"
    same 'animate a.gif speed 2' 'rate' "$(complete 'animate a.gif speed 2 r')"
    "$DOMINO" -e 'help animate' | tr '\n' ' ' | grep -q 'at most 9 can be seen *together at r = 1.5'
    one_line 'N is an integer in 1 .. 9, ' 'animate a.gif 10'
}

@test "where and draw agree on whether the walk still is in this train" {
    while IFS='|' read -r change; do
        theta=$(json "goto 0.2; $change; where" | values theta | tail -n 1)
        drawn=$(json "goto 0.2; $change; draw" | values theta | sed -n 2p)
        whole=$(json "goto 0.2; $change; draw" | grep '"i":0' | tail -n 1 | values theta)
        close "goto 0.2; $change" "${theta:-none}" "${whole:-none}"
    done <<'END'
set digits 4
effect friction 0.3
effect slope 1 deg
set r 1.4
set q hollow
set precision quad
END
    expects drawn "$drawn"
}

@test "the gallery has what examples/pictures.dom draws, and is small" {
    cd "$BATS_TEST_TMPDIR" || false
    "$DOMINO" -f "$root/examples/pictures.dom" >/dev/null
    same pictures "$(ls "$root/examples/pictures")" "$(ls)"
    for picture in *; do
        [ "$(stat -c %s "$root/examples/pictures/$picture")" -lt 300000 ]
    done
    for picture in *.svg; do xmllint --noout "$root/examples/pictures/$picture"; done
    for picture in *.gif; do same "$picture" "$("$dir/gif" "$root/examples/pictures/$picture")" "$("$dir/gif" "$picture")"; done
}
