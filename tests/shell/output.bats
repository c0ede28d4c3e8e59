#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Answers as tables, csv and json: keys, digits, and missing values.

load common

# Prints a script that runs each command in each format, always after a reset. The script marks the beginning of each
# answer with the format and a number, and the end with 'end'.
in_one_session() {
    local call number
    for format in table csv json; do
        echo "set output $format"
        number=0
        while IFS='|' read -r call _; do
            number=$((number + 1))
            printf 'reset; goto launch; echo %s %s\n%s\necho end\n' "$format" "$number" "$call"
        done <<<"$commands"
    done
}

answers_in() { # WAY
    local call expected number=0
    session "$1" "$(in_one_session)" >"$BATS_TEST_TMPDIR/answers"
    [ "$1" = -e ] || session -e "$(in_one_session)" >"$BATS_TEST_TMPDIR/like"
    [ "$1" = -e ] || same_file "$BATS_TEST_TMPDIR/like" "$BATS_TEST_TMPDIR/answers"
    while IFS='|' read -r call expected; do
        number=$((number + 1))
        answer=$(sed -n "/\"json $number\"/,/\"end\"/p" "$BATS_TEST_TMPDIR/answers" | grep -v '^{"command":"\(echo\|reset\)"' || :)
        same "keys of $call" "$expected" "$(keys <<<"$answer")"
        [ "$1" != -e ] || same "$call: like alone" "$(json "$call")" "$(bare <<<"$answer")"
    done <<<"$commands"
}

# Extreme scenes, in which lengths, forces, masses or frictions overflow, or the train stands, hangs
# or flies.
scenes='set s 1; set r 1
set s 1e-4; set r 1
set r 1e6
set h 1e9; set g 1e-9; set mass 1e9
set density 1e9; set h 1e9; set g 1e9
set q 1e9; set d 0.9; set s 0.001
effect row 60; set r 1e6
effect row 55; set r 1e5; set mass 1
effect row 5; effect push 1e9
effect row 3; effect floor 0; set s 1; set r 1
effect row 5; effect floor 0.01; set h 1e-9; set r 1.01
set angle deg; set r 1.7; effect friction 0.1
set fuel paper; set r 2.4'

# Prints a call of every command that answers quickly and without files.
calls() {
    local name
    for name in $("$DOMINO" -e complete); do
        case $name in
        quit | exit | help | complete | apropos | source | save | animate | set | reset | effect | \
            place | cost | effects | plot | placement | budget | mend | rowmax | best) ;;
        theta1 | energy | omega | chain) printf '%s\n' "$name 0" "$name 1e-9" ;;
        goto) printf '%s\n' 'goto 0' 'goto 1e-6' 'goto stop' ;;
        count) printf '%s\n' 'count 112' 'count 1e300 m' 'count 1e-300' 'count 1e4000' ;;
        print) printf 'print %s\n' 1e400 1e-400 -1e4000 '1e4000 deg' 3.5e38 '1e39 m' ;;
        draw) printf '%s\n' draw 'draw 0 forces' 'draw 1e-9 forces' ;;
        curve) echo 'curve 0.4 1 3' ;;
        sweep) printf 'sweep %s\n' 's 0.1, 1 : barrier' 'r 1, 1e6, 1e9 : launch' 'r 1e6, 1e9 : row' 's 0.5, 1 : fall' ;;
        *) echo "$name" ;;
        esac
    done
}

# Checks that a key is null in the row that jq selects, and that the row has the reason.
null_of() { # COMMANDS SELECTION KEY REASON
    local said
    said=$(json "$1" | jq -r "select($2) | \"\(.$3)|\(.reason)\"")
    [[ $said =~ ^null\|.*$4 ]] || same "$1" "null|$4" "$said"
}

# bats test_tags=rows,chance,pictures,sweeps,explain,planning,landmarks
@test "every command answers with its keys, with -e, -f, '#!' and from standard input" {
    for way in -e stdin -f '#!'; do answers_in "$way"; done
}

# bats test_tags=rows,chance,sweeps,planning,landmarks
@test "in tables, the labels of every command are its keys" {
    while IFS='|' read -r call expected; do
        answer=$("$DOMINO" -e "$call")
        if [ "${call%% *}" = print ]; then # only the value is printed
            same "$call" 0.1 "$answer"
            continue
        fi
        case $call in # sentences and windows of rows, whose tests are with the rows
        *'; verdict' | *'; fall' | *'; placement 50' | *'; budget '* | *'; tolerance') continue ;;
        esac
        for key in ${expected% reason}; do
            # A column without a value is not shown, and the columns that are not in a short answer are in its details.
            [ "$(json "$call" | values "$key" | sort -u)" != null ] || continue
            grep -qw -- "$key" <<<"$answer"$'\n'"$("$DOMINO" -e "$call > /dev/null; details" 2>&1)" || same "$call" "$key" "$answer"
        done
    done <<<"$commands"
}

