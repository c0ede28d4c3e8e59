#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Lines: comments, blanks, line ends, quotes, letters beyond ASCII, and the end of a session.

load common

@test "standard input: no prompt, no echo, no banner" {
    same 'nothing' '(nothing)' "$(printf 'set s 0.3\nset r 1.2\n\n# only this\n' | "$DOMINO" 2>&1)"
    same 'empty' '(nothing)' "$("$DOMINO" </dev/null 2>&1)"
    same 'a known answer' 42 "$(printf 'set s 0.3\n\nprint 6*7\n# only this\n' | "$DOMINO" 2>&1)"
    same 'only the answer' "$(json fuel)" "$(printf 'set output json\nfuel\n' | "$DOMINO" 2>&1)"
}

@test "comments, blank lines, ';', CRLF, tabs and a missing final newline change nothing" {
    expected=$(json 'set s 0.3; fuel')
    differ 's counts' "$(json fuel)" "$expected"
    while IFS= read -r text; do
        same "$text" "$expected" "$(printf "$text" | "$DOMINO" 2>&1)"
    done <<'END'
set output json\nset s 0.3\nfuel\n
set output json\nset s 0.3\nfuel
set output json\r\nset s 0.3\r\nfuel\r\n
set output json\r\n\r\nset s 0.3\r\nfuel
\n\n  \n\t\nset output json\n\nset s 0.3\n\n\nfuel\n\n
# set s 9; quit\nset output json # json; quit\n#\nset s 0.3 #\nfuel #\n#fuel
;;set output json;set s 0.3;;fuel;
 set  output\tjson ; set s 0.3 ; \t fuel ; # ; fuel
END
}

@test "'quit' in the middle ends the session, however the commands are given" {
    for way in -e stdin -f '#!'; do
        run -0 --separate-stderr session "$way" $'set output json\nfuel; quit; foo\nfoo'
        same "$way" "$(json fuel)" "$output"
        same "$way" '(nothing)' "$stderr"
    done
    same 'several -e' 42 "$("$DOMINO" -e 'print 6*7' -e quit -e fuel -f /nonexistent 2>&1)"
}

@test "Greek letters are accepted wherever they are typed" {
    all_worth <<'END'
3.1415926535897931|-|π
0.43633231299858238|rad|25°
-1|-|−1
6|-|2 × 3
6|-|2·3
1.5|-|3÷2
9|-|3²
2|-|5 − 3
9.81|m s^-2|9.81 m/s²
END
    same 'θ1' "$(json 'theta1 0.1')" "$(json 'θ1 0.1')"
    same 'θc' "$(json thetac)" "$(json 'θc')"
    same '°' "$(json 'theta1 10 deg')" "$(json 'theta1 10°')"
    same 'a blank that does not break' "$(json 'theta1 0.1')" "$(json $'theta1\u00a00.1')"
    printf '\357\273\277set output json\r\nset s 0.3\r\nfuel' >bom
    same 'byte order mark, CRLF, no last newline' "$(json 'set s 0.3; fuel')" "$("$DOMINO" bom 2>&1)"
}

@test "empty input is not an error" {
    for text in '' ' ' ';' ' ; ;; ' '#' $'\n\n' $'\r\n' $'\t'; do
        same "-e '$text'" '(nothing)' "$("$DOMINO" -e "$text" 2>&1)"
        same "'$text'" '(nothing)' "$(printf '%s' "$text" | "$DOMINO" 2>&1)"
        # Commands after the empty input are run.
        same "-e '$text', then an answer" 42 "$("$DOMINO" -e "$text" -e 'print 6*7' 2>&1)"
        same "'$text', then an answer" 42 "$(printf '%s\nprint 6*7' "$text" | "$DOMINO" 2>&1)"
    done
}

# bats test_tags=rows,save
@test "a quote in the middle of a word is an ordinary character, and the next command runs" {
    printf '%s\n' "$two_dominoes" >'a"b.csv'
    same 'the next command' 42 "$("$DOMINO" -e 'effect row a"b.csv; print 41 + 1')"
    for line in 'save "a; print 1' 'save "a""; print 1'; do
        run -1 --separate-stderr "$DOMINO" --keep-going -e "$line"
        [[ $stderr == *"this '\"' is never closed"* ]] || same "$line" 'never closed' "$stderr"
    done
}
