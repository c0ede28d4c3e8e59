#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Answers in files: > and >>, file extensions, links, permissions, and files after an error.

load common

# bats test_tags=rows,planning,sweeps,landmarks
@test "'> FILE' and '>> FILE' after any command" {
    while IFS='|' read -r call _; do
        case $call in design*) continue ;; esac # a file gets the designed row: see plan.bats
        plain='set header off; ' asked=$plain # because '>>' to an existing file writes no header
        for format in table csv json; do
            plain+="set output $format; $call; "
            asked+="set output $format; $call > $format; $call >> $format; $call; "
        done
        expected=$("$DOMINO" -e "$plain" | grep .)
        run -0 --separate-stderr "$DOMINO" -e "$asked"
        same "$call > FILE: stdout" "$expected" "$(grep . <<<"$output")"
        for part in head tail; do # the answer that '>' wrote, and the one that '>>' added
            same "$call > FILE: the $part" "$expected" \
                "$(for file in table csv json; do $part -n $(($(wc -l <$file) / 2)) $file; done | grep .)"
        done
    done <<<"$commands"
    for call in help 'help fuel' show 'print 1' 'source nested' 'apropos hollow'; do
        echo 'fuel; rmax' >nested
        "$DOMINO" -e "$call >out"
        same "$call" "$("$DOMINO" -e "$call")" "$(cat out)"
    done
    echo old >out
    "$DOMINO" -e 'fuel > out'
    same 'the old file is gone' "$("$DOMINO" -e fuel)" "$(cat out)"
    "$DOMINO" -e 'fuel > "with  blanks"; fuel >> "with  blanks"; fuel >"x;y #z" # and on; foo'
    same 'blanks' 6 "$(wc -l <'with  blanks')"
    same "';' and '#'" "$("$DOMINO" -e fuel)" "$(cat 'x;y #z')"
    "$DOMINO" -e 'rmax 0.3>close; fuel>/dev/null'  2>/dev/null || true
    same 'no blank before it' "$("$DOMINO" -e 'rmax 0.3')" "$(cat close)"
    same 'nothing else' 'close,csv,json,nested,out,table,with  blanks,x;y #z' "$(inside)"
}

@test "a file is written whole or not at all" {
    "$DOMINO" -e 'fuel > good' # in contrast to a command that succeeds
    grep -q '^fuel ' good
    rm good
    for call in 'theta1 9' 'set s 0.9; fuel' 'foo' 'rmax 2' 'print 1 +' 'show foo' 'fuel 1' \
        'set s 1e-6; set r 1e6; set q 100; fuel' 'apropos zzzz' 'source nonexistent'; do
        for to in '>' '>>'; do
            echo old >file
            run -1 "$DOMINO" --keep-going -e "$call $to file; reset; $call $to new"
            expects "$call $to file: a reason" "$output"
            same "$call $to file" old "$(cat file)"
            same "$call $to: what is left" file "$(inside)"
        done
    done
}

@test "files keep their permissions, and links keep their targets" {
    touch private && chmod 600 private
    "$DOMINO" -e 'fuel > private'
    same mode private "$(mode private 600)"
    (umask 027 && "$DOMINO" -e 'fuel > new')
    same 'umask' new "$(mode new 640)"
    if [ "$(id -u)" -eq 0 ]; then
        chgrp 12 new && chmod 664 new
        "$DOMINO" -e 'fuel > new'
        same 'group and mode' '12 664' "$(stat -c '%g %a' new)"
    fi
    echo old >target
    ln -s target link
    "$DOMINO" -e 'fuel > link'
    [ -L link ] || same 'link' 'a link still' 'a file'

    same 'through the link' "$("$DOMINO" -e fuel)" "$(cat target)"
}

