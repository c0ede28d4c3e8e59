#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of trains and rows: positions of dominoes, captions, files, and errors.

load ../shell/common

record="effect row \"$root/examples/record.csv\""

# bats test_tags=rows
@test "corners of a picture are 0 where only rounding errors are left" {
    same tiny '(nothing)' "$("$DOMINO" -n -e 'set output csv; set header off; effect row 4; draw; draw at end' |
        tr , '\n' | awk '$1 != 0 && $1 < 1e-12 && $1 > -1e-12')"
}

# bats test_tags=rows
@test "draw: rounded edges touch the back of their leader; files show them as arcs, captions name the radius" {
    for scene in 'draw 0' 'draw 0.3' 'set r 1.2; effect friction 0.1; draw 0.1'; do
        "$DOMINO" -e "set output csv; set digits 17; set header off; effect edges 0.05; $scene" 2>forces.txt |
            awk -F, '$11 + 0 == $11 && $12 != "" { n++; x = $9 - $7; z = $10 - $8
                off = (x * ($12 - $8) - z * ($11 - $7)) / $2
                if (off > 1e-9 || off < -1e-9) { print; bad = 1 } }
                END { exit bad || n < 3 }'
    done
    command -v gnuplot >/dev/null || skip 'gnuplot is not installed'
    "$DOMINO" -e 'draw > sharp.svg; effect edges 0.02; draw > round.svg; effect row 5; draw > row.svg; draw at end > end.svg'
    [ "$(wc -c <round.svg)" -gt "$(wc -c <sharp.svg)" ]
    grep -q 'edges 0.02 h' round.svg
    grep -q 'edges rounded by 0.02 of the height' row.svg
    same 'points of a polygon' 17 "$(tr '\n' ' ' <end.svg | grep -o "<polygon [^>]*" | sed -n "s/.*points = '\([^']*\)'.*/\1/p" | head -n 1 | wc -w)"
}

@test "draw: in characters, to scale, in 80 columns and 24 rows, with and without gnuplot" {
    mkdir empty
    run -0 env PATH="$PWD/empty" "$DOMINO" -e 'draw 0.3'
    [ "${#lines[@]}" -ge 15 ]
    for words in 'theta = 0.3 rad (17.19 deg)' 'to scale' '^   \[h\] ' '^domino .* next$' '0: head' '#: the next' '0000' '111' '###'; do
        grep -q -- "$words" <<<"$output" || same draw "$words" "$output"
    done
    [ "${#lines[@]}" -le 23 ]
    awk 'length > 79 { exit 1 }' <<<"$output"
    same 'no blanks at the ends' '(nothing)' "$(grep ' $' <<<"$output")"
    "$DOMINO" -e 'draw forces' | grep -q "contact forces, divided by the pushed domino's weight: 0: "
    same 'a safe session draws in characters' "$output" "$("$DOMINO" --safe -e 'draw 0.3')"
    # Measured in lines, the next domino is about 1.5 times as tall as the head.
    next=$(grep -c '#' <<<"$("$DOMINO" -e 'draw 0' | head -n -2)")
    head=$(grep -c '0 *#\|000' <<<"$("$DOMINO" -e 'draw 0' | sed '1d;/-----/,$d')")
    awk -v n="$next" -v h="$head" 'BEGIN { exit !(n / h > 1.3 && n / h < 1.7) }'
}

# bats test_tags=rows
@test "draw: T is an expression, 'forces' may be the only word, 'train' is for scenes with a row; without T the picture has the tilt of the walk" {
    differ 'T counts' "$("$DOMINO" -e 'draw 0.2')" "$("$DOMINO" -e 'draw 0.3')"
    differ 'forces, too' "$("$DOMINO" -e 'draw 0')" "$("$DOMINO" -e 'draw 0 forces')"
    same degrees "$("$DOMINO" -e 'draw 0.17453292519943295')" "$("$DOMINO" -e 'draw 10 deg')"
    same expression "$("$DOMINO" -e 'draw thetac')" "$("$DOMINO" -e 'draw asin(r*s)')"
    same alone "$("$DOMINO" -e 'draw 0 forces')" "$("$DOMINO" -e 'draw forces')"
    same train "$("$DOMINO" -e 'draw 0.3')" "$("$DOMINO" -e 'effect row 5; draw train 0.3')"
    differ 'the row' "$("$DOMINO" -e 'draw 0.3')" "$("$DOMINO" -e 'effect row 5; draw')"
    same now "$("$DOMINO" -e 'draw 0.2')" "$("$DOMINO" -e 'goto 0.2 > /dev/null; draw')"
    same 'another train begins anew' "$("$DOMINO" -e 'set s 0.3; draw 0')" \
        "$("$DOMINO" -e 'goto 0.2 > /dev/null; set s 0.3; draw')"
}

