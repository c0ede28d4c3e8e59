#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# 'remove' and 'insert': a row loses and gains dominoes.

load ../shell/common

# Prints the column KEY of the row after COMMANDS, in one line.
column() { json "$2; row" | values "$1" | paste -sd ' ' -; } # KEY COMMANDS

four() {
    printf 'height (mm), thickness (mm), gap (mm), mass (g), colour\n48, 7, -, 5, red\n72, 10, 20, 17, blue\n108, 15, 30, 60, green\n162, 23, 45, 200, black\n' >four.csv
}

@test "remove: numbers, ranges and lists; the gaps before the others stay" {
    same one '0.048 0.072 0.162 0.243' "$(column height 'set row 5; remove 3')"
    same gaps '0 0.0288 0.0648 0.0972' "$(column gap 'set row 5; remove 3')"
    for list in 2,4 '4, 2' 2,4-4 2..2,4:4; do
        same "$list" '0.048 0.108 0.243' "$(column height "set row 5; remove $list")"
    done
    same 'a range' '0.048 0.243' "$(column height 'set row 5; remove 2:4')"
    same 'the first: the new first domino has no gap' '0 0.0432 0.0648' "$(column gap 'set row 4; remove 1')"
    same 'twice' '0.048 0.243' "$(column height 'set row 5; remove 2; remove 2-3')"
    same 'one undo, and redo' '5 4' "$(json 'set row 5; remove 3; undo; row; redo; row' | values domino | awk '$1 == 1 && NR > 1 { print last } { last = $1 } END { print last }' | paste -sd ' ')"
    same people '2 dominoes removed; the row has 3.' "$(echo 'set row 5; remove 2,4' | "$DOMINO")"
    same show '5, now 3' "$("$DOMINO" -e 'set row 5; remove 2,4; show' | sed -n 's/^row  *\(5, now 3\) .*/\1/p')"
}

@test "insert: a copy, which gets a gap if it is the second domino" {
    same copy '0.048 0.072 0.108 0.108 0.162' "$(column height 'set row 4; insert 3')"
    same 'at the end' '0.048 0.072 0.072' "$(column height 'set row 2; insert 3')"
    same 'at the beginning: the second domino gets a gap' '0 0.0192 0.0288' "$(column gap 'set row 2; insert 1')"
    same 'one domino' '0 0.0192' "$(column gap 'set row 1; insert 2')"
    same people 'domino 2: 7.2 cm tall and 1.05 cm thick; the row has 4.' "$(echo 'set row 3; insert 2' | "$DOMINO")"
    same 'copies of changes' '0.009 0.009' "$(column thickness 'set row 2; change 2 thickness 9 mm; insert 2; remove 1')"
}

@test "insert: another height, and the rest in proportion" {
    local scene row
    same 'sizes and gap' '0.03 0.004375 0.012' "$(for key in height thickness gap; do json 'set row 3; insert 2 height 3 cm; row' | sed -n 2p | values $key; done | paste -sd ' ')"
    same 'width, edges' '0.015 0.0015' "$(for key in width radius; do json 'set row 3; set width 0.25; change all width 24 mm; change 2 radius 3.6 mm; insert 2 height 3 cm; row' | sed -n 2p | values $key; done | paste -sd ' ' | awk '{ print $1 * 1.5, $2 }')"
    for scene in 'set q solid' 'set q hollow' 'set walls 1 mm'; do # the same density, except that walls are as thick as before
        row=$(json "$scene; set density 600; set row 4; insert 3 height 30 cm; row" | sed -n 3p)
        same "$scene" "$(json "$scene; set density 600; set row 4; insert 3; change 3 height 30 cm; change 3 thickness 43.75 mm; change 3 width 15 cm; row" | sed -n 3p | values mass)" "$(values mass <<<"$row")"
    done
    same 'at the end' '0.072 0.3 0.12' "$(json 'set row 2; insert 3 height 30 cm; row' | sed -n 2,3p | values height | paste -sd ' ') $(json 'set row 2; insert 3 height 30 cm; row' | sed -n 3p | values gap)"
    same 'after the only domino' 0.036 "$(json 'set row 1; set s 0.4; insert 2 height 9 cm; row' | sed -n 2p | values gap)"
    same people 'domino 2: 3.6 cm tall and 5.25 mm thick; the row has 4.' "$(echo 'set row 3; insert 2 height 36 mm' | "$DOMINO")"
}

