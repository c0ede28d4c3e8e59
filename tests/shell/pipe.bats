#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The calculator without a terminal: every command in every way, json and csv, known values, options.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

# The rows of a table of known values, without its head.
reference() { tail -n +2 "$BATS_TEST_DIRNAME/../reference/$1.csv" | tr -d '\r'; }

# ---- Every command, in each of the ways ----

# Prints the commands, each as if alone, in each format, with a line of its number before it.
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

@test "every command answers with its keys: -e" { answers_in -e; }
@test "every command answers with its keys: standard input" { answers_in stdin; }
@test "every command answers with its keys: -f FILE" { answers_in -f; }
@test "every command answers with its keys: '#!'" { answers_in '#!'; }

@test "for people every command answers with labels: its keys" {
    while IFS='|' read -r call expected; do
        answer=$("$DOMINO" -e "$call")
        if [ "${call%% *}" = print ]; then # just the value
            same "$call" 0.1 "$answer"
            continue
        fi
        case $call in
        *'; verdict') # sentences
            grep -q '^All 5 fall; the last lies 1\.433 s after the first hit\.$' <<<"$answer"
            grep -q '^Domino 2 has the least to spare: it has 239 % of the energy that it needs\.$' <<<"$answer"
            continue
            ;;
        *'; fall') # energies in percent, and in J if masses are known
            for key in kinetic barrier margin; do run ! grep -qw "$key" <<<"$answer"; done
            expected=${expected/kinetic barrier margin /}
            grep -qw kinetic <<<"$("$DOMINO" -e "set mass 1; $call")"
            ;;
        *'; tolerance') # windows alone; leans and the friction in sentences
            expected='domino from to gap_low gap_high height_low height_high first'
            grep -q '^All fall with a friction between the dominoes up to' <<<"$answer"
            grep -q '^Set domino 2 up plumb: its top may be off by ' <<<"$answer"
            ;;
        esac
        for key in ${expected% reason}; do
            grep -qw -- "$key" <<<"$answer" || same "$call" "$key" "$answer"
        done
    done <<<"$commands"
}

@test "help lists every command, and explains each with its keys" {
    list=$("$DOMINO" -e help)
    while IFS='|' read -r call expected; do
        name=${call##*; }
        name=${name%% *}
        grep -q "^  $name " <<<"$list" || same help "$name" "$list"
        text=$("$DOMINO" -e "help $name")
        as=$(sed -n "s/^It answers as '\([a-z]*\)' does.*/\1/p" <<<"$text")
        [ -z "$as" ] || text=$("$DOMINO" -e "help $as")
        for key in ${expected% reason}; do
            grep -q "^  $key " <<<"$text" || same "help $name" "$key" "$text"
        done
    done <<<"$commands"
    for name in set show reset print save source exit quit help apropos complete; do grep -q "^  $name " <<<"$list"; done
}

@test "lesson: in a pipe it shows the tutorial without waiting, and in a file the rest of the file" {
    cd "$BATS_TEST_TMPDIR"
    golden=$BATS_TEST_DIRNAME/golden/tutorial.out
    same steps 10 "$(grep -c '^---- ' "$golden")"
    for way in -e stdin; do
        session "$way" 'set s 0.3; lesson; print s' | diff <(cat "$golden"; echo 0.3) - || same "$way" 'the tutorial' ''
    done
    printf '%s\n' 'set s 0.3' lesson '# Two dominoes.' '#' '#  pair' 'pair.s; foo' >own.dom
    run -1 --separate-stderr "$DOMINO" --safe -f own.dom
    same 'own file' $'Two dominoes.\n\n pair\ndomino> pair.s; foo\n0.4' "$output"
    same 'an error' "unknown command 'foo'; 'help' lists the commands" "$stderr"
    run -1 "$DOMINO" -e 'set output json; lesson'
    [[ $output == *"a lesson is for people; 'set output table' comes first"* ]]
}

@test "json: one object a line, the same keys in every row" {
    while IFS='|' read -r call expected; do
        json "$call" >"$BATS_TEST_TMPDIR/rows"
        same "$call: objects" '(nothing)' "$(grep -v '^{"[^{}]*}$' "$BATS_TEST_TMPDIR/rows" || true)"
        [ -s "$BATS_TEST_TMPDIR/rows" ]
        while read -r row; do same "$call: keys" "$expected" "$(keys <<<"$row")"; done <"$BATS_TEST_TMPDIR/rows"
    done <<<"$commands"
}

