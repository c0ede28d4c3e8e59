#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Effects: how they are switched on and off, their values, and the effects that they need; friction,
# slope, edges, walls and the floor.

load ../shell/common

# bats test_tags=rows,chance
@test "an effect that has been switched off again changes no answer" {
    for effect in 'friction 0.3' 'row 9; effect push 3; verdict' 'floor 1; show'; do
        differ "effect $effect" "$(json 'rmax; barrier; duration')" "$(json "effect $effect; rmax; barrier; duration")"
    done
    same untouched "$(json 'rmax; barrier; duration; cycle 5; launch; fuel; step')" \
        "$(json 'effect friction 0.3; effect row 9; effect push 3; effect placement 1 mm; effect floor 1
effect floor off; effect placement off; effect push off; effect row off; effect friction off
rmax; barrier; duration; cycle 5; launch; fuel; step')"
    same 'mu = 0' "$(json 'barrier; duration; rmax' | values margin)" "$(json 'effect friction 0; barrier; duration; rmax' | values margin)"
    same reset "$(json rmax)" "$(json 'effect friction 0.3; effect row 9; reset; rmax')"
}

# bats test_tags=sweeps
@test "friction: r_max, front speeds and verdicts; all are smaller than without friction" {
    close 's = 0.2' 1.48474793410 "$(json 'set q hollow; effect friction 0.2; rmax 0.2' | values r_max)"
    close 'front speed' 0.98392 "$(json 'set r 1; set s 13/48; effect friction 0.2; duration' | values speed)" 1e-5
    same stops stops "$(json 'effect friction 1; barrier' | values verdict)"
    same locks locks "$(json 'set s 0.5; set r 1.9; effect friction 5; barrier' | values verdict)"
    same 'no paper fuel' null "$(json 'effect friction 0.2; rmax' | values r_max_paper)"
}

# bats test_tags=rows,explain,engine
@test "slope: r_max, an error if no domino stands, and no paper fuel" {
    close '1 degree' 1.64507145 "$(json 'set q hollow; effect slope 1 deg; rmax 0.2' | values r_max)" 1e-8
    close '1 degree uphill' 1.93981351 "$(json 'set q hollow; effect slope -1 deg; rmax 0.4' | values r_max)" 1e-8
    same level "$(json 'rmax; barrier' | values margin)" "$(json 'effect slope 0; rmax; barrier' | values margin)"
    wrong 'effect slope 10 deg; rmax' "no domino can stand upright on a slope of 10 deg; for this thickness the limit is 8.297 deg; enter, for example, 'set slope 4.1 deg'"
    wrong 'effect slope -10 deg; effect row 4; fall' "the limit is 8.297 deg; enter, for example, 'set slope -4.1 deg'"
    # The centre must be above the flat part of the foot: atan(0.2 - 2*0.05).
    wrong 'set d 0.2; effect edges 0.05; effect slope 10 deg; rmax' 'for this thickness and rounded edges the limit is 5.711 deg'
    for ask in rmax 'set row 4; fall'; do
        wrong "set d 0.0134; set slope 2.6 deg; set edges 0.0166; $ask" 'edges with a radius of 0.0166 h do not fit: .*'
    done
    wrong 'effect slope 1; effect row 4; effect feet 0.4; fall' 'no domino can stand upright on a slope of 57.3 deg'
    wrong 'effect slope 1 deg; set fuel paper' "first enter 'set slope off'"
    wrong 'set fuel paper; effect slope 1 deg' "'fuel paper' cannot be combined with slope; first enter 'set fuel exact'"
    wrong 'effect slope 1 mm' 'ALPHA is an angle, not a length'
    same 'a row' 'stops' "$(json 'set r 1.6; set q hollow; effect slope -3 deg; effect row 6; effect push 3; verdict' | values verdict)"
}

# bats test_tags=rows,explain,fit
@test "edges: r_max, lengths over h, a radius that does not fit, and what cannot be combined with them" {
    close 'rounded by 1 %' 1.649661 "$(json 'set q hollow; effect edges 0.01; rmax 0.2' | values r_max)" 1e-6
    close 'a length' 1.649661 "$(json 'set q hollow; effect edges 0.48 mm; rmax 0.2' | values r_max)" 1e-6
    same sharp "$(json 'rmax; barrier' | values margin)" "$(json 'effect edges 0; rmax; barrier' | values margin)"
    wrong 'effect edges 0.08; rmax' 'at most half of the thickness'
    wrong 'effect edges 0.6' '0 .. 0.49'
    same 'the largest radius' '0.49 0.49' "$(json 'set edges 0.49; show edges; set precision quad; set edges 0.49; show edges' | values value | paste -sd ' ')"
    wrong 'effect edges 0.01; set fuel paper' "'set edges off'"
    same 'a row' 'all fall' "$(json 'set q hollow; set r 1.1; effect edges 0.01; effect row 6; verdict' | values verdict)"
}