@test "remove and insert: rows from files keep masses and leans; files and scripts" {
    four
    same masses '0.005 0.2' "$(column mass 'set row four.csv; remove 2,3' 2>/dev/null)"
    same 'masses known by the first domino of the file' '0.017 0.06' "$(column mass 'set row four.csv; remove 1; remove 3' 2>/dev/null)"
    "$DOMINO" -e 'set row four.csv; remove 2; insert 3; insert 1; row > new.csv' >/dev/null 2>&1
    same 'and back' "$(json 'set row four.csv; remove 2; insert 3; insert 1; row' 2>/dev/null)" "$(json 'set row new.csv; row' 2>/dev/null)"
    printf 'height (mm), thickness (mm), gap (mm), lean (mm)\n48, 7, -, 0\n48, 7, 20, 2\n48, 7, 20, 0\n' >lean.csv
    same lean '0 0.002 0.002 0' "$(column lean 'set row lean.csv; insert 2')"
}

# bats test_tags=chance,save
@test "remove and insert: any sequence is saved and read again, and undone" {
    four
    local seed edits step base saved
    for seed in 1 2 3 4 5 6 7 8; do
        base='set row 5'
        [ $((seed % 2)) = 0 ] || base='set row four.csv; set q hollow'
        edits=$(awk -v seed=$seed 'BEGIN { srand(seed); n = 4; for (i = 0; i < 9; i++) { k = 1 + int(n * rand()); what = rand()
            if (what < 0.3 && n > 2) { print "remove " k; n-- }
            else if (what < 0.5) { print "insert " k (what < 0.4 ? " height " 40 + int(60 * rand()) " mm" : ""); n++ }
            else print "change " k " " (what < 0.85 ? "mass" : "thickness") " +" 1 + int(20 * rand()) " %" } }' | paste -sd ';')
        saved=$(json "$base; $edits; row; save saved.dom" 2>/dev/null)
        [ "$(wc -l <<<"$saved")" -gt 2 ]
        same "$edits" "$saved" "$(json 'source saved.dom; set output json; row' 2>/dev/null)"
        same "undone: $edits" "$(json "$base; row" 2>/dev/null)" "$(json "$base; $edits; $(for step in 1 2 3 4 5 6 7 8 9; do printf 'undo; '; done) row" 2>/dev/null | grep -v change)"
    done
}

@test "remove and insert: wrong input is one line, and changes nothing" {
    wrong 'remove 3' "there is no row; first enter 'set row N' or 'set row FILE'"
    wrong 'set row 5; remove 6' 'there is no domino 6; this row has 5'
    wrong 'set row 5; remove 4-2' "'4-2' names no dominoes; write the smaller number first"
    wrong 'set row 5; remove all' "a row has at least one domino; 'set row off' removes the row"
    wrong 'set row 5; remove' 'K is missing; usage: remove K'
    wrong 'set row 5; insert 9' "there is no place 9 in this row of 5 dominoes; 'insert 6' adds one at its end"
    wrong 'set row 5; insert 3 30 cm' "unknown size '30'; use one of: height"
    wrong 'set row 5; insert 3 height' "the height is missing; enter, for example, 'insert 3 height 30 cm'"
    wrong 'set row 5; insert 3 height 1e12 m' 'the new domino: .* is too large'
    same 'nothing changed' '0.048 0.072' "$(json 'set row 2; remove 3; remove 1-2; insert 9; insert 1 1 kg; insert 1 height 0 m; row' 2>/dev/null | values height | paste -sd ' ')"
}