# bats test_tags=sweeps,save
@test "paths that cannot be written: the message has the path and the reason, and the session goes on" {
    mkdir directory
    ln -s loop loop
    echo old >file
    all_wrong <<'END'
8|fuel > /nonexistent/file|^fuel: cannot write '/nonexistent/file': No such file
8|fuel > directory|^fuel: cannot write 'directory': Is a directory
9|fuel >> directory|^fuel: cannot write 'directory': Is a directory
8|fuel > loop|^fuel: cannot write 'loop': Too many levels of symbolic links
7|fuel >|^fuel: .*missing
8|fuel > ""|^fuel: .*missing
8|fuel > a b|^fuel: only one word
8|fuel > "a b|^fuel: .*never closed
6|save "a b|^save: .*never closed
8|source "a b|^source: .*never closed
END
    wrong 'save directory' "^-e:1:.*save: cannot write 'directory': Is a directory"
    wrong 'save ""' 'save: .*missing'
    wrong 'source /nonexistent/file' "source: cannot read '/nonexistent/file': No such file"
    wrong 'source loop' "source: cannot read 'loop': Too many levels of symbolic links"
    for call in 'fuel >' 'curve 0.1 0.9 200 >' save; do
        [ ! -c /dev/full ] || wrong "$call /dev/full" "${call%% *}: cannot write '/dev/full': No space"
    done
    same 'nothing was written' 'directory,file,loop' "$(inside)"
}

@test "'> FILE' parts hard links and '>>' keeps them; both need no blank, and can write to /dev/stdout" {
    echo old >one && ln one two && ln two three
    "$DOMINO" -e 'print 1>one; print 2>>two'
    same '>' 1 "$(cat one)"
    same '>>, and the other name' $'old\n2|old\n2' "$(cat two)|$(cat three)"
    "$DOMINO" -e 'print 1; print 5 > /dev/stdout; print 2' | grep . >through-a-pipe
    "$DOMINO" -e 'print 1; print 5 > /dev/stdout; print 2' >file
    same 'to a pipe' $'1\n5\n2' "$(cat through-a-pipe)"
    same 'to a file' $'1\n5\n2' "$(grep . file)"
}

@test "an inner command cannot write the file that an outer one is writing" {
    mkdir folder
    ln -s . again
    for name in out ./out folder/../out again/out "$PWD/out"; do # none of these names exists yet
        printf 'rmax > %s\nfuel\n' "$name" >script
        run -1 --separate-stderr "$DOMINO" --keep-going -e 'source script > out; print 7'
        same message "script:1:8: rmax: cannot write '$name': this session is already writing to it; choose another file" "$stderr"
    done
    printf 'rmax > other\nfuel\n' >script
    "$DOMINO" -e 'source script > out'
    same outer "$("$DOMINO" -e fuel)" "$(cat out)"
    same inner "$("$DOMINO" -e rmax)" "$(cat other)"
    "$DOMINO" -e 'rmax > out; fuel > out'
    same 'one after the other' "$("$DOMINO" -e fuel)" "$(cat out)"
}

# bats test_tags=rows
@test ".csv and .json choose the format; .txt, or no extension, means the format of 'set output'" {
    for output in table csv json; do
        "$DOMINO" -e "set output $output; effect row 5; fall > fall.csv; rmax > r.JSON; verdict > v.txt; verdict > v"
        same "$output: csv" "$("$DOMINO" -e 'set output csv; effect row 5; fall')" "$(cat fall.csv)"
        same "$output: json" "$("$DOMINO" -e 'effect row 5; set output json; rmax')" "$(cat r.JSON)"
        for name in v.txt v; do
            same "$output: $name" "$("$DOMINO" -e "set output $output; effect row 5; verdict")" "$(cat $name)"
        done
    done
    same 'each answer of a script' "$("$DOMINO" -e 'set output csv; rmax; fuel')" \
        "$(printf 'rmax\nfuel\nrmax > inner.json\n' >s.dom && "$DOMINO" -e 'source s.dom > all.csv' && cat all.csv)"
    same 'but a file of its own' '{' "$(head -c 1 inner.json)"
    same 'the session stays as it was' "$("$DOMINO" -e rmax)" "$("$DOMINO" -e 'rmax > r.json; rmax')"
    "$DOMINO" -e 'rmax 0.3 > all.csv; rmax 0.5 >> all.csv'
    same 'appended' "$("$DOMINO" -e 'set output csv; rmax 0.3; rmax 0.5')" "$(cat all.csv)"
    "$DOMINO" -e 'rmax > .csv; rmax > a.b/../c' 2>/dev/null || true
    same 'a hidden file has no extension' "$("$DOMINO" -e rmax)" "$(cat .csv)"
}