# bats test_tags=rows,pictures,sweeps
@test "edges: the reach is (1 - 2 rho + rho pi/2)/s in every answer, even if it is below 1" {
    local scene='effect edges 0.05' row
    row=$(json "$scene; curve 0.9 0.9 1")
    close reach 1.0872664626 "$(values reach <<<"$row")" 1e-10
    close 'is r_max' "$(values reach <<<"$row")" "$(values exact <<<"$row")" 1e-14
    close plot 1.0872664626 "$("$DOMINO" -n -e "set output csv; $scene; plot growth" | sed -n 's/^0\.9,.*,//p')" 1e-10
    "$DOMINO" -n -e "$scene; plot growth" | grep -q 'reach: r = 0.9785/s'
    row=$(json "$scene; rmax 0.98")
    same 'out of reach' 'none null' "$(values ends_by <<<"$row") $(values r_max <<<"$row")"
    [[ $(values reason <<<"$row") == *'each domino falls past the next one'* ]]
    wrong "$scene; set s 0.9; set r 1.1; fuel" 'r s = 0.99 > 0.97854.*the largest r for this s is 1.08726$'
}

# bats test_tags=rows,explain,proof
@test "edges: thetac shows no equation of sharp edges; there is no paper fuel and no proof; a row file keeps the radii" {
    same 'no equation' 0 "$("$DOMINO" -e 'effect edges 0.01; thetac' | grep -c 'sin theta_c')"
    says 'set s 0.54; set r 1.7; set q hollow; step; step details' 'follower 1 detaches from the domino in front of it' 'theta_leave'
    same 'no paper fuel' null "$(json 'effect edges 0.01; fuel' | values fuel_paper)"
    same "no paper fuel on a slope" null "$(json 'effect slope 2 deg; fuel' | values fuel_paper)"
    same 'no proof' 'not proved: there is no proof for trains with effects that change their motion' "$(json 'effect edges 0.01; prove rmax' | values reason)"
    printf 'height (mm),thickness (mm),gap (mm),radius (mm)\n48,7,,0.5\n60,8,20,0\n72,9,25,0.4\n' >radii.csv
    fall=$("$DOMINO" -e 'effect edges 0.01; effect row radii.csv; row > again.csv; set output json; fall')
    close 'written and read' "$(values falls <<<"$fall" | tail -n 1)" "$(json 'effect edges 0.01; effect row again.csv; fall' | values falls | tail -n 1)" 1e-14
    sed 's/,[^,]*$//' again.csv >shares.csv
    differ 'without radii' "$fall" "$(json 'effect edges 0.01; effect row shares.csv; fall')"
    same radii '0.0005 0 0.0004' "$(json 'effect edges 0.01; effect row again.csv; row' | values radius | paste -sd ' ' -)"
}

# bats test_tags=rows,chance,sweeps,explain,engine
@test "effects that need each other, or cannot be combined, say so" {
    # What is about a row may be set before there is a row, but a command about the row needs one.
    same 'a push' "$(json 'set row 9; set push 3; verdict')" "$(json 'set push 3; set row 9; verdict')"
    same 'feet' "$(json 'set row 4; set feet 0.4; rowmax' 2>/dev/null | head -c 20)" "$(json 'set feet 0.4; set row 4; rowmax' 2>/dev/null | head -c 20)"
    same 'a push stays' "$(json 'set row 9; set push 3; verdict' | tail -n 1)" "$(json 'set row 4; set push 3; set row off; set row 9; verdict' | tail -n 1)"
    wrong 'set push 3; verdict' "there is no row; first enter 'set row N'"
    same 'the order' "$(json 'effect row 9; effect placement 3 mm; placement 100')" \
        "$(json 'effect placement 3 mm; effect row 9; placement 100')"
    wrong 'set fuel paper; effect friction 0.2' "'fuel paper' cannot be combined with friction; first enter 'set fuel exact'"
    wrong 'effect friction 0.2; set fuel paper' "'fuel paper' cannot be combined with friction; first enter 'set friction off'"
    same 'both in one with' "$(csv 'set fuel paper; rmax')" "$(csv 'effect friction 0.2; rmax with fuel paper friction off')"
    same 'swept' "paper,,,,,,'fuel paper' cannot be combined with friction; first enter 'set friction off'" \
        "$(csv 'effect friction 0.2; sweep fuel exact, paper : rmax' | tail -n 1)"
    wrong 'fall' "there is no row; first enter 'set row N' or 'set row FILE'"
    wrong 'effect row 4; placement' "first enter 'set placement 1 mm'"
    wrong 'effect row 4; effect placement 1 mm; budget 2' 'P = 2 is out of range; P is a probability'
}

