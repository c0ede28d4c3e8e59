#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Mend: the smallest change that makes a row fall.

load ../shell/common

@test "verdict says where a row stops and how much energy is missing, and mend finds the smallest change that makes the row fall" {
    scene="effect row $root/examples/record.csv; effect push 3; effect friction 0.3"
    verdict=$(json "$scene; verdict")
    same stops 'stops 8' "$(values verdict <<<"$verdict") $(values domino <<<"$verdict")"
    close short_by "$(json "$scene; fall" | tail -n 1 | values margin | tr -d -)" "$(values short_by <<<"$verdict")"
    mend=$(json "$scene; mend" | head -n 1)
    domino=$(values domino <<<"$mend") to=$(values to <<<"$mend") change=$(values change <<<"$mend")
    same saved 'all fall' "$(json "$scene; place $domino $to; verdict" | values verdict)"
    [[ $change == *[1-9]* ]]
    # The advice is a whole number of millimetres on the safe side.
    advice=$("$DOMINO" -e "$scene; mend" | sed -n "s/.* to 72 cm: '\(place 8 [^']*\)'\.$/\1/p")
    same advice 'place 8 72 cm' "$advice"
    same 'as advised' 'all fall' "$(json "$scene; $advice; verdict" | values verdict)"
    less=$(awk -v to="$to" -v change="$change" 'BEGIN { printf "%.17g", to - 1e-4 * change }')
    same 'a bit less does not' stops "$(json "$scene; place $domino $less; verdict" | values verdict)"
}

@test "mend offers a window for a gap out of reach, even if the gap is many times as wide as the domino is tall" {
    for gap in '60 mm' '5 m'; do
        said=$("$DOMINO" -e "set r 1; effect row 5; place 2 $gap; mend details" | tail -n 1)
        same "$gap" "All dominoes fall if this gap is between 1.036 cm and 4.8 cm: 'place 2 3.545 cm' leaves a margin." "$said"
    done
    same 'its end' 'all fall' "$(json 'set r 1; effect row 5; place 2 1.036 cm; verdict' | values verdict)"
    differ 'just beyond' 'all fall' "$(json 'set r 1; effect row 5; place 2 1.035 cm; verdict' | values verdict)"
    said=$("$DOMINO" -e 'set r 1; effect row 5; place 4 60 mm; mend details' | tail -n 1)
    same 'down to 0' "All dominoes fall if this gap is between 0 mm and 4.8 cm: 'place 4 3.2 cm' leaves a margin." "$said"
}

@test "mend reports first that the row needs a push, and how large" {
    printf 'height (mm), thickness (mm), gap (mm)\n48, 7, -\n48, 7, 5\n48, 7, 20\n' | file leans.csv
    mend=$("$DOMINO" -e 'effect row leans.csv; mend')
    sed -n 1p <<<"$mend" | grep -q '^The row needs a push: its first domino touches the second before it tips over\.$'
    push=$(sed -En "2s/^With 'set push ([0-9.]+)', all dominoes fall\.$/\1/p" <<<"$mend")
    grep -q '^The smallest change, if the push stays as it is: widen the gap before domino 2' <<<"$mend"
    same 'that push' 'all fall' "$(json "effect row leans.csv; effect push $push; verdict" | values verdict)"
    less=$(awk -v push="$push" 'BEGIN { print 0.998 * push }')
    same 'a weaker one' stops "$(json "effect row leans.csv; effect push $less; verdict" | values verdict)"
    "$DOMINO" -e 'effect row leans.csv; effect push 0.4; mend' | sed -n 1p | grep -q '^The row needs a stronger push: '
    # If a gap is wrong, no push is mentioned.
    run "$DOMINO" -e 'effect row 5; set r 1; effect push 5; place 4 60 mm; mend'
    run ! grep -qi push <<<"$output"
}

@test "mend: if a push helps, missing changes of gaps are not mentioned; without any advice, it points to why" {
    same 'a push' "The row needs a stronger push: its first domino does not tip over.
With 'set push 2.521', all dominoes fall." "$("$DOMINO" -e 'set row 8; set push 2; mend')"
    # a push that would lift the first domino off the floor is no advice
    [[ $("$DOMINO" -e 'set row 8; set s 0.1; set push 1; mend') == *"first domino off the floor. Enter 'set push 3', and then 'mend' again."* ]]
    [[ $("$DOMINO" -e 'set row 8; set d 0.9; mend') == *"first domino off the floor. Enter 'set push 13', and then 'mend' again."* ]]
    [[ $("$DOMINO" -e 'set row 8; set s 0.2; mend') == *"'why' says with which gaps or growth an endless train keeps falling." ]]
}