@test "csv: the header is the keys, the rows are those of json" {
    answered=0
    while IFS='|' read -r call expected; do
        for state in '' 'set s 0.001'; do
            rows=$("$DOMINO" -e "set output csv; $state; $call" 2>/dev/null) || continue
            answered=$((answered + 1))
            like=$(json "$state; $call")
            # That of 'row' has units, too: it is read back.
            same "$call: header" "$(keys <<<"$like" | tr ' ' ,)" "$(head -n 1 <<<"$rows" | sed 's/ ([a-z]*)//g')"
            same "$call: rows" "$(sed -E 's/"[A-Za-z0-9_]*"://g; s/[{}]//g; s/\bnull\b//g' <<<"$like" | tr -d '"')" \
                "$(tail -n +2 <<<"$rows" | tr -d '"')"
        done
    done <<<"$commands"
    # All in the first state, and more than half of them in the other.
    [ "$answered" -gt $((3 * $(wc -l <<<"$commands") / 2)) ] || same 'answers' 'more' "$answered"
}

@test "every number has as many digits as read back to the same double, and no more" {
    while IFS='|' read -r call _; do json "$call"; done <<<"$commands" |
        grep -o ':-\?[0-9][^,}]*' | tr -d : >"$BATS_TEST_TMPDIR/numbers"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/numbers")" -gt 100 ]
    # Among 15, 16 and 17 digits one form of the double is what was written, and no shorter one reads back to it.
    awk '{ for (n = 15; n < 17 && sprintf("%." n "g", $1) + 0 != $1 + 0; n++);
           if (sprintf("%." n "g", $1) != $1) { print; bad = 1 } } END { exit bad }' "$BATS_TEST_TMPDIR/numbers"
    same '0.1' 0.1 "$(json 'set s 0.1; show s' | values value)"
    theta_c=$(json thetac | values theta_c)
    same 'theta_c is a tilt' "$theta_c" "$(json "theta1 $theta_c" | values theta)"
}

# ---- Known values ----

@test "reference/points.csv: angles, energies, fuels, launch, barrier, speed and duration of a cycle" {
    rows=0
    # shellcheck disable=SC2034 # some are read by ${!name}
    while IFS=, read -r name s r q d theta theta_c theta_f theta_leave theta_1 _ slope _ J0 J dH \
        fuel_paper fuel_exact launch_paper launch_exact theta_m barrier omega_paper omega_exact \
        duration_paper duration_exact; do
        for fuel in exact paper; do
            json "set s $s; set r $r; set q $q; set d $d; set fuel $fuel
                thetac; theta1 $theta; energy $theta; fuel; launch; barrier; omega $theta; duration
                " >"$BATS_TEST_TMPDIR/answers"
            fuel_in_use=fuel_$fuel launch=launch_$fuel omega=omega_$fuel duration=duration_$fuel
            while read -r key expected; do
                # The square of no speed: the table goes on with (21; c3) and (24; c6) where a train stops.
                [[ $key == omega*sq && $expected == -* ]] && expected=''
                # The table leaves out some durations, which take long in 40 digits.
                [ "$key $expected" = "duration " ] && continue
                close "$name, fuel $fuel: $key" "${expected:-(nothing)}" "$(values "$key" <"$BATS_TEST_TMPDIR/answers" | head -n 1)"
            done <<END
theta_c $theta_c
theta_f $theta_f
theta_leave $theta_leave
theta_1 $theta_1
slope $slope
J0 $J0
J $J
dH $dH
fuel ${!fuel_in_use}
fuel_exact $fuel_exact
fuel_paper $fuel_paper
omega0sq ${!launch}
barrier $barrier
theta_m $theta_m
omegasq ${!omega}
duration ${!duration}
END
        done
        rows=$((rows + 1))
    done < <(reference points)
    same rows 16 "$rows"
}

