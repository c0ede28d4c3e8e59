#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Undo, redo, and what show lists.

load common

# bats test_tags=rows,planning
@test "undo and redo: all kinds of changes of the scene" {
    printf 'set s 0.3\nset r 1.2\n' >two.dom
    printf 'height (mm), thickness (mm), gap (mm)\n48, 7, -\n60, 8, 20\n80, 9, 30\n' >row.csv
    local before change state
    while IFS='|' read -r before change; do
        state='show; set output json; show; set output table; row'
        "$DOMINO" --keep-going -e "$before; $state" >as_was 2>&1 || true
        "$DOMINO" --keep-going -e "$before; $change > /dev/null; $state" >changed 2>&1 || true
        "$DOMINO" --keep-going -e "$before; $change > /dev/null; undo > /dev/null; $state" >undone 2>&1 || true
        "$DOMINO" --keep-going -e "$before; $change > /dev/null; undo > /dev/null; redo > /dev/null; $state" >redone 2>&1 || true
        clean() { grep . "$1" | sed 's/^-e:[0-9:]* //'; }
        same "$change" "$(clean as_was)" "$(clean undone)"
        same "$change again" "$(clean changed)" "$(clean redone)"
        ! cmp -s as_was changed || differ "$change" "$(clean as_was)" "$(clean changed)"
    done <<'END'
s = 0.5|s = 0.3
s = 0.5|reset
effect row row.csv|place 2 25 mm
effect row row.csv; place 2 25 mm|reset
effect row row.csv|change 1-2 mass +10 %
set mass 1; effect row 3; change 3 lean 2 mm|change 3 lean = -1 mm
effect row row.csv; place 2 25 mm|effect row 3
set d 0.2|precision = quad
set d 0.2|friction = 0.2
friction = 0.1|effect friction off
set d 0.2|let x = 3
let x = 4|x = 3
let x = 4|let x(a) = a
set d 0.2|source two.dom
set q hollow|design 1
END
}

# bats test_tags=rows,chance
@test "undo: the message, the end of the list, and a change that changes nothing" {
    same 'says' 'undone: r = 2' "$("$DOMINO" -e 'r = 2; undo')"
    same 'again' 'done again: r = 2' "$("$DOMINO" -e 'r = 2; undo > /dev/null; redo')"
    same 'as data' '{"change":"s = 0.3"} {"change":"s = 0.3"}' "$(json 's = 0.3; undo; redo' | paste -sd ' ' -)"
    same 'in order' '0.3 0.2 0.4' "$("$DOMINO" -e 's = 0.2; s = 0.3; print s; undo > /dev/null; print s; undo > /dev/null; print s' |
        grep . | paste -sd ' ' -)"
    same 'no change' 0.4 "$("$DOMINO" -e 's = 0.2; s = 0.2; undo > /dev/null; print s')"
    wrong undo 'there is no change to undo'
    wrong redo 'there is nothing to redo'
    wrong 's = 0.2; undo > /dev/null; s = 0.3; redo' 'there is nothing to redo'
    for i in {1..150}; do echo "seed = $i"; done >many.dom
    for i in {1..100}; do echo 'undo > /dev/null'; done >>many.dom
    same 'the last 100' 50 "$("$DOMINO" -f many.dom -e 'seed*1')"
}

# bats test_tags=rows
@test "show lists differences from the defaults" {
    same none "All parameters have their defaults, and no effect is on. 'show all' lists them." "$("$DOMINO" -e show)"
    same some 's r friction x f(a)' "$("$DOMINO" -e 's = 0.3; friction = 0.2; r = 2; let x = 2; let f(a) = 2*a; show' | awk 'NR > 1 { print $1 }' | paste -sd ' ' -)"
    same 'and changed rows' 'row 3, changed' "$("$DOMINO" -e 'effect row 3; place 2 20 mm; show' | awk '/^row/ { print $1, $2, $3 }')"
    same 'and longer rows' 'row 3, now 4' "$("$DOMINO" -e 'effect row 3; insert 2; show' | awk '/^row/ { print $1, $2, $3, $4 }' | tail -n 1)"
}
