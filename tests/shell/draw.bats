#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures: their data, which is what is drawn; the kinds of files; errors.

load common

csv() { "$DOMINO" -e "set output csv; $1"; }
one_line() { # PART COMMANDS: fails with one line, that has the part
    run -1 "$DOMINO" --keep-going -e "$2"
    same "$2: one line" 1 "${#lines[@]}"
    [[ $output == *"$1"* ]] || same "$2" "$1" "$output"
}

@test "draw: csv has every domino, upright and where it stands, with its corners" {
    csv draw >"$BATS_TEST_TMPDIR/rows"
    same keys i,height,x,theta,top_front_x,top_front_z,top_back_x,top_back_z,foot_back_x,foot_back_z,contact_x,contact_z,force,of_own \
        "$(head -n 1 "$BATS_TEST_TMPDIR/rows")"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/rows")" -gt 8 ]
    # The next one, 1.5 high and (s + d) r in front of the head; the head; its first follower.
    csv 'set d 0.125; set s 0.375; draw' | sed -n 2,4p | cut -d , -f 1-10 >"$BATS_TEST_TMPDIR/first"
    same next -1,1.5,0.75,0,0.75,1.5,0.5625,1.5,0.5625,0 "$(sed -n 1p "$BATS_TEST_TMPDIR/first")"
    same head 0,1,0,0,0,1,-0.125,1,-0.125,0 "$(sed -n 2p "$BATS_TEST_TMPDIR/first")"
    close 'the first behind it' -0.5 "$(sed -n 3p "$BATS_TEST_TMPDIR/first" | cut -d , -f 3)"
    # The head touches the next one when it has come to theta_c, at the height cos theta_c.
    head_hits=$(csv 'draw thetac' | sed -n 2p)
    close 'where the head hits' 0.6 "$(cut -d , -f 11 <<<"$head_hits")"
    close 'how high' 0.8 "$(cut -d , -f 12 <<<"$head_hits")"
    before=$(csv 'draw 0.6' | sed -n 2p)
    same 'which is the next' -1 "${before%%,*}"
    same 'not before' '(nothing)' "$(cut -d , -f 11 <<<"$before")"
}

@test "draw: rounded edges touch the back of their leader; files show them as arcs, captions name the radius" {
    cd "$BATS_TEST_TMPDIR"
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
    mkdir "$BATS_TEST_TMPDIR/empty"
    run -0 env PATH="$BATS_TEST_TMPDIR/empty" "$DOMINO" -e 'draw 0.3'
    [ "${#lines[@]}" -ge 15 ]
    for words in 'theta = 0.3 rad (17.19 deg)' 'to scale' '^   \[h\] ' '^domino .* next$' '0: head' '#: the next' '0000' '111' '###'; do
        grep -q -- "$words" <<<"$output" || same draw "$words" "$output"
    done
    [ "${#lines[@]}" -le 23 ]
    awk 'length > 79 { exit 1 }' <<<"$output"
    same 'no blanks at the ends' '(nothing)' "$(grep ' $' <<<"$output")"
    "$DOMINO" -e 'draw forces' | grep -q 'contact forces, in weights of the one that is pushed: 0: '
    same 'a safe session draws in characters' "$output" "$("$DOMINO" --safe -e 'draw 0.3')"
    # The next one is 1.5 times as tall as the head, whose width stays d/h up to a character.
    next=$(grep -c '#' <<<"$("$DOMINO" -e 'draw 0' | head -n -2)")
    head=$(grep -c '0 *#\|000' <<<"$("$DOMINO" -e 'draw 0' | sed '1d;/-----/,$d')")
    awk -v n="$next" -v h="$head" 'BEGIN { exit !(n / h > 1.3 && n / h < 1.7) }'
}

@test "draw: T is an expression, 'forces' may be the only word; without T the picture has the tilt of the walk" {
    differ 'T counts' "$("$DOMINO" -e 'draw 0.2')" "$("$DOMINO" -e 'draw 0.3')"
    differ 'forces, too' "$("$DOMINO" -e 'draw 0')" "$("$DOMINO" -e 'draw 0 forces')"
    same degrees "$("$DOMINO" -e 'draw 0.17453292519943295')" "$("$DOMINO" -e 'draw 10 deg')"
    same expression "$("$DOMINO" -e 'draw thetac')" "$("$DOMINO" -e 'draw asin(r*s)')"
    same alone "$("$DOMINO" -e 'draw 0 forces')" "$("$DOMINO" -e 'draw forces')"
    same now "$("$DOMINO" -e 'draw 0.2')" "$("$DOMINO" -e 'goto 0.2 > /dev/null; draw')"
    same 'another train begins anew' "$("$DOMINO" -e 'set s 0.3; draw 0')" \
        "$("$DOMINO" -e 'goto 0.2 > /dev/null; set s 0.3; draw')"
}

