#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The ending of a file decides its format, whatever 'set output' says; one that does not fit is an error at once.

load common

setup() {
    answers_at_all
    cd "$BATS_TEST_TMPDIR" || false
}

@test ".csv and .json are written as such; .txt, and no ending as 'set output' has it" {
    for output in table csv json; do
        "$DOMINO" -e "set output $output; effect row 5; fall > fall.csv; rmax > r.JSON; verdict > v.txt; verdict > v"
        same "$output: csv" "$("$DOMINO" -e 'set output csv; effect row 5; fall')" "$(cat fall.csv)"
        same "$output: json" "$("$DOMINO" -e 'effect row 5; set output json; rmax')" "$(cat r.JSON)"
        for name in v.txt v; do
            same "$output: $name" "$("$DOMINO" -e "set output $output; effect row 5; verdict")" "$(cat $name)"
        done
    done
    same 'each answer of a script' "$("$DOMINO" -e 'set output csv; rmax; fuel')" \
        "$(printf 'rmax\nfuel\nrmax > inner.json\n' >s.dom && "$DOMINO" -e 'source s.dom > all.csv' && cat all.csv)"
    same 'but a file of its own' '{' "$(head -c 1 inner.json)"
    same 'the session stays as it was' "$("$DOMINO" -e rmax)" "$("$DOMINO" -e 'rmax > r.json; rmax')"
    "$DOMINO" -e 'rmax 0.3 > all.csv; rmax 0.5 >> all.csv'
    same 'appended' "$("$DOMINO" -e 'set output csv; rmax 0.3; rmax 0.5')" "$(cat all.csv)"
    "$DOMINO" -e 'rmax > .csv; rmax > a.b/../c' 2>/dev/null || true
    same 'a hidden file has no ending' "$("$DOMINO" -e rmax)" "$(cat .csv)"
}

@test "row > out.csv, effect row out.csv: the same row, digit for digit" {
    for scene in 'effect row 7' 'set q hollow; effect row 4; set mass 1; place 3 25 mm' 'set errors on; effect row 3'; do
        "$DOMINO" -e "$scene; row > out.csv; effect row out.csv; row > again.csv"
        same_file out.csv again.csv
        same "$scene: falls alike" "$("$DOMINO" -e "$scene; set errors off; fall")" \
            "$("$DOMINO" -e 'effect row out.csv; fall')"
    done
}

@test "a picture is drawn whatever 'set output' says; csv and json are its data" {
    for output in table csv json; do
        "$DOMINO" -e "set output $output; draw > d.svg; plot energy > e.svg; draw > d.csv; plot energy > e.json"
        for name in d.svg e.svg; do
            xmllint --noout $name
            same "$output: $name is a picture" 1 "$(grep -c '^</svg>' $name)"
        done
        same "$output: data" "$("$DOMINO" -e 'set output csv; draw')" "$(cat d.csv)"
        same "$output: data" "$("$DOMINO" -e 'set output json; plot energy')" "$(cat e.json)"
    done
    "$DOMINO" -e 'draw > plain; draw > d.txt'
    same 'characters' "$("$DOMINO" -e draw)" "$(cat plain)"
    same 'characters' "$("$DOMINO" -e draw)" "$(cat d.txt)"
}

@test "an ending that does not fit is one line, before anything is computed, and no file is left" {
    for name in a.jpg a.gif a.xlsx a.foo v.dat; do
        wrong "rmax > $name" "no format has the ending of '$name'; use .csv, .json or .txt"
        wrong "draw > $name" "no format has the ending of '$name'; use .svg, .png, .pdf or .txt"
    done
    wrong 'plot growth > a.b' "no format has the ending of 'a.b'; use .svg, .png, .pdf or .txt, or .csv or .json for its data"
    for what in 'set s 0.3' reset; do
        wrong "$what > a.csv" "'a.csv' is the name of data, and '${what%% *}' answers with none"
    done
    wrong 'effect row 12; effect placement 5 mm; placement 10000000 > a.svg' "is the name of a picture, and 'placement' draws none"
    same 'nothing is left' '(nothing)' "$(ls -I 'separate-stderr-*')"
}