# bats test_tags=rows
@test "csv: the header consists of the keys, and the rows agree with json" {
    answered=0
    while IFS='|' read -r call expected; do
        for state in '' 'set s 0.001'; do
            rows=$("$DOMINO" -e "set output csv; $state; $call" 2>/dev/null) || continue
            answered=$((answered + 1))
            like=$(json "$state; $call")
            # The header of 'row' also has units, since it can be read again.
            same "$call: header" "$(keys <<<"$like" | tr ' ' ,)" "$(head -n 1 <<<"$rows" | sed 's/ ([a-z]*)//g')"
            same "$call: rows" "$(sed -E 's/"[A-Za-z0-9_]*"://g; s/[{}]//g; s/\bnull\b//g' <<<"$like" | tr -d '"')" \
                "$(tail -n +2 <<<"$rows" | tr -d '"')"
        done
    done <<<"$commands"
    # All commands answer in the first scene, and more than half of them in the other.
    [ "$answered" -gt $((3 * $(wc -l <<<"$commands") / 2)) ] || same 'answers' 'more' "$answered"
}

@test "every number has exactly as many digits as a round trip to the same double needs" {
    while IFS='|' read -r call _; do json "$call"; done <<<"$commands" |
        grep -o ':-\?[0-9][^,}]*' | tr -d : >"$BATS_TEST_TMPDIR/numbers"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/numbers")" -gt 100 ]
    # The number was written with 15, 16 or 17 digits, and no shorter form round-trips.
    awk '{ for (n = 15; n < 17 && sprintf("%." n "g", $1) + 0 != $1 + 0; n++);
           if (sprintf("%." n "g", $1) != $1) { print; bad = 1 } } END { exit bad }' "$BATS_TEST_TMPDIR/numbers"
    same '0.1' 0.1 "$(json 'set s 0.1; show s' | values value)"
    theta_c=$(json thetac | values theta_c)
    same 'theta_c is a tilt' "$theta_c" "$(json "theta1 $theta_c" | values theta)"
}

# bats test_tags=rows,sweeps
@test "json: an object for each command, with the name of the command, also for errors" {
    while IFS='|' read -r line expected; do
        got=$(printf '%s\n' 'set output json' "$line" | "$DOMINO" 2>err) || true
        grep -qxE -- "$expected" <<<"$got" || same "$line" "$expected" "$got"
        same "$line: one object" 1 "$(wc -l <<<"$got")"
        python3 -c 'import json, sys; assert "command" in json.loads(sys.stdin.read())' <<<"$got"
    done <<'END'
rmax > answer|\{"command":"rmax"\}
quit|\{"command":"quit"\}
theta1 9|\{"command":"theta1","error":"T = 9 rad is outside .*","source":"stdin","line":2,"column":8\}
assert verdict|\{"command":"verdict","error":"there is no row; .*","source":"stdin","line":2,"column":null\}
print "|\{"command":"print","error":".*\\".*","source":"stdin","line":2,"column":7\}
print 1e400|\{"command":"print","value":null,"unit":"","reason":".*quad.*"\}
print 1e5000|\{"command":"print","error":".*this number is too large","source".*\}
help rmax|\{"command":"help","name":"rmax","kind":"command","usage":"rmax \[S\]",.*"keys":"s r_max ends_by r_max_exact r_max_paper r_start".*\}
help friction|\{"command":"help","name":"friction","kind":"effect","usage":"set friction .*\}
complete set output j|\{"command":"complete","line":".*json"\}
echo "a; b"|\{"command":"echo","text":"a; b"\}
END
    # An error is also on standard error.
    grep -q . <(echo 'foo' | "$DOMINO" 2>&1 >/dev/null)
    # 'source' gives an answer for each command of the file, and one for itself at the end.
    printf 'fuel\nset s 0.3\n' >inner
    same 'source' 'fuel set source' "$("$DOMINO" -e 'set output json; source inner' |
        sed -E 's/^\{"command":"([a-z]*)".*/\1/' | paste -sd ' ' -)"
    same 'and in its own file' 'fuel set' "$("$DOMINO" -e 'source inner > all.json' && sed -E 's/^\{"command":"([a-z]*)".*/\1/' all.json | paste -sd ' ' -)"
}