@test "draw and plot: each kind of file" {
    dir=$BATS_TEST_TMPDIR
    for what in 'draw 0.3' 'draw forces' 'plot energy' 'plot omega' 'plot chain' 'plot growth' 'plot marginal'; do
        "$DOMINO" -e "$what > $dir/a.svg; $what > $dir/b.png; $what > $dir/c.pdf; $what > $dir/d.txt"
        head -c 5 "$dir/a.svg" | grep -q '<?xml'
        tail -n 3 "$dir/a.svg" | grep -q '</svg>'
        same png 89504e470d0a1a0a "$(head -c 8 "$dir/b.png" | od -An -tx1 | tr -d ' \n')"
        same pdf '%PDF-' "$(head -c 5 "$dir/c.pdf")"
        same text "$("$DOMINO" -e "$what")" "$(cat "$dir/d.txt")"
        rm "$dir"/[a-d].*
    done
    "$DOMINO" -e "draw 0.3 forces > $dir/a.svg"
    for words in 'to scale' 'x \[h\]' '>next<' 'dots: contacts' 'arrows: the push'; do grep -q "$words" "$dir/a.svg"; done
}

# How many frames a gif has of each delay, in 1/100 s as little-endian hex.
delays() { od -An -v -tx1 -w100000000 "$1" | tr -d ' \n' | grep -oE '21f904[0-9a-f]{2}[0-9a-f]{4}[0-9a-f]{2}00' | cut -c 9-12 | sort | uniq -c | awk '{ print $1, $2 }'; }

@test "animate: a gif, its frames equally far apart in time; each cycle lasts sqrt(r) longer" {
    gif=$BATS_TEST_TMPDIR/a.gif
    same silent '(nothing)' "$("$DOMINO" -e "animate $gif")"
    same gif GIF89a "$(head -c 6 "$gif")"
    same 'frames and their delay' '95 0400' "$(delays "$gif")"
    csv 'animate a.gif' >"$BATS_TEST_TMPDIR/frames"
    same rows 96 "$(wc -l <"$BATS_TEST_TMPDIR/frames")"
    awk -F, -v whole="$(json duration | values seconds)" 'NR == 3 { step = $1 } NR > 2 { d = $1 - before - step; if (!(d <= 1e-9 && d >= -1e-9)) bad = 1 }
        { before = $1; n[$2]++ }
        # 1 + sqrt(r) + r cycles, as many frames in each as it lasts; theta grows in each, up to theta_c.
        END { w = before / whole - (1 + sqrt(1.5) + 1.5); exit bad || !(w < 1e-6 && w > -1e-6 && n[2] / n[1] > 1.1 && n[2] / n[1] < 1.35 && n[3] > n[2] && $3 > 0.6435 && $3 < 0.64351) }' "$BATS_TEST_TMPDIR/frames"
    awk -F, 'NR > 2 && $2 == cycle { pairs++; if (!($3 > theta)) bad = 1 } { cycle = $2; theta = $3 }
        END { exit bad || pairs < 80 }' "$BATS_TEST_TMPDIR/frames"
    "$DOMINO" -e "animate $gif 1"
    same 'one cycle' '26 0400' "$(delays "$gif")"
    same 'data instead, and no file' '(nothing)' "$(csv "animate $BATS_TEST_TMPDIR/b.gif" >/dev/null; ls "$BATS_TEST_TMPDIR" | grep 'b\.gif')"
    # A train that stops is shown to its stop.
    "$DOMINO" -e "set r 1.7; animate $gif"
    same 'it stops' "$(json 'set r 1.7; barrier' | sed -n 's/.*stops at theta = \([0-9.]*\).*/\1/p' | cut -c 1-8)" \
        "$(csv 'set r 1.7; animate a.gif' | tail -n 1 | cut -d, -f 3 | cut -c 1-8)"
}