@test "reference/rmax.csv: rmax with both fuels" {
    # Once as the parameter, once as the argument.
    mapfile -t answers < <(reference rmax | while IFS=, read -r s q d fuel _; do
        echo "set output json; set q $q; set d $d; set fuel $fuel; set s $s; rmax; reset s; rmax $s"
    done | "$DOMINO" | grep -F r_max)
    same answers 84 "${#answers[@]}"
    rows=0
    while IFS=, read -r s q d fuel r_max ends_by; do
        what="s $s, q $q, d $d, $fuel"
        for answer in "${answers[@]:rows:2}"; do
            close "$what: s" "$s" "$(values s <<<"$answer")"
            close "$what" "${r_max:-(nothing)}" "$(values r_max <<<"$answer")"
            close "$what" "${r_max:-(nothing)}" "$(values "r_max_$fuel" <<<"$answer")"
            same "$what" "$ends_by" "$(values ends_by <<<"$answer")"
        done
        rows=$((rows + 2))
    done < <(reference rmax)
    same rows 84 "$rows"
}

@test "reference/pair.csv: pair" {
    mapfile -t answers < <(reference pair | while IFS=, read -r s q _; do echo "set output json; set q $q; pair $s"; done |
        "$DOMINO" | grep -F r_max)
    rows=0
    while IFS=, read -r s q r_max ends_by; do
        answer=${answers[rows]}
        close "s $s, q $q: s" "$s" "$(values s <<<"$answer")"
        close "s $s, q $q" "${r_max:-(nothing)}" "$(values r_max <<<"$answer")"
        same "s $s, q $q" "$ends_by" "$(values ends_by <<<"$answer")"
        rows=$((rows + 1))
    done < <(reference pair)
    same rows 18 "$rows"
}

@test "best: hollow and solid, exact and paper, to six decimals" {
    while read -r q fuel s r_max; do
        answer=$(json "set q $q; set fuel $fuel; best")
        same "$q $fuel: s" "$s" "$(printf %.6f "$(values s <<<"$answer")")"
        same "$q $fuel: r_max" "$r_max" "$(printf %.6f "$(values r_max <<<"$answer")")"
    done <<END
hollow exact 0.443615 2.172869
hollow paper 0.432413 2.202558
massive exact 0.533651 1.810436
massive paper 0.520419 1.831348
END
}

@test "curve: the separations are evenly spaced, its values are those of rmax and pair" {
    json 'set q hollow; curve 0.3 0.5 3' >"$BATS_TEST_TMPDIR/rows"
    same rows 3 "$(wc -l <"$BATS_TEST_TMPDIR/rows")"
    for i in 1 2 3; do
        row=$(sed -n "${i}p" "$BATS_TEST_TMPDIR/rows")
        s=$(values s <<<"$row")
        close "s of row $i" "0.$((i + 2))" "$s"
        answer=$(json "set q hollow; rmax $s; pair $s; set fuel paper; rmax $s")
        same exact "$(values r_max <<<"$answer" | sed -n 1p)" "$(values exact <<<"$row")"
        same pair "$(values r_max <<<"$answer" | sed -n 2p)" "$(values pair <<<"$row")"
        same paper "$(values r_max <<<"$answer" | sed -n 3p)" "$(values paper <<<"$row")"
        close reach "$(awk "BEGIN { printf \"%.17g\", 1 / $s }")" "$(values reach <<<"$row")"
    done
    same 'one row' 0.5 "$(json 'curve 0.5 0.5 1' | values s)"
    same 'to the very end' 0.9 "$(json 'curve 0.1 0.9 7' | values s | tail -n 1)"
}