@test "draw: a picture with forces has a legend, and a .txt file has the drawing in characters" {
    "$DOMINO" -e 'draw 0.3 forces > a.svg; draw forces > a.txt'
    same text "$("$DOMINO" -e 'draw forces')" "$(cat a.txt)"
    for words in 'to scale' 'x \[h\]' '>next<' 'dots: contacts' 'arrows: the push'; do grep -q "$words" a.svg; done
}

# bats test_tags=rows
@test "what cannot be drawn gives a one-line error that says what to do, and no file" {
    dir=$PWD
    cd "$dir" || false
    wrong 'draw 9 > a.svg' 'T = 9 rad is outside the cycle'
    wrong 'draw 10 mm' 'T is an angle, not a length'
    wrong 'draw forces 0.3 8' "'8' does not fit here; usage: draw, draw at 2.5 s, "
    wrong 'set r 1.7; draw 0.3 > a.svg' 'it stops at 0.02802163121 rad, before the top of the barrier'
    wrong 'animate > a.png' "'animate' cannot write 'a.png'; use .gif"
    wrong 'draw > a.gif' "'draw' cannot write 'a.gif'; use .svg"
    wrong 'animate > none/a.gif' "cannot write 'none/a.gif'"
    wrong 'set row 3; animate' "an animation can be shown only on a terminal; enter 'animate > film.gif' for a file"
    wrong 'animate >> a.gif' "'a.gif' can hold only one picture; '>' replaces it"
    wrong 'set s 0.001; draw > a.svg' 'the fuel P is not positive'
    wrong 'set r 9; draw > a.svg' 'r s = 3.6 > 1'
    same 'nothing is left' '(nothing)' "$(ls)"
    # An existing file is not changed.
    echo old >a.gif
    run -1 "$DOMINO" --keep-going -e 'set s 0.001; animate > a.gif'
    same 'an old file' old "$(cat a.gif)"
    mkdir full
    chmod 555 full
    [ -w full ] || wrong 'animate > full/a.gif' "cannot write 'full/a.gif'"
}

# bats test_tags=rows
@test "without gnuplot, a one-line error says what to install, and the data are still available" {
    dir=$PWD
    mkdir "$dir/empty"
    for what in 'plot omega > a.svg' 'draw > a.png' "set row 3; animate > $dir/a.gif"; do
        run -1 env PATH="$dir/empty" "$DOMINO" --keep-going -e "$what; print 1"
        [[ ${lines[0]} == *"pictures need gnuplot, which is not installed; run 'apt install gnuplot-nox'"* ]]
        same "$what: the session goes on" 1 "${lines[1]}"
        rows=$(env PATH="$dir/empty" "$DOMINO" -e "set output csv; ${what%% >*}")
        same "$what: data" "$(csv "${what%% >*}")" "$rows"
    done
    same 'nothing is left' empty "$(ls "$dir" | grep -v '\.bats')"
}

# bats test_tags=rows
@test "gnuplot settings of the user have no effect" {
    pictures() { "$DOMINO" -e 'plot energy > e.svg; set row 3; animate rate 5 > a.gif' && grep -v Produced e.svg && cksum <a.gif; }
    plain=$(pictures)
    grep -q 'Energy' <<<"$plain"
    echo 'set terminal png; set title "mine"' >.gnuplot
    same '.gnuplot' "$plain" "$(HOME=$PWD pictures)"
    for GNUTERM in x11 'svg enhanced' 'no such terminal' ''; do
        export GNUTERM
        same "GNUTERM=$GNUTERM" "$plain" "$(pictures)"
    done
}

