#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Rows as people type them: what stops and by how much, files with and without units, what 'on' takes, and a push.

load common

file() { cat >"$BATS_TEST_TMPDIR/$1"; }

setup() { answers_at_all && cd "$BATS_TEST_TMPDIR" || false; }

@test "a row that stops lacks energy for its highest barrier, which comes after a domino has detached" {
    file tops.csv <<'END'
height (mm), thickness (mm), gap (mm)
100, 30, -
130, 80, 98
300, 20, 100
END
    while read -r push kinetic short_by; do
        fall=$(json "effect row tops.csv; effect push $push; fall" | tail -n 1)
        same "push $push" "$kinetic 0.957745 -$short_by" "$(printf '%.6f %.6f %.6f' "$(values kinetic <<<"$fall")" \
            "$(values barrier <<<"$fall")" "$(values margin <<<"$fall")")"
        same "push $push" "$short_by" \
            "$(printf %.6f "$(json "effect row tops.csv; effect push $push; verdict" | values short_by)")"
    done <<'END'
30 0.361154 0.596591
37 0.524509 0.433236
END
}

@test "rounded 1/s is the reach of a row, too" {
    for s in $(seq 0.2 0.01 0.64); do echo "set s $s; set r 1/s; verdict"; done >all.dom
    verdicts=$(json "set q hollow; effect row 6; source \"all.dom\"" | values verdict | sort | uniq -c | tr -s ' ')
    same 'all rows' ' 11 all fall 34 stops' "$(paste -sd ' ' <<<"$verdicts" | sed 's/  */ /g')"
    same 's = 0.55' 'all fall' "$(json 'set q hollow; set s 0.55; set r 1/s; effect row 6; verdict' | values verdict)"
    same rowmax 1.6666666666666667 "$(json 'set q hollow; effect row 6; set s 0.6; rowmax' | values r_max)"
}

@test "much friction: a stop before a lock is a verdict, with mend and placement" {
    printf 'height (mm), thickness (mm), gap (mm)\n30, 3.4, -\n40, 18, 3.4\n' | file lock.csv
    scene='effect row lock.csv; effect friction 1.35'
    verdict=$(json "$scene; verdict")
    same verdict 'stops 2 null' \
        "$(values verdict <<<"$verdict") $(values domino <<<"$verdict") $(values short_by <<<"$verdict")"
    values reason <<<"$verdict" | grep -q 'farther on friction locks'
    "$DOMINO" -e "$scene; fall" | grep -q '^The row ends at domino 2 of 2: .*locks, so that no energy is enough\.$'
    "$DOMINO" -e "$scene; fall" | grep -qE '^ +2 .* -$'
    same placement 200 "$(json "$scene; effect placement 1 mm; placement 200" | values rows)"
    "$DOMINO" -e "$scene; mend" | grep -q '^No change of a single gap'
}

@test "placement with an effect that no row can have reads nothing that was not written" { # under UBSan
    wrong 'effect edges 0.2; effect row 4; effect placement 1 mm; placement 20' 'radius'
    wrong 'effect slope 1; effect row 4; effect placement 1 mm; placement 20' 'no domino can stand upright'
}

@test "pool: an interval of two million rows" {
    # Made by awk, as a loop of bats takes half a minute.
    awk 'BEGIN {
        print "sigma,heights,seed,scene,dominoes,of,first,rows,fall,unknown,stops"
        for (i = 0; i < 20000; i++) {
            fall = i < 13952 ? 73 : 72
            printf "0.005,0,1,xcc917d87,4,2000000,%d,100,%d,0,2:%d\n", 100 * i + 1, fall, 100 - fall
        }
    }' | file blocks.csv
    pool=$(json 'pool blocks.csv')
    same pool '2000000 1453952 0.72635798 0.72759336' "$(printf '%.0f %.0f %.8f %.8f' "$(values rows <<<"$pool")" \
        "$(values fall <<<"$pool")" "$(values low <<<"$pool")" "$(values high <<<"$pool")")"
}

@test "count: a bit more than a power takes one more" {
    same more '31 2147483648' "$(json 'set h 1 m; count 1073741824.00001 m 2' |
        { read -r answer; echo "$(values dominoes <<<"$answer") $(values last_height <<<"$answer")"; })"
    same power 30 "$(json 'set h 1 m; count 1073741824 m 2' | values dominoes)"
}

