#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Scenes: effects on and off, rows from files, what saves them, random errors, the floor.

load common

root=$BATS_TEST_DIRNAME/../..

# A file of the test's own.
file() { # NAME < text
    cat >"$BATS_TEST_TMPDIR/$1"
}

@test "effects are off, and entered 0 times; each alone enters its own code" {
    run -0 json effects
    same states 'off off off off off off off off off off' "$(values state <<<"$output" | paste -sd ' ' -)"
    same entered '0 0 0 0 0 0 0 0 0 0' "$(values entered <<<"$output" | paste -sd ' ' -)"
    same names 'friction slope walls edges row push placement floor feet bounce' "$(values effect <<<"$output" | paste -sd ' ' -)"
    while IFS='|' read -r commands pattern; do
        entered=$(json "$commands; effects" | values entered | sed 's/^[1-9].*/x/' | paste -sd ' ' -)
        same "$commands" "$pattern" "$entered"
    done <<'END'
effect friction 0.2|x 0 0 0 0 0 0 0 0 0
effect slope 1 deg|0 x 0 0 0 0 0 0 0 0
effect walls 1 mm|0 0 x 0 0 0 0 0 0 0
effect floor 0.2|0 0 0 0 0 0 0 x 0 0
effect row 4|0 0 0 0 x 0 0 0 0 0
effect row 4; effect push 5|0 0 0 0 x x 0 0 0 0
effect row 4; effect placement 1 mm|0 0 0 0 x 0 x 0 0 0
effect row 4; effect friction 0.1; effect floor 1|x 0 0 0 x 0 0 x 0 0
effect row 4; effect slope 1 deg|0 x 0 0 x 0 0 0 0 0
effect row 4; effect walls 1 mm|0 0 x 0 x 0 0 0 0 0
effect edges 0.01|0 0 0 x 0 0 0 0 0 0
effect row 4; effect edges 0.5 mm|0 0 0 x x 0 0 0 0 0
effect row 4; effect feet 0.5|0 0 0 0 x 0 0 0 x 0
effect row 4; effect push 5; effect bounce 0.2|0 0 0 0 x x 0 0 0 x
END
}

@test "an effect that was on and is off again leaves no trace in any answer" {
    for effect in 'friction 0.3' 'row 9; effect push 3; verdict' 'floor 1; scene'; do
        differ "effect $effect" "$(json 'rmax; barrier; duration')" "$(json "effect $effect; rmax; barrier; duration")"
    done
    same untouched "$(json 'rmax; barrier; duration; cycle 5; launch; fuel; step')" \
        "$(json 'effect friction 0.3; effect row 9; effect push 3; effect placement 1 mm; effect floor 1
effect floor off; effect placement off; effect push off; effect row off; effect friction off
rmax; barrier; duration; cycle 5; launch; fuel; step')"
    same 'mu = 0' "$(json 'barrier; duration; rmax' | values margin)" "$(json 'effect friction 0; barrier; duration; rmax' | values margin)"
    same reset "$(json rmax)" "$(json 'effect friction 0.3; effect row 9; reset; rmax')"
}

@test "friction: r_max, front speeds, its verdicts; each smaller than without" {
    close 's = 0.2' 1.48474793410 "$(json 'set q hollow; effect friction 0.2; rmax 0.2' | values r_max)"
    close 's = 0.4' 1.91495681184 "$(json 'set q hollow; effect friction 0.1; rmax 0.4' | values r_max)"
    for pair in '0 1.28427' '0.1 1.11545' '0.2 0.98392' '0.5 0.71678'; do
        speed=$(json "set r 1; set s 13/48; effect friction ${pair% *}; duration" | values speed)
        same "front speed, mu = ${pair% *}" "${pair#* }" "$(printf '%.5f' "$speed")"
    done
    same stops stops "$(json 'effect friction 1; barrier' | values verdict)"
    same locks locks "$(json 'set s 0.5; set r 1.9; effect friction 5; barrier' | values verdict)"
    same 'no paper fuel' null "$(json 'effect friction 0.2; rmax' | values r_max_paper)"
    # The curve and the count follow, too.
    same curve "$(json 'effect friction 0.2; rmax 0.3' | values r_max)" "$(json 'effect friction 0.2; curve 0.3 0.3 1' | values exact)"
    same count false "$(json 'effect friction 0.5; count 112' | values feasible)"
}

