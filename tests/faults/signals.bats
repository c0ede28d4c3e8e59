#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Signals while files are written, partners that do not come, streams that are closed, locks that others keep.
# shellcheck disable=SC2154

load faults

# Drafts have six letters behind their dot.
drafts() { find . -name '*.??????' ! -name '*.script'; }

# Ended by this signal, and not by the time limit of the test, which is KILL?
ended_by() { # WHAT SIGNAL STATUS
    same "$1: ended by SIG$2" "$((128 + $(kill -l "$2")))" "$3"
}

every_file_command() { # SIGNAL
    enter
    echo 'set output csv; fuel > inner; curve 0.2 0.6 40' >in.script
    {
        echo 'set output csv; effect row 20; row > row.csv'
        for _ in {1..2000}; do
            echo 'curve 0.2 0.6 40 > new; curve 0.2 0.6 40 > two; curve 0.2 0.6 40 >> log; save saved
                source in.script > outer; source saved; effect row row.csv'
        done
    } >all.script
    "$DOMINO" -n -e 'set output csv; curve 0.2 0.6 40' >answer
    touch two log && ln two other
    local wait status
    # Moments all over the commands; the last come while files are written again and again.
    for wait in 0.005 0.010 0.015 0.020 0.025 0.030 0.035 0.040 0.047 0.053; do
        timeout -s KILL 20 "$DOMINO" -n all.script >/dev/null 2>&1 3>&- &
        sleep "$wait"
        # The program itself, below timeout.
        child=$(cat "/proc/$!/task/$!/children")
        [ -n "$child" ] || { wait $! || :; continue; }
        until [ "$(tr '\0' ' ' <"/proc/${child% }/cmdline" | cut -d' ' -f1)" = "$DOMINO" ]; do :; done
        kill -s "$1" "${child% }"
        wait $! && status=0 || status=$?
        ended_by "after $wait s" "$1" "$status"
        same "drafts" '' "$(drafts)"
        [ ! -e new ] || cmp new answer
        [ ! -s two ] || cmp two answer
        same 'rows of the log, in whole answers' 0 "$(($(wc -l <log) % $(wc -l <answer)))"
    done
}

@test "SIGINT while files are written" { every_file_command INT; }
@test "SIGTERM while files are written" { every_file_command TERM; }
@test "SIGHUP while files are written" { every_file_command HUP; }
@test "SIGQUIT while files are written" { ulimit -c 0 && every_file_command QUIT; }
@test "SIGALRM while files are written" { every_file_command ALRM; }
@test "SIGUSR1 while files are written" { every_file_command USR1; }
@test "SIGXCPU while files are written" { ulimit -c 0 && every_file_command XCPU; }
@test "SIGVTALRM while files are written" { every_file_command VTALRM; }

@test "a limit of processor time leaves no draft" {
    enter
    ulimit -c 0
    # shellcheck disable=SC2016
    soon bash -c 'ulimit -St 1; exec "$DOMINO" -n -e "curve 0.01 0.9 10000000 > new"' && status=0 || status=$?
    ended_by 'after a second' XCPU "$status"
    same 'what is left' '' "$(inside)"
}

@test "SIGTERM while gnuplot draws leaves no file" {
    command -v gnuplot >/dev/null || skip 'no gnuplot'
    enter
    timeout -s KILL 20 "$DOMINO" -n -e 'animate film.gif 2' >/dev/null 2>&1 3>&- &
    until [ -n "$(drafts)" ]; do kill -0 $!; done
    child=$(cat "/proc/$!/task/$!/children")
    kill -TERM "${child% }"
    wait $! && status=0 || status=$?
    ended_by 'the program' TERM "$status"
    same 'what is left' '' "$(inside)"
}

@test "a script that waits for a FIFO ends with SIGINT and SIGTERM, and leaves no file" {
    enter
    mkfifo fifo
    for signal in INT TERM; do
        while read -r call; do
            timeout -k 10 -s "$signal" 0.1 "$DOMINO" -n -e "$call" >/dev/null 2>&1 && status=0 || status=$?
            same "$call, SIG$signal" 124 "$status"
            same 'what is left' fifo "$(inside)"
        done <<'END'
source fifo
effect row fifo
pool fifo
fuel > fifo
fuel >> fifo
save fifo
END
    done
}

@test "eight sessions that end at once keep every line of the history" { prompt history_many 8 10; }

@test "eight that append to one file tear no line" {
    enter
    "$DOMINO" -n -e 'manual; manual; manual' >answer # more than one block
    echo 'manual; manual; manual' >three
    for _ in {1..8}; do
        for _ in {1..25}; do echo 'source three >> log'; done | timeout -k 1 60 "$DOMINO" -n -f - 3>&- &
    done
    wait
    for _ in {1..200}; do cat answer; done | cmp - log
}

@test "a lock that somebody keeps is reported, and the file is left alone" {
    enter
    echo old >file
    mkfifo over
    timeout 60 flock file cat over >/dev/null 3>&- &
    until ! flock -n file true; do :; done
    run -1 --separate-stderr soon "$DOMINO" -n -e 'fuel >> file; print 42'
    echo >over
    wait
    same 'message' "-e:1: fuel: cannot write 'file': another program has locked it" "$stderr"
    same 'the session goes on' 42 "$output"
    same 'the file' old "$(cat file)"
}

@test "closed streams: files have their answers, and nothing else" {
    enter
    command="set timing on; fuel > out; foo; fuel; save saved; fuel >> out"
    "$DOMINO" -n -e "$command" >/dev/null 2>&1 || :
    mv out out.right && mv saved saved.right
    for closed in '' '<&-' '>&-' '2>&-' '<&- >&-' '<&- 2>&-' '>&- 2>&-' '<&- >&- 2>&-'; do
        eval 'soon "$DOMINO" -n -e "$command"' "$closed" >/dev/null 2>&1 && status=0 || status=$?
        same "$closed: status" 1 "$status"
        for file in out saved; do diff <(grep -v '^time' $file.right) <(grep -v '^time' $file); done
        eval 'soon "$DOMINO" -n -f -' "$closed" >/dev/null 2>&1 </dev/null && status=0 || status=$?
        no_crash "$closed" "$status"
        same "$closed: files" 'out out.right saved saved.right' "$(inside)"
        rm out saved
    done
}