@test "duration and launch in seconds: the axes tau = sqrt((h^2 + d^2) / 3 g h)" {
    answer=$(json 'duration; launch')
    tau=$(awk 'BEGIN { h = 0.048; d = 0.007; printf "%.17g", sqrt((h * h + d * d) / (3 * 9.81 * h)) }')
    close tau "$tau" "$(values tau <<<"$answer")"
    seconds=$(awk "BEGIN { printf \"%.17g\", $tau * $(values duration <<<"$answer") }")
    close seconds "$seconds" "$(values seconds <<<"$answer")"
    close speed "$(awk "BEGIN { printf \"%.17g\", (0.4 * 0.048 + 0.007) * 1.5 / $seconds }")" \
        "$(values speed <<<"$answer")"
    close omega0 "$(awk "BEGIN { printf \"%.17g\", sqrt($(values omega0sq <<<"$answer")) / $tau }")" \
        "$(values omega0 <<<"$answer")"
}

# ---- count ----

@test "count: the quiz, and powers that are exact" {
    while IFS='|' read -r arguments dominoes exact; do
        answer=$(json "count $arguments")
        same "count $arguments" "$dominoes" "$(values dominoes <<<"$answer")"
        close "count $arguments" "$exact" "$(values exact <<<"$answer")"
    done <<END
112|20|19.126314408539823
112 2|12|11.188176705998537
0.048|0|0
0.072|1|1
49.152 2|10|10
49.153 2|11|10.000029351328536
49.151 2|10|9.9999706480743
END
}

@test "count: h r^k, computed in double precision, takes k dominoes, k = 1 .. 20" {
    for r in 2 1.5 1.1 3 1.25; do
        awk -v r=$r 'BEGIN { print "set output json"
            for (k = 1; k <= 20; k++) printf "count %.17g %s\n", 0.048 * r ^ k, r }' >"$BATS_TEST_TMPDIR/powers"
        same "r = $r" "$(seq 20)" "$("$DOMINO" "$BATS_TEST_TMPDIR/powers" | values dominoes)"
        # And one that is clearly taller takes one more.
        same "above, r = $r" "$(seq 2 21)" \
            "$(awk '/count/ { $2 = sprintf("%.17g", $2 * 1.000001) } 1' "$BATS_TEST_TMPDIR/powers" |
                "$DOMINO" | values dominoes)"
    done
}

@test "count: h counts, the last height reaches the height, r = 1 reaches nothing" {
    same 'h 1' 7 "$(json 'set h 1; count 128 2' | values dominoes)"
    close 'last height' 128 "$(json 'set h 1; count 100 2' | values last_height)"
    answer=$(json 'count 112 1')
    same 'r 1' null "$(values dominoes <<<"$answer")"
    grep -q '"reason":"[^"]' <<<"$answer"
}

@test "count 112 answers the quiz as a person asks it" {
    same 'count 112' '20 dominoes, each 1.5 times as large as the one before, topple one of 112 m.
toppled: 159.6 m; the 20th domino is 106.4 m tall
can it fall? yes' "$("$DOMINO" -e 'count 112' | head -n 3)"
    answer=$("$DOMINO" -e 'count 112')
    for words in '^Falling with growth 1\.5 at s = 0\.4' '^ *hollow *yes;.* 2\.06377 .* 11 dominoes' \
        '^ *solid *yes;.* 1\.64423 .* 16 dominoes'; do
        grep -q "$words" <<<"$answer" || same 'count 112' "$words" "$answer"
    done
    # The toppled domino is one growth larger than the last of the 20.
    close 'the 20th' "$(json 'count 112' | values last_height)" "$(json 'print 1.5 * h * 1.5^19' | values value)"
    same 'r 2 with solid dominoes' false "$(json 'count 112 2' | values feasible)"
    same 'r 2 with hollow dominoes' true "$(json 'set q hollow; count 112 2' | values feasible)"
    answer=$("$DOMINO" -e 'count 112 2')
    for words in '^12 dominoes, .* would be needed' '^can it fall? no$' '^Falling with growth 2 ' '^ *hollow *yes' \
        '^ *solid *no;.*1\.64423' 'not possible at s = 0\.4 with solid dominoes: the train has too little energy'; do
        grep -q "$words" <<<"$answer" || same 'count 112 2' "$words" "$answer"
    done
    # A mass exponent that has no word gets its own line; a synonym gets none.
    "$DOMINO" -e 'set q 3.5; count 112' | grep -q '^ *q = 3\.5 *yes'
    same 'hollow and solid' 2 "$("$DOMINO" -e 'count 112' | grep -c '^ .*growth up to')"
    for pair in '0.05|the first domino is 4.8 cm tall' '0.1|the 2nd domino' '0.15|the 3rd domino' '0.2|the 4th domino' \
        '4|the 11th domino' '6|the 12th domino' '9|the 13th domino' '200|the 21st domino'; do
        [[ $("$DOMINO" -e "count ${pair%|*}") == *"; ${pair#*|}"* ]] || same "$pair" "${pair#*|}" "$("$DOMINO" -e "count ${pair%|*}")"
    done
    same 'tall enough' 'No domino is needed: the first is already 4.8 cm tall.' "$("$DOMINO" -e 'count 1 cm' | head -n 1)"
    # A train that misses the next domino is a "no", too: the number is there all the same.
    answer=$(json "set s 0.9; count 112")
    same "r s > 1" "20 false" "$(values dominoes <<<"$answer") $(values feasible <<<"$answer")"
    grep -q '"reason":"[^"]*without touching' <<<"$answer"
    "$DOMINO" -e 'set s 0.9; count 112' | grep -q 'without touching'
    answer=$(json 'count 112')
    same 'feasible' true "$(values feasible <<<"$answer")"
    same 'feasible: no reason' '(nothing)' "$(values reason <<<"$answer")"
}