# bats test_tags=rows,chance,explain,engine
@test "an effect is a parameter whose default is off: set, show and reset work as effect does" {
    same off off "$(json 'show friction' | values value)"
    for with in 'friction 0.2|rmax' 'floor 0.5|slip' 'row 6|effects' "row $root/examples/record.csv|effects" 'placement 1 mm 0.01|effects'; do
        values=${with%|*} name=${with%% *} before=''
        [ "$name" != placement ] || before='set row 4;'
        for command in "show $name" "${with#*|}"; do
            same "$with" "$(json "$before effect $values; $command")" "$(json "$before set $values; $command")"
            differ "$name" "$(json "$before set $values; $command")" "$(json "$before $command")"
        done
        same "$name off" off "$(json "$before set $values; set $name off; show $name" | values value)"
        same "$name reset" off "$(json "$before set $values; reset $name; show $name" | values value)"
    done
    [[ $("$DOMINO" -e 'set friction on') == 'friction is on: 0.2.'* ]]
    wrong 'set friction -1' 'MU = -1 is out of range'
    wrong 'set friction 0.1 0.2' 'one argument too many; usage: set friction MU'
    wrong 'set row 4; set feet 0.4; set error_floor 0.1; set feet off' "'set error_floor' needs the feet; first enter 'set error_floor off'"
    wrong 'set s 0.4 0.5' "'0.5' is one argument too many; usage: set NAME VALUE"
}

# bats test_tags=rows,chance,engine
@test "values of effects: units, ranges, missing and surplus arguments" {
    wrong 'effect friction' "VALUE is missing; usage: effect NAME VALUE"
    wrong 'effect friction 3 mm' 'MU is a plain number, not a length'
    wrong 'effect row 2.5' 'not a whole number'
    wrong 'effect row 4; effect push 3 mm' 'OMEGA is'
    wrong 'effect row 4; effect placement 3 rad' 'SIGMA is a length, not an angle'
    wrong 'effect foo 1' "unknown parameter 'foo'"
    wrong 'effect row 4; place 2 -1' "a change of the gap by -1 needs a unit, as in '-1 m'"
    wrong 'effect row 4; place 2 -1 m' 'domino 2: gap = -0.9712 m is negative'
}

# bats test_tags=rows,chance,engine
@test "the floor: the friction that the struck domino needs, and the verdict" {
    # The head needs the most: |1/2 - (1 + d^2)/(3 a)| / (d/2) with a = sqrt(1/r^2 - s^2).
    close struck "$(awk 'BEGIN { d = 7 / 48; a = sqrt(1 - 0.16); x = 0.5 - (1 + d * d) / (3 * a); printf "%.17g", (x < 0 ? -x : x) / (d / 2) }')" \
        "$(json 'set r 1; slip' | values hit)"
    same slips true "$(json 'set r 1; effect floor 0.5; slip' | values slips)"
    local train='set s 0.2; set r 1.3; effect floor'
    wrong 'set s 0.01; effect slope 3 deg; slip' "a cycle releases no energy; 'why' says more"
    same 'slips in motion' false "$(json "$train 0.4; slip" | values slips)"
    same 'slips in a hit' true "$(json "$train 0.4; slip" | values slips_hit)"
    same holds false "$(json "$train 3; slip" | values slips_hit)"
    local scene='set s 0.2; set r 1.3; effect row 6; effect floor'
    run "$DOMINO" -e "$scene 0.4; fall"
    [[ $output == *'While dominoes fall, '*'on this floor, with 0.4, no foot slips.'* ]]
    [[ $output == *'When dominoes are hit, '*', the foot of domino 1 slips first, when domino '*'by up to a tenth'* ]]
    says "$scene 0.1; verdict" 'While dominoes fall, ' ', the foot of domino 2 slips first, when domino ' 'can stop sooner'
    run "$DOMINO" -e "$scene 3; verdict"
    [[ $output == *'When dominoes are hit, '*'on this floor, with 3, no foot slips.'* && $output != *'feet do not slip'* ]]
}

