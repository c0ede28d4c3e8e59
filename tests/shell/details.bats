#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Short answers, and 'details', which prints the rest of the last answer.

load common

rest() { "$DOMINO" -e "$1 > /dev/null; details"; }

@test "an answer for people is at most three sentences and seven values" {
    local command short
    while IFS='|' read -r command _; do
        short=$("$DOMINO" -e "$command")
        # A sentence ends with a full stop at the end of a line or before a capital letter.
        [ "$(grep -oE '[a-z0-9%)]\.( [A-Z]|$)' <<<"$short" | wc -l)" -le 3 ] || same "$command: sentences" 'three' "$short"
        [ "$(wc -l <<<"$short")" -le 7 ] || same "$command: lines" 'seven' "$short"
    done < <(printf '%s\n' "$commands" | grep -E '^(count|rmax|pair|best|why|goto|where|barrier)')
}

@test "'details' at the end of a command prints the same at once, into a file, too" {
    for command in 'count 112' 'rmax 0.3' 'why' 'step 2' 'barrier with r 2'; do
        same "$command" "$("$DOMINO" -e "$command; details > rest" -e 'quit')"$'\n\n'"$(cat rest)" "$("$DOMINO" -e "$command details")"
        "$DOMINO" -e "$command details > all.txt"
        same "$command > all.txt" "$("$DOMINO" -e "$command details")" "$(cat all.txt)"
    done
}

# bats test_tags=rows
@test "below the table of 'fall' one sentence is enough; the weakest domino is a detail" {
    same sentences 1 "$("$DOMINO" -e 'set row 12; fall' | grep -c '\.$')"
    same rest 'The weakest, domino 2, needs 42 % of the energy that it has.' "$(rest 'set row 12; fall')"
}

# bats test_tags=rows
@test "the details are those of the answer, even if the scene has changed; only an answer replaces them" {
    same 'another scene' "$(rest 'count 112')" "$("$DOMINO" -e 'count 112 > /dev/null; set s 0.2; effect row 5; details')"
    same 'step' "$(rest 'step 2')" "$("$DOMINO" -e 'step 2 > /dev/null; set r 1.7; details')"
    same 'a file' "$(rest 'count 112')" "$("$DOMINO" -e 'count 112 > answer.txt; details')"
    wrong 'count 112; print 2; details' 'details: the last answer has no more details'
    wrong 'details' 'details: the last answer has no more details'
    wrong 'set s 0.3; details' 'details: the last answer has no more details'
    # An answer that fails leaves the details of the one before it.
    same 'an error' "$(rest 'count 112')" "$("$DOMINO" --keep-going -e 'count 112 > /dev/null; barrier with s 0.9; details' 2>/dev/null)"
}

@test "csv and json are complete, with and without the word; 'details' alone is an error there" {
    same json "$(json 'count 112')" "$(json 'count 112 details')"
    same csv "$(csv 'rmax 0.3')" "$(csv 'rmax 0.3 details')"
    wrong 'set output json; count 112; set output table; details' 'details: the last answer has no more details'
    run -1 --separate-stderr "$DOMINO" -e 'count 112 > /dev/null; set output json; details'
    [[ $stderr == *'answers in csv and json have all their values'* ]]
}

@test "the word belongs to the command of the line, and other commands take it as a word" {
    wrong 'fuel details' "fuel: 'details' is one argument too many; usage: fuel"
    wrong 'rmax details 0.3' "rmax: '0.3' is one argument too many"
    same echo details "$("$DOMINO" -e 'echo details')"
    wrong 'let details = 3' "'details' is a command"
}

# bats test_tags=rows
@test "limits in sentences are rounded down: what they allow falls" {
    local scene growth
    while read -r scene; do
        growth=$("$DOMINO" -e "$scene; rmax" | grep -oE 'each be [0-9.]+ times' | grep -oE '[0-9]+(\.[0-9]+)?')
        expects "$scene" "$growth"
        same "$scene: r = $growth" 'goes on' "$(json "$scene; set r $growth; barrier" | values verdict)"
        growth=$("$DOMINO" -e "$scene; rmax" | grep -oE 'growth of up to [0-9.]+' | grep -oE '[0-9]+(\.[0-9]+)?') || continue
        same "$scene: r = $growth, from rest" 'all fall' "$(json "$scene; set r $growth; effect row 24; verdict" | values verdict)"
        growth=$("$DOMINO" -e "$scene; count 112 m $growth + 0.5" | grep -oE 'can each be [0-9.]+' | grep -oE '[0-9]+(\.[0-9]+)?')
        same "$scene: r = $growth, counted" 'all fall' "$(json "$scene; set r $growth; effect row 24; verdict" | values verdict)"
    done <<'END'
set s 0.4
set s 0.3
set q hollow
set q hollow; set s 0.4436
set q 3.7; set s 0.25; set d 0.1
effect friction 0.2
effect slope 3 deg; set s 0.5
effect edges 0.02
set s 0.8
set s 0.6; set d 0.3
END
}