@test "a file that gives no row leaves none in force, and says so" {
    printf 'height (mm), thickness (mm), gap (mm)\n48, 7, -\n48, 7, 20\n' | file good.csv
    printf 'height (mm), thickness (mm), gap (mm)\n48, 7, -\n48, 7\n' | file short.csv
    wrong 'effect row typo.csv' "cannot read 'typo\.csv': No such file or directory$"
    wrong 'effect row 5; effect row typo.csv' '; the earlier row \(N = 5\) is now off$'
    wrong 'effect row good.csv; effect row short.csv' 'short\.csv:3:1: too few cells.*; the earlier row \(good\.csv\) is now off$'
    wrong 'effect row good.csv; effect push 3; effect placement 1 mm; effect row typo.csv' \
        '\(good\.csv\) is now off, with push and placement$'
    for before in 'effect row 5' 'effect row good.csv; effect push 3'; do
        run --separate-stderr "$DOMINO" --keep-going -e "$before; effect row typo.csv; verdict; save"
        grep -q 'verdict: there is no row;' <<<"$stderr" || same "$before" 'no row' "$stderr"
    done
    same 'the next one is fine' 'all fall' \
        "$(json 'effect row 5; effect push 3; effect row typo.csv; set r 1; effect row good.csv; effect push 9; verdict' 2>&1 | values verdict)"
    # Without an error nothing of that is said, and the row before is replaced.
    run --separate-stderr "$DOMINO" -e 'effect row 5; effect row good.csv; row'
    [ "$status" -eq 0 ] && [ -z "$stderr" ]
}

@test "a length or a mass without a unit is an error that shows what it would mean" {
    while IFS='|' read -r name text pattern; do
        printf '%b' "$text" | file "$name.csv"
        wrong "effect row $name.csv" "$name\\.csv:$pattern"
    done <<'END'
height|height,thickness (mm),gap (mm)\n48,7,-\n|2:1: height has no unit: '48' would be 48 m; write 'height \(mm\)' in the first line, or '48 mm' in the cell$
gap|height (mm),thickness (mm),gap\n48,7,-\n48,7,20\n|3:6: gap has no unit: '20' would be 20 m; write 'gap \(mm\)' in the first line, or '20 mm' in the cell$
cell|height,thickness (mm),gap (mm)\n48 mm,7,-\n4*12,7,20\n|3:1: height has no unit: '4\*12' would be
mass|height (mm),thickness (mm),gap (mm),mass\n48,7,-,10\n|2:8: mass has no unit: '10' would be 10 kg; write 'mass \(g\)' in the first line$
density|height (mm);thickness (mm);gap (mm);density\n48;7;-;600\n|2:8: density has no unit: '600' would be 600 kg/m\^3; write 'density \(g/cm\^3\)' in the first line$
width|height (mm);thickness (mm);gap (mm);width\n48;7;-;24\n|2:8: width has no unit: '24' would be 24 m;
END
    # Units in every cell will do, and 0 is 0 in any unit.
    printf 'domino,height,thickness,gap,relative\n1,48 mm,7 mm,0,1\n2,4.8 cm,0.7 cm,0,2\n3,48 mm,7 mm,2 cm,1' | file cells.csv
    same cells '0.048 0.048 0.048' "$(json 'effect row cells.csv; row' | values height | paste -sd ' ')"
    # What 'row' writes has its units, with masses and without.
    for scene in 'effect row 4' 'set mass 0.01; effect row 4' 'effect row cells.csv'; do
        "$DOMINO" -e "$scene; set output csv; row > again.csv"
        head -n 1 again.csv | grep -qE '^domino,height \(m\),thickness \(m\),gap \(m\),(mass \(kg\)|relative)$'
        same "$scene" "$(json "$scene; row" | values gap)" "$(json 'effect row again.csv; row' | values gap)"
    done
}