@test "slope: r_max, an error where no domino stands, and no paper fuel" {
    close '1 degree' 1.64507145 "$(json 'set q hollow; effect slope 1 deg; rmax 0.2' | values r_max)" 1e-8
    close '1 degree uphill' 1.93981351 "$(json 'set q hollow; effect slope -1 deg; rmax 0.4' | values r_max)" 1e-8
    same 'no paper fuel' null "$(json 'effect slope 1 deg; rmax' | values r_max_paper)"
    same level "$(json 'rmax; barrier' | values margin)" "$(json 'effect slope 0; rmax; barrier' | values margin)"
    wrong 'effect slope 10 deg; rmax' "no domino can stand upright on a slope of 10 deg; for this thickness the limit is 8.297 deg; for example 'effect slope 4.1 deg'"
    wrong 'effect slope -10 deg; effect row 4; fall' "the limit is 8.297 deg; for example 'effect slope -4.1 deg'"
    # The centre must be above the flat part of the foot: atan(0.2 - 2*0.05).
    wrong 'set d 0.2; effect edges 0.05; effect slope 10 deg; rmax' 'for this thickness and rounded edges the limit is 5.711 deg'
    wrong 'effect slope 1; effect row 4; effect feet 0.4; fall' 'no domino can stand upright on a slope of 57.3 deg'
    wrong 'effect slope 1 deg; set fuel paper' "first enter 'effect slope off'"
    wrong 'set fuel paper; effect slope 1 deg' "'fuel paper' cannot be combined with slope; first enter 'set fuel exact'"
    wrong 'effect slope 1 mm' 'ALPHA is an angle, not a length'
    same 'a row' 'stops' "$(json 'set r 1.6; set q hollow; effect slope -3 deg; effect row 6; effect push 3; verdict' | values verdict)"
}

@test "edges: r_max, lengths over h, a radius that does not fit, and what cannot be combined with them" {
    close 'rounded by 1 %' 1.649661 "$(json 'set q hollow; effect edges 0.01; rmax 0.2' | values r_max)" 1e-6
    close 'a length' 1.649661 "$(json 'set q hollow; effect edges 0.48 mm; rmax 0.2' | values r_max)" 1e-6
    same sharp "$(json 'rmax; barrier' | values margin)" "$(json 'effect edges 0; rmax; barrier' | values margin)"
    same 'no paper fuel' null "$(json 'effect edges 0.01; rmax' | values r_max_paper)"
    wrong 'effect edges 0.08; rmax' 'at most half of the thickness'
    wrong 'effect edges 0.08; effect row 4; fall' 'at most half of the thickness'
    wrong 'effect edges 0.6' '0 .. 0.49'
    wrong 'effect edges 0.01; set fuel paper' "'effect edges off'"
    same 'a row' 'all fall' "$(json 'set q hollow; set r 1.1; effect edges 0.01; effect row 6; verdict' | values verdict)"
}

@test "edges: the reach is (1 - 2 rho + rho pi/2)/s in every answer, also where it is below 1" {
    local scene='effect edges 0.05' row
    row=$(json "$scene; curve 0.9 0.9 1")
    close reach 1.0872664626 "$(values reach <<<"$row")" 1e-10
    close 'is r_max' "$(values reach <<<"$row")" "$(values exact <<<"$row")" 1e-14
    for plot in growth marginal; do
        close "$plot" 1.0872664626 "$("$DOMINO" -n -e "set output csv; $scene; plot $plot" | sed -n 's/^0\.9,.*,//p')" 1e-10
        "$DOMINO" -n -e "$scene; plot $plot" | grep -q 'reach: r = 0.9785/s'
    done
    row=$(json "$scene; rmax 0.98")
    same 'out of reach' 'none null' "$(values ends_by <<<"$row") $(values r_max <<<"$row")"
    [[ $(values reason <<<"$row") == *'fall past each other'* ]]
    wrong "$scene; set s 0.9; set r 1.1; fuel" 'r s = 0.99 > 0.97854.*up to 1.08726646'
    [[ $("$DOMINO" -n -e "$scene; set s 0.9; set r 1; why") == *'beyond r = 1.08727 the head'* ]]
}

