#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Precision and tolerance.

load ../shell/common

# Checks the first digits of a number in quad.
quad() { # COMMANDS KEY DIGITS
    obtained=$(json "set precision quad; $1" | values "$2")
    same "$1: $2" "$3" "${obtained:0:${#3}}"
}

# The expected values were computed independently, by plain sums over angles in 75-digit arithmetic.
@test "quad: 30 correct digits of r_max, barrier, launch, fuel" {
    quad 'rmax' r_max 1.64422903953514910728136563949
    quad 'set q hollow; rmax' r_max 2.06377177270466132423919510133
    quad barrier theta_m 0.033609639206345952749260977383444
    quad barrier barrier 0.000585546490924827398543445669755
    quad launch omega0sq 0.003764633846114133271360875675498
    quad fuel fuel_exact 0.177287017324780688790030782681
    # A table shows as many digits as 'set digits' says, but no more than tol guarantees.
    "$DOMINO" -e 'set precision quad; set digits 29; rmax; details' | grep -q '^r_max  *1\.6442290395351491072813656395 '
}

@test "quad: typed decimals and fractions are not rounded to double" {
    same '7/48' 0 "$(json 'set d 1; set precision quad; set d 7/48; print 7/48 - d' | values value)"
    same '0.1' 0.1 "$(json 'set s 0.1; set precision quad; show s' | values value)"
    same 'theta1' 0.1 "$(json 'set precision quad; theta1 0.1' | values theta)"
    same 'pi' 3.1415926535897932384626433832795028 "$(json 'set precision quad; print pi' | values value)"
}

@test "float, double, quad: numbers for programs have the fewest digits that round-trip" {
    value=$(json 'set precision float; rmax' | values r_max)
    close float 1.6442290395351491 "$value" 1e-6
    same 'digits of a float' "$value" "$(json "set precision float; set r $value; show r" | values value)"
    [ ${#value} -le 10 ]
    value=$(json rmax | values r_max)
    same double "$(python3 -c "print(repr(float('$value')))")" "$value"
    close double 1.6442290395351491 "$value" 2e-12
    value=$(json 'set precision quad; rmax' | values r_max)
    same quad "$value" "$(json "set precision quad; set r $value; show r" | values value)"
}

@test "the default of tol follows the precision; a chosen tol changes only if the precision cannot reach it; digits never change" {
    show='show tol; show digits'
    state() { json "$1; $show" | values value | paste -sd ' ' -; }
    same double '1e-12 6' "$(state '')"
    same quad '1e-30 6' "$(state 'set precision quad')"
    same float '1e-05 6' "$(state 'set precision float')"
    same 'quad, then double' '1e-12 6' "$(state 'set precision quad; set precision double')"
    same 'chosen ones stay' '1e-06 12' "$(state 'set tol 1e-6; set digits 12; set precision quad')"
    same 'a tol below the floor becomes it' '1e-06 6' "$(state 'set tol 1e-14; set precision float')"
    same 'reset takes the precision back' '1e-12 6' "$(state 'set precision quad; set digits 9; reset; reset digits')"
    same 'reset tol' '1e-30 6' "$(state 'set precision quad; set tol 1e-3; reset tol')"
    same 'set says that tol has changed' 'tol is now 1e-30' "$("$DOMINO" -e 'set precision quad')"
    same 'and nothing where it has not' '(nothing)' "$("$DOMINO" -e 'set tol 1e-3; set precision quad')"
}

# bats test_tags=chance
@test "tables show 6 digits, or as many as 'set digits' says, but no more than tol guarantees; csv and json have all" {
    rmax() { "$DOMINO" -e "$1; rmax; details" | sed -n 's/^r_max  *\([0-9.]*\) .*/\1/p'; }
    same default 1.64422 "$(rmax '')"
    same 3 1.64 "$(rmax 'set digits 3')"
    same 12 1.64422903953 "$(rmax 'set digits 12')"
    same 'no more than tol promises' 1.64422903953 "$(rmax 'set digits 30')"
    same quad 1.644229039535149107281365639 "$(rmax 'set precision quad; set digits 28')"
    # Output for programs does not depend on 'digits'.
    for output in csv json; do
        same "$output" "$("$DOMINO" -e "set output $output; set digits 2; rmax; count 112")" \
            "$("$DOMINO" -e "set output $output; set digits 30; rmax; count 112")"
    done
}

@test "tol below what the precision can reach: an error that names the smallest tol" {
    for pair in 'float|1e-06' 'double|1e-15' 'quad|1e-33'; do
        run "$DOMINO" -e "set precision ${pair%|*}; set tol ${pair#*|}/2"
        [ "$status" -eq 1 ]
        [[ $output == *"is too small for ${pair%|*} precision; tol must be in the range ${pair#*|} .. 0.1"* ]]
        json "set precision ${pair%|*}; set tol ${pair#*|}; rmax" | grep -q '"ends_by":"barrier"'
    done
    json 'set precision float; set tol 0.1; rmax' | grep -q '"ends_by":"barrier"' # in float, 0.1 is larger than in double
}

# bats test_tags=whole
@test "searches and studies compute in double, and say so" {
    local scene='set row 6; set r 1.3; set placement 2 mm' precision command tol=1e-6 double same note='This answer is computed in double precision.'
    for precision in float quad; do
        for command in rowmax tolerance 'change 4 gap 9 cm; mend' 'placement 100' 'budget 0.9 100' 'improve' 'design 1 m' plan; do
            double=$(json "$scene; set tol $tol; $command")
            same=$(json "$scene; set precision $precision; set tol $tol; $command" | sed "s/,\"note\":\"$note\"//")
            same "$command in $precision" "$double" "$same"
        done
        for command in slip 'prove rmax' 'prove barrier'; do
            double=$(json "set tol $tol; $command")
            same=$(json "set precision $precision; set tol $tol; $command" | sed "s/,\"note\":\"$note\"//")
            same "$command in $precision" "$double" "$same"
            same "note of '$command' in $precision" "$note" "$(json "set precision $precision; $command" | values note)"
        done
        [[ $("$DOMINO" -e "set precision $precision; set row 5; slip") == *'not about the row'* ]]
        same "details in $precision" "($note)" "$("$DOMINO" -e "$scene; set precision $precision; placement 100 details" | tail -n 1)"
        same "note in $precision" "$note" "$(json "$scene; set precision $precision; rowmax" | values note)"
        same "sweep in $precision" "$(json "$scene; set tol $tol; sweep s 0.3, 0.4 : placement 50" | values probability low)" \
            "$(json "$scene; set precision $precision; set tol $tol; sweep s 0.3, 0.4 : placement 50" | values probability low)"
    done
    same 'double needs no note' '(nothing)' "$("$DOMINO" -e "$scene; placement 100 details" | grep double)"
    # What becomes the row has few digits, also in quad.
    same 's of a design' "$(json 'design 1 m; show s' | values value | tail -n 1)" "$(json 'set precision quad; design 1 m; show s' | values value | tail -n 1)"
    close 'the last domino' 1 "$(json 'set precision quad; design 1 m; row' | values height | tail -n 1)" 1e-30
}

@test "a sentence has no more digits than the tolerance justifies" {
    says 'set tol 1e-2; best' 'With the best gap, 0.53 times the height, solid dominoes can each be 1.8 times as large'
    says 'set tol 1e-3; rmax' 'solid dominoes can each be 1.64 times as large'
}
