#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Files that are no regular files, links, locks, descriptors that are missing: what is written, and what stays.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

prompt() { timeout 120 expect -f "$BATS_TEST_DIRNAME/files.exp" "$@" </dev/null; }
enter() { mkdir -p "$BATS_TEST_TMPDIR/in" && cd "$BATS_TEST_TMPDIR/in" || exit; }
# No test may wait for ever.
soon() { timeout 30 "$@"; }

# ---- FIFOs ----

@test "^C ends the wait for the writer of a FIFO: source" { prompt interrupt_fifo 'source %s'; }
@test "^C ends the wait for the writer of a FIFO: effect row" { prompt interrupt_fifo 'effect row %s'; }
@test "^C ends the wait for the writer of a FIFO: pool" { prompt interrupt_fifo 'pool %s'; }
@test "^C ends the wait for the reader of a FIFO: >" { prompt interrupt_fifo 'fuel > %s'; }
@test "^C ends the wait for the reader of a FIFO: >>" { prompt interrupt_fifo 'fuel >> %s'; }
@test "^C ends the wait for the reader of a FIFO: save" { prompt interrupt_fifo 'save %s'; }
@test "^C ends the wait for a writer that writes nothing" {
    prompt interrupt_partner '3>' 'source %s' 'source: interrupted'
}
@test "^C ends the wait for a reader that reads nothing" {
    # More than a FIFO holds, at once.
    for _ in {1..40}; do echo help; done >"$BATS_TEST_TMPDIR/script"
    prompt interrupt_partner '<' "source $BATS_TEST_TMPDIR/script > %s" 'cannot write [^\n]*canceled'
}
@test "^C ends a command that reads the terminal" {
    prompt interrupt_terminal 'pool -'
    prompt interrupt_terminal 'source /dev/tty'
}
@test "SIGTERM and SIGHUP end a session that waits for a FIFO" {
    prompt end_fifo TERM 'source %s'
    rm "$BATS_TEST_TMPDIR/fifo"
    prompt end_fifo HUP 'save %s'
}
@test "a FIFO as the start-up file is reported, and the session opens" { prompt startup_fifo; }

@test "FIFOs, pipes and devices are read and written as files are" {
    enter
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
    soon "$DOMINO" -e 'set output csv; curve 0.1 0.9 20000 > fifo' # more than a pipe holds
    wait $!
    same '> FIFO, long' 20001 "$(wc -l <got)"
    soon "$DOMINO" -e 'fuel > /dev/null; save /dev/null; fuel >> /dev/null; source /dev/null'
    same 'and no file besides' 'fifo got row.csv' "$(echo *)"
    [ -p fifo ]
}

@test "a FIFO's writer has its answer before it writes the next command" {
    enter
    mkfifo ask answer
    soon "$DOMINO" -f ask >answer 3>&- &
    exec 5<answer 4>ask
    for k in 1 2; do
        echo "print 41 + $k" >&4
        read -r -t 20 said <&5
        [ -n "$said" ] || read -r -t 20 said <&5 # a blank line parts answers
        same "answer $k" "$((41 + k))" "$said"
    done
    exec 4>&- 5<&-
    wait
}

@test "the command in '> >(...)' reads the answer" {
    enter
    answer=$("$DOMINO" -e fuel)
    mkfifo over
    # shellcheck disable=SC2016 # the inner shell expands it
    soon bash -c '"$DOMINO" -e "fuel > $1"; exec 3>&-' bash >(cat >got; echo >over)
    soon cat over >/dev/null
    same '>()' "$answer" "$(cat got)"
}

# ---- History ----

@test "history: a device keeps its mode, and nothing is said" {
    prompt history_device /dev/null
    ln -s /dev/null "$BATS_TEST_TMPDIR/link"
    prompt history_device "$BATS_TEST_TMPDIR/link"
}
@test "history: a link's target keeps its mode" { prompt history_link; }
@test "history: a FIFO is reported, and is none" { prompt history_fifo; }
@test "history: SIGKILL loses nothing" { prompt history_crash; }
@test "history: half a line and a long file" { prompt history_long; }
@test "history: four sessions that end at once" { prompt history_many 4 5; }

# ---- Links, groups, temporary files ----

@test "'>' through links whose target is not there makes the target" {
    enter
    mkdir folder
    ln -s folder/target one && ln -s "$PWD/one" two && ln -s ../three folder/three
    for name in one two folder/three; do
        "$DOMINO" -e "fuel > $name"
        [ -L "$name" ] || same "$name" 'a link still' 'a file'
        same "$name" "$("$DOMINO" -e fuel)" "$(cat "$name")"
        rm -f folder/target three
    done
    run -1 "$DOMINO" --keep-going -e 'theta1 9 > two'
    same 'nothing is made for an error' "folder one two folder/three" "$(echo ./* folder/* | sed 's|\./||g')"
    ln -s nowhere/target lost
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'fuel > lost'
    same 'no folder' "-e:1:8: fuel: cannot write 'lost': No such file or directory" "$stderr"
    [ -L lost ]
}

@test "'>' keeps the group of a file" {
    enter
    [ "$(id -u)" -eq 0 ] || skip 'needs two groups'
    echo old >file && chgrp 12 file && chmod 664 file
    "$DOMINO" -e 'fuel > file'
    same 'group and mode' '12 664' "$(stat -c '%g %a' file)"
}

