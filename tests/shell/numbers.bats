#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# No 'inf' and no 'nan': all commands, in each output and precision, at parameters where something is infinite, too
# large, or does not exist. A real parser reads the json.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

setup() { answers_at_all && cd "$BATS_TEST_TMPDIR" || exit; }

# Where lengths, forces, masses or frictions leave the numbers, or the train stands, hangs or flies.
scenes='set s 1; set r 1
set s 1e-4; set r 1
set r 1e6
set h 1e9; set g 1e-9; set mass 1e9
set h 1e-9; set g 1e9; set mass 1e-9
set density 1e9; set h 1e9; set g 1e9
set q 1e9; set d 0.9; set s 0.001
effect row 60; set r 1e6
effect row 55; set r 1e5; set mass 1
effect row 5; effect push 1e9
effect floor 0; effect friction 1.5
effect floor 0; set s 1; set r 1
effect row 3; effect floor 0; set s 1; set r 1
effect row 5; effect floor 0.01; set h 1e-9; set r 1.01
set angle deg; set r 1.7; effect friction 0.1
set fuel paper; set r 2.4'

# Every command that answers at once, with arguments where it takes some; those that count for long, or files, not.
calls() {
    local name
    for name in $("$DOMINO" -e complete); do
        case $name in
        quit | exit | help | complete | apropos | source | save | pool | animate | set | reset | effect | \
            place | cost | effects | plot | placement | budget | mend | rowmax | best) ;;
        theta1 | energy | omega | chain) printf '%s\n' "$name 0" "$name 1e-9" ;;
        goto) printf '%s\n' 'goto 0' 'goto 1e-6' 'goto stop' ;;
        count) printf '%s\n' 'count 112' 'count 1e300 m' 'count 1e-300' 'count 1e4000' ;;
        print) printf 'print %s\n' 1e400 1e-400 -1e4000 '1e4000 deg' 3.5e38 '1e39 m' ;;
        draw) printf '%s\n' draw 'draw 0 forces' 'draw 1e-9 forces' ;;
        curve) echo 'curve 0.4 1 3' ;;
        sweep) printf 'sweep %s\n' 's 0.1, 1 : barrier' 'r 1, 1e6, 1e9 : launch' 'r 1e6, 1e9 : row' 's 0.5, 1 : fall' ;;
        *) echo "$name" ;;
        esac
    done
}

@test "all commands in all outputs and precisions: every number is finite, else null" {
    local scene precision style status sessions=0
    calls >calls.dom
    [ "$(wc -l <calls.dom)" -gt 40 ]
    while read -r scene; do
        for precision in float double quad; do
            for style in json csv table; do
                # How a table looks is no matter of the precision, but for what it holds.
                if [ "$style$precision" = csvfloat ] || [ "$style$precision" = tablequad ]; then continue; fi
                echo "set output $style; set precision $precision; set errors on; $scene" >session.dom
                # In quad, which is slow, what shows how numbers are written.
                if [ "$precision" = quad ]; then grep -E '^(print|row|launch|draw)' calls.dom; else cat calls.dom; fi >>session.dom
                status=0
                "$DOMINO" -n --keep-going session.dom >out 2>err || status=$?
                [ "$status" -le 1 ] || same "$scene, $precision, $style: status" '0 or 1' "$status"
                [ "$(wc -l <out)" -gt 5 ] || same "$scene, $precision, $style" answers "$(cat out err)"
                same "$scene, $precision, $style" '(nothing)' "$(grep -aiwE -- '[-+]?(inf|nan|infinity)' out err || true)"
                if [ "$style" = json ]; then
                    jq -es 'length > 5' out >/dev/null || same "$scene, $precision" json "$(jq -e . out 2>&1 | tail -n 1)"
                fi
                sessions=$((sessions + 1))
            done
        done
    done <<<"$scenes"
    same sessions 112 "$sessions"
}

# Prints the value of a key in the row that jq selects, and whether the row has a reason.
null_of() { # COMMANDS SELECTION KEY REASON
    local said
    said=$(json "$1" | jq -r "select($2) | \"\(.$3)|\(.reason)\"")
    [[ $said =~ ^null\|.*$4 ]] || same "$1" "null|$4" "$said"
}

@test "what a precision cannot hold is null in json and empty in csv, with the reason" {
    null_of 'print 1e400' true value "beyond what double precision can hold; 'set precision quad'"
    null_of 'print -1e4000' true value 'beyond what double precision can hold'
    null_of 'set precision float; print 1e39' true value 'beyond what float precision can hold'
    null_of 'set precision float; print -1e39 m' true value 'beyond what float precision can hold'
    same 'a float that is one' 3e+38 "$(json 'set precision float; print 3e38' | values value)"
    same 'quad holds it' 1e+4000 "$(json 'set precision quad; print 1e4000' | values value)"
    null_of 'set r 1e6; effect row 60; row' '.domino == 60' height 'beyond what double precision can hold'
    null_of 'effect row 60; sweep r 2, 1e6 : row' '.r > 2 and .domino == 60' height 'beyond what double precision can hold'
    same csv $'value,unit,reason\n,,value is beyond what double precision can hold; \'set precision quad\' holds more' \
        "$("$DOMINO" -e 'set output csv; print 1e400')"
    # A table of csv has no column for a reason that comes with its last rows: the line is on stderr.
    for style in csv table; do
        run -0 --separate-stderr "$DOMINO" -e "set output $style; set r 1e6; effect row 60; row"
        [[ "$stderr$output" == *'is beyond what double precision can hold'* ]] || same "$style" reason "$stderr$output"
    done
    run -0 --separate-stderr "$DOMINO" -e 'set output csv; set r 1e6; effect row 60; row'
    same 'cells' 1 "$(awk -F, '{ print NF }' <<<"$output" | sort -u | wc -l)"
    [[ $output == *$'\n60,,,,' ]]
}

@test "contact forces where the contact is at the hinge, and a floor that no friction makes hold: in words" {
    [[ $("$DOMINO" -e 'set s 1; set r 1; draw forces') == *'pushed: 0: none is enough'* ]]
    null_of 'set s 1; set r 1; draw forces' '.i == 0' force 'the contact is at the hinge'
    null_of 'effect floor 0; effect friction 1.5; slip' true hit 'lifted off the floor'
    null_of 'effect row 3; effect floor 0; set s 1; set r 1; fall' '.domino == 2' floor 'lifted off the floor'
    run "$DOMINO" -e 'effect row 3; effect floor 0; set s 1; set r 1; fall'
    [[ $output == *'While dominoes fall, the foot of domino 1, while it falls, is lifted off, which no friction prevents.'* ]]
    [[ $("$DOMINO" -e 'set precision quad; count 1e4000 m') == *'one of 1e+4000 m.'* ]]
    if command -v gnuplot; then "$DOMINO" -e 'set s 1; set r 1; draw forces > x.svg' && ! grep -qE "[^a-z]nan[^a-z]" x.svg; fi
}