@test "'on' says what it took, to people alone" {
    while IFS='|' read -r command line; do
        same "$command" "$line" "$("$DOMINO" -e "$command" | tail -n 1)"
        same "$command: csv" '(nothing)' "$("$DOMINO" -e "set output csv; $command")"
        same "$command: json" '(nothing)' "$(json "$command")"
    done <<'END'
effect row on|row is on now with N = 20: the number of dominoes. 'effect row N|FILE' sets another.
effect friction on|friction is on now with MU = 0.2: the friction coefficient. 'effect friction MU' sets another.
effect friction 0.3; effect friction on|friction is on with MU = 0.3: the friction coefficient. 'effect friction MU' sets another.
effect row 5; effect push on|push is on now with OMEGA = 5 rad/s: the angular velocity of the first domino. 'effect push OMEGA' sets another.
END
    same 'a value is not repeated' '(nothing)' "$("$DOMINO" -e 'effect friction 0.2; effect row 20; effect push 3')"
}

@test "mend offers a window for a gap out of reach, also where it is many heights" {
    for gap in '60 mm' '5 m'; do
        said=$("$DOMINO" -e "set r 1; effect row 5; place 2 $gap; mend" | tail -n 1)
        same "$gap" "All fall with gaps between 1.036 cm and 4.8 cm: 'place 2 3.545 cm' leaves room for errors of 1.3 cm." "$said"
    done
    same 'its end' 'all fall' "$(json 'set r 1; effect row 5; place 2 1.036 cm; verdict' | values verdict)"
    differ 'just beyond' 'all fall' "$(json 'set r 1; effect row 5; place 2 1.035 cm; verdict' | values verdict)"
    said=$("$DOMINO" -e 'set r 1; effect row 5; place 4 60 mm; mend' | tail -n 1)
    same 'down to 0' "All fall with gaps up to 4.8 cm: 'place 4 3.2 cm' leaves room for errors of 1.6 cm." "$said"
}

@test "mend reports first that the row needs a push, and how large" {
    printf 'height (mm), thickness (mm), gap (mm)\n48, 7, -\n48, 7, 5\n48, 7, 20\n' | file leans.csv
    mend=$("$DOMINO" -e 'effect row leans.csv; mend')
    sed -n 1p <<<"$mend" | grep -q '^The row needs a push: its first domino touches the second before it tips over\.$'
    push=$(sed -En "2s/^With 'effect push ([0-9.]+)' all fall\.$/\1/p" <<<"$mend")
    grep -q '^Without another push, the smallest change: widen the gap before domino 2' <<<"$mend"
    same 'that push' 'all fall' "$(json "effect row leans.csv; effect push $push; verdict" | values verdict)"
    less=$(awk -v push="$push" 'BEGIN { print 0.998 * push }')
    same 'a weaker one' stops "$(json "effect row leans.csv; effect push $less; verdict" | values verdict)"
    "$DOMINO" -e 'effect row leans.csv; effect push 0.4; mend' | sed -n 1p | grep -q '^The row needs a stronger push: '
    # Where a gap is what is wrong, no push is spoken of.
    run "$DOMINO" -e 'effect row 5; set r 1; effect push 5; place 4 60 mm; mend'
    run ! grep -qi push <<<"$output"
}

@test "sentences say 'both' of two, keep the digits before the point, and write m g s with blanks" {
    local push='set s 0.05; set r 1; effect row 3; effect push 1000'
    [[ $("$DOMINO" -n -e 'effect row 2; verdict') == 'Both fall; the last lies '* ]]
    [[ $("$DOMINO" -n -e 'effect row 3; verdict') == 'All 3 fall; the last lies '* ]]
    [[ $("$DOMINO" -n -e 'effect row 1; verdict') == 'It falls.'* ]]
    [[ $("$DOMINO" -n -e "$push; verdict") =~ 'it has '[0-9]{4,}' times the energy that it needs.' ]]
    [[ $("$DOMINO" -n -e "$push; draw") =~ 'with '[0-9]{4,}' times the energy that it needs.' ]]
    "$DOMINO" -n -e step | grep -q ' m g s; all push'
}

@test "corners of a picture are 0 where only rounding errors are left" {
    same tiny '(nothing)' "$("$DOMINO" -n -e 'set output csv; set header off; effect row 4; draw; draw at end' |
        tr , '\n' | awk '$1 != 0 && $1 < 1e-12 && $1 > -1e-12')"
}