@test "a '>' in a file that is sourced is complete at once, and the one around it leaves nothing" {
    enter
    mkdir files
    echo 'fuel > files/inner; curve 0.01 1 10000000' >script
    for signal in TERM KILL; do
        "$DOMINO" -e 'source script > files/outer' 3>&- &
        until [ -e files/inner ]; do kill -0 $!; done
        kill "-$signal" $!
        wait $! || true
        same "$signal: what is left" "$("$DOMINO" -e fuel)" "$(cat files/*)"
        rm files/inner
    done
}

@test "'>>' of two programs at once writes the names of the columns once" {
    enter
    mkfifo ask
    soon "$DOMINO" -e 'source ask >> rows.csv' 3>&- &
    exec 4>ask # the first has opened its file, and waits
    "$DOMINO" -e 'pair 0.3 >> rows.csv'
    echo 'pair 0.5' >&4
    exec 4>&-
    wait
    same 'one head' "$("$DOMINO" -e 'set output csv; pair 0.3; pair 0.5')" "$(cat rows.csv)"
}

@test "a file that the session is writing is refused, under any of its names, and stays as it is" {
    enter
    answer=$("$DOMINO" -e fuel)
    echo old >twice && ln twice hard && ln twice hard.gif && ln -s twice soft && ln -s new dangling
    while IFS='|' read -r begin then name; do
        run --separate-stderr "$DOMINO" --keep-going -e "$begin" -e "$then" -e 'log off; tee off; fuel'
        [[ $stderr == *"cannot write '$name': this session is writing it already; choose another file" ]] ||
            same "$begin; $then" refused "$stderr"
        same "$begin; $then: goes on" "$answer" "$(tail -n 3 <<<"$output")"
        [ ! -s new ] || same "$begin; $then: the log" 1 "$(grep -c '^# A log' new)"
        same "$begin; $then: the other file" 1 "$(grep -c . twice)"
        rm -f new
        echo old >twice
    done <<'END'
log new|rmax > new|new
log new|rmax > dangling|dangling
log dangling|save new|new
log new|tee ./new|./new
tee twice; fuel > /dev/null; echo x|rmax > soft|soft
tee twice; echo x|rmax >> hard|hard
tee soft; echo x|animate hard.gif|hard.gif
END
    "$DOMINO" -e 'log new; fuel; log new; log off' >/dev/null # the same again is no other
    same 'log anew' 2 "$(grep -c '^# A log' new)"
    run -1 --separate-stderr bash -c '"$DOMINO" -e "fuel; log out" >out'
    same 'standard output' "-e:1: log: cannot write 'out': this session is writing it already; choose another file" "$stderr"
    same 'its answer' "$answer" "$(cat out)"
    echo 'fuel > /dev/null; tee /dev/null' >script
    same 'devices take more than one' "$answer" "$("$DOMINO" -e 'log /dev/null; tee /dev/null; source script; fuel' | tail -n 3)"
}

@test "files whose names are as long as a name may be" {
    enter
    local name ascii other
    ascii=$(printf 'x%.0s' {1..255}) other=$(printf 'ü%.0s' {1..127})
    for name in "${ascii:0:248}" "${ascii:0:249}" "$ascii" "$other" "x$other"; do
        for call in 'fuel >' 'fuel >>' save; do
            "$DOMINO" -e "$call $name"
            [ -s "$name" ] && "$DOMINO" -e "$call $name"
            rm "$name"
        done
    done
    run -1 "$DOMINO" -e "fuel > x$ascii"
    [[ $output == *': File name too long' ]]
}

@test "temporary files are where TMPDIR says" {
    enter
    command -v gnuplot >/dev/null || skip 'no gnuplot'
    run -1 --separate-stderr env TMPDIR="$PWD/none" "$DOMINO" -e 'plot energy > x.svg'
    same 'no such folder' '-e:1: plot: cannot draw: No such file or directory' "$stderr"
    mkdir own
    TMPDIR=$PWD/own "$DOMINO" -e 'plot energy > x.svg'
    [ -s x.svg ]
    same 'nothing is left' '(nothing)' "$(ls own)"
}

# ---- Descriptors ----

@test "where standard streams are closed, no file takes their place" {
    enter
    answer=$("$DOMINO" -e fuel)
    for closed in '<&-' '2>&-' '<&- 2>&-'; do
        rm -f out
        eval '"$DOMINO" -e "set timing on; fuel > out; foo"' "$closed" || true
        same "$closed: the file" "$answer" "$(grep -v '^time' out)"
        same "$closed: the timing" 0 "$(grep -c '^time' out || true)"
        same "$closed: standard output" "$answer" "$(eval '"$DOMINO" -e fuel' "$closed")"
    done
    run -1 --separate-stderr bash -c '"$DOMINO" -e "fuel > out; fuel" >&-'
    same 'no standard output' 'domino: cannot write the output: Bad file descriptor' "$stderr"
    same 'the file' "$answer" "$(cat out)"
    run -1 --separate-stderr bash -c '"$DOMINO" <&-'
    same 'no standard input' 'stdin:0: cannot read the next line: Bad file descriptor' "$stderr"
    run -1 bash -c '"$DOMINO" -e "fuel > out; foo; fuel" <&- >&- 2>&-'
    same 'none of the three' "$answer" "$(cat out)"
}

@test "signals that end the program give the terminal back" {
    for signal in USR1 ALRM QUIT XCPU VTALRM; do prompt end_signal "$signal"; done
}
