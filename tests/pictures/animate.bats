#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Animations of rows.

load ../shell/common

record="effect row \"$root/examples/record.csv\""

# bats test_tags=rows
@test "animate: a row in real time, from the first hit to the end, which is held for a second" {
    same silent '(nothing)' "$("$DOMINO" -e "$record; animate rate 10 > a.gif" 2>&1)"
    read -r width height frames delay rest <<<"$("$root/tests/pictures/gif" a.gif)"
    same 'one delay of a tenth of a second' '10 ' "$delay $rest"
    [ "$width" -eq 640 ] && [ "$height" -ge 170 ] && [ "$(stat -c %s a.gif)" -lt 300000 ]
    csv "$record; animate rate 10" >data
    same keys 'time,domino,theta' "$(head -n 1 data)"
    same 'a frame each row, and ten more' "$frames" "$(($(wc -l <data) - 1 + 10))"
    # The times are evenly spaced up to the end, which is at the time that 'verdict' gives.
    awk -F, -v end="$(json "$record; verdict" | values seconds)" 'NR == 2 && $1 != 0 { bad = 1 }
        NR > 3 && before < end - 0.1 { d = $1 - before - 0.1; if (d > 1e-9 || d < -1e-9) bad = 1 }
        NR > 2 && $2 < domino { bad = 1 } { before = $1; domino = $2 }
        END { d = before / end - 1; exit bad || domino != 10 || d > 1e-9 || d < -1e-9 }' data
    # With a push, times begin with the push. Half the speed takes twice as many frames.
    set_push='set r 1; effect row 12; effect push 6'
    same 'from the push' 0 "$(csv "$set_push; animate" | sed -n '2s/,.*//p')"
    "$DOMINO" -e "$set_push; animate speed 0.5 > a.gif; animate speed 0.25 > b.gif"
    read -r _ _ fast _ <<<"$("$root/tests/pictures/gif" a.gif)"
    read -r _ _ slow _ <<<"$("$root/tests/pictures/gif" b.gif)"
    awk -v a=$((fast - 25)) -v b=$((slow - 25)) 'BEGIN { exit !(b / a > 1.9 && b / a < 2.1) }'
    # A row that stops, and a row in which the view follows the front, make valid gifs.
    "$DOMINO" -e 'set r 1.6; effect row 12; animate > a.gif; set r 1.5; effect row 12; animate rate 5 > b.gif'
    "$root/tests/pictures/gif" a.gif
    "$root/tests/pictures/gif" b.gif
}

# bats test_tags=rows,sweeps
@test "the gallery has the pictures that examples/pictures.dom draws, and is small" {
    "$DOMINO" -f "$root/examples/pictures.dom" >/dev/null
    same pictures "$(ls "$root/examples/pictures")" "$(ls)"
    for picture in *; do
        [ "$(stat -c %s "$root/examples/pictures/$picture")" -lt 300000 ]
    done
    for picture in *.svg; do xmllint --noout "$root/examples/pictures/$picture"; done
    for picture in *.gif; do same "$picture" "$("$root/tests/pictures/gif" "$root/examples/pictures/$picture")" "$("$root/tests/pictures/gif" "$picture")"; done
}