@test "rmax says why exact and paper differ, and only where they do" {
    "$DOMINO" -e rmax | grep -q '^They differ since'
    same 'only where they do' '(nothing)' "$("$DOMINO" -e rmax | grep 'Both end by the reach')"
    "$DOMINO" -e 'rmax 0.9' | grep -q '^Both end by the reach'
    same 'nor there' '(nothing)' "$("$DOMINO" -e 'rmax 0.9' | grep differ)"
}

# ---- A physical "no" is an answer ----

@test "no fuel, no growth, stopped: null with a reason, status 0, nothing on stderr" {
    while IFS='|' read -r calls nulls reason; do
        run --separate-stderr json "$calls"
        same "$calls: status" 0 "$status"
        same "$calls: stderr" '(nothing)' "$stderr"
        row=$(tail -n 1 <<<"$output")
        for key in $nulls; do same "$calls: $key" null "$(values "$key" <<<"$row")"; done
        grep -q "\"reason\":\"[^\"]*${reason}[^\"]*\"}$" <<<"$row" || same "$calls" "$reason" "$row"
        # People read the same.
        expects "$calls" "$reason"
        "$DOMINO" -e "$calls" | grep -q "$reason"
    done <<END
set s 0.001; fuel||fuel P is not positive.*s is too small
set s 0.05; fuel||this growth r .*fuel P is not positive
set s 0.001; launch|omega0sq omega0 kinetic|fuel P is not positive
set s 0.001; omega 0|omegasq omega|fuel P is not positive
set s 0.001; barrier|kinetic margin|fuel P is not positive
set s 0.001; duration|duration seconds speed|fuel P is not positive
set s 0.001; set fuel paper; launch|omega0sq omega0 kinetic|fuel P is not positive
rmax 0.001|r_max r_max_exact r_max_paper|no growth possible.*no energy free
pair 0.1|r_max|no growth possible
set d 1; best|s r_max|no growth possible
set r 1.8; duration|duration seconds speed|below the barrier
set r 1.8; omega 0.2|omegasq omega|below the barrier
set r 1.8; barrier||too little energy, and stops at theta.*below the barrier
END
}

@test "a physical no: verdict and what ends the growth" {
    same verdict 'no fuel' "$(json 'set s 0.001; barrier' | values verdict)"
    same verdict 'stops' "$(json 'set r 1.8; barrier' | values verdict)"
    same verdict 'goes on' "$(json 'barrier' | values verdict)"
    same none none "$(json 'rmax 0.001' | values ends_by)"
    same none none "$(json 'pair 0.1' | values ends_by)"
    same reach reach "$(json 'rmax 0.9' | values ends_by)"
    same 'a hole in a curve' 'null 1.6442290' \
        "$(json 'curve 0.001 0.4 2' | values exact | cut -c1-9 | paste -sd ' ' -)"
}

