#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of placement: studies and budgets.

load ../shell/common

@test "placement: the rows depend on the seed but not on the number of threads, and the interval is right" {
    scene='set q hollow; set r 5/3; effect friction 0.3; effect row 11; effect placement 1 mm'
    one=$(json "$scene; set threads 1; placement 400")
    for threads in 2 3 7 0; do same "$threads threads" "$one" "$(json "$scene; set threads $threads; placement 400")"; done
    differ 'another seed' "$one" "$(json "$scene; set seed 2; placement 400")"
    # Without errors all 200 rows fall, and the interval is exactly 0.025^(1/200) .. 1.
    exact=$(json 'effect row 5; effect placement 0; placement 200')
    same all '200 1' "$(values fall <<<"$exact") $(values high <<<"$exact")"
    close low "$(awk 'BEGIN { printf "%.15g", exp(log(0.025) / 200) }')" "$(values low <<<"$exact")"
    # With the sigma that budget finds, 80 % to 81 % of the rows fall.
    sigma=$(json "$scene; budget 0.8 400" | values sigma)
    share=$(json "$scene; effect placement $sigma m; placement 400" | values probability)
    within 'the share that falls' 0.8 "$share" 'd >= 0 && d < 0.0125'
}

@test "placement with a value that no row can have reads no uninitialized memory" { # under UBSan
    wrong 'effect edges 0.2; effect row 4; effect placement 1 mm; placement 20' 'radius'
    wrong 'effect slope 1; effect row 4; effect placement 1 mm; placement 20' 'no domino can stand upright'
}

@test "budget finds sigma while the effect placement is off, and says how many rows fall with this sigma" {
    # Errors this large make dominoes touch, which with friction have no motion to solve.
    [ -n "$(json 'effect row 12; set r 1.2; effect friction 0.2; budget 0.9' | values sigma)" ]
    said=$("$DOMINO" -e 'effect row 13; budget 0.95 300')
    grep -qE '^The error of the gap may be 1\.9 mm \(one standard deviation\): then [0-9]+ of 300 rows fall \(92\.[0-9] % to 97\.[0-9] %\), with 95 % confidence\.$' <<<"$said"
    says 'effect row 13; budget 0.9 200 friction' 'The error of the friction may be 0.12 (one standard deviation)'
    same 'no effect is on' off "$(json 'effect row 13; budget 0.95 50; show placement' | tail -n 1 | values value)"
    # The interval agrees with a study of placement with this sigma.
    answer=$(json 'effect row 13; effect placement 1.9 mm; placement 300')
    same low 92 "$(values low <<<"$answer" | awk '{ print int(100 * $1) }')"
    same high 98 "$(values high <<<"$answer" | awk '{ print int(100 * $1) + 1 }')"
    same 'gaps of the effect are not used' "$(json 'effect row 13; budget 0.95 50')" \
        "$(json 'effect row 13; effect placement 9 mm; budget 0.95 50')"
    differ 'its heights are' "$(json 'effect row 13; budget 0.95 50')" \
        "$(json 'effect row 13; effect placement 9 mm 0.02; budget 0.95 50')"
}

@test "after a signal that ends a script, placement answers for the rows that were counted" {
    for call in 'placement 9000000'; do
        for wait in 0.3 1 3 9 27; do # wait until some rows have been counted
            "$DOMINO" -n -e "echo begun; set output csv; effect row 13; effect placement 8 mm; $call; print 7" >out 2>err 3>&- &
            until grep -q begun out; do kill -0 $!; done # the answer before 'placement' is written when it begins
            sleep "$wait"
            kill -TERM $!
            wait $! && status=0 || status=$?
            same "$call: ended by SIGTERM" 143 "$status"
            same "$call: said" "-e:1: ${call%% *}: interrupted" "$(cat err)"
            ! grep -q '^[0-9].*interrupted' out || break
        done
        same "$call: names and numbers" 2 "$(sed 1d out | wc -l)"
    done
}

# bats test_tags=sweeps,engine,save
@test "random errors of every kind are saved, undone and swept like effects, and may need the effect to which they apply" {
    scene='set q hollow; set r 1.6; effect friction 0.3; effect row 9; effect push 3'
    all='effect placement 2 mm uniform; effect error_place 1 mm; effect error_thickness 2 %; effect error_mass 5 % uniform
effect error_lean 0.1 deg; effect error_friction 0.05; effect error_slope 0.2 deg; effect error_push 0.2'
    whole=$(json "$scene; $all; placement 40")
    "$DOMINO" -e "$scene; $all; save scene.dom"
    same saved "$whole" "$(json 'source scene.dom; set output json; placement 40')"
    grep -qx 'set placement 2 mm 0 uniform' scene.dom
    same undone "$(json "$scene; effect placement 2 mm; placement 40")" \
        "$(json "$scene; effect placement 2 mm; effect error_mass 0.2; undo; placement 40" | tail -n 1)"
    same swept "$(json "$scene; effect placement 2 mm; effect error_friction 0.1; placement 40" | values fall)" \
        "$(json "$scene; effect placement 2 mm; sweep error_friction 0.05, 0.1 : placement 40" | values fall | tail -n 1)"
    wrong 'effect error_mass 0.1; placement' 'there is no row'
    wrong 'effect row 4; effect error_radius 0.1' "needs the effect edges; first enter 'set edges on'"
    wrong 'effect row 4; effect error_floor 0.1' 'feet'
    wrong 'effect row 4; effect error_push 0.1' 'push'
    wrong 'effect edges 0.01; effect row 4; effect error_lean 0.1 deg; placement 5' 'cannot be combined with rounded edges'
    wrong 'effect row 4; effect feet 0.4; effect error_lean 0.1 deg; placement 5' \
        "this row because feet is on; first enter 'set error_lean off'"
    wrong 'effect row 4; effect error_mass 0.1 foo' 'use one of: normal, uniform'
    wrong 'effect row 4; budget 0.9 20 all' "'all' needs random errors"
}

@test "budget finds the size of any single error, and one factor for all errors" {
    row='set q hollow; set r 1.6; effect friction 0.3; effect row 9; effect placement 2 mm; effect error_thickness 2 %'
    size=$(json "$row; budget 0.8 100 thickness" | values sigma)
    share=$(json "$row; effect error_thickness $size; placement 100" | values probability)
    within 'the share that falls' 0.8 "$share" 'd >= 0 && d < 0.03'
    factor=$(json "$row; budget 0.8 100 all" | values sigma)
    share=$(json "$row; effect placement 2*$factor mm; effect error_thickness 0.02*$factor; placement 100" | values probability)
    within 'the share with all errors scaled' 0.8 "$share" 'd >= 0 && d < 0.03'
}