# bats test_tags=rows
@test "draw: dominoes in the svg are where the model has them: before the fall, at a time and at the end" {
    while IFS='|' read -r count row what; do
        "$DOMINO" -e "$row; $what > a.svg"
        xmllint --noout a.svg
        same "$row; $what" "$count" "$("$DOMINO" -e "set output json; $row; $what" | "$root/tests/pictures/polygons" a.svg)"
    done <<END
10|$record|draw
10|$record|draw at domino 8
10|$record|draw at end
5|set r 1.4; effect row 5; effect friction 0.2; effect slope 1 deg|draw at domino 4
200|set r 1; effect row 200|draw
END
}

# bats test_tags=rows
@test "draw: texts in the svg do not overlap, and each domino has a number where there is room" {
    while IFS='|' read -r row numbers; do
        "$DOMINO" -e "$row; draw > a.svg"
        "$root/tests/pictures/labels" a.svg >texts || same "$row" 'texts apart' "$(cat texts)"
        cut -d ' ' -f 5- texts >words
        same "$row: the tape begins at domino 1" '(nothing)' "$(grep '^-[0-9]' words)"
        [ -z "$numbers" ] || same "$row: numbers" "$numbers" "$(sed -n '/^tape/,$p' words | grep -xE '[0-9]+' | sort -n | paste -sd ' ' -)"
    done <<END
$record|
set q 4; set r 1.7; effect row 8|
set r 1; effect row 60; effect push 3|
effect row 14|2 7 8 9 10 11 12 13 14
set r 1; effect row 14; effect push 3|1 2 3 4 5 6 7 8 9 10 11 12 13 14
END
    # In a low picture of a row, the axis of heights has few numbers.
    "$DOMINO" -e 'set r 1; effect row 12; effect push 5; draw at 0.2 > a.svg'
    "$root/tests/pictures/labels" a.svg | cut -d ' ' -f 5- >texts
    grep -qx 'tape measure from the back of domino 1 \[cm\]' texts
    same heights '0 5' "$(grep -x '[0-9.]*' texts | head -n 2 | paste -sd ' ' -)"
}

# bats test_tags=rows,sweeps
@test "draw: data of the row agree with 'row' and with the tape measure, and change with time" {
    "$DOMINO" -e "set output json; $record; row" >row
    "$DOMINO" -e "set output json; $record; draw" >draw
    python3 - row draw <<'END'
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
    # When domino 8 is hit, the top of domino 7, which is 1.9 m tall, has crossed the gap of 64 cm.
    hit=$(csv "$record; fall" | awk -F, '$1 == 8 { print $3 }')
    same 'a time or its domino' "$(csv "$record; draw at domino 8" | cut -d, -f 4 | cut -c 1-9)" \
        "$(csv "$record; draw at $hit s" | cut -d, -f 4 | cut -c 1-9)"
    csv "$record; draw at domino 8" | awk -F, '$1 == 7 { seventh = $4 } $1 == 8 { eighth = $4 } NR > 9 && $4 != 0 { bad = 1 }
        END { exit bad || eighth != 0 || !(sin(seventh) * 1.9 - 0.64 < 1e-9 && sin(seventh) * 1.9 - 0.64 > -1e-9) }'
}