# bats test_tags=pictures
@test "a picture is drawn whatever 'set output' says; a .csv or .json file gets its data" {
    for output in table csv json; do
        "$DOMINO" -e "set output $output; draw > d.svg; plot energy > e.svg; draw > d.csv; plot energy > e.json"
        for name in d.svg e.svg; do
            xmllint --noout $name
            same "$output: $name is a picture" 1 "$(grep -c '^</svg>' $name)"
        done
        same "$output: data" "$("$DOMINO" -e 'set output csv; draw')" "$(cat d.csv)"
        same "$output: data" "$("$DOMINO" -e 'set output json; plot energy')" "$(cat e.json)"
    done
    "$DOMINO" -e 'draw > plain; draw > d.txt'
    same 'characters' "$("$DOMINO" -e draw)" "$(cat plain)"
    same 'characters' "$("$DOMINO" -e draw)" "$(cat d.txt)"
}

# bats test_tags=rows,chance,pictures
@test "a file extension that does not suit the answer is an error before anything is computed, and leaves no file" {
    wrong 'rmax > a.gif' "'rmax' cannot write 'a.gif'; use .csv, .json or .txt"
    wrong 'plot growth > a.b' "'plot' cannot write 'a.b'; use .svg, .png, .pdf, .gp or .txt [(]for the data: .csv or .json[)]"
    for what in 'set s 0.3' reset; do
        wrong "$what > a.csv" "'${what%% *}' cannot write 'a.csv'; use .txt"
    done
    wrong 'effect row 12; effect placement 5 mm; placement 10000000 > a.svg' "'placement' cannot write 'a.svg'; use .csv, .json or .txt"
    echo draw >s.dom
    for what in 'source s.dom' show help; do
        wrong "$what > a.PNG" "'${what%% *}' cannot write 'a.PNG'; use "
        wrong "$what >> a.svg" "cannot write 'a.svg'"
    done
    same 'nothing is left' s.dom "$(ls)"
}

# bats test_tags=save,log
@test "a link whose target does not exist is not written, and stays a link" {
    ln -s nowhere link
    for call in 'fuel >' 'fuel >>' save log; do
        run -1 --separate-stderr "$DOMINO" --keep-going -e "$call link"
        [[ $stderr == "-e:1:"*"cannot write 'link': No such file or directory" ]] || same "$call" 'no such file' "$stderr"
    done
    same 'what is left' link "$(ls)"
    [ -L link ]
}

# bats test_tags=sweeps
@test "a '>' in a sourced file is written at once, although the outer '>' fails and leaves no file" {
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

@test "'>>' of two programs at the same time writes a single header" {
    mkfifo ask
    soon "$DOMINO" -e 'source ask >> rows.csv' 3>&- &
    exec 4>ask # the first program has opened the file, and waits
    "$DOMINO" -e 'pair 0.3 >> rows.csv'
    echo 'pair 0.5' >&4
    exec 4>&-
    wait
    same 'one head' "$("$DOMINO" -e 'set output csv; pair 0.3; pair 0.5')" "$(cat rows.csv)"
}

@test "'>>' begins a new line after a last line without an end" {
    printf 's,r_max\n0.3,1' >a.csv
    "$DOMINO" -e 'print 2 >> a.csv; print 3 >> a.csv'
    same csv $'s,r_max\n0.3,1\nvalue,unit\n2,\n3,' "$(cat a.csv)"
}

