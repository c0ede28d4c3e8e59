#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The number of dominoes that topple a height: count.

load ../shell/common

@test "count: the quiz, and powers that are exact" {
    while IFS='|' read -r arguments dominoes exact; do
        answer=$(json "count $arguments")
        same "count $arguments" "$dominoes" "$(values dominoes <<<"$answer")"
        close "count $arguments" "$exact" "$(values exact <<<"$answer")"
    done <<END
112|20|19.126314408539823
112 2|12|11.188176705998537
0.048|0|0
0.072|1|1
49.152 2|10|10
49.153 2|11|10.000029351328536
END
}

@test "count: starts from h, the last height is at least the given one, and r = 1 reaches no larger height" {
    same 'h 1' 7 "$(json 'set h 1; count 128 2' | values dominoes)"
    close 'last height' 128 "$(json 'set h 1; count 100 2' | values last_height)"
    answer=$(json 'count 112 1')
    same 'r 1' null "$(values dominoes <<<"$answer")"
    grep -q '"reason":"[^"]' <<<"$answer"
    same 'in words' 'With r = 1 all dominoes are equally tall, so none of them reaches this height.
Solid dominoes can each be 1.59 times as large as the one before: then 17 are enough.' "$("$DOMINO" -e 'count 112 m 1')"
    same 'the reason in the details' "If its first domino just tips over, the fall ends at domino 2: it has too little energy to tip over; a push of 3.76 rad/s is enough." \
        "$("$DOMINO" -e 'set friction 0.2; count 112 m details' | grep '^If its')"
}

# bats test_tags=rows
@test "count 112 answers the quiz in the words of the quiz" {
    same 'count 112' '20 solid dominoes, each 1.5 times as large as the one before, with gaps of 0.4 times the height, topple one that is 112 m tall. Such a row falls.
Hollow dominoes can each be 2.04 times as large as the one before: then 11 are enough.' "$("$DOMINO" -e 'count 112')"
    says 'count 112 details' 'last_height 159.612 m '
    # The toppled domino is r times as tall as the last of the 20.
    close 'the 20th' "$(json 'count 112' | values last_height)" "$(json 'print 1.5 * h * 1.5^19' | values value)"
    same 'r 2 with solid dominoes' false "$(json 'count 112 2' | values feasible)"
    same 'r 2 with hollow dominoes' true "$(json 'set q hollow; count 112 2' | values feasible)"
    says 'count 112 2 details' '12 solid dominoes, ' ' would be needed ' 'Such a row does not fall.' \
        'Solid dominoes can each be 1.59 times as large as the one before: then 17 are enough.' \
        'Not possible at s = 0.4 with solid dominoes: the train has too little energy'
    same 'tall enough' 'No other domino is needed: the first is already 4.8 cm tall.' "$("$DOMINO" -e 'count 1 cm')"
    # A train that misses the next domino is also a "no", and the number is still printed.
    answer=$(json "set s 0.9; count 112")
    same "r s > 1" "20 false" "$(values dominoes <<<"$answer") $(values feasible <<<"$answer")"
    grep -q '"reason":"[^"]*without touching' <<<"$answer"
    "$DOMINO" -e 'set s 0.9; count 112 details' | grep -q 'without touching'
}

# Prints the verdict on the row of a count. The first domino tips over or is pushed.
falls() { # SCENE DOMINOES
    json "$1; effect row $(($2 + 1)); verdict" | values verdict
}

# bats test_tags=rows
@test "count agrees with 'verdict' about a row whose first domino tips over or is pushed" {
    while IFS='|' read -r scene dominoes feasible goes_on; do
        answer=$(json "$scene; count 112" | tail -n 1)
        same "$scene: dominoes" "$dominoes" "$(values dominoes <<<"$answer")"
        same "$scene: feasible" "$feasible" "$(values feasible <<<"$answer")"
        same "$scene: goes_on" "$goes_on" "$(values goes_on <<<"$answer")"
        verdict=$(falls "$scene" "$dominoes")
        [[ $feasible == true ]] && same "$scene: verdict" 'all fall' "$verdict"
        [[ $feasible == false ]] && differ "$scene: verdict" 'all fall' "$verdict"
        if [[ $feasible == false && $goes_on == true ]]; then
            push=$(values push <<<"$answer")
            same "$scene: push" 'all fall' "$(falls "$scene; effect row 2; effect push $push" "$dominoes")"
            differ "$scene: less" 'all fall' "$(falls "$scene; effect row 2; effect push 0.998*$push" "$dominoes")"
            same "$scene: with the push" true \
                "$(json "$scene; effect row 2; effect push $push; count 112" | values feasible)"
        fi
    done <<END
set r 1.5|20|true|true
set r 1.64|16|false|true
set q hollow; set s 0.1; set r 1.2|43|false|true
set r 1.59|17|true|true
set r 1.6|17|false|true
set r 2|12|false|false
set q hollow; set r 2|12|true|true
effect friction 0.2; set r 1.5|20|false|true
effect slope 1 deg; set r 1.7|15|false|true
effect edges 0.01; set r 1.5|20|true|true
END
}

# bats test_tags=rows
@test "count: how a row ends if its first domino just tips over, and how many dominoes are needed at a smaller growth" {
    says 'count 112 m 1.64 details' '16 solid dominoes, ' 'Such a row does not fall.' '1.59 times as large as the one before: then 17 are enough' \
        'just tips over, the fall ends at domino 2: it has too little energy' 'a push of 6.766 rad/s is enough'
    says 'set q hollow; set s 0.1; count 112 m 1.2 details' 'ends at domino 1: the first domino touches the second before it tips over' \
        'With these gaps no row of such dominoes starts if its first domino just tips over.'
    # The largest growth at which a row starts agrees with 'rowmax', and json has the reason.
    close r_start "$(json 'effect row 24; rowmax' | values r_max)" "$(json 'count 112' | values r_start)" 1e-8
    json 'count 112 m 1.64' | grep -q '"reason":"if its first domino just tips over, the fall ends at domino 2'
    # A short row with a push may fall although an endless train would stop.
    says 'effect row 2; effect push 19; set r 1.66; count 5 cm details' 'Such a row falls.' 'goes_on no '
}

# bats test_tags=rows,engine
@test "count asks the rigid-body engine about a row that only it can run" {
    command -v "$DOMINO" >/dev/null
    answer=$("$DOMINO" -e 'effect row 2; effect feet 0.5; count 1 m details' 2>&1) || skip 'without Chipmunk'
    grep -q 'The rigid-body engine ran the row because feet is on' <<<"$answer"
    same 'on ice' false "$(json 'effect row 2; effect feet 0.05; count 1 m' | values feasible)"
}
