#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# How many dominoes it takes: count.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

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
49.151 2|10|9.9999706480743
END
}

@test "count: h counts, the last height reaches the height, r = 1 reaches nothing" {
    same 'h 1' 7 "$(json 'set h 1; count 128 2' | values dominoes)"
    close 'last height' 128 "$(json 'set h 1; count 100 2' | values last_height)"
    answer=$(json 'count 112 1')
    same 'r 1' null "$(values dominoes <<<"$answer")"
    grep -q '"reason":"[^"]' <<<"$answer"
}

@test "count 112 answers the quiz as a person asks it" {
    same 'count 112' '20 dominoes, each 1.5 times as large as the one before, topple one of 112 m.
toppled: 159.6 m; the 20th domino is 106.4 m tall
can it fall? yes' "$("$DOMINO" -e 'count 112' | head -n 3)"
    answer=$("$DOMINO" -e 'count 112')
    for words in '^Falling with growth 1\.5 at s = 0\.4' '^ *hollow *yes;.* 2\.06377 .* 11 dominoes' \
        '^ *solid *yes;.* 1\.64423 .* 16 dominoes'; do
        grep -q "$words" <<<"$answer" || same 'count 112' "$words" "$answer"
    done
    # The toppled domino is one growth larger than the last of the 20.
    close 'the 20th' "$(json 'count 112' | values last_height)" "$(json 'print 1.5 * h * 1.5^19' | values value)"
    same 'r 2 with solid dominoes' false "$(json 'count 112 2' | values feasible)"
    same 'r 2 with hollow dominoes' true "$(json 'set q hollow; count 112 2' | values feasible)"
    answer=$("$DOMINO" -e 'count 112 2')
    for words in '^12 dominoes, .* would be needed' '^can it fall? no$' '^Falling with growth 2 ' '^ *hollow *yes' \
        '^ *solid *no;.*1\.64423' 'not possible at s = 0\.4 with solid dominoes: the train has too little energy'; do
        grep -q "$words" <<<"$answer" || same 'count 112 2' "$words" "$answer"
    done
    # A mass exponent that has no word gets its own line; a synonym gets none.
    "$DOMINO" -e 'set q 3.5; count 112' | grep -q '^ *q = 3\.5 *yes'
    same 'hollow and solid' 2 "$("$DOMINO" -e 'count 112' | grep -c '^ .*growth up to')"
    for pair in '0.05|the first domino is 4.8 cm tall' '0.1|the 2nd domino' '0.15|the 3rd domino' '0.2|the 4th domino' \
        '4|the 11th domino' '6|the 12th domino' '9|the 13th domino' '200|the 21st domino'; do
        [[ $("$DOMINO" -e "count ${pair%|*}") == *"; ${pair#*|}"* ]] || same "$pair" "${pair#*|}" "$("$DOMINO" -e "count ${pair%|*}")"
    done
    same 'tall enough' 'No domino is needed: the first is already 4.8 cm tall.' "$("$DOMINO" -e 'count 1 cm' | head -n 1)"
    # A train that misses the next domino is a "no", too: the number is there all the same.
    answer=$(json "set s 0.9; count 112")
    same "r s > 1" "20 false" "$(values dominoes <<<"$answer") $(values feasible <<<"$answer")"
    grep -q '"reason":"[^"]*without touching' <<<"$answer"
    "$DOMINO" -e 'set s 0.9; count 112' | grep -q 'without touching'
    answer=$(json 'count 112')
    same 'feasible' true "$(values feasible <<<"$answer")"
    same 'feasible: no reason' '(nothing)' "$(values reason <<<"$answer")"
}
