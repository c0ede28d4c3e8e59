#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# log: a record of the session in a file.

load ../shell/common

@test "log writes a script of the commands, with answers as comments" {
    printf 'set s 0.3\nfuel\n' >script
    printf '%s\n' 'log l.dom' 'set q hollow; pair 0.2' 'foo' 'source script' 'log off' 'fuel' |
        "$DOMINO" >out 2>err || true
    same 'commands' 'set q hollow pair 0.2 foo source script log off' "$(grep -v '^#\|^$' l.dom | paste -sd ' ' -)"
    same 'errors' 1 "$(grep -c '^# stdin:3:1: unknown command' l.dom)"
    grep -q '^# fuel_exact' l.dom
    same 'answers' "$(grep . out | head -n -3)" "$(sed -n 's/^# //p' l.dom | grep -v '^A log\|^stdin')"
    same 'after them' "$("$DOMINO" -e 'set q hollow; set s 0.3; fuel')" "$(tail -n 5 out | grep . | tail -n 3)"
    same 'it runs again' "$(grep . out | head -n -3)" "$("$DOMINO" --keep-going l.dom 2>/dev/null | grep .)"
    "$DOMINO" -e 'log l.dom; fuel' >/dev/null
    same 'the rest of its line' fuel "$(grep -v '^#\|^$' l.dom | tail -n 1)"
    same 'a log is appended to' 2 "$(grep -c '^# A log' l.dom)"
    printf 'print 1' >l.dom
    "$DOMINO" -e 'log l.dom; fuel' >/dev/null
    same 'a new line after a last line without an end' 'print 1' "$(head -n 1 l.dom)"
    wrong 'log none/l' "cannot write 'none/l': No such file or directory"
    wrong 'log' 'FILE is missing; usage: log FILE'
    run -1 --separate-stderr "$DOMINO" --safe -e 'log t'
    [[ $stderr == *'a safe session cannot read or write files'* ]]
    printf 'log x\n' >inner
    wrong 'source inner > y' "'log' does not work while answers go to 'y'; enter 'log FILE' on a line of its own, without '>'"
}

# bats test_tags=save
@test "the file of the log is refused under any of its names, and is not changed" {
    answer=$("$DOMINO" -e fuel)
    echo old >twice && ln -s twice soft
    while IFS='|' read -r begin then name; do
        run --separate-stderr "$DOMINO" --keep-going -e "$begin" -e "$then" -e 'log off; fuel'
        [[ $stderr == *"cannot write '$name': this session is already writing to it; choose another file" ]] ||
            same "$begin; $then" refused "$stderr"
        same "$begin; $then: goes on" "$answer" "$(tail -n 3 <<<"$output")"
        [ ! -s new ] || same "$begin; $then: the log" 1 "$(grep -c '^# A log' new)"
        same "$begin; $then: the other file" old "$(head -n 1 twice)"
        rm -f new
        echo old >twice
    done <<'END'
log new|rmax > new|new
log new|save ../work/new|../work/new
log twice; fuel > /dev/null|rmax > soft|soft
log soft|fuel >> twice|twice
END
    "$DOMINO" -e 'log new; fuel; log new; log off' >/dev/null # opening the same log again is allowed
    same 'log anew' 2 "$(grep -c '^# A log' new)"
    run -1 --separate-stderr bash -c '"$DOMINO" -e "fuel; log out" >out'
    same 'standard output' "-e:1: log: cannot write 'out': this session is already writing to it; choose another file" "$stderr"
    same 'its answer' "$answer" "$(cat out)"
    echo 'fuel > /dev/null; save /dev/null' >script
    same 'devices take more than one' "$answer" "$("$DOMINO" -e 'log /dev/null; source script; fuel' | tail -n 3)"
}