@test "edges: step, why, thetac and scene name their equations; no paper fuel, no proof; a file of the row keeps radii" {
    run -0 "$DOMINO" -e 'effect edges 0.01; step; step; step; why; thetac; scene'
    for text in 'J(0) omega(0) = (J(0) - i(0)) omega_1' 'the share i(0)/J(0)' 'rho theta_c + (1 - 2 rho) sin theta_c = r s' "Newton's method"; do
        [[ $output == *"$text"* ]]
    done
    [[ $output != *'- 1) omega_1'* && $output != *'1/J(0)'* && $output != *': sin theta_c'* && $output != *'no trigonometry'* ]]
    run -0 "$DOMINO" -e 'effect friction 0.1; effect edges 0.01; step; effect row 4; scene'
    [[ $output == *'(A(0) - i(0)) omega_1'* && $output == *'S_i i(theta_i) theta_i'* && $output == *"Newton's method"* ]]
    # What a domino that detaches keeps is its energy of position there, on this floor, with these edges.
    for with in 'slope 0|(41; A17), (42; A18)|0.0638494' 'slope 1 deg|(41; A17), (42; A18)|0.0604271' 'edges 0.005|(as in 41; A17 and 42; A18)|0.0625102'; do
        IFS='|' read -r effect label keeps <<<"$with"
        run -0 "$DOMINO" -n -e "set s 0.54; set r 1.7; set q hollow; effect $effect; step; step"
        [[ $output == *"Domino 1 detaches from domino 0"*"$label"*"it keeps $keeps."* ]]
    done
    same 'no paper fuel' null "$(json 'effect edges 0.01; fuel' | values fuel_paper)"
    same 'no proof' 'not proved: trains with friction, a slope or rounded edges have no proof' "$(json 'effect edges 0.01; prove rmax' | values reason)"
    cd "$BATS_TEST_TMPDIR" || false
    printf 'height (mm),thickness (mm),gap (mm),radius (mm)\n48,7,,0.5\n60,8,20,0\n72,9,25,0.4\n' >radii.csv
    fall=$("$DOMINO" -e 'effect edges 0.01; effect row radii.csv; row > again.csv; set output json; fall')
    close 'written and read' "$(values falls <<<"$fall" | tail -n 1)" "$(json 'effect edges 0.01; effect row again.csv; fall' | values falls | tail -n 1)" 1e-14
    sed 's/,[^,]*$//' again.csv >shares.csv
    differ 'without radii' "$fall" "$(json 'effect edges 0.01; effect row shares.csv; fall')"
    same radii '0.0005 0 0.0004' "$(json 'effect edges 0.01; effect row again.csv; row' | values radius | paste -sd ' ' -)"
    for name in float double quad; do
        same "$name" 'all fall' "$(json "set q hollow; set precision $name; effect edges 0.01; effect row 5; verdict" | values verdict)"
    done
}

@test "the ledger closes with friction at every event" {
    for parameters in 'set s 0.4' 'set s 0.3; set r 1.2' 'set q hollow; set s 0.5; set r 1.8' 'set s 0.6; set r 1.4'; do
        json "$parameters; effect friction 0.2; step; step; step; step; step" | while IFS= read -r row; do
            for key in before lost gained rubbed kinetic; do
                printf '%s ' "$(values "$key" <<<"$row")"
            done
            echo
        done | awk '{ open = $1 - $2 + $3 - $4 - $5; if (NF != 5 || !(open <= 1e-9 * $1 && open >= -1e-9 * $1) || $4 < 0) { print; bad = 1 } }
            END { exit bad || NR < 3 }'
    done
}