# bats test_tags=rows
@test "draw: captions say how the fall ends, which domino is the weakest, and what falls" {
    while IFS='|' read -r row what words; do
        "$DOMINO" -e "$row; $what > a.svg; $what > b.txt"
        for file in a.svg b.txt; do
            grep -qF -- "$words" <(tr '\n' ' ' <"$file") || same "$row; $what" "$words" "$(cat "$file")"
        done
    done <<END
$record|draw|10 dominoes, 24 cm to 5.5 m tall, on 8.85 m of floor.
$record|draw|All 10 fall: the last one lies flat 7.65 s after the first hit.
$record|draw|Weakest: domino 8, which needs 40 % of the energy that it has.
$record|draw at domino 8|3.348 s after the first hit: domino 8 falls; 2 dominoes still stand.
$record|draw at domino 1|0.000 s after the first hit: domino 2 falls; 8 dominoes still stand.
$record|draw at end|all have fallen.
set r 1.6; effect row 12|draw|stops the row: it has 96 % of the energy that it needs.
set r 1.6; effect row 12|draw at end|the fall ends at domino 2; 10 dominoes 
set s 0.9; set r 1.2; effect row 4|draw|The fall ends at domino 1: 
END
    share=$(json 'set r 1.6; effect row 12; fall' | tail -n 1)
    awk -v k="$(values kinetic <<<"$share")" -v b="$(values barrier <<<"$share")" 'BEGIN { p = 100 * k / b; exit !(p > 95.5 && p < 96.5) }'
    # A file with a picture contains nothing else.
    for ending in svg png pdf; do
        same "silent, $ending" '(nothing)' "$("$DOMINO" -e "$record; draw > a.$ending; draw train > b.$ending" 2>&1)"
        "$DOMINO" -e "$record; draw 0.3 > c.$ending" 2>said
        grep -q 'endless train' said
        run -1 grep -qa 'endless train with these' c.$ending
    done
    xmllint --noout a.svg b.svg c.svg
}

# bats test_tags=rows
@test "draw: the row in characters has every domino, fits the terminal, and needs no gnuplot" {
    mkdir empty
    run -0 env PATH="$PWD/empty" "$DOMINO" -e "$record; draw"
    [ "${#lines[@]}" -le 23 ]
    awk 'length > 79 { exit 1 }' <<<"$output"
    same 'no blanks at the ends' '(nothing)' "$(grep ' $' <<<"$output")"
    for mark in 1 2 3 4 5 6 7 '\*' 9 0; do grep -q " *$mark" <<<"$(sed -n '4,/ 0 -/p' <<<"$output")"; done
    grep -q '^domino .* 9 * 10$' <<<"$output"
    # The picture is to scale: domino 10 is 5.5 / 2.9 times as tall as domino 8, and a line is as
    # high as 2 columns are wide.
    awk '/0000/ { tall++ } /\*\*/ { eighth++ } END { exit !(tall / eighth > 1.6 && tall / eighth < 2.2) }' <<<"$output"
    differ 'it falls' "$output" "$("$DOMINO" -e "$record; draw at 4")"
}

# bats test_tags=rows
@test "draw: on a terminal with UTF-8 the row is drawn in braille and colour, and fits the terminal" {
    terminal() { env -u NO_COLOR LC_ALL=C.UTF-8 TERM=xterm-256color "$@" python3 "$root/tests/shell/terminal.py" 100 30 "$DOMINO" -e "$record; draw at 5"; }
    terminal >seen
    grep -q $'\u28ff' seen || same braille 'a full cell' "$(cat seen)"
    grep -q $'\e\[' seen
    grep -q 'Weakest: domino 8, which' seen
    terminal LC_ALL=C | grep -q '\*\*\*'
}

# bats test_tags=rows,sweeps,planning
@test "draw: in a pdf, no word is cut off or written over another one" {
    "$DOMINO" -e 'draw 0.3 > tilt.pdf; draw 0.3 forces > forces.pdf; effect row 12; draw > row12.pdf; plan > plan.pdf
        effect row 20; draw > row20.pdf; plot fall > fall.pdf'
    for picture in tilt forces row12 row20 plan fall; do
        pdftotext -bbox "$picture.pdf" words.xml
        python3 - <<'END' || same "$picture" 'words apart, on the page' 'others'
import re
pages = re.split("<page ", open("words.xml").read())[1:]
for page in pages:
    width, height = map(float, re.findall(r'(?:width|height)="([\d.]+)"', page)[:2])
    boxes = [([float(x) for x in m[:4]], m[4]) for m in
             re.findall(r'xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)">(.*?)<', page)]
    assert len(boxes) > 10
    for i, ((left, top, right, bottom), word) in enumerate(boxes):
        assert left >= 0 and top >= 0 and right <= width and bottom <= height, word
        # The boxes are as tall as the font, which leaves room above and below the letters.
        for (l, t, r, b), other in boxes[:i]:
            assert not (left < r - 1 and l < right - 1 and top < b - 5 and t < bottom - 5), (word, other)
END
    done
}

