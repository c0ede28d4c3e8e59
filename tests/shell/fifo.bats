#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# FIFOs, pipes and devices as files, and closed descriptors.
# bats file_tags=whole

load common

# bats test_tags=save
@test "^C ends the wait for the other end of a FIFO" {
    for command in source 'effect row' 'fuel >' 'fuel >>' save; do
        prompt interrupt_fifo "$command %s"
        rm "$BATS_TEST_TMPDIR/fifo"
    done
}

@test "^C ends the wait for a writer that writes nothing" {
    prompt interrupt_partner '3>' 'source %s' 'source: interrupted'
}

@test "^C ends the wait for a reader that reads nothing" {
    # Write more than a FIFO can hold at once.
    for _ in {1..40}; do echo 'help all'; done >"$BATS_TEST_TMPDIR/script"
    prompt interrupt_partner '<' "source $BATS_TEST_TMPDIR/script > %s" '(cannot write [^\n]*canceled|source: interrupted)'
}

# bats test_tags=save
@test "FIFOs, pipes and devices are read and written like files" {
    answer=$("$DOMINO" -e fuel)
    mkfifo fifo
    echo 'fuel' >fifo &
    same 'source FIFO' "$answer" "$(soon "$DOMINO" -e 'source fifo')"
    echo 'fuel' >fifo &
    same '-f FIFO' "$answer" "$(soon "$DOMINO" -f fifo)"
    same 'source <()' "$answer" "$(soon bash -c '"$DOMINO" -e "source $1"' bash <(echo fuel))"
    same '<()' "$answer" "$(soon "$DOMINO" <(echo fuel))"
    same 'nothing in <()' '(nothing)' "$(soon "$DOMINO" <(true))"
    "$DOMINO" -e 'set output csv; effect row 4; row > row.csv'
    same 'effect row <()' "$("$DOMINO" -e 'effect row row.csv; verdict')" \
        "$(soon bash -c '"$DOMINO" -e "effect row $1; verdict"' bash <(cat row.csv))"
    same 'effect row /dev/stdin' "$("$DOMINO" -e 'effect row row.csv; verdict')" \
        "$(soon "$DOMINO" -e 'effect row /dev/stdin; verdict' <row.csv)"
    same 'source /dev/stdin' "$answer" "$(echo fuel | soon "$DOMINO" -e 'source /dev/stdin')"
    for to in '>' '>>'; do
        cat fifo >got &
        soon "$DOMINO" -e "fuel $to fifo"
        wait $!
        same "$to FIFO" "$answer" "$(cat got)"
    done
    cat fifo >got &
    soon "$DOMINO" -e 'set output csv; curve 0.1 0.9 20000 > fifo' # more than a pipe can hold
    wait $!
    same '> FIFO, long' 20001 "$(wc -l <got)"
    soon "$DOMINO" -e 'fuel > /dev/null; save /dev/null; fuel >> /dev/null; source /dev/null'
    same 'and no file besides' 'fifo got row.csv' "$(echo *)"
    [ -p fifo ]
}

@test "the command in '> >(...)' reads the answer" {
    answer=$("$DOMINO" -e fuel)
    mkfifo over
    soon bash -c '"$DOMINO" -e "fuel > $1"; exec 3>&-' bash >(cat >got; echo >over)
    soon cat over >/dev/null
    same '>()' "$answer" "$(cat got)"
}

@test "a standard stream that is closed is reported, and no file takes its place" {
    answer=$("$DOMINO" -e fuel)
    run -1 --separate-stderr bash -c '"$DOMINO" -e "fuel > out; fuel" >&-'
    same 'no standard output' 'domino: cannot write the output: Bad file descriptor' "$stderr"
    same 'the file' "$answer" "$(cat out)"
    run -1 --separate-stderr bash -c '"$DOMINO" <&-'
    same 'no standard input' 'stdin:0: cannot read the next line: Bad file descriptor' "$stderr"
}