@test "effects that need each other, or cannot be combined, say so" {
    wrong 'effect push 3' "'effect push' needs a row; first enter 'effect row N'"
    wrong 'effect placement 1 mm' "'effect placement' needs a row"
    wrong 'effect row 4; effect push 3; effect row off' "'effect push' needs the row; first enter 'effect push off'"
    wrong 'set fuel paper; effect friction 0.2' "'fuel paper' cannot be combined with friction; first enter 'set fuel exact'"
    wrong 'effect friction 0.2; set fuel paper' "'fuel paper' cannot be combined with friction; first enter 'effect friction off'"
    wrong 'fall' "there is no row; first enter 'effect row N' or 'effect row FILE'"
    wrong 'effect row 4; placement' "first enter 'effect placement 1 mm'"
    wrong 'effect row 4; effect placement 1 mm; budget 2' 'P = 2 is out of range; P is a probability'
}

@test "an effect is a parameter whose default is off: set, show and reset take it as effect does" {
    same off off "$(json 'show friction' | values value)"
    for with in 'friction 0.2|rmax' 'floor 0.5|slip' 'row 6|scene' "row $root/examples/record.csv|scene" 'placement 1 mm 0.01|scene'; do
        values=${with%|*} name=${with%% *} before=''
        [ "$name" != placement ] || before='effect row 4;'
        for command in "show $name" "${with#*|}"; do
            same "$with" "$(json "$before effect $values; $command")" "$(json "$before set $values; $command")"
            differ "$name" "$(json "$before set $values; $command")" "$(json "$before $command")"
        done
        same "$name off" off "$(json "$before set $values; set $name off; show $name" | values value)"
        same "$name reset" off "$(json "$before set $values; reset $name; show $name" | values value)"
    done
    same 'both values' "$(json 'effect row 4; effect placement 1 cm 0.1; placement 50')" \
        "$(json 'effect row 4; set placement 1 cm 0.1; placement 50')"
    same 'a value' 0.2 "$(json 'set friction 0.2; show friction' | values value)"
    same 'a file' record.csv "$(json "set row $root/examples/record.csv; show row" | values value)"
    same 'the others stay' "$(json show)" "$(json 'set friction 0.2; reset s; show')"
    [[ $("$DOMINO" -e 'set push on' 2>&1) == *"'effect push' needs a row"* ]]
    [[ $("$DOMINO" -e 'set friction on') == 'friction is on now with MU = 0.2:'* ]]
    wrong 'set friction -1' 'MU = -1 is out of range'
    wrong 'set friction 0.1 0.2' 'one argument too many; usage: effect friction MU'
    wrong 'set friction off 0.2' 'one argument too many; usage: effect friction MU'
    wrong 'set fuel paper; set friction 0.2' 'cannot be combined with friction'
    wrong 'set row 4; set push 3; reset row' "'effect push' needs the row; first enter 'effect push off'"
    wrong 'set s 0.4 0.5' "'0.5' is one argument too many; usage: set NAME VALUE"
}

@test "values of effects: units, ranges, what is missing, one too many" {
    wrong 'effect friction' "MU, the friction coefficient, is missing; for example 'effect friction 0.2'"
    wrong 'effect friction -1' 'MU = -1 is out of range'
    wrong 'effect friction 0.1 0.2' 'one argument too many; usage: effect friction MU'
    wrong 'effect friction 3 mm' 'MU is a plain number, not a length'
    wrong 'effect row 2.5' 'not a whole number'
    wrong 'effect row 0' 'out of range'
    wrong 'effect row 4; effect push 3 mm' 'OMEGA is'
    wrong 'effect row 4; effect placement 3 rad' 'SIGMA is a length, not an angle'
    wrong 'effect foo 1' "unknown effect 'foo'; use one of: friction, slope, walls, edges, row, push, placement, floor, feet, bounce"
    wrong 'effect row 4; place 1 1 cm' 'there is no gap before domino 1; K is 2 .. 4 in this row'
    wrong 'effect row 1; place 2 1 cm' 'a row of one domino has no gap'
    wrong 'effect row 4; place 2 -1' 'is not a gap'
}

@test "a wrong value leaves the scene as it was" {
    before=$("$DOMINO" -e 'effect friction 0.2; effect row 4; scene')
    after=$("$DOMINO" --keep-going -e 'effect friction 0.2; effect row 4; effect friction x; effect row 0; effect push -1; effect foo; scene' 2>/dev/null || true)
    same scene "$before" "$after"
}