@test "what cannot be drawn: one line that says what would be right, and no file" {
    dir=$BATS_TEST_TMPDIR
    cd "$dir" || false
    one_line 'T = 9 rad is outside the cycle' 'draw 9 > a.svg'
    one_line 'T is an angle, not a length' 'draw 10 mm'
    one_line "'9' is one argument too many; usage: draw, draw at 2.5 s, " 'draw forces 9'
    one_line "'sideways' is neither a value nor one of the words; usage: draw" 'draw sideways'
    one_line "'draw 0.1 forces'" 'draw forces forces'
    one_line 'it stops at 0.02802163121 rad, below the barrier' 'set r 1.7; draw 0.3 > a.svg'
    one_line 'it stops at 1.605' 'set angle deg; set r 1.7; draw 3'
    one_line 'use .svg, .png, .pdf or .txt' 'draw 0.1 > a.jpg'
    one_line 'use the ending .gif, .webm or .mp4' 'animate a.png'
    one_line "cannot write 'none/a.svg'" 'draw 0.1 > none/a.svg'
    one_line "cannot write 'none/a.gif'" 'animate none/a.gif'
    one_line 'FILE is missing; usage: animate FILE [HOW]' animate
    for what in 0 2.5 10 1e7; do
        one_line 'N is an integer in 1 .. 9, the most cycles that one picture can show at this r' "animate a.gif $what"
    done
    one_line 'N is an integer in 1 .. 30, ' 'set r 1; animate a.gif 31'
    one_line 'N is an integer in 1 .. 1, ' 'set s 0.1; set r 7; animate a.gif 2'
    one_line 'use .svg, .png' 'plot growth > a.gif'
    for what in 'draw > a.svg' 'animate a.gif'; do
        one_line 'the fuel P is not positive' "set s 0.001; $what"
        one_line 'r s = 3.6 > 1' "set r 9; $what"
    done
    r=$(json 'set precision quad; rmax' | values r_max)
    one_line 'the margin is 0 to rounding' "set r $r; animate a.gif"
    same 'nothing is left' '(nothing)' "$(ls)"
    # What was there stays.
    echo old >a.gif
    run -1 "$DOMINO" --keep-going -e 'set s 0.001; animate a.gif'
    same 'an old file' old "$(cat a.gif)"
    mkdir full
    chmod 555 full
    [ -w full ] || one_line "cannot write 'full/a.gif'" 'animate full/a.gif'
}

@test "without gnuplot: one line that says what to install; the data is there" {
    dir=$BATS_TEST_TMPDIR
    mkdir "$dir/empty"
    for what in 'plot chain > a.svg' 'draw > a.png' "animate $dir/a.gif"; do
        run -1 env PATH="$dir/empty" "$DOMINO" --keep-going -e "$what; print 1"
        [[ ${lines[0]} == *"pictures need gnuplot, which is not installed: 'apt install gnuplot-nox'"* ]]
        same "$what: the session goes on" 1 "${lines[1]}"
        rows=$(env PATH="$dir/empty" "$DOMINO" -e "set output csv; ${what%% >*}")
        same "$what: data" "$(csv "${what%% >*}")" "$rows"
    done
    same 'nothing is left' empty "$(ls "$dir" | grep -v '\.bats')"
    run -1 "$DOMINO" --keep-going --safe -e "animate $dir/a.gif"
    [[ $output == *'a safe session cannot read or write files'* ]]
    run -1 "$DOMINO" --keep-going --safe -e "draw > $dir/a.svg"
    [[ $output == *'a safe session cannot read or write files'* ]]
}

@test "a user's own settings of gnuplot change nothing" {
    echo 'set terminal png; set title "mine"' >"$BATS_TEST_TMPDIR/.gnuplot"
    plain=$("$DOMINO" -e "plot energy > $BATS_TEST_TMPDIR/a.svg" && grep -v Produced "$BATS_TEST_TMPDIR/a.svg")
    grep -q 'Energy' <<<"$plain"
    HOME=$BATS_TEST_TMPDIR "$DOMINO" -e "plot energy > $BATS_TEST_TMPDIR/b.svg"
    same 'plot energy' "$plain" "$(grep -v Produced "$BATS_TEST_TMPDIR/b.svg")"
}

@test "completion: what draw takes" {
    same draw forces "$("$DOMINO" -e 'complete draw f')"
    same 'draw T' forces "$("$DOMINO" -e 'complete draw 0.3 f')"
}