# bats test_tags=errors
@test "csv: a new header only if the columns change, and none with 'set header off'" {
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

# bats test_tags=rows,sweeps
@test "csv and json say that an answer is about the train although a row is on" {
    for format in json csv; do
        for call in rmax 'pair 0.3' 'thetac' 'curve 0.3 0.5 2'; do
            "$DOMINO" -e "effect row 5; set output $format; $call" | grep -q 'endless train' ||
                same "$call in $format" note "$("$DOMINO" -e "effect row 5; set output $format; $call")"
            same "$call without a row" '(nothing)' "$("$DOMINO" -e "set output $format; $call" | grep note || true)"
        done
        same "fall" '(nothing)' "$("$DOMINO" -e "effect row 5; set output $format; fall" | grep note || true)"
    done
}

# bats test_tags=rows,chance,pictures,sweeps,errors
@test "all commands in all outputs and precisions: every number is finite or null" {
    local scene precision style status errors sessions=0
    calls >calls.dom
    [ "$(wc -l <calls.dom)" -gt 30 ]
    while read -r scene; do
        for precision in float double quad; do
            for style in json csv table; do
                # The layout of a table does not depend on the precision.
                if [ "$style$precision" = csvfloat ] || [ "$style$precision" = tablequad ]; then continue; fi
                # An error takes a computation in quad, so one format in one precision has errors.
                errors=off
                if [ "$style$precision" = jsondouble ]; then errors=on; fi
                echo "set output $style; set precision $precision; set errors $errors; $scene" >session.dom
                # Quad is slow, so it runs only a few commands, which show how numbers are written.
                if [ "$precision" = quad ]; then grep -E '^(print|row|launch|draw)' calls.dom; else cat calls.dom; fi >>session.dom
                status=0
                "$DOMINO" -n --keep-going session.dom >out 2>err || status=$?
                [ "$status" -le 1 ] || same "$scene, $precision, $style: status" '0 or 1' "$status"
                [ "$(wc -l <out)" -gt 5 ] || same "$scene, $precision, $style" answers "$(cat out err)"
                same "$scene, $precision, $style" '(nothing)' "$(grep -aiwE -- '[-+]?(inf|nan|infinity)' out err || true)"
                if [ "$style" = json ]; then
                    jq -es 'length > 5' out >/dev/null || same "$scene, $precision" json "$(jq -e . out 2>&1 | tail -n 1)"
                fi
                sessions=$((sessions + 1))
            done
        done
    done <<<"$scenes"
    same sessions 91 "$sessions"
}

# bats test_tags=rows,sweeps
@test "values that a precision cannot represent are null in json and empty in csv, with the reason" {
    null_of 'print 1e400' true value "too large for double precision; quad precision has a wider range"
    null_of 'set precision float; print 1e39' true value 'too large for float precision'
    same 'a float that is one' 3e+38 "$(json 'set precision float; print 3e38' | values value)"
    same 'quad holds it' 1e+4000 "$(json 'set precision quad; print 1e4000' | values value)"
    null_of 'set r 1e6; effect row 60; row' '.domino == 60' height 'too large for double precision'
    null_of 'effect row 60; sweep r 2, 1e6 : row' '.r > 2 and .domino == 60' height 'too large for double precision'
    same csv $'value,unit,reason\n,,value is too large for double precision; quad precision has a wider range (\'set precision quad\')' \
        "$("$DOMINO" -e 'set output csv; print 1e400')"
    # A csv table has no column for a reason that comes with its last rows, so the reason is on
    # stderr.
    for style in csv table; do
        run -0 --separate-stderr "$DOMINO" -e "set output $style; set r 1e6; effect row 60; row"
        [[ "$stderr$output" == *'is too large for double precision'* ]] || same "$style" reason "$stderr$output"
    done
}

# bats test_tags=rows,chance,pictures
@test "a contact at the hinge, and a foot that no friction can hold, are explained in words" {
    [[ $("$DOMINO" -e 'set s 1; set r 1; draw forces') == *'weight: 0: no force is enough'* ]]
    null_of 'set s 1; set r 1; draw forces' '.i == 0' force 'the contact is at the hinge'
    null_of 'effect floor 0; effect friction 1.5; slip' true hit 'lifted off the floor'
    null_of 'effect row 3; effect floor 0; set s 1; set r 1; fall' '.domino == 2' floor 'lifted off the floor'
    says 'effect row 3; effect floor 0; set s 1; set r 1; fall' 'While dominoes fall, the foot of domino 1 is lifted off the floor, and no friction can prevent this.'
    [[ $("$DOMINO" -e 'set precision quad; count 1e4000 m') == *'one that is 1e+4000 m tall.'* ]]
    if command -v gnuplot; then "$DOMINO" -e 'set s 1; set r 1; draw forces > x.svg' && ! grep -qE "[^a-z]nan[^a-z]" x.svg; fi
}