@test "rows from csv: the same row in every way of writing it" {
    file plain.csv <<'END'
height (m),thickness (m),gap (m),mass (kg)
0.048,0.007,,0.008
0.06,0.009,0.025,0.016
0.08,0.012,0.03,0.04
END
    file units.csv <<'END'
# made by hand
"gap (mm)"; height (cm); mass (g); thickness (mm)

-; 4.8; 8; 7
25; 60 mm; 16; 9 # a comment
30; 8; 40; 12
END
    printf '\xef\xbb\xbfheight (m)\tthickness (m)\tgap (m)\tmass (kg)\r\n0.048\t0.007\t0\t0.008\r\n0.06\t0.009\t0.025\t0.016\r\n0.08\t0.012\t0.03\t0.04' | file crlf.csv
    plain=$(json "effect row $BATS_TEST_TMPDIR/plain.csv; effect push 8; verdict; fall")
    same 'the row' 'all fall 3' "$(head -n 1 <<<"$plain" | values verdict) $(head -n 1 <<<"$plain" | values domino)"
    for name in units crlf; do
        other=$(json "effect row $BATS_TEST_TMPDIR/$name.csv; effect push 8; verdict; fall")
        same "$name: verdict" "$(values verdict <<<"$plain")" "$(values verdict <<<"$other")"
        falls=0
        while read -r a b; do
            close "$name" "$a" "$b"
            falls=$((falls + 1))
        done < <(paste <(values kinetic <<<"$plain") <(values kinetic <<<"$other"))
        same "$name: falls" 3 "$falls"
    done
    # 'row' in csv is such a file.
    "$DOMINO" -e "effect row $BATS_TEST_TMPDIR/plain.csv; set output csv; row > $BATS_TEST_TMPDIR/again.csv"
    same again "$plain" "$(json "effect row $BATS_TEST_TMPDIR/again.csv; effect push 8; verdict; fall")"
    "$DOMINO" -e "set q 3; effect row 4; set output csv; row > $BATS_TEST_TMPDIR/train.csv"
    same 'row of a train' "$(json 'set q 3; effect row 4; verdict' | cut -c 1-60)" \
        "$(json "effect row $BATS_TEST_TMPDIR/train.csv; verdict" | cut -c 1-60)"
}

@test "rows from csv: what is wrong, with file, line and column; nothing half loaded" {
    while IFS='|' read -r name text pattern; do
        printf '%b' "$text" | file "$name.csv"
        wrong "effect row $BATS_TEST_TMPDIR/$name.csv" "$name\\.csv:$pattern"
        same "$name: nothing is loaded" 'there is no row' \
            "$("$DOMINO" --keep-going -e "effect row $BATS_TEST_TMPDIR/$name.csv; fall" 2>&1 | grep -o 'there is no row')"
    done <<'END'
hight|hight,thickness,gap\n1,1,1\n|1:1: unknown column 'hight'; did you mean 'height'\?
missing|height (m),thickness (m)\n1,1\n|1:[0-9]+: the column 'gap' is missing
few|height (m),thickness (m),gap (m)\n1,0.1,0\n1,0.1\n|3:[0-9]+: too few cells: 2
many|height (m),thickness (m),gap (m)\n1,0.1,0,3\n|2:[0-9]+: too many cells
empty|height (m),thickness (m),gap (m)\n1,,0\n|2:3: thickness is missing
gap|height (m),thickness (m),gap (m)\n1,0.1,0\n1,0.1,-0.2\n|3:7: gap = -0.2 m is negative
zero|height (m),thickness (m),gap (m)\n0,0.1,0\n|2:1: height = 0
comma|height (m);thickness (m);gap (m)\n1,5x;0.1;0\n|2:4: height at 'x': 'x' is not a unit
unit|height (m),thickness (m),gap (m)\n1 s,0.1,0\n|2:1: height: this is a time
word|height (m),thickness (m),gap (m)\nx,0.1,0\n|2:1: height
nothing|height (m),thickness (m),gap (m)\n|[0-9]+:[0-9]+: the file has no dominoes
both|height (m),thickness (m),gap (m),mass (kg),density\n1,.1,0,1,1\n|1:[0-9]+: both mass and density are given; leave
END
    wrong "effect row $BATS_TEST_TMPDIR/none.csv" "cannot read '.*none.csv': No such file"
    wrong "effect row $BATS_TEST_TMPDIR" 'cannot read'
}