# bats test_tags=rows
@test "animate: a long row is shown faster, in at most 10 s and 300 frames, unless a speed is given" {
    "$DOMINO" -e 'effect row 20; animate > a.gif'
    read -r _ _ frames delay rest <<<"$("$root/tests/pictures/gif" a.gif)"
    same 'one delay' '4 ' "$delay $rest"
    [ "$frames" -gt 200 ] && [ "$frames" -le 250 ] # 10 s
    # The frames still cover the time from the first hit to the end.
    csv 'effect row 20; animate' >data
    close 'the end' "$(json 'effect row 20; verdict' | values seconds)" "$(tail -n 1 data | cut -d, -f 1)"
    awk -F, 'NR == 4 { step = $1 - before } NR > 4 && NR < 200 { d = $1 - before - step; if (d > 1e-9 || d < -1e-9) exit 1 } { before = $1 }' data
    same 'in real time' "$(csv 'effect row 20; animate speed 1' | wc -l)" \
        "$(awk -v end="$(json 'effect row 20; verdict' | values seconds)" -v begin="$(csv 'effect row 20; animate' | sed -n '2s/,.*//p')" \
            'BEGIN { n = (end - begin) * 25; print (n == int(n) ? n : int(n) + 1) + 2 }')"
    # With 'tower' the last domino of the row that the last count found topples the tower, which falls like a
    # domino of its height.
    "$DOMINO" -e 'count 1 m; animate tower rate 5 > b.gif' >/dev/null
    "$root/tests/pictures/gif" b.gif >said
    csv 'count 1 m; animate tower rate 5' | sed 1,2d >tower
    same tower "$(csv 'effect row 9; change 9 height 1 m; change 9 thickness 14.5833333333333333333333333333333333 cm
        change 9 width 50 cm; change 9 gap 40 cm; animate rate 5')" "$(cat tower)"
    same 'the tower falls last, and lies' '9 1.57' "$(tail -n 1 tower | cut -d, -f 2,3 | tr , ' ' | cut -c 1-6)"
    wrong 'animate tower > a.gif' "'tower' works only if the last answer was a count"
    wrong 'set precision quad; set row 5; animate speed 0.001 > a.gif' 'the film would have [0-9]* frames'
    wrong 'count 5 m; animate tower 4 > a.gif' "'4' does not fit here; usage: animate"
    same 'a short row is shown in real time' "$(csv 'set r 1; effect row 12; effect push 6; animate')" \
        "$(csv 'set r 1; effect row 12; effect push 6; animate speed 1')"
}

# The film of a terminal is a stream of screens, each after "ESC [ H". Prints for each screen: the number of its lines,
# the unit of its ruler, the highest number on its vertical scale, and the column where the last domino that was hit has
# its number.
screens_of() { # COLUMNS ROWS COMMANDS
    NO_COLOR=1 TERM=xterm-256color LC_ALL=C.UTF-8 python3 "$root/tests/shell/terminal.py" "$1" "$2" "$DOMINO" -n -e "$3" >film.screens
    awk 'BEGIN { RS = "\033\\[H" }
        /space stops/ {
            sub(/q ends\).*/, "") # the last screen is written again after the film
            gsub(/\033\[[0-9;?]*[A-Za-z]/, ""); gsub(/\r/, "")
            n = split($0, line, "\n"); unit = high = hit = column = "-"
            for (i = 1; i <= n; i++) {
                if (match(line[i], /domino [0-9]+ falls/)) { split(substr(line[i], RSTART), w, " "); hit = w[2] }
                if (high == "-" && match(line[i], /^ *[0-9.]+ (\+|┤)/)) high = line[i] + 0
                if (line[i] ~ /^domino/) {
                    gsub(/domino/, "      ", line[i]); padded = " " line[i] " "
                    column = index(padded, " " hit " ")
                }
                if (match(line[i], /^ *\[[a-z]+\]/)) { unit = substr(line[i], RSTART, RLENGTH); gsub(/ /, "", unit) }
            }
            print n, unit, high, column
        }' film.screens
}

# bats test_tags=whole
@test "animate at a terminal: the view follows the front, and grows with it" {
    for size in '80 24' '100 30'; do
        read -r columns rows <<<"$size"
        screens_of "$columns" "$rows" 'count 112 m; animate tower speed 40' >screens
        [ "$(wc -l <screens)" -ge 20 ] || same frames 'at least 20' "$(wc -l <screens)"
        same "lines of $size" "$((rows))" "$(cut -d ' ' -f 1 screens | sort -u | paste -sd ' ')"
        same "units of $size" '[cm] [m]' "$(cut -d ' ' -f 2 screens | uniq | paste -sd ' ')"
        # the first screen shows some 15 cm, the last some 200 m, and the view never shrinks
        awk -v columns="$columns" '{ high = $3 * ($2 == "[cm]" ? 0.01 : 1) }
            NR == 1 && !(high >= 0.1 && high <= 0.2) { exit bad = 1 }
            high < 0.6 * before { exit bad = 1 }
            $4 > 0 && ($4 < 0.3 * columns || $4 > 0.6 * columns) { exit bad = 1 }
            { before = high; found += $4 > 0 } END { exit bad || !(before >= 150 && before <= 300) || found < NR / 2 }' screens ||
            same "$size" 'a view that grows' "$(cat screens)"
        grep -q '20 *tower' film.screens
    done
}