# bats test_tags=rows,chance,explain,fit,proof,engine,planning
@test "walls: times of a train, masses and inertia of a row, and walls that have no room" {
    close 'thin walls' 1.02806 "$(awk -v a="$(json 'effect walls 1e-6; duration' | values seconds)" -v b="$(json 'duration' | values seconds)" 'BEGIN { printf "%.17g", a / b }')" 1e-5
    same 'a solid block' "$(json 'duration' | values seconds)" "$(json 'effect walls 3.5 mm; duration' | values seconds)"
    # Boards of 10 mm with 0.6 g/cm^3 make a box of 200 x 60 x 100 mm with a hollow of 180 x 40 x 80
    # mm.
    printf 'height (mm), thickness (mm), gap (mm), density (g/cm^3), width (mm)\n200, 60, -, 0.6, 100\n300, 60, 80, 0.6, 120\n' >"boxes.csv"
    local row="effect row boxes.csv"
    close 'mass of a box' "$(awk 'BEGIN { print 0.6 * (20 * 6 * 10 - 18 * 4 * 8) / 1000 }')" "$(json "$row; effect walls 10 mm; row" | values mass | head -1)"
    close 'with its width' "$(awk 'BEGIN { print 0.6 * (30 * 6 * 12 - 28 * 4 * 10) / 1000 }')" "$(json "$row; effect walls 10 mm; row" | values mass | tail -1)"
    close 'mass of a block' 0.72 "$(json "$row; row" | values mass | head -1)"
    differ 'times of a row' "$(json "$row; effect push 9; verdict" | values seconds)" \
        "$(json "$row; effect push 9; effect walls 10 mm; verdict" | values seconds)"
    # The boxes in the rigid-body engine have the same moment of inertia.
    local train='set r 1.3; set s 0.3; effect row 6; effect friction 0.1; effect walls 1 mm'
    [ -n "${SANITIZED-}" ] || close 'in the engine' "$(json "$train; verdict" | values seconds)" "$(json "$train; set method engine; verdict" | values seconds)" 2e-3
    # Dominoes up to a given height are solid, and taller dominoes are boxes.
    local tall='set r 1.5; set density 600; effect row 7'
    same 'all solid' "$(json "$tall; row; verdict")" "$(json "$tall; effect walls 12 mm 1 m; row; verdict")"
    close 'mass of the first box' "$(awk 'BEGIN { OFMT = "%.17g"; h = 0.048 * 1.5^5; t = h * 7 / 48; print 600 * (h * h / 2 * t - (h - 0.024) * (h / 2 - 0.024) * (t - 0.024)) }')" \
        "$(json "$tall; effect walls 12 mm 30 cm; row" | values mass | sed -n 6p)" 1e-9
    wrong "$tall; effect walls 3 cm 30 cm; verdict" 'walls of 3 cm do not fit into domino 6'
    wrong "$row; effect walls 31 mm; verdict" 'walls of 3.1 cm do not fit into domino 1, which is 6 cm thick; walls of 3 cm make it solid'
    wrong 'effect walls 4 mm; duration' 'walls of 4 mm do not fit into the domino, which is 7 mm thick; walls of 3.5 mm make it solid'
    wrong 'effect walls 3 deg' 'enter it without a unit, or as a length'
}

# bats test_tags=rows
@test "'on' prints the value that it chose, but not in csv and json" {
    while IFS='|' read -r command line; do
        same "$command" "$line" "$("$DOMINO" -e "$command" | tail -n 1)"
        same "$command: csv" '(nothing)' "$("$DOMINO" -e "set output csv; $command")"
        same "$command: json" '(nothing)' "$(json "$command")"
    done <<'END'
effect row on|row is on: 20. 'set row N|FILE' sets another value.
effect friction on|friction is on: 0.2. 'set friction MU' sets another value.
effect friction 0.3; effect friction on|friction is on: 0.3. 'set friction MU' sets another value.
effect row 5; effect push on|push is on: 5 rad/s. 'set push OMEGA' sets another value.
END
    same 'a value is not repeated' '(nothing)' "$("$DOMINO" -e 'effect friction 0.2; effect row 20; effect push 3')"
}