@test "a file beside the script is found from anywhere; a safe session reads none" {
    cd / || false
    "$DOMINO" -f "$root/examples/record.dom" | grep -q 'All 10 fall'
    run --separate-stderr "$DOMINO" --safe -e "effect row $root/examples/record.csv"
    [ "$status" -eq 1 ]
    grep -q 'safe session' <<<"$stderr"
}

@test "a saved session and the row beside it can be moved together, and find each other from anywhere" {
    cd "$BATS_TEST_TMPDIR" || false
    mkdir -p here/rows other
    for height in 48 24; do
        printf '%s\n' 'height (mm), thickness (mm), gap (mm)' "$height, 7, -" "$height, 7, 20" >row$height.csv
    done
    cp row48.csv here/row.csv && cp row48.csv here/rows/below.csv && cp row24.csv other/row.csv
    "$DOMINO" -e 'effect row here/row.csv; save here/beside.dom; save other/elsewhere.dom' \
        -e 'effect row here/rows/below.csv; save here/below.dom'
    (cd here && "$DOMINO" -e 'effect row row.csv; save bare.dom')
    mv here there
    for name in beside below bare; do
        for from in . there other /; do
            same "$name from $from" '0.048 0.048' \
                "$(there=$PWD/there && cd "$from" && json "source $there/$name.dom; set output json; row" | values height | paste -sd ' ' -)"
        done
    done
    wrong 'source other/elsewhere.dom' "cannot read '$PWD/here/row.csv': No such file"
    same 'to a device' "effect row \"$PWD/there/row.csv\"" "$("$DOMINO" -e 'effect row there/row.csv; save /dev/stdout' | grep 'effect row')"
}

@test "a row that stops: where, short by how much; mend finds the smallest change, and it is one" {
    scene="effect row $root/examples/record.csv; effect push 3; effect friction 0.3"
    verdict=$(json "$scene; verdict")
    same stops 'stops 8' "$(values verdict <<<"$verdict") $(values domino <<<"$verdict")"
    close short_by "$(json "$scene; fall" | tail -n 1 | values margin | tr -d -)" "$(values short_by <<<"$verdict")"
    mend=$(json "$scene; mend" | head -n 1)
    domino=$(values domino <<<"$mend") to=$(values to <<<"$mend") change=$(values change <<<"$mend")
    same saved 'all fall' "$(json "$scene; place $domino $to; verdict" | values verdict)"
    [[ $change == *[1-9]* ]]
    less=$(awk -v to="$to" -v change="$change" 'BEGIN { printf "%.17g", to - 1e-4 * change }')
    same 'a bit less does not' stops "$(json "$scene; place $domino $less; verdict" | values verdict)"
}

@test "rows of the model: one, the verdicts of each end, thousands, taller than the Earth" {
    same one 'all fall' "$(json 'effect row 1; effect push 5; verdict' | values verdict)"
    same weak stops "$(json 'effect row 1; effect push 1; verdict' | values verdict)"
    same leans leans "$(json 'set s 0.05; set r 1; effect row 3; verdict' | values verdict)"
    same misses misses "$(json 'effect row 3; effect push 9; place 2 60 mm; verdict' | values verdict)"
    file low.csv <<'END'
height (m),thickness (m),gap (m)
0.1,0.015,
0.05,0.0075,0.02
END
    wrong "effect row $BATS_TEST_TMPDIR/low.csv; effect push 9; fall" 'its upper edge passes above the next domino'
    same thousands 'all fall 10000' "$(json 'set r 1; set s 0.3; effect row 10000; effect push 5; verdict' |
        sed -E 's/.*"verdict":"([^"]*)","domino":([0-9]*).*/\1 \2/')"
    # 0.048 m 2^40 is 5e7 km: the numbers are large, and right.
    close tall "$(awk 'BEGIN { printf "%.17g", 0.048 * 2 ^ 40 }')" \
        "$(json 'set q 3; set s 0.35; set r 1.9; set r 2; set s 0.42; effect row 41; row' | tail -n 1 | values height)"
}

