#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Improve: the most reliable row.

load ../shell/common

scene='set r 1.6; set s 0.45; set q 3; effect row 3; place 3 7.4 cm; effect placement 3 mm'

@test "improve: the session gets the new row, its probability agrees with placement, and undo restores the old row" {
    json "$scene; set threads 1; improve sizes grid 1 mm; placement; row; undo; row" >answers
    [ "$(values before <answers)" != "$(values probability <answers | head -n 1)" ]
    same probability "$(values probability <answers | head -n 1)" "$(values probability <answers | tail -n 1)"
    within better "$(values before <answers)" "$(values probability <answers | head -n 1)" 'o > e'
    same 'whole mm' 3 "$(values gap <answers | head -n 3 | awk '{ x = 1000 * $1; d = x - int(x + 0.5); n += d * d < 1e-12 } END { print n }')"
    same undone "$(json "$scene; row" | values gap)" "$(values gap <answers | tail -n 3)"
    same 'other threads' "$(grep '"changed"' answers)" "$(json "$scene; set threads 3; improve sizes grid 1 mm" | grep '"changed"')"
}

@test "improve: refusals say what to do" {
    "$DOMINO" -e 'effect row 5; effect friction 3; effect placement 1 mm; improve sizes' | grep -q "No better row was found.*'mend' looks for a change"
    wrong 'effect row 3; improve' "needs random errors; first enter 'set placement 1 mm'"
    wrong "$scene; improve boards 5 mm" "without 'sizes', only gaps change"
    wrong "$scene; improve sizes hall 9 cm" 'has no room for these dominoes'
    wrong "$scene; improve grid 1 m" 'a grid of 1 m is too coarse: domino 1 is 4.8 cm tall and cannot reach across a gap of this length'
    wrong "$scene; improve sizes boards 1 m" 'no room for dominoes of these boards.*or thinner boards'
    wrong "$scene; effect walls 2 mm; improve sizes boards 3 mm" "no row that falls was found within these limits; enter other values of 'hall', 'grid' or 'boards'"
    wrong "$scene; improve sizes boards 0" 'the thickness of a board must be a length above 0'
}
