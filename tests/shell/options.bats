#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Options, their order, the exit status, and answers that cannot be written.

load common

@test "several -e, -f and FILE run in one session, in the order given" {
    echo 'set output json; set s 0.2' >a
    echo 'show s' >b
    same '-f -e FILE -e' $'0.2\n0.3\n0.3' \
        "$("$DOMINO" -f a -e 'show s' -e 'set s 0.3' b --execute 'show s' | values value)"
    same 'options behind FILE' 0.2 "$("$DOMINO" a --file=b | values value)"
    same 'behind --' 0.2 "$("$DOMINO" -- a b | values value)"
    same '- is standard input' 0.2 "$("$DOMINO" -f a - <b | values value)"
    # A file name that looks like an option.
    cp b ./-e
    same 'FILE -e' 0.2 "$("$DOMINO" -- a -e | values value)"
    # With -e, standard input is not read.
    same 'standard input is left alone' 'foo' "$(echo foo | { "$DOMINO" -e 'set s 0.2'; cat; })"
}

@test "--version and --help" {
    for option in --version -V; do
        run -0 "$DOMINO" "$option"
        [[ ${lines[0]} =~ ^domino\ [0-9]+(\.[0-9]+)+$ ]]
        # The option prints the same as the command, also in json.
        same version "$("$DOMINO" -n -e version)" "$output"
        [[ $output =~ (gcc|clang)\ [0-9] ]]
    done
    same json "${lines[0]#domino }" "$(json version | values version)"
    json version | values quad | grep -qx '__float128\|long double'
    for option in --help -h; do
        run -0 --separate-stderr "$DOMINO" "$option"
        same stderr '(nothing)' "$stderr"
        for word in '^usage: domino' '-e, --execute' '-f, --file' '--bail' '--keep-going' '--help' '--version' 'Exit status'; do
            grep -q -e "$word" <<<"$output" || same --help "$word" "$output"
        done
    done
}

@test "exit status: 0 for answers, 1 after an error in a command, 2 for wrong options" {
    while IFS='|' read -r expected arguments; do
        eval "run --separate-stderr \"\$DOMINO\" $arguments" </dev/null
        same "domino $arguments" "$expected" "$status"
    done <<'END'
0|-e fuel
0|-e ''
0|-e 'set s 0.001; fuel'
0|
1|-e foo
1|-f /nonexistent
2|--frob
2|-e
2|-f
2|--bail=1
2|--keep-going=1
2|-e fuel -x
END
    # Wrong options are reported before anything runs.
    run -2 --separate-stderr "$DOMINO" -e fuel -x
    same 'nothing ran' '(nothing)' "$output"
    grep -q '^usage: ' <<<"$stderr"
}

@test "an error stops -e, -f and FILE, except with --keep-going; it stops standard input only with --bail" {
    printf 'set output json\nfuel; foo; fuel\nfuel\n' >bad
    text=$(cat bad)
    bad_ways() {
        "$DOMINO" "$@" -e "$text"
        echo "$?"
        "$DOMINO" "$@" <bad
        echo "$?"
        "$DOMINO" "$@" -f bad -e fuel
        echo "$?"
        "$DOMINO" bad "$@"
        echo "$?"
    }
    fuel=$(json fuel)
    once=$fuel$'\n'1
    thrice=$fuel$'\n'$fuel$'\n'$once
    same 'with --bail' "$once"$'\n'"$once"$'\n'"$once"$'\n'"$once" "$(bad_ways --bail 2>/dev/null)"
    same 'with neither' "$once"$'\n'"$thrice"$'\n'"$once"$'\n'"$once" "$(bad_ways 2>/dev/null)"
    for options in --keep-going '--bail --keep-going'; do # the last option counts
        same "with $options" "$thrice"$'\n'"$thrice"$'\n'"$fuel"$'\n'"$thrice"$'\n'"$thrice" "$(bad_ways $options 2>/dev/null)"
    done
    same 'with --bail in the end' "$once" "$("$DOMINO" --keep-going --bail -e "$text" 2>/dev/null; echo $?)"
    # A physical "no" is not an error.
    same 'a no' 2 "$("$DOMINO" --bail -e 'set output json; set s 0.001; fuel; fuel' | grep -c reason)"
}

# bats test_tags=sweeps
@test "output that cannot be written gives a message and status 1" {
    [ -c /dev/full ] || skip 'no /dev/full'
    for arguments in '-e fuel' '-e help' '--help' '--version' '-e curve\ 0.1\ 0.9\ 200'; do
        full() { eval "\"\$DOMINO\" $arguments" >/dev/full; }
        run -1 --separate-stderr full
        # If the first write failed long ago, its reason may be unknown.
        same "$arguments" "domino: cannot write the output" "${stderr%%: No space*}"
    done
}