@test "rowmax tends to rmax as the row grows longer" {
    train=$(json 'set q hollow; rmax' | values r_max)
    row=$(json 'set q hollow; effect row 60; effect push 20; rowmax' | values r_max)
    close 'of the train' 2.06377177270466132 "$train"
    within rowmax "$train" "$row" 'd > -5e-10 && d < 5e-7'
}

@test "rowmax of a row that stops at r = 1, and of one that falls at no growth" {
    scene='set q 2; set d 0.4; set s 0.5180007117763072; effect slope 0.01'
    same 'as the pair' "$(json "$scene; pair" | values r_max | cut -c1-12)" "$(json "$scene; effect row 2; rowmax" | values r_max | cut -c1-12)"
    said=$("$DOMINO" -e "$scene; effect row 2; rowmax")
    grep -qxF "All fall from r = 1.12268 on; with a smaller growth the row ends earlier: 'set r 1; fall'." <<<"$said"
    same none "at no growth from 1 to 2.5 do all dominoes fall; 'set r 1; fall' shows why" \
        "$(json 'effect friction 3; effect row 5; rowmax' | values reason)"
}

@test "placement: the same rows whatever the number of threads, another seed others; the interval is right" {
    scene='set q hollow; set r 5/3; effect friction 0.3; effect row 11; effect placement 1 mm'
    one=$(json "$scene; set threads 1; placement 400")
    for threads in 2 3 7 0; do same "$threads threads" "$one" "$(json "$scene; set threads $threads; placement 400")"; done
    differ 'another seed' "$one" "$(json "$scene; set seed 2; placement 400")"
    # Nothing goes wrong without errors: all of 200 fall, with the exact interval 0.025^(1/200) .. 1.
    exact=$(json 'effect row 5; effect placement 0; placement 200')
    same all '200 1' "$(values fall <<<"$exact") $(values high <<<"$exact")"
    close low "$(awk 'BEGIN { printf "%.15g", exp(log(0.025) / 200) }')" "$(values low <<<"$exact")"
    # And the budget: at its sigma the share falls, within the interval.
    sigma=$(json "$scene; budget 0.8 400" | values sigma)
    share=$(json "$scene; effect placement $sigma m; placement 400" | values probability)
    within 'the share that falls' 0.8 "$share" 'd >= 0 && d < 0.0125'
}

@test "the floor: what the struck domino needs, with the centre of percussion; and its verdict" {
    # |1/2 - (1 + d^2)/(3 a)| / (d/2), a = sqrt(1/r^2 - s^2), where the head is the worst.
    close struck "$(awk 'BEGIN { d = 7 / 48; a = sqrt(1 - 0.16); x = 0.5 - (1 + d * d) / (3 * a); printf "%.17g", (x < 0 ? -x : x) / (d / 2) }')" \
        "$(json 'set r 1; slip' | values hit)"
    same slips true "$(json 'set r 1; effect floor 0.5; slip' | values slips)"
    local train='set s 0.2; set r 1.3; effect floor'
    same 'slips in motion' false "$(json "$train 0.4; slip" | values slips)"
    same 'slips in a hit' true "$(json "$train 0.4; slip" | values slips_hit)"
    same holds false "$(json "$train 3; slip" | values slips_hit)"
    local scene='set s 0.2; set r 1.3; effect row 6; effect floor'
    run "$DOMINO" -e "$scene 0.4; fall"
    [[ $output == *'None slips then on a floor with a friction of 0.4.'* ]]
    [[ $output == *'the foot of domino 1, when domino 2 is hit, is the first to slip then; it needs 2.504.'*'is no verdict'* ]]
    run "$DOMINO" -e "$scene 0.1; verdict"
    [[ $output == *'the foot of domino 2, while it falls, is the first to slip then; it needs 0.1041.'*'can stop sooner'* ]]
    run "$DOMINO" -e "$scene 3; verdict"
    [[ $output == *'None slips then on a floor with a friction of 3.'* && $output != *'feet that hold'* ]]
    # The two columns are the motion and the hit of the library.
    close floor 0.1041 "$(json "$scene 1; fall" | values floor | tail -1)" 1e-3
    close floor_hit 2.504 "$(json "$scene 1; fall" | values floor_hit | tail -1)" 1e-3
}