# bats test_tags=rows
@test "rows that cannot be drawn give a one-line error that says what works" {
    wrong 'draw at 2 s' "'draw at' shows a row at a given time; first enter 'set row N', for example 'set row 10'"
    wrong "$record; draw at 8 s > a.svg" "the motion ends at 7.648 s; 'draw at end' shows the row at this time"
    wrong "$record; draw at domino 11" "domino 11 is never hit: this row has 10, and the fall ends at domino 10;"
    wrong "$record; draw at domino 2.5" 'domino 2.5 is never hit: this row has 10'
    wrong 'set r 1.6; effect row 12; draw at domino 5' "domino 5 is never hit: this row has 12, and the fall ends at domino 2; 'draw at end' shows how far the row falls"
    wrong 'effect row 5; effect push 5; draw at -1' "times count from the push and cannot be negative; 'draw at 0' shows the row at the push"
    wrong "$record; draw at 2 m" "this needs a time such as 2.5 s, not a length"
    wrong "$record; draw at" "'at' needs a time, 'domino N' or 'end'; usage: draw, draw at 2.5 s, "
    wrong "$record; animate rate 1000 > a.gif" 'rate is 1000; it must be in the range 1 .. 50'
    wrong "$record; animate speed 0.01 > a.gif" "at most 3000 are drawn; enter 'speed"
    same 'nothing is left' '(nothing)' "$(ls)"
}

# bats test_tags=rows
@test "draw at end: a leaning domino that stops the row is drawn where it stands, however small the lean" {
    cd "$BATS_TEST_TMPDIR" || return
    for lean in 0.018 0.031 0.05 0.11 0.37 -0.2; do
        printf 'height (mm),thickness (mm),gap (mm),lean (mm)\n31.856,6.294,0,0\n39.594,9.852,12.261,%s\n' "$lean" >leans.csv
        run -0 "$DOMINO" -n -e 'effect row leans.csv; draw at end'
        [[ $output == *'Domino 2 stops the row'* ]] || same "lean $lean" 'domino 2 stops the row' "$output"
    done
}

# bats test_tags=rows
@test "draw tower: the row of the last count, a tower of the counted height at its end" {
    cd "$BATS_TEST_TMPDIR"
    answer=$("$DOMINO" -e 'count 112 m; draw tower' | sed -n '/^20 dominoes, 4/,$p')
    says 'count 112 m; draw tower' '20 dominoes, 4.8 cm to 106 m tall; a tower of 112 m' 'All 20 fall, and so does the tower: it lies flat 51.8 s' ' 19 20 tower'
    # The spire is narrower than the foot.
    awk '/##/ { n = match($0, /#+$/); if (n && !top) top = length($0) - n; if (n) low = length($0) - n } END { exit !(top < low) }' <<<"$answer"
    # The data are for the growth of the count, not for the growth of the session.
    same data "$(csv 'set r 1.6; effect row 17; draw')" "$(csv 'count 112 m 1.6; draw tower' | sed '1,2d;$d')"
    "$DOMINO" -e 'count 112 m; draw tower > a.svg; draw tower > a.png; set r 1.2; count 60 m; draw tower > b.svg'
    grep -q '>tower<' a.svg && grep -q '>tower<' b.svg
    # Drawing does not change the session.
    same scene "$(json 'show')" "$(json 'count 112 m 1.6; draw tower' >/dev/null; json show)"
    wrong 'draw tower' "works only if the last answer was a count; first enter 'count 112 m'"
    wrong 'count 1 cm; draw tower' "the last 'count' needs no dominoes"
    wrong 'count 112 m 1; draw tower' "the last 'count' does not reach its height"
    wrong 'count 112 m with s 0.3; draw tower' "made 'with' settings that the session does not have; first set them, and count again"
}
