#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Rows: verdicts, causes of stops, rowmax, gaps.

load ../shell/common

@test "row K lists one domino, and the mass of the whole row is below the table" {
    local scene='set density 650; set row 5'
    same 'domino 3' 1 "$(json "$scene; row 3" | wc -l)"
    close 'its mass' "$(awk 'BEGIN { print 650 * 0.108 * 0.01575 * 0.054 }')" "$(json "$scene; row 3" | values mass)"
    same 'the same row' "$(json "$scene; row" | sed -n 3p)" "$(json "$scene; row 3")"
    mass=$(json "$scene; row" | values mass | awk '{ sum += $1 } END { printf "%.2f", 1000 * sum }')
    same 'all' "All 5 weigh $mass g." "$("$DOMINO" -e "$scene; row" | tail -n 1)"
    [[ $("$DOMINO" -e 'set row 5; row') != *weigh* ]]
    wrong "$scene; row 6" 'row: the row has 5 dominoes$'
}

# bats test_tags=engine
@test "rows of the model: a single domino, each way to end, thousands of dominoes, dominoes taller than the Earth" {
    same one 'all fall' "$(json 'effect row 1; effect push 5; verdict' | values verdict)"
    same weak stops "$(json 'effect row 1; effect push 1; verdict' | values verdict)"
    same leans leans "$(json 'set s 0.05; set r 1; effect row 3; verdict' | values verdict)"
    same misses misses "$(json 'effect row 3; effect push 9; place 2 60 mm; verdict' | values verdict)"
    file low.csv <<'END'
height (m),thickness (m),gap (m)
0.1,0.015,
0.05,0.0075,0.02
END
    wrong "effect row low.csv; effect push 9; fall" \
        "its upper edge passes above the next domino.* contact that follows; the rigid-body engine includes it: 'set method engine'$"
    same thousands 'all fall 10000' "$(json 'set r 1; set s 0.3; effect row 10000; effect push 5; verdict' |
        sed -E 's/.*"verdict":"([^"]*)","domino":([0-9]*).*/\1 \2/')"
    # The last domino is 0.048 m times 2^40, which is 5e7 km.
    close tall "$(awk 'BEGIN { printf "%.17g", 0.048 * 2 ^ 40 }')" \
        "$(json 'set q 3; set s 0.35; set r 1.9; set r 2; set s 0.42; effect row 41; row' | tail -n 1 | values height)"
}

@test "rowmax converges to rmax as the row gets longer" {
    train=$(json 'set q hollow; rmax' | values r_max)
    row=$(json 'set q hollow; effect row 60; effect push 20; rowmax' | values r_max)
    close 'of the train' 2.06377177270466132 "$train"
    within rowmax "$train" "$row" 'd > -5e-10 && d < 5e-7'
}

@test "rowmax of a row that stops at r = 1 but falls at larger growths, and of a row that does not fall at any growth" {
    scene='set q 2; set d 0.4; set s 0.5180007117763072; effect slope 0.01'
    same 'as the pair' "$(json "$scene; pair" | values r_max | cut -c1-12)" "$(json "$scene; effect row 2; rowmax" | values r_max | cut -c1-12)"
    said=$("$DOMINO" -e "$scene; effect row 2; rowmax")
    grep -qxF "All dominoes fall if r is between 1.12269 and r_max, but not if r is smaller, as 'set r 1; fall' shows." <<<"$said"
    same none "there is no growth from 1 to 2.5 at which all dominoes fall; 'set r 1; fall' shows why" \
        "$(json 'effect friction 3; effect row 5; rowmax' | values reason)"
}

@test "rowmax: all dominoes fall at this growth, and not at a slightly larger one, unless the reach ends it" {
    while IFS='|' read -r scene end; do
        r=$(json "$scene; rowmax" | values r_max)
        same "$scene: at $r" 'all fall' "$(json "$scene; set r $r*(1-1e-9); verdict" | values verdict)"
        same "$scene: above $r" "$end" "$(json "$scene; set r $r*(1+1e-9); verdict" 2>/dev/null | values verdict)"
    done <<'END'
set row 2|stops
set s 0.3; set q 3; set row 7; set push 6|stops
set s 0.6; set d 0.1; set row 5; set friction 0.2|stops
set s 0.8; set q 2.5; set d 0.25; set row 4; set push 9|misses
set row 1; set push 6|all fall
END
    same 'touching dominoes' 'null' "$(json 'set s 0.05; set row 3; rowmax' | values r_max)"
}

# bats test_tags=chance
@test "with much friction, a row that stops before friction would lock it has a verdict; mend and placement work, too" {
    printf 'height (mm), thickness (mm), gap (mm)\n30, 3.4, -\n40, 18, 3.4\n' | file lock.csv
    scene='effect row lock.csv; effect friction 1.35'
    verdict=$(json "$scene; verdict")
    same verdict 'stops 2 null' \
        "$(values verdict <<<"$verdict") $(values domino <<<"$verdict") $(values short_by <<<"$verdict")"
    values reason <<<"$verdict" | grep -q 'friction would lock the row'
    "$DOMINO" -e "$scene; fall" | grep -q '^The fall ends at domino 2 of 2: .*with more energy, friction would lock the row at a larger tilt\.$'
    "$DOMINO" -e "$scene; fall" | grep -qE '^ +2 .* -$'
    same placement 200 "$(json "$scene; effect placement 1 mm; placement 200" | values rows)"
    "$DOMINO" -e "$scene; mend" | grep -q '^The search found no change of a single gap'
}

# bats test_tags=pictures
@test "sentences say 'both' for two, and do not round digits before the point" {
    local push='set s 0.05; set r 1; effect row 3; effect push 1000'
    [[ $("$DOMINO" -n -e 'effect row 2; verdict') == 'Both fall in '*' s.'* ]]
    [[ $("$DOMINO" -n -e 'effect row 3; verdict') == 'All 3 fall in '*' s.'* ]]
    [[ $("$DOMINO" -n -e 'effect row 1; verdict') == 'It falls.'* ]]
    [[ $("$DOMINO" -n -e "$push; verdict") == *', has more than 100 times the energy that it needs.' ]]
    [[ $("$DOMINO" -n -e "$push; draw") == *'which has more than 100 times the energy that it needs.'* ]]
}

@test "place: a gap out of reach is allowed, and a number without a unit is in m" {
    wrong 'effect row 3; place 9 3' 'there is no gap before domino 9'
    same metres 0.03 "$(json 'effect row 3; place 2 0.03; row' | values gap | sed -n 2p)"
    same unit 3 "$(json 'effect row 3; place 2 3 m; row' | values gap | sed -n 2p)"
}

@test "fall: the table has energies in J if the first domino has a mass" {
    run -0 "$DOMINO" -e 'set mass 0.02; effect row 3; fall'
    same heads 'domino height hit falls omega kinetic barrier energy' "$(echo ${lines[0]})"
    same units 'cm s s rad/s J J %' "$(echo ${lines[1]})"
    run -0 "$DOMINO" -e 'effect row 3; fall'
    same 'without a mass' 'domino height hit falls omega energy' "$(echo ${lines[0]})"
}