@test "fuel paper: the figures of the paper" {
    answer=$(json 'set q hollow; rmax; set fuel paper; rmax; fuel; show fuel')
    close 'exact' '2.06377177270466131' "$(values r_max <<<"$answer" | head -n 1)"
    close 'paper' '2.16858351495697886' "$(values r_max <<<"$answer" | tail -n 1)"
    close 'both show exact' '2.06377177270466131' "$(values r_max_exact <<<"$answer" | tail -n 1)"
    same 'fuel in use' "$(values fuel_paper <<<"$answer")" "$(values fuel <<<"$answer" | head -n 1)"
    same 'its word' paper "$(values value <<<"$answer")"
}

# ---- The shape of the input ----

@test "standard input: no prompt, no echo, no banner" {
    same 'nothing' '(nothing)' "$(printf 'set s 0.3\nset r 1.2\n\n# only this\n' | "$DOMINO" 2>&1)"
    same 'empty' '(nothing)' "$("$DOMINO" </dev/null 2>&1)"
    same 'a known answer' 42 "$(printf 'set s 0.3\n\nprint 6*7\n# only this\n' | "$DOMINO" 2>&1)"
    same 'only the answer' "$(json fuel)" "$(printf 'set output json\nfuel\n' | "$DOMINO" 2>&1)"
}

@test "comments, blank lines, ';', CRLF, tabs and a missing final newline change nothing" {
    expected=$(json 'set s 0.3; fuel')
    differ 's counts' "$(json fuel)" "$expected"
    while IFS= read -r text; do
        # shellcheck disable=SC2059 # the text is a format: \n, \r, \t
        same "$text" "$expected" "$(printf "$text" | "$DOMINO" 2>&1)"
    done <<'END'
set output json\nset s 0.3\nfuel\n
set output json\nset s 0.3\nfuel
set output json\r\nset s 0.3\r\nfuel\r\n
set output json\r\n\r\nset s 0.3\r\nfuel
\n\n  \n\t\nset output json\n\nset s 0.3\n\n\nfuel\n\n
# set s 9; quit\nset output json # json; quit\n#\nset s 0.3 #\nfuel #\n#fuel
;;set output json;set s 0.3;;fuel;
 set  output\tjson ; set s 0.3 ; \t fuel ; # ; fuel
END
}

@test "'quit' in the middle ends the session, in every way" {
    for way in -e stdin -f '#!'; do
        run -0 --separate-stderr session "$way" $'set output json\nfuel; quit; foo\nfoo'
        same "$way" "$(json fuel)" "$output"
        same "$way" '(nothing)' "$stderr"
    done
    same 'several -e' 42 "$("$DOMINO" -e 'print 6*7' -e quit -e fuel -f /nonexistent 2>&1)"
}

@test "several -e, -f and FILE make one session, in their order" {
    cd "$BATS_TEST_TMPDIR"
    echo 'set output json; set s 0.2' >a
    echo 'show s' >b
    same '-f -e FILE -e' $'0.2\n0.3\n0.3' \
        "$("$DOMINO" -f a -e 'show s' -e 'set s 0.3' b --execute 'show s' | values value)"
    same 'options behind FILE' 0.2 "$("$DOMINO" a --file=b | values value)"
    same 'behind --' 0.2 "$("$DOMINO" -- a b | values value)"
    same '- is standard input' 0.2 "$("$DOMINO" -f a - <b | values value)"
    # A name that looks like an option.
    cp b ./-e
    same 'FILE -e' 0.2 "$("$DOMINO" -- a -e | values value)"
    # With -e nothing is read from standard input.
    same 'standard input is left alone' 'foo' "$(echo foo | { "$DOMINO" -e 'set s 0.2'; cat; })"
}

