#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# A program at the other end of the pipes: one line in, one object out; records of a session.
# shellcheck disable=SC2154 # 'run' sets variables

load common

setup() {
    answers_at_all
    cd "$BATS_TEST_TMPDIR" || false
    mkdir bin
    ln -s "$DOMINO" bin/domino
    PATH=$PWD/bin:$PATH
    examples=$BATS_TEST_DIRNAME/../../examples
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

@test "json: an object for each command, each with its command, also for errors" {
    while IFS='|' read -r line expected; do
        got=$(printf '%s\n' 'set output json' "$line" | "$DOMINO" 2>err) || true
        grep -qxE -- "$expected" <<<"$got" || same "$line" "$expected" "$got"
        same "$line: one object" 1 "$(wc -l <<<"$got")"
        python3 -c 'import json, sys; assert "command" in json.loads(sys.stdin.read())' <<<"$got"
    done <<'END'
rmax|\{"command":"rmax","s":0\.4,"r_max":.*\}
set s 0.3|\{"command":"set"\}
effect friction 0.2|\{"command":"effect"\}
rmax > answer|\{"command":"rmax"\}
quit|\{"command":"quit"\}
foo|\{"command":null,"error":"unknown command 'foo'; .*","source":"stdin","line":2,"column":1\}
theta1 9|\{"command":"theta1","error":"T = 9 rad is outside .*","source":"stdin","line":2,"column":8\}
assert verdict|\{"command":"verdict","error":"there is no row; .*","source":"stdin","line":2,"column":null\}
print "|\{"command":"print","error":".*\\".*","source":"stdin","line":2,"column":7\}
source missing|\{"command":"source","error":"cannot read 'missing': .*"source".*\}
print 1e400|\{"command":"print","value":null,"unit":"","reason":".*quad.*"\}
print 1e-400|\{"command":"print","value":null,"unit":"","reason":".*nearer to 0.*"\}
print 1e5000|\{"command":"print","error":".* is too large for a number","source".*\}
help rmax|\{"command":"help","name":"rmax","kind":"command","usage":"rmax \[S\]",.*"keys":"s r_max ends_by r_max_exact r_max_paper".*\}
help friction|\{"command":"help","name":"friction","kind":"effect","usage":"effect friction .*\}
show s|\{"command":"show","name":"s","value":0\.4,.*\}
complete set output j|\{"command":"complete","line":".*json"\}
echo "a; b"|\{"command":"echo","text":"a; b"\}
END
    # An error is on standard error, too.
    grep -q . <(echo 'foo' | "$DOMINO" 2>&1 >/dev/null)
    same 'help in csv' "$(json help | wc -l)" "$("$DOMINO" -e 'set output csv; help' | tail -n +2 | wc -l)"
    same 'apropos' "$("$DOMINO" -e 'apropos barrier' | grep -c '^[a-z]')" "$(json 'apropos barrier' | wc -l)"
    # A file that is read answers for each of its commands, and for itself at its end.
    printf 'fuel\nset s 0.3\n' >inner
    same 'source' 'fuel set source' "$("$DOMINO" -e 'set output json; source inner' |
        sed -E 's/^\{"command":"([a-z]*)".*/\1/' | paste -sd ' ' -)"
    same 'and in its own file' 'fuel set' "$("$DOMINO" -e 'source inner > all.json' && sed -E 's/^\{"command":"([a-z]*)".*/\1/' all.json | paste -sd ' ' -)"
}

@test "csv: one head for answers with the same columns, again for others, and none if that is set" {
    same 'a run' 's,r_max,ends_by 0.3 0.5 fuel,fuel_exact,fuel_paper 0.17 s,r_max,ends_by 0.3' \
        "$("$DOMINO" -e 'set output csv; pair 0.3; pair 0.5; fuel; pair 0.3' | sed -E 's/^(0\.[0-9]{2}).*/\1/; s/^(0\.[35])0*,.*/\1/; s/^(0\.[35]),.*/\1/' | sed -E 's/^(0\.[0-9]*),.*/\1/' | paste -sd ' ' -)"
    same 'off' 2 "$("$DOMINO" -e 'set output csv; set header off; pair 0.3; fuel' | wc -l)"
    same 'a file has its own' "$("$DOMINO" -e 'set output csv; fuel')" "$("$DOMINO" -e 'set output csv; fuel; fuel > a.csv' >/dev/null; cat a.csv)"
    for _ in 1 2; do "$DOMINO" -e 'pair 0.3 >> b.csv'; done
    "$DOMINO" -e 'fuel >> b.csv; pair 0.3 >> b.csv'
    same 'appended' 's fuel s' "$(grep -o '^[a-z]*' b.csv | paste -sd ' ' -)"
    same 'rows' 4 "$(grep -c '^0' b.csv)"
    same 'bounds are other columns' 2 "$("$DOMINO" -e 'set output csv; pair; set errors on; pair' | grep -c '^s,')"
}

# A study that would take minutes, after a quick answer.
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

@test "a signal that ends a script leaves the answer of the rows that placement and budget have counted" {
    for call in 'placement 9000000' 'budget 0.95 20000'; do
        for wait in 0.3 1 3 9; do # how long it takes until there are some
            "$DOMINO" -n -e "set output csv; effect row 13; effect placement 8 mm; $call; print 7" >out 2>err 3>&- &
            sleep "$wait"
            kill -TERM $!
            wait $! && status=0 || status=$?
            same "$call: ended by SIGTERM" 143 "$status"
            same "$call: said" "-e:1: ${call%% *}: interrupted" "$(cat err)"
            ! grep -q '^[0-9].*interrupted' out || break
        done
        same "$call: names and numbers" 2 "$(wc -l <out)"
    done
    [[ $(sed -n 2p out) =~ ^0\.95,[0-9.e-]+,.*,interrupted ]]
}

@test "with --interruptible SIGINT ends the command, and the program goes on; without it the program ends" {
    cat >interrupt.py <<'END'
import json, signal, subprocess, sys, threading
domino = subprocess.Popen(["domino", "-n"] + sys.argv[1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, bufsize=1)
def ask(line):
    domino.stdin.write(line + "\n")
    return json.loads(domino.stdout.readline())
domino.stdin.write("set output json\n")
ask("effect row 13")
answered = threading.Event()
def interrupt(): # until the study has begun, and is answered
    while not answered.wait(0.2):
        domino.send_signal(signal.SIGINT)
thread = threading.Thread(target=interrupt)
if len(sys.argv) > 1:
    domino.send_signal(signal.SIGINT) # while no command runs
ask("effect placement 8 mm")
domino.stdin.write("placement 9000000\n")
thread.start()
for line in domino.stdout:
    answer = json.loads(line)
    print(answer.get("reason", answer.get("error")))
    if "error" in answer:
        break
answered.set()
thread.join()
if len(sys.argv) > 1:
    print(ask("print 41 + 1")["value"])
domino.stdin.close()
print(domino.wait(60))
END
    said=$(timeout 60 python3 interrupt.py --interruptible)
    [[ $said =~ ^interrupted(\ after\ [0-9]+\ of\ 9000000\ rows$'\n'interrupted)?$'\n'42$'\n'1$ ]] || same 'it goes on' 42 "$said"
    same 'as a script' '-2' "$(timeout 60 python3 interrupt.py | tail -n 1)"
}

@test "an answer that is about the train, while a row is on, says so to programs" {
    for format in json csv; do
        for call in rmax 'pair 0.3' 'thetac' 'curve 0.3 0.5 2'; do
            "$DOMINO" -e "effect row 5; set output $format; $call" | grep -q 'endless train' ||
                same "$call in $format" note "$("$DOMINO" -e "effect row 5; set output $format; $call")"
            same "$call without a row" '(nothing)' "$("$DOMINO" -e "set output $format; $call" | grep note || true)"
        done
        same "fall" '(nothing)' "$("$DOMINO" -e "effect row 5; set output $format; fall" | grep note || true)"
    done
}

@test "log: a script of the commands, with answers as comments; tee: the answers alone" {
    printf 'set s 0.3\nfuel\n' >script
    printf '%s\n' 'log l.dom' 'tee t' 'set q hollow; pair 0.2' 'foo' 'source script' 'tee off' 'log off' 'fuel' |
        "$DOMINO" >out 2>err || true
    same 'commands' 'tee t set q hollow; pair 0.2 source script tee off log off' \
        "$(grep -v '^#\|^$' l.dom | paste -sd ' ' -)"
    same 'a line that failed is a comment' 1 "$(grep -c '^# foo$' l.dom)"
    same 'errors' 1 "$(grep -c '^# stdin:4:1: unknown command' l.dom)"
    same 'answers' "$(head -n "$(wc -l <t)" out)" "$(cat t)"
    same 'the same in the log' "$(grep . t)" "$(sed -n 's/^# //p' l.dom | grep -v '^A log\|^stdin\|^foo$')"
    grep -q '^fuel_exact' t
    same 'after them' "$("$DOMINO" -e 'set q hollow; set s 0.3; fuel')" "$(tail -n 5 out | grep . | tail -n 3)"
    same 'it runs again' "$(grep -c . t)" "$("$DOMINO" l.dom | grep -c .)"
    "$DOMINO" -e 'log l.dom; fuel' >/dev/null
    same 'the rest of its line' fuel "$(grep -v '^#\|^$' l.dom | tail -n 1)"
    same 'a log is appended to' 2 "$(grep -c '^# A log' l.dom)"
    "$DOMINO" -e 'set output csv; tee t.csv; fuel; fuel' >whole.csv
    same_file whole.csv t.csv
    wrong 'log none/l' "cannot write 'none/l': No such file or directory"
    wrong 'log' 'FILE is missing; usage: log FILE'
    run -1 --separate-stderr "$DOMINO" --safe -e 'tee t'
    [[ $stderr == *'a safe session cannot read or write files'* ]]
    printf 'tee x\n' >inner
    wrong 'source inner > y' "answers go to 'y' here; begin a record before"
}

@test "echo, and source of standard input" {
    same echo 'as it is: θ  1#' "$("$DOMINO" -e 'echo as it is: θ  1# # but this')"
    same 'quotes' 'a; b > c # d' "$("$DOMINO" -e 'echo "a; b > c # d" # e')"
    same 'to a file' 'a b' "$("$DOMINO" -e 'echo a b > f; echo' >/dev/null && cat f)"
    run -1 --separate-stderr "$DOMINO" -e 'echo "a'
    [[ $stderr == *'never closed'* ]]
    same 'source -' $'0.3\n0.4' "$(echo 'set s 0.3; print s' | "$DOMINO" -e 'source -; reset; print s' | grep .)"
    study='effect row 4; effect placement 5 mm; set output csv; placement 8'
    same 'data after pool -' "$("$DOMINO" -e "$study")" "$({
        echo 'set output csv; pool -'
        "$DOMINO" --shard 1/1 -e "$study"
    } | "$DOMINO")"
}

@test "a file that an answer around a command writes is not written by the command, too" {
    printf 'rmax > out\nfuel\n' >script
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'source script > out; print 7'
    same message "script:1:8: rmax: cannot write 'out': this session is writing it already; choose another file" "$stderr"
    printf 'rmax > other\nfuel\n' >script
    "$DOMINO" -e 'source script > out'
    same outer "$("$DOMINO" -e fuel)" "$(cat out)"
    same inner "$("$DOMINO" -e rmax)" "$(cat other)"
    "$DOMINO" -e 'rmax > out; fuel > out'
    same 'one after the other' "$("$DOMINO" -e fuel)" "$(cat out)"
}