@test "walls: times of a train, masses and inertia of a row, and walls that have no room" {
    close 'thin walls' 1.02806 "$(awk -v a="$(json 'effect walls 1e-6; duration' | values seconds)" -v b="$(json 'duration' | values seconds)" 'BEGIN { printf "%.17g", a / b }')" 1e-5
    same 'a solid block' "$(json 'duration' | values seconds)" "$(json 'effect walls 3.5 mm; duration' | values seconds)"
    same growth "$(json 'rmax; set fuel paper; rmax')" "$(json 'effect walls 1 mm; rmax; set fuel paper; rmax')"
    same proof "$(json 'prove rmax 0.4' | sed 's/"seconds.*//')" "$(json 'effect walls 1 mm; prove rmax 0.4' | sed 's/"seconds.*//')"
    # Boards of 10 mm, 0.6 g/cm^3: the block of 200 x 60 x 100 mm, less the hollow of 180 x 40 x 80 mm.
    printf 'height (mm), thickness (mm), gap (mm), density (g/cm^3), width (mm)\n200, 60, -, 0.6, 100\n300, 60, 80, 0.6, 120\n' >"$BATS_TEST_TMPDIR/boxes.csv"
    local row="effect row $BATS_TEST_TMPDIR/boxes.csv"
    close 'mass of a box' "$(awk 'BEGIN { print 0.6 * (20 * 6 * 10 - 18 * 4 * 8) / 1000 }')" "$(json "$row; effect walls 10 mm; row" | values mass | head -1)"
    close 'with its width' "$(awk 'BEGIN { print 0.6 * (30 * 6 * 12 - 28 * 4 * 10) / 1000 }')" "$(json "$row; effect walls 10 mm; row" | values mass | tail -1)"
    close 'mass of a block' 0.72 "$(json "$row; row" | values mass | head -1)"
    close 'of a train, by its density' "$(awk 'BEGIN { print 700 * (48 * 7 * 24 - 46 * 5 * 22) / 1e9 }')" \
        "$(json 'set density 700; effect walls 1 mm; effect row 3; row' | values mass | head -1)"
    differ 'times of a row' "$(json "$row; effect push 9; verdict" | values seconds)" \
        "$(json "$row; effect push 9; effect walls 10 mm; verdict" | values seconds)"
    # The rigid-body engine has boxes of the same moment of inertia.
    local train='set r 1.3; set s 0.3; effect row 6; effect friction 0.1; effect walls 1 mm'
    [ -n "${SANITIZED-}" ] || close 'in the engine' "$(json "$train; verdict" | values seconds)" "$(json "$train; set method engine; verdict" | values seconds)" 2e-3
    wrong "$row; effect walls 31 mm; verdict" 'walls of 3.1 cm leave no room in domino 1, which is 6 cm thick: they are 3 cm at most'
    wrong 'effect walls 4 mm; duration' 'walls of 4 mm leave no room in the domino, which is 7 mm thick: they are 3.5 mm at most'
    wrong 'effect walls 0' 'THICKNESS = 0 is out of range'
    wrong 'effect walls -1 mm' 'is out of range'
    wrong 'effect walls 3 deg' 'enter it without a unit, or as a length'
}

@test "save keeps the scene, and source brings it back" {
    scene="effect friction 0.3; effect row $root/examples/record.csv; effect push 3; place 8 0.75; effect placement 2 mm 0.01; effect floor 0.5"
    differ 'a scene' "$(json 'effect row 5; fall; verdict')" "$(json "$scene; fall; verdict")"
    same saved "$(json "$scene; fall; verdict")" "$(json "$scene; save $BATS_TEST_TMPDIR/scene.dom; reset; source $BATS_TEST_TMPDIR/scene.dom; fall; verdict")"
    grep -qx 'effect friction 0.3' "$BATS_TEST_TMPDIR/scene.dom"
    grep -qx 'effect placement 0.002 0.01' "$BATS_TEST_TMPDIR/scene.dom"
}

@test "the help of each effect has its source" {
    for name in friction row push placement floor; do
        "$DOMINO" -e "help $name" | grep -q '^Source: '
    done
}