# bats test_tags=sweeps
@test "a closed pipe ends even a long answer" {
    # Ten million rows would take hours.
    while IFS='|' read -r trap status message; do
        timeout 60 sh -c "$trap"' { "$DOMINO" -e "curve 0.01 0.9 10000000; fuel" 2>"$1/err"; echo $? >"$1/status"; } |
            head -n 1 >"$1/out"' sh "$PWD"
        same 'head' 1 "$(wc -l <out)"
        same 'status' "$status" "$(cat status)"
        same 'message' "$message" "$(sed 's/: Broken pipe//' err)"
    done <<'END'
trap - PIPE;|141|(nothing)
trap '' PIPE;|1|domino: cannot write the output
END
}

@test "answers and errors keep their order if both streams go to the same file" {
    "$DOMINO" --keep-going -e 'set output json; fuel; foo; fuel' >both 2>&1 || true
    same 'the error is between the answers, as an object and as a message' '2 3' \
        "$(grep -n 'foo' both | cut -d: -f1 | paste -sd ' ' -)"
    same 'the object' 2 "$(grep -n '^{.*"error":"unknown command' both | cut -d: -f1)"
    same 'lines' 4 "$(wc -l <both)"
}

@test "answers do not depend on the locale, the directory or the environment" {
    expected=$(json 'fuel; show')
    close fuel 0.177287017324780688790030782681 "$(head -n 1 <<<"$expected" | values fuel)"
    cd /
    for locale in C POSIX C.UTF-8 de_DE.UTF-8; do
        same "$locale" "$expected" "$(LC_ALL=$locale LC_NUMERIC=$locale json 'fuel; show')"
    done
    same 'bare environment' "$expected" "$(env -i "$DOMINO" -e 'set output json; fuel; show')"
}

# bats test_tags=rows
@test "-i reads standard input after the other sources, and a .csv file is a row" {
    printf 'set s 0.3\n' >s.dom
    "$DOMINO" -e 'effect row 4; row > hall.csv; row > "two words.CSV"'
    cp hall.csv '"q.csv'
    same '-i' $'0.3\n6' "$(echo 'print 2*3' | "$DOMINO" -i -e 'print s' s.dom -e 'print s' | grep . | tail -n 2)"
    same 'without -i' 0.3 "$(echo 'print 2*3' | "$DOMINO" s.dom -e 'print s')"
    local name verdict
    verdict=$("$DOMINO" -e 'effect row hall.csv; verdict')
    for name in hall.csv 'two words.CSV' ./hall.csv '"q.csv'; do
        same "$name" "$verdict" "$(echo verdict | "$DOMINO" "$name")"
    done
    same 'with commands of its own' "$verdict" "$(echo 'print 1' | "$DOMINO" hall.csv -e verdict)"
    same 'after --' "$verdict" "$(echo verdict | "$DOMINO" -- hall.csv)"
    run -1 --separate-stderr bash -c 'echo "print 7" | "$DOMINO" none.csv'
    same 'no such row' "domino: cannot read 'none.csv': No such file or directory|" "$stderr|$output"
    run -1 --separate-stderr bash -c 'echo "print 7" | "$DOMINO" -i -e foo'
    same 'after an error, nothing is read' '(nothing)' "$output"
    same 'but with --keep-going' 7 "$(echo 'print 7' | "$DOMINO" --keep-going -i -e foo 2>/dev/null)"
}

# bats test_tags=save
@test "--safe: commands cannot use files, and everything else works" {
    echo 'set s 0.3' >plain
    while IFS='|' read -r command place; do
        run -1 --separate-stderr "$DOMINO" --keep-going --safe -e "$command; print 7"
        same "$command: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [[ $stderr =~ ^-e:1:$place:?.*'safe' ]] || same "$command" "safe" "$stderr"
        same "$command: the session goes on" 7 "$output"
    done <<'END'
save file|1
source plain|1
fuel > file|[0-9]
fuel > plain|[0-9]
help > /dev/null|[0-9]
END
    same 'nothing was written' 'plain,set s 0.3' "$(inside),$(cat plain)"
    same 'no file names are told' '(nothing)' "$("$DOMINO" --safe -e 'complete source p')"
    # Files on the command line are read.
    same '-f' 0.3 "$("$DOMINO" --safe -f plain -e 'set output json; show s' | values value)"
}

@test "a message says which file cannot be read and why, and the other files run" {
    echo 'set output json; show s' >good
    for file in 'nonexistent|No such file' '.|directory'; do
        run -1 --separate-stderr "$DOMINO" --keep-going -f "${file%|*}" good
        same "$file: the other" s "$(values name <<<"$output")"
        same "$file: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [[ $stderr =~ ${file%|*}.*${file#*|} ]] || same "$file" why "$stderr"
    done
    run -1 "$DOMINO" --bail nonexistent good
    same --bail 1 "${#lines[@]}"
}
