#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Animations of trains and rows.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load ../shell/common

# Replaces gnuplot with a wrapper that stores the script in $PWD/script.
keep_scripts() {
    mkdir bin
    printf '#!/bin/sh\ntee "%s/script" | exec "%s" "$@"\n' "$PWD" "$(command -v gnuplot)" \
        >"$PWD/bin/gnuplot"
    chmod +x "$PWD/bin/gnuplot"
    PATH=$PWD/bin:$PATH
}

# Counts the frames of a gif by their delay, which is in 1/100 s as a little-endian hexadecimal
# number.
delays() { od -An -v -tx1 -w100000000 "$1" | tr -d ' \n' | grep -oE '21f904[0-9a-f]{2}[0-9a-f]{4}[0-9a-f]{2}00' | cut -c 9-12 | sort | uniq -c | awk '{ print $1, $2 }'; }

record="effect row \"$root/examples/record.csv\""

# bats test_tags=rows
@test "animate: the frames of a gif are evenly spaced in time, and each cycle lasts sqrt(r) times as long" {
    gif=$PWD/a.gif
    same silent '(nothing)' "$("$DOMINO" -e "animate > $gif")"
    same gif GIF89a "$(head -c 6 "$gif")"
    same 'frames and their delay' '95 0400' "$(delays "$gif")"
    csv 'animate' >frames
    same rows 96 "$(wc -l <frames)"
    awk -F, -v whole="$(json duration | values seconds)" 'NR == 3 { step = $1 } NR > 2 { d = $1 - before - step; if (!(d <= 1e-9 && d >= -1e-9)) bad = 1 }
        { before = $1; n[$2]++ }
        # The 3 cycles last 1 + sqrt(r) + r times as long as the first one. The number of frames of a cycle is
        # proportional to its duration, and theta grows in each cycle up to theta_c.
        END { w = before / whole - (1 + sqrt(1.5) + 1.5); exit bad || !(w < 1e-6 && w > -1e-6 && n[2] / n[1] > 1.1 && n[2] / n[1] < 1.35 && n[3] > n[2] && $3 > 0.6435 && $3 < 0.64351) }' frames
    awk -F, 'NR > 2 && $2 == cycle { pairs++; if (!($3 > theta)) bad = 1 } { cycle = $2; theta = $3 }
        END { exit bad || pairs < 80 }' frames
    "$DOMINO" -e "animate 1 > $gif"
    same 'one cycle' '26 0400' "$(delays "$gif")"
    # A train that stops is shown until it stops.
    "$DOMINO" -e "set r 1.7; animate > $gif"
    same 'it stops' "$(json 'set r 1.7; barrier' | sed -n 's/.*stops at theta = \([0-9.]*\).*/\1/p' | cut -c 1-8)" \
        "$(csv 'set r 1.7; animate' | tail -n 1 | cut -d, -f 3 | cut -c 1-8)"
}

# bats test_tags=rows
@test "animate: a row in real time, from before the first hit to the end, which is held for a second" {
    same silent '(nothing)' "$("$DOMINO" -e "$record; animate rate 10 > a.gif" 2>&1)"
    read -r width height frames delay rest <<<"$("$root/tests/pictures/gif" a.gif)"
    same 'one delay of a tenth of a second' '10 ' "$delay $rest"
    [ "$width" -eq 640 ] && [ "$height" -ge 170 ] && [ "$(stat -c %s a.gif)" -lt 300000 ]
    csv "$record; animate rate 10" >data
    same keys 'time,domino,theta' "$(head -n 1 data)"
    same 'a frame each row, and ten more' "$frames" "$(($(wc -l <data) - 1 + 10))"
    # The times are evenly spaced up to the end, which is at the time that 'verdict' gives.
    awk -F, -v end="$(json "$record; verdict" | values seconds)" 'NR == 2 && !($1 < 0) { bad = 1 }
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
    same 'the train, with a row on' "$(csv 'animate 2')" "$(csv 'effect row 3; animate train 2')"
}

# bats test_tags=rows
@test "animate: the file stands after '>'; 'slow'" {
    local scene='set r 1; effect row 5; effect push 6'
    same silent '(nothing)' "$("$DOMINO" -e "$scene; animate rate 20 > a.gif; animate rate 20 > a.csv" 2>&1)"
    same data "$(csv "$scene; animate rate 20")" "$(cat a.csv)"
    same 'four times slower' "$(csv "$scene; animate speed 0.25")" "$(csv "$scene; animate slow")"
    same 'a film, even after set output csv' GIF89a "$("$DOMINO" -e "set output csv; $scene; animate slow > c.gif" && head -c 6 c.gif)"
    same 'the train' '26 1000' "$("$DOMINO" -e 'animate slow 1 > d.gif' && delays d.gif)"
    wrong "$scene; animate a.gif" "to write the answer to a file, put '>' before its name: '> a.gif'"
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

@test "animate: the number of the head is between its feet in every frame of every cycle" {
    keep_scripts
    local scene
    for scene in '' 'set r 1.1' 'set r 1.3; set q hollow; set d 0.05' 'set r 1.7'; do
        "$DOMINO" -e "$scene; animate > a.gif"
        # In each frame, the block $part2 has the corners of the head. The label 0 must be between the feet.
        awk '/^\$part2/ { heads++; n = 0; next } /^END/ { n = -1 } n >= 0 && NF == 2 { x[n++] = $1 }
            /^set label .0. at/ {
                labels++
                split($5, at, ",")
                if (!(at[1] < x[0] && at[1] > x[3])) outside++
            }
            END { if (heads < 26 || labels != heads || outside) { print heads, labels, outside + 0; exit 1 } }' \
            "$PWD/script"
    done
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
    same 'hollow dominoes' "$(csv 'set q hollow; effect row 9; change 9 height 1 m; change 9 thickness 14.5833333333333333333333333333333333 cm
        change 9 width 50 cm; change 9 gap 40 cm; change 9 mass +23.0188 %; animate rate 5' | cut -c 1-4)" \
        "$(csv 'set q hollow; count 1 m; animate tower rate 5' | sed 1,2d | cut -c 1-4)"
    wrong 'animate tower > a.gif' "'tower' works only if the last answer was a count"
    wrong 'count 5 m; animate tower 4 > a.gif' "'4' is one argument too many"
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
                if (match(line[i], /(domino|cycle) [0-9]+ (falls|of)/)) { split(substr(line[i], RSTART), w, " "); hit = w[1] == "cycle" ? 0 : w[2] }
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
        grep -q 'tower 112 m' film.screens
    done
    screens_of 80 24 'animate' >screens
    same 'the train: lines' 24 "$(cut -d ' ' -f 1 screens | sort -u | paste -sd ' ')"
    awk '$4 < 24 || $4 > 48 { exit bad = 1 } { last = $3 } NR == 1 { first = $3 }
        END { exit bad || !(NR > 50 && last >= 2 * first) }' screens || same train 'a view that grows' "$(cat screens)"
}