@test "--version and --help" {
    for option in --version -V; do
        run -0 "$DOMINO" "$option"
        [[ $output =~ ^domino\ [0-9]+\.[0-9]+\.[0-9]+$ ]]
    done
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
0|-e 'set s 0.001; rmax'
0|
1|-e foo
1|-e 'foo; fuel'
1|-e foo -e fuel
1|-f /nonexistent
1|/nonexistent
2|-x
2|--frob
2|-e
2|-f
2|--bail=1
2|--keep-going=1
2|-e fuel -x
END
    # Wrong options are seen before anything runs.
    run -2 --separate-stderr "$DOMINO" -e fuel -x
    same 'nothing ran' '(nothing)' "$output"
    grep -q '^usage: ' <<<"$stderr"
}

@test "-e, -f and FILE stop at the first error, standard input with --bail; with --keep-going all go on" {
    printf 'set output json\nfuel; foo; fuel\nfuel\n' >"$BATS_TEST_TMPDIR/bad"
    text=$(cat "$BATS_TEST_TMPDIR/bad")
    bad_ways() {
        "$DOMINO" "$@" -e "$text"
        echo "$?"
        "$DOMINO" "$@" <"$BATS_TEST_TMPDIR/bad"
        echo "$?"
        "$DOMINO" "$@" -f "$BATS_TEST_TMPDIR/bad" -e fuel
        echo "$?"
        "$DOMINO" "$BATS_TEST_TMPDIR/bad" "$@"
        echo "$?"
    }
    fuel=$(json fuel)
    once=$fuel$'\n'1
    thrice=$fuel$'\n'$fuel$'\n'$once
    same 'with --bail' "$once"$'\n'"$once"$'\n'"$once"$'\n'"$once" "$(bad_ways --bail 2>/dev/null)"
    same 'with neither' "$once"$'\n'"$thrice"$'\n'"$once"$'\n'"$once" "$(bad_ways 2>/dev/null)"
    for options in --keep-going '--bail --keep-going'; do # the last one counts
        # shellcheck disable=SC2086 # words
        same "with $options" "$thrice"$'\n'"$thrice"$'\n'"$fuel"$'\n'"$thrice"$'\n'"$thrice" "$(bad_ways $options 2>/dev/null)"
    done
    same 'with --bail in the end' "$once" "$("$DOMINO" --keep-going --bail -e "$text" 2>/dev/null; echo $?)"
    # A physical "no" is no error.
    same 'a no' 2 "$("$DOMINO" --bail -e 'set output json; set s 0.001; fuel; fuel' | grep -c reason)"
}

# ---- Parameters ----

@test "show: all parameters with defaults, units, ranges and meanings; show NAME" {
    json show >"$BATS_TEST_TMPDIR/all"
    same names 's r d q tol h g mass density fuel precision method seed threads output header digits angle errors timing hints' "$(values name <"$BATS_TEST_TMPDIR/all" | paste -sd ' ' -)"
    while read -r name unit value; do
        row=$(json "show $name")
        same "show $name" "$(grep "\"name\":\"$name\"" "$BATS_TEST_TMPDIR/all")" "$row"
        same "keys" 'name value unit range default meaning' "$(keys <<<"$row")"
        [ "$unit" != - ] || unit='(nothing)'
        same "$name: unit" "$unit" "$(values unit <<<"$row")"
        case $value in
        *[0-9]*)
            close "$name: value" "$value" "$(values value <<<"$row")"
            close "$name: default" "$value" "$(values default <<<"$row")"
            ;;
        *) same "$name: default" "$value" "$(values default <<<"$row")" ;;
        esac
        grep -q '"range":"[^"]' <<<"$row"
        grep -q '"meaning":"[^"]' <<<"$row"
        # For people: one head, one line.
        same "show $name: lines" 2 "$("$DOMINO" -e "show $name" | wc -l)"
    done <<END
s h 0.4
r - 1.5
d h 0.14583333333333334
q - 4
tol - 1e-12
h m 0.048
g m/s^2 9.81
fuel - exact
output - table
digits - 6
angle - rad
timing - off
END
}

