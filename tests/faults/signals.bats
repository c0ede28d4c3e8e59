#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Signals while files are written, FIFOs that nobody opens, closed streams, and locks that other processes
# hold.

load faults

# Lists temporary files, whose names end with a dot and six letters.
temporary_files() { find . -name '*.??????' ! -name '*.script'; }

# Starts the program in the background as $child. Signals have their default actions, as for a program that a shell
# starts at a terminal, even under nohup.
begin() { # ARGUMENT...
    env --default-signal "$DOMINO" -n "$@" >/dev/null 2>&1 3>&- &
    child=$!
}

# Sends a signal to the program, and checks that the signal soon ends the program.
end_by() { # WHAT SIGNAL
    until [ "$(tr '\0' '\n' <"/proc/$child/cmdline" | head -n 1)" = "$DOMINO" ]; do kill -0 "$child"; done
    kill -s "$2" "$child"
    ended_by "$@"
}
ended_by() { # WHAT SIGNAL
    local status
    timeout 60 tail -s 0.01 --pid="$child" -f /dev/null || kill -KILL "$child"
    wait "$child" && status=0 || status=$?
    same "$1: ended by SIG$2" "$((128 + $(kill -l "$2")))" "$status"
}

teardown() { kill -KILL "${child:-}" 2>/dev/null || :; }

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
    "$DOMINO" -n -e 'set output csv; effect row 20; curve 0.2 0.6 40' >answer
    touch two log && ln two other
    local wait
    # Send the signal at different moments: first during the first commands, and finally while files are written again
    # and again.
    for wait in 0.005 0.010 0.015 0.020 0.025 0.030 0.035 0.040 0.047 0.053; do
        begin all.script
        sleep "$wait"
        end_by "after $wait s" "$1"
        same "temporary files" '(nothing)' "$(temporary_files)"
        [ ! -e new ] || cmp new answer
        [ ! -s two ] || cmp two answer
        [ ! -s log ] || same 'rows of the log, in whole answers below one head' 0 "$((($(wc -l <log) - 1) % ($(wc -l <answer) - 1)))"
    done
}

@test "SIGINT while files are written" { every_file_command INT; }
@test "SIGTERM while files are written" { every_file_command TERM; }
@test "SIGHUP while files are written" { every_file_command HUP; }
@test "SIGALRM while files are written" { every_file_command ALRM; }

@test "exceeding the limit of processor time leaves no temporary file" {
    enter
    ulimit -c 0
    ulimit -St 1
    begin -e 'curve 0.01 0.9 10000000 > new'
    ended_by 'after a second' XCPU
    same 'what is left' '(nothing)' "$(inside)"
}

@test "gnuplot ends with the program, whatever signal ends the program" {
    command -v gnuplot >/dev/null || skip 'no gnuplot'
    enter
    local drawing
    for signal in TERM USR1 KILL; do
        begin -e 'set row 20; animate speed 0.5 > film.gif' # gnuplot draws for many seconds
        until drawing=$(pgrep -P "$child" gnuplot); do kill -0 "$child"; done
        end_by 'the program' "$signal"
        timeout 60 tail -s 0.01 --pid="$drawing" -f /dev/null || same "SIG$signal: gnuplot" 'is gone' "$(ps "$drawing")"
        [ $signal != TERM ] || same 'what is left' '(nothing)' "$(inside)"
    done
}

@test "a command that waits for a FIFO ends on SIGINT and on SIGTERM, and leaves no file" {
    enter
    mkfifo fifo
    for signal in INT TERM; do
        while read -r call; do
            timeout -k 60 -s "$signal" 0.1 "$DOMINO" -n -e "$call" >/dev/null 2>&1 && status=0 || status=$?
            same "$call, SIG$signal" 124 "$status"
            same 'what is left' fifo "$(inside)"
        done <<'END'
source fifo
effect row fifo
fuel > fifo
fuel >> fifo
save fifo
END
    done
}

@test "eight processes that append to one file do not mix their lines" {
    enter
    "$DOMINO" -n -e 'help; help; help' >answer # more than one block
    echo 'help; help; help' >three
    for _ in {1..8}; do
        for _ in {1..25}; do echo 'source three >> log'; done | timeout -k 1 120 "$DOMINO" -n -f - 3>&- &
    done
    wait
    for _ in {1..200}; do cat answer; done | cmp - log
}

@test "a lock that another process holds is reported, and the file is left alone" {
    enter
    echo old >file
    mkfifo over
    timeout 60 flock file cat over >/dev/null 3>&- &
    until ! flock -n file true; do :; done
    run -1 --separate-stderr soon "$DOMINO" -n --keep-going -e 'fuel >> file; print 42'
    echo >over
    wait
    same 'message' "-e:1: fuel: cannot write 'file': another program has locked it" "$stderr"
    same 'the session goes on' 42 "$output"
    same 'the file' old "$(cat file)"
}

@test "closed streams: files contain the answers, and nothing else" {
    enter
    command="set digits 7; fuel > out; foo; fuel; save saved; fuel >> out"
    "$DOMINO" -n --keep-going -e "$command" >/dev/null 2>&1 || :
    mv out out.right && mv saved saved.right
    for closed in '' '<&-' '>&-' '2>&-' '<&- >&-' '<&- 2>&-' '>&- 2>&-' '<&- >&- 2>&-'; do
        eval 'soon "$DOMINO" -n --keep-going -e "$command"' "$closed" >/dev/null 2>&1 && status=0 || status=$?
        same "$closed: status" 1 "$status"
        for file in out saved; do diff <(grep -v '^time' $file.right) <(grep -v '^time' $file); done
        eval 'soon "$DOMINO" -n -f -' "$closed" >/dev/null 2>&1 </dev/null && status=0 || status=$?
        no_crash "$closed" "$status"
        same "$closed: files" 'out out.right saved saved.right' "$(inside)"
        rm out saved
    done
}
