#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Programs that control domino through pipes; echo.
# bats file_tags=whole

load common

# Sends each command of the table, and waits for its answer. The answer ends where the answer to a following
# 'print 7' begins. The timeout matters only if the test fails.
talk() { # READ-FROM WRITE-TO: descriptors
    local call line
    while IFS='|' read -r call _; do
        printf '%s\n' "${call##*; }" >&"$2"
        read -r -t 60 -u "$1" line || same "an answer of '${call##*; }'" something "$line"
        printf 'print 7\n' >&"$2"
        while [ "$line" != '{"command":"print","value":7,"unit":""}' ]; do
            read -r -t 60 -u "$1" line || same "what follows '${call##*; }'" 'print 7' "$line"
        done
    done <<<"$commands"
}

setup() {
    begin
    mkdir bin
    ln -s "$DOMINO" bin/domino
    PATH=$PWD/bin:$PATH
    examples=$root/examples
}

@test "a program that waits for each answer gets it: standard input" {
    coproc CALCULATOR { "$DOMINO"; }
    local in=${CALCULATOR[0]} out=${CALCULATOR[1]} process=$CALCULATOR_PID
    echo 'set output json; effect row 4; effect placement 5 mm' >&"$out"
    talk "$in" "$out"
    echo quit >&"$out"
    wait "$process"
}

@test "a program that waits for each answer gets it: a named pipe, with -f and with 'source'" {
    mkfifo commands answers
    local by
    for by in '-f commands' '-e source\ commands'; do
        eval "'$DOMINO' $by >answers &"
        exec 6<answers 5>commands # in the order in which domino opens them
        echo 'set output json; effect row 4; effect placement 5 mm' >&5
        talk 6 5
        exec 5>&- 6<&-
        wait
    done
}

@test "answers are not sent one by one if no reader waits" {
    # dd counts its reads, each of which returns the data of one or more writes.
    for way in stdin file; do
        printf 'print 12345\n%.0s' {1..20000} >lines
        [ $way = stdin ] && ask=("$DOMINO") || ask=("$DOMINO" -f lines)
        "${ask[@]}" <lines | dd bs=1M of=/dev/null 2>counted
        same "$way: bytes" "$((20000 * 7 - 1))" "$(sed -n 's/ bytes.*//p' "$PWD/counted")"
        awk -F + '/records in/ && $1 + $2 > 60 { print; exit 1 }' counted
    done
}

@test "lines that were not run are left in the input for the next program" {
    printf 'print 1\nquit\nthe rest\n' >lines
    same 'quit' $'1\nthe rest' "$({ "$DOMINO"; cat; } <lines)"
    same '-f -' $'1\nthe rest' "$({ "$DOMINO" -f -; cat; } <lines)"
    printf 'print 1\nfoo\nthe rest\n' >lines
    same 'an error' $'1\nthe rest' "$({ "$DOMINO" --bail 2>/dev/null; cat; } <lines)"
}

@test "clients in Python and in C ask line by line, and find the same separation" {
    cc -std=c99 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Wpedantic -Werror "$examples/client.c" -o client
    for growth in 1.6 '3/2' '0.9*rmax'; do
        in_c=$(timeout 60 ./client "$growth")
        same "$growth" "$in_c" "$(timeout 60 "$examples/client.py" "$growth")"
        close "rmax at $in_c" "$(json "print $growth" | values value)" "$(json "rmax $in_c" | values r_max)" 1e-7
    done
    for client in ./client "$examples/client.py"; do
        run -1 --separate-stderr timeout 60 "$client" foo
        grep -q "'foo' has no value" <<<"$stderr"
        run -2 timeout 60 "$client"
    done
}

# A quick answer, followed by a study that would take minutes.
long='print 41 + 1; effect row 13; effect placement 8 mm; placement 9000000'

@test "a finished answer is written while the next one is computed, into pipes and files" {
    "$DOMINO" -n -e "$long" >out 3>&- &
    until [ -s out ]; do kill -0 $!; done
    kill -KILL $!
    wait $! || true
    same 'a file' 42 "$(cat out)"
    exec 5< <(exec "$DOMINO" -n -e "$long" 3>&-)
    read -r -t 60 said <&5
    same 'a pipe' 42 "$said"
    kill -KILL $!
    exec 5<&-
}

@test "echo, and source of standard input" {
    same echo 'as it is: θ  1#' "$("$DOMINO" -e 'echo as it is: θ  1# # but this')"
    same 'quotes' 'a; b > c # d' "$("$DOMINO" -e 'echo "a; b > c # d" # e')"
    same 'to a file' 'a b' "$("$DOMINO" -e 'echo a b > f; echo' >/dev/null && cat f)"
    run -1 --separate-stderr "$DOMINO" -e 'echo "a'
    [[ $stderr == *'never closed'* ]]
    same 'source -' $'0.3\n0.4' "$(echo 'set s 0.3; print s' | "$DOMINO" -e 'source -; reset; print s' | grep .)"
}
