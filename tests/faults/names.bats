#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Malicious file names: each is used as it is, or leads to an error message of one readable line. No other file is
# touched.

load faults

long=$(printf 'x%.0s' {1..300})
names=('with  blanks' -e --safe '%s%n%d' '*' '?' "'" '$(touch x)' '`x`' '\' '\n' 'a;b' '#a' '>a' '&' '|' '!' ü 字
    "${long:0:255}" "${long:0:256}" "${long:0:249}" "${long:0:250}" ... '~x' 'a"b' '"' $'a\nquit' $'a\rb' $'\t' $'a\033[2Jb'
    $'\033]0;x\a' $'\001' $'\177' $'\302\233m' $'\377\376' $'\342\200\256gpj' $'\342\200\213')

# Quotes a name for a command line, in which '""' stands for a quote.
quoted() { printf '"%s"' "${1//\"/\"\"}"; }

# Checks that the error message is a single line without control characters or others that a terminal does not show.
readable() { # WHAT NAME
    same "$1 $(printf %q "$2"): lines" 1 "$(wc -l <err)"
    if LC_ALL=C.UTF-8 grep -qvP '^[\P{C}]+$' err; then same "$1 $(printf %q "$2")" readable "$(cat -v err)"; fi
}

@test "hostile names: '>', '>>' and save" {
    enter
    mkdir files && cd files
    answer=$("$DOMINO" -n -e fuel)
    for name in "${names[@]}"; do
        [[ $name != *$'\n'* ]] || continue # a line break would end the command
        for call in 'fuel >' 'fuel >>' save; do
            soon "$DOMINO" -n -e "$call $(quoted "$name")" >../out 2>../err && status=0 || status=$?
            no_crash "$call $(printf %q "$name")" "$status"
            same "$call $(printf %q "$name"): standard output" '(nothing)' "$(cat ../out)"
            if [ "$status" -eq 0 ]; then
                ! LC_ALL=C grep -q '[[:cntrl:]]' <<<"$name" || same "$call $(printf %q "$name")" refused written
                [ "$call" = save ] || same "$(printf %q "$name")" "$answer" "$(cat ./"$name")"
                rm ./"$name"
            else
                (cd .. && readable "$call" "$name")
            fi
            same "$call $(printf %q "$name"): no other file" 0 "$(find . -mindepth 1 -printf x | wc -c)"
        done
    done
}

@test "hostile names: source, effect row and -f" {
    enter
    mkdir files && cd files
    answer=$("$DOMINO" -n -e fuel)
    for name in "${names[@]}"; do
        echo fuel 2>/dev/null >./"$name" || continue
        for call in source 'effect row'; do
            [[ $name != *$'\n'* ]] || continue
            soon "$DOMINO" -n -e "$call $(quoted "$name")" >../out 2>../err && status=0 || status=$?
            no_crash "$call $(printf %q "$name")" "$status"
            if [ "$status" -eq 0 ]; then
                same "$call $(printf %q "$name")" "$answer" "$(cat ../out)"
            else
                (cd .. && readable "$call" "$name")
            fi
        done
        echo foo >./"$name"
        soon "$DOMINO" -n -- "$name" >../out 2>../err && status=0 || status=$?
        same "-- $(printf %q "$name")" 1 "$status"
        (cd .. && readable -- "$name")
        rm ./"$name"
    done
}