@test "set: numbers as people write them, quotients, words" {
    while read -r name text value; do
        same "set $name $text" "$value" "$(json "set $name $text; show $name" | values value)"
    done <<END
s .5 0.5
s 5e-1 0.5
s 5.E-1 0.5
s +0.5 0.5
s 1/2/2 0.25
s 1e-6 1e-06
s 1/2 0.5
s 1 1
r 3/2 1.5
r 1 1
d 7/48 0.14583333333333334
q hollow 3
q solid 4
q massive 4
q 3.5 3.5
fuel paper paper
END
}

@test "reset and reset NAME restore the defaults; output belongs to the session" {
    changed='set s 0.3; set r 1.2; set d 0.2; set q 3; set tol 1e-10; set h 1; set g 1.6; set fuel paper'
    defaults=$(json show)
    differ 'what is reset' "$(json "$changed; show")" "$defaults"
    same 'reset' "$defaults" "$(json "$changed; reset; show")"
    same 'reset s' "$(json "$changed; set s 0.4; show")" "$(json "$changed; reset s; show")"
    same 'reset output' "$("$DOMINO" -e fuel)" "$("$DOMINO" -e 'set output json; reset output; fuel')"
}

@test "each set is checked on its own: r s > 1 errs where a command needs both, and a second set mends it" {
    run -1 --separate-stderr json 'set s 0.9; thetac; set r 1.1; thetac'
    same 'one answer' 1 "${#lines[@]}"
    close 'theta_c' "$(awk 'BEGIN { x = 0.9 * 1.1; printf "%.17g", atan2(x, sqrt(1 - x * x)) }')" \
        "$(values theta_c <<<"$output")"
    grep -q 'r s = 1.35 > 1' <<<"$stderr"
    for order in 'set s 0.9; set r 1.1' 'set r 1.1; set s 0.9' 'set r 3; set s 0.9; set r 1.1'; do
        same "$order" "$output" "$(json "$order; thetac")"
    done
    # r s = 1 is the end of the range, also where 1/s is rounded.
    for s in 0.5 0.3 0.7 0.9 1; do
        same "s $s, r 1/s" 2 "$(json "set s $s; set r 1/$s; thetac; barrier" | grep -cE '"(theta_c|barrier)":[0-9]')"
    done
}

# ---- The output ----

@test "output that cannot be written: a message and a status" {
    [ -c /dev/full ] || skip 'no /dev/full'
    for arguments in '-e fuel' '-e help' '--help' '--version' '-e curve\ 0.1\ 0.9\ 200'; do
        full() { eval "\"\$DOMINO\" $arguments" >/dev/full; }
        run -1 --separate-stderr full
        # Where the first write failed long ago, its reason may be gone.
        same "$arguments" "domino: cannot write the output" "${stderr%%: No space*}"
    done
}

@test "a closed pipe ends even a long answer" {
    # Ten million rows would take hours.
    while IFS='|' read -r trap status message; do
        # shellcheck disable=SC2016 # sh expands it
        timeout 60 sh -c "$trap"' { "$DOMINO" -e "curve 0.01 0.9 10000000; fuel" 2>"$1/err"; echo $? >"$1/status"; } |
            head -n 1 >"$1/out"' sh "$BATS_TEST_TMPDIR"
        same 'head' 1 "$(wc -l <"$BATS_TEST_TMPDIR/out")"
        same 'status' "$status" "$(cat "$BATS_TEST_TMPDIR/status")"
        same 'message' "$message" "$(sed 's/: Broken pipe//' "$BATS_TEST_TMPDIR/err")"
    done <<'END'
trap - PIPE;|141|(nothing)
trap '' PIPE;|1|domino: cannot write the output
END
}

@test "both streams keep their order where they share a file" {
    "$DOMINO" --keep-going -e 'set output json; fuel; foo; fuel' >"$BATS_TEST_TMPDIR/both" 2>&1 || true
    same 'the error is between the answers, as an object and as a message' '2 3' \
        "$(grep -n 'foo' "$BATS_TEST_TMPDIR/both" | cut -d: -f1 | paste -sd ' ' -)"
    same 'the object' 2 "$(grep -n '^{.*"error":"unknown command' "$BATS_TEST_TMPDIR/both" | cut -d: -f1)"
    same 'lines' 4 "$(wc -l <"$BATS_TEST_TMPDIR/both")"
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
