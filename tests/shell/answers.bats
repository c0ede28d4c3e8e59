#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# What commands answer as values, into files, through pipes and in tables.

load common

# ---- Commands in expressions ----

@test "each command with a principal column stands for that column, each other one for nothing" {
    local name key list=''
    for name in $("$DOMINO" -e 'complete '); do
        key=$("$DOMINO" -e "help $name" | sed -n "s/^In an expression '$name' stands for its \(.*\)\.\$/\1/p")
        if [ -n "$key" ]; then
            list+=" $name.$key"
        else
            run -1 --separate-stderr "$DOMINO" --keep-going -e "print $name"
            [[ $stderr == *"'$name"*"' has no value"* ]] || same "print $name" "'$name' has no value" "$stderr"
        fi
    done
    same 'the principal columns' ' thetac.theta_c theta1.theta_1 energy.dH fuel.fuel launch.omega0sq omega.omega'`
        `' barrier.barrier duration.duration where.theta why.margin rmax.r_max pair.r_max best.s count.dominoes'`
        `' verdict.seconds rowmax.r_max design.steps placement.probability budget.sigma slip.motion' "$list"
    for name in thetac.theta_c 'theta1(0.1).theta_1' 'energy(0.1).dH' fuel.fuel launch.omega0sq 'omega(0.1).omega' \
        barrier.barrier duration.duration where.theta why.margin rmax.r_max pair.r_max best.s 'count(112).dominoes' \
        verdict.seconds rowmax.r_max 'placement(50).probability' 'budget(0.9, 50).sigma' slip.motion; do
        same "$name" 0 "$("$DOMINO" -e "effect row 4; effect placement 5 mm; print $name - ${name%.*}" | cut -d ' ' -f 1)"
    done
}

# ---- One state for 'where' and 'draw' ----

@test "draw without T shows the state of 'where', whatever has changed since the last step" {
    local change where
    for change in 'set s 0.3' 'set r 1.4' 'set d 0.2' 'set q 3' 'set tol 1e-9' 'set fuel paper' \
        'set precision quad' 'effect friction 0.3'; do
        [[ $("$DOMINO" -e "goto 0.2; $change; where") == *'the walk begins again'* ]]
        same "$change" "$("$DOMINO" -e "$change > /dev/null; draw 0")" \
            "$("$DOMINO" -e "goto 0.2 > /dev/null; $change > /dev/null; draw")"
    done
    for change in 'set h 1' 'set mass 2' 'set digits 5' 'set seed 3' 'effect row 5' 'effect floor 0.4'; do
        [[ $("$DOMINO" -e "goto 0.2; $change; where") != *'the walk begins again'* ]]
        same "$change" "$("$DOMINO" -e "$change; draw train 0.2")" \
            "$("$DOMINO" -e "goto 0.2 > /dev/null; $change; draw train")"
    done
    # The walk is computed to a tolerance of its own, so that every state of the walk can be drawn.
    for change in 'set tol 0.1' 'set tol 0.01' 'set tol 1e-13'; do
        same "$change" "$("$DOMINO" -e 'set r 1.7; goto stop > /dev/null; draw')" \
            "$("$DOMINO" -e "$change; set r 1.7; goto stop > /dev/null; draw")"
    done
}

# ---- Pictures ----

answers_at_a_terminal() { timeout 300 expect -f "$BATS_TEST_DIRNAME/answers.exp" "$@" </dev/null; }

@test "a file with a picture holds the picture alone, also where a row is on and times are asked for" {
    cd "$BATS_TEST_TMPDIR" || false
    local row='effect row 5; set timing on' what size
    for what in draw 'draw 0.3 forces' 'plot energy' 'plot omega' 'plot chain' 'plot growth' 'plot marginal' \
        'plot cost fuel'; do
        "$DOMINO" -e "$row; $what > a.svg; $what > a.png; $what > a.pdf" >said 2>notes
        same "$what: standard output" '(nothing)' "$(cat said)"
        xmllint --noout a.svg
        same "$what: the end of the svg" '</svg>' "$(grep . a.svg | tail -n 1)"
        # Width and height, then bit depth, colour type; the last chunk is IEND with its checksum.
        case $what in # a stage is as high as what stands on it
        draw) size=0000050000000460 ;;
        draw*) size=0000050000000372 ;;
        *) size=000003c0000002d0 ;;
        esac
        same "$what: the first chunk of the png" $size "$(od -An -tx1 -j 16 -N 8 a.png | tr -d ' ')"
        same "$what: the last chunk of the png" 0000000049454e44ae426082 "$(tail -c 12 a.png | od -An -tx1 | tr -d ' \n')"
        same "$what: the end of the pdf" '%%EOF' "$(tail -n 1 a.pdf)"
        if [[ $what = 'draw 0.3'* ]]; then
            same "$what: the note is for people" 3 "$(grep -c "^(This is the endless train" notes)"
        fi
        rm a.*
    done
    "$DOMINO" -e "$row; animate a.gif 2" >said
    same 'the end of the gif' '3b' "$(tail -c 1 a.gif | od -An -tx1 | tr -d ' \n')"
    same 'the same picture' "$("$DOMINO" -e 'animate b.gif 2' && cksum <b.gif)" "$(cksum <a.gif)"
    # Where people read the file, it has the note.
    "$DOMINO" -e 'effect row 5; duration > a.txt; barrier > b.txt'
    for what in a b; do grep -q '^(This is the endless train' $what.txt; done
}

@test "the name of a picture is no name for another answer" {
    cd "$BATS_TEST_TMPDIR" || false
    echo draw >s.dom
    for what in rmax 'source s.dom' show help; do
        for name in a.svg a.PNG a.pdf; do
            wrong "$what > $name" "'$name' is the name of a picture, and '${what%% *}' draws none; 'draw' and 'plot' do"
            wrong "$what >> $name" "'$name' is the name of a picture"
        done
    done
    same 'nothing is left' s.dom "$(ls -I 'separate-stderr-*')"
}

@test "GNUTERM in the environment changes no picture" {
    local expected gif
    cd "$BATS_TEST_TMPDIR" || false
    energy() { "$DOMINO" -e 'plot energy > e.svg' && grep -v Produced e.svg; }
    expected=$(energy)
    "$DOMINO" -e "animate $BATS_TEST_TMPDIR/a.gif 1"
    gif=$(cksum <"$BATS_TEST_TMPDIR/a.gif")
    for GNUTERM in x11 dumb png 'svg enhanced' 'no such terminal' ''; do
        export GNUTERM
        same "GNUTERM=$GNUTERM" "$expected" "$(energy)"
        "$DOMINO" -e "animate $BATS_TEST_TMPDIR/a.gif 1"
        same "GNUTERM=$GNUTERM" "$gif" "$(cksum <"$BATS_TEST_TMPDIR/a.gif")"
    done
}

@test "^Z while gnuplot draws: the picture is finished, then the program stops" { answers_at_a_terminal suspend_drawing; }

# A gnuplot that keeps the script which it gets.
keep_scripts() {
    mkdir "$BATS_TEST_TMPDIR/bin"
    printf '#!/bin/sh\ntee "%s/script" | exec "%s" "$@"\n' "$BATS_TEST_TMPDIR" "$(command -v gnuplot)" \
        >"$BATS_TEST_TMPDIR/bin/gnuplot"
    chmod +x "$BATS_TEST_TMPDIR/bin/gnuplot"
    PATH=$BATS_TEST_TMPDIR/bin:$PATH
}

@test "animate: the number of the head stands on the head in every frame of every cycle" {
    keep_scripts
    local scene
    for scene in '' 'set r 1.1' 'set r 1.3; set q hollow; set d 0.05' 'set r 1.7'; do
        "$DOMINO" -e "$scene; animate $BATS_TEST_TMPDIR/a.gif"
        # A frame has one domino of the head's part, after the data of which its number comes: between its feet.
        awk '/^\$part2/ { heads++; n = 0; next } /^END/ { n = -1 } n >= 0 && NF == 2 { x[n++] = $1 }
            /^set label .0. at/ {
                labels++
                split($5, at, ",")
                if (!(at[1] < x[0] && at[1] > x[3])) outside++
            }
            END { if (heads < 26 || labels != heads || outside) { print heads, labels, outside + 0; exit 1 } }' \
            "$BATS_TEST_TMPDIR/script"
    done
}

# ---- Pipes ----

# A program that writes a command and waits for its answer: each of the table, and what replaces a line.
# The timeout is for the failure alone.
talk() { # READ-FROM WRITE-TO: descriptors
    local call line
    while IFS='|' read -r call _; do
        printf '%s\n' "${call##*; }" >&"$2"
        read -r -t 60 -u "$1" line || same "an answer of '${call##*; }'" something "$line"
        printf 'print 7\n' >&"$2"
        while [ "$line" != '{"command":"print","value":7,"unit":""}' ]; do
            read -r -t 60 -u "$1" line || same "what follows '${call##*; }'" 'print 7' "$line"
        done
    done <<<"$commands"
}

@test "a program that waits for each answer gets it: standard input" {
    coproc CALCULATOR { "$DOMINO"; }
    local in=${CALCULATOR[0]} out=${CALCULATOR[1]} process=$CALCULATOR_PID
    echo 'set output json; effect row 4; effect placement 5 mm' >&"$out"
    talk "$in" "$out"
    echo quit >&"$out"
    wait "$process"
}

@test "a program that waits for each answer gets it: a pipe with a name, by -f and by 'source'" {
    cd "$BATS_TEST_TMPDIR" || false
    mkfifo commands answers
    local by
    for by in '-f commands' '-e source\ commands'; do
        eval "'$DOMINO' $by >answers &"
        exec 6<answers 5>commands # in the order in which the program opens them
        echo 'set output json; effect row 4; effect placement 5 mm' >&5
        talk 6 5
        exec 5>&- 6<&-
        wait
    done
}

@test "answers are not sent one by one if no reader waits" {
    # dd counts what it is given at a time; a read takes one write or more of them.
    for way in stdin file; do
        printf 'print 12345\n%.0s' {1..20000} >"$BATS_TEST_TMPDIR/lines"
        [ $way = stdin ] && ask=("$DOMINO") || ask=("$DOMINO" -f "$BATS_TEST_TMPDIR/lines")
        "${ask[@]}" <"$BATS_TEST_TMPDIR/lines" | dd bs=1M of=/dev/null 2>"$BATS_TEST_TMPDIR/counted"
        same "$way: bytes" "$((20000 * 7 - 1))" "$(sed -n 's/ bytes.*//p' "$BATS_TEST_TMPDIR/counted")"
        awk -F + '/records in/ && $1 + $2 > 60 { print; exit 1 }' "$BATS_TEST_TMPDIR/counted"
    done
}

@test "what was not run is left to the program that reads on" {
    cd "$BATS_TEST_TMPDIR" || false
    printf 'print 1\nquit\nthe rest\n' >lines
    same 'quit' $'1\nthe rest' "$({ "$DOMINO"; cat; } <lines)"
    same '-f -' $'1\nthe rest' "$({ "$DOMINO" -f -; cat; } <lines)"
    printf 'print 1\nfoo\nthe rest\n' >lines
    same 'an error' $'1\nthe rest' "$({ "$DOMINO" --bail 2>/dev/null; cat; } <lines)"
}

# ---- Tables ----

# Every row of a table whose words are set to the left has a blank before each column, and something in the given ones.
columns_in_line() { # WHAT FILLED: keys; the table, its head first, on stdin
    awk -v what="$1" -v filled=" $2 " '
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = index(" " $0 " ", " " $i " ") }
        NR > 1 {
            rows++
            for (key in at) {
                before = at[key] > 1 ? substr($0, at[key] - 1, 1) : " "
                here = substr($0, at[key], 1)
                if (before != " " || (index(filled, " " key " ") && (here == " " || here == ""))) { print what ", " key ": " $0; bad = 1 }
            }
        }
        END { exit bad || rows == 0 }'
}

@test "show: every column begins where its head does, however long the values are" {
    for scene in '' 'set precision quad; set d 7/48; set digits 36; set seed 123456789' 'set h 1/3; set g 9.8123456789' \
        'set density 700; set output table'; do
        "$DOMINO" -e "${scene:+$scene > /dev/null; }show" | grep -v '^tol is now\|^$' |
            columns_in_line "show after '$scene'" 'name value range default meaning'
    done
    "$DOMINO" -e 'show density' | columns_in_line 'show density' 'name value unit range default meaning'
    "$DOMINO" -e 'help set' | sed -e '1,/^The parameters now/d' -e '/^$/,$d' | columns_in_line 'help set' 'name value range default meaning'
}

@test "effects: every column is in line, however long the settings are" {
    count=$("$DOMINO" -e 'set output csv; effects' | sed 1d | wc -l)
    for scene in 'effect row 5' 'effect row 5; effect placement 5 mm 0.012345; effect floor 0.123456789'; do
        # The heads of numbers end where the numbers do.
        "$DOMINO" -e "$scene; effects" | sed '/^Times are/,$d' | awk -v count="$count" '
            NR == 1 { for (i = 4; i <= NF; i++) end[i] = index($0 " ", " " $i " ") + length($i) }
            NR > 2 { for (i in end) if (substr($0, end[i], 1) == " " || substr($0 " ", end[i] + 1, 1) != " ") { print; bad = 1 } rows++ }
            END { exit bad || rows != count }'
    done
    # The method that each effect needs, and that of the scene, which the plan names too.
    methods() { "$DOMINO" -n -e "$1; effects; scene" | sed -nE 's/.* its effects, now ([a-z]*)\.$/\1/p; s/^motion .*(energy balance|equation of motion|rigid-body engine).*/\1/p' | paste -sd ',' -; }
    same balance 'balance,energy balance' "$(methods 'effect slope 1 deg')"
    same motion 'motion,equation of motion' "$(methods 'effect friction 0.1; effect row 3')"
    same engine 'engine,rigid-body engine' "$(methods 'effect row 2; effect push 9; effect feet 0.5')"
    same 'of each' 'motion balance balance balance balance balance balance balance engine engine' "$("$DOMINO" -e 'set output json; effects' | values method | paste -sd ' ' -)"
}

@test "few digits: a column is as wide as its head" {
    for what in 'sweep s 0.1 0.3 3 : rmax' 'sweep r 1.2 2.2 3 : count 112'; do
        "$DOMINO" -e "set digits 3; $what" | awk 'NR == 1 { wide = length($0) } /^ .*[0-9]/ { rows++; if (length($0) != wide) { print; bad = 1 } } END { exit bad || rows != 3 }'
    done
}

@test "help: on every page keys, units and meanings begin below each other" {
    local topic pages=0
    for topic in $("$DOMINO" -e 'complete help '); do
        "$DOMINO" -e "help $topic" | sed -n '/^It answers/,/^$\|^In an/{/^  /p}' >"$BATS_TEST_TMPDIR/page"
        [ -s "$BATS_TEST_TMPDIR/page" ] || continue
        pages=$((pages + 1))
        # The unit begins after the longest key, the meaning after the longest unit; rows without a unit have the meaning there.
        awk -v topic="$topic" '
            { if (length($1) > key) key = length($1) }
            NF > 1 { line[++n] = $0 }
            END {
                unit = 2 + (key > 12 ? key : 12) + 2
                for (k = 1; k <= n; k++)
                    if (substr(line[k], unit, 1) == " ") {
                        match(substr(line[k], unit), /[^ ]/)
                        if (meaning && RSTART != meaning) { print topic ": " line[k]; exit 1 }
                        meaning = RSTART
                    }
                meaning = meaning ? unit + meaning - 1 : unit + 7
                for (k = 1; k <= n; k++)
                    if (substr(line[k], unit - 1, 1) != " " || substr(line[k], meaning - 1, 1) != " " ||
                        (length(line[k]) >= meaning && substr(line[k], meaning, 1) == " ")) { print topic ": " line[k]; exit 1 }
            }' "$BATS_TEST_TMPDIR/page"
    done
    [ "$pages" -ge 30 ]
}

@test "help and apropos: every summary begins in one column" {
    "$DOMINO" -e help | sed '/^Parameters/,$d' | grep '^  ' >"$BATS_TEST_TMPDIR/list"
    "$DOMINO" -e 'apropos e' | sed 's/^/  /' >>"$BATS_TEST_TMPDIR/list"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/list")" -gt 80 ]
    same 'out of line' '(nothing)' "$(grep -vE '^  .{20} [^ ]' "$BATS_TEST_TMPDIR/list")"
    same 'no blank before it' '(nothing)' "$(grep -vE '^  .{20} ' "$BATS_TEST_TMPDIR/list")"
}

@test "help begins with ten lines to type, all of which work in this order" {
    "$DOMINO" -e help | sed -nE 's/^> (.{20}) [^ ].*$/\1/p' >"$BATS_TEST_TMPDIR/lines"
    same lines 10 "$(wc -l <"$BATS_TEST_TMPDIR/lines")"
    same 'the first' 'count 112 m' "$(sed -n '1s/ *$//p' "$BATS_TEST_TMPDIR/lines")"
    same 'the last' quit "$(sed -n '$s/ *$//p' "$BATS_TEST_TMPDIR/lines")"
    run --separate-stderr "$DOMINO" --bail - <"$BATS_TEST_TMPDIR/lines"
    same 'what went wrong' '(nothing)' "$stderr"
    for words in '20 dominoes' 1.64423 1.51445 '^   \[h\] ' '^    12 ' '^rmax \[S\]: '; do
        grep -q -- "$words" <<<"$output" || same 'the answers' "$words" "$output"
    done
}

@test "apropos finds what people say, first what is about it" {
    while read -r word wanted; do
        same "apropos $word" "$wanted" "$("$DOMINO" -e "apropos $word" | grep -oxE "$wanted( .*)?" | cut -c "-${#wanted}")"
    done <<'END'
quiz count
tower count
picture draw
image plot
spacing set s
feet slip
undo reset
script source
slope effect slope
probability placement
graph curve
movie animate
Domtoren count
solid set q
massive set q
sandpaper effect friction
speed duration
degrees set angle
END
    same 'first what is about it' 'effect slope' "$("$DOMINO" -e 'apropos slope' | sed -n '1s/ \{2,\}.*//p')"
    wrong 'apropos money' "^-e:1: apropos: nothing is about 'money'; try another word, such as"
    for word in picture gap; do expects "$word" "$("$DOMINO" -e "apropos $word")"; done
}

@test "a pipe is answered with what writes a file" {
    wrong 'rmax | head' "^-e:1:6: rmax: pipes are not supported; 'COMMAND > FILE' writes a file\$"
}

@test "q takes solid and its synonym, and only solid is offered" {
    same values '4 4 3' "$(for word in solid massive hollow; do "$DOMINO" -e "set q $word; print q"; done | paste -sd ' ' -)"
    same offered 'hollow solid' "$("$DOMINO" -e 'complete set q ' | paste -sd ' ' -)"
    same 'help q' 'hollow 3 solid 4' "$("$DOMINO" -e 'help q' | sed -n 's/^  \(hollow\|solid\|massive\) */\1 /p' | paste -sd ' ' -)"
}

# ---- Names ----

@test "an unknown name: what was meant, which there are, or where they are listed, never two of these" {
    while IFS='|' read -r line message; do
        run -1 "$DOMINO" --keep-going -e "$line"
        same "$line" "$message" "${output#-e:*: }"
    done <<'END'
foo|unknown command 'foo'; 'help' lists the commands
barier|unknown command 'barier'; did you mean 'barrier'?
ba|'ba' may be barrier, back
friction 0.2|'friction' is an effect; enter 'effect friction MU'
plot foo|plot: unknown picture 'foo'; use one of: fall, speed, gaps, placement, growth, marginal, sweep, energy, omega, inertia, chain, cost
plot enrgy|plot: unknown picture 'enrgy'; did you mean 'energy'?
plot c|plot: unknown picture 'c'; use one of: fall, speed, gaps, placement, growth, marginal, sweep, energy, omega, inertia, chain, cost
goto lanch|goto: unknown event 'lanch'; did you mean 'launch'?
set foo 1|set: unknown parameter 'foo'
END
}

@test "among the numbers of the model only q has words, and the help of tol is that of no other" {
    same q 3 "$("$DOMINO" -e 'set q hollow; print q')"
    for name in s r d tol h g mass; do
        wrong "set $name hollow" "^-e:1:[0-9]*: set: .*'hollow' has no value"
        same "help $name" '(nothing)' "$("$DOMINO" -e "help $name" | grep -E '^  (hollow|massive) ' || true)"
    done
    for name in s r d q h g; do [[ $("$DOMINO" -e "help $name") != *'The tolerance decides how'* ]]; done
    [[ $("$DOMINO" -e 'help tol') == *'The tolerance decides how'* ]]
}

# ---- Completion ----

@test "what completion offers after a word is no error there" {
    local line word refused=''
    same 'draw' 'at train forces' "$("$DOMINO" -e 'complete draw ' | paste -sd ' ' -)"
    same 'a lone answer is not written for s' '(nothing)' "$("$DOMINO" -e 'complete set s ')"
    same 'but for a beginning' best "$("$DOMINO" -e 'complete set s b')"
    same 'after a plain number' rate "$("$DOMINO" -e 'complete animate a.gif speed 2 r')"
    same 'plot cost' 'fuel launch barrier duration rmax pair' "$("$DOMINO" -e 'complete plot cost ' | paste -sd ' ' -)"
    same 'an abbreviation' 'rmax' "$("$DOMINO" -e 'complete plot co r')"
    for line in draw 'draw forces' 'draw 0.3' 'draw 0.3 forces' 'plot chain' 'plot energy' 'plot growth' \
        'plot gr' 'plot sweep' 'plot marginal' 'plot omega' 'cycle 3' 'effect friction' 'effect friction on' \
        'effect friction 0.2' 'effect row 5' 'set q' 'set output' 'set output csv' reset 'reset s' show; do
        for word in $("$DOMINO" -e "complete $line "); do
            run --separate-stderr "$DOMINO" -e "set output csv; set r 1.4; $line $word > /dev/null"
            case $stderr in
            *'too many'* | *'said twice'* | *'takes no name'* | *unknown* | *' is no '*) refused+=" '$line $word'" ;;
            esac
        done
    done
    same 'offered, then refused' '(nothing)' "$refused"
    for line in 'draw forces' 'draw 0.3 forces' 'plot growth paper' 'plot energy' 'plot energy r' 'reset s'; do
        same "complete $line" '(nothing)' "$("$DOMINO" -e "complete $line ")"
    done
}

# ---- Units for people ----

# The line of a key in an answer to people: its value, and its unit.
shown() { # KEY COMMANDS
    "$DOMINO" -e "$2" | awk -v key="$1" '$1 == key { print $2, $3 }'
}

@test "a table shows lengths in mm, cm or m as fits, masses in g or kg; csv and json keep m and kg" {
    local pair
    for pair in '9.99 mm|9.99 mm' '10 mm|1 cm' '4.8 cm|4.8 cm' '99.9 cm|99.9 cm' '1 m|1 m' '112 m|112 m' '0.001 mm|0.001 mm'; do
        same "${pair%|*}" "${pair#*|}" "$(shown height "count ${pair%|*}")"
    done
    same json '{"height":0.03,"first_height":0.01}' "$(json 'set h 1 cm; count 3 cm' | sed -E 's/("height":[^,]*),.*("first_height":[^,]*),.*/\1,\2}/')"
    same csv 0.048 "$("$DOMINO" -e 'set output csv; count 1 m' | tail -n 1 | cut -d , -f 5)"
    # One unit holds for a column of rows, that of the largest.
    same 'a row in tables' '4.8 0.7 0
7.2 1.05 2.88' "$("$DOMINO" -e 'effect row 2; row' | awk 'NR > 2 { print $2, $3, $4 }')"
    same 'a row for programs' '0.048,0.007,0
0.072,0.0105,0.0288' "$("$DOMINO" -e 'set output csv; effect row 2; row' | tail -n 2 | cut -d , -f 2-4)"
    same 'units of a sweep' 'cm m cm m' "$("$DOMINO" -e 'sweep h 1 cm 10 cm 2 : count 112' | sed -n 2p | xargs)"
    same 'of a longer one' 'm cm cm cm' "$("$DOMINO" -e 'sweep h 1 cm 1 m 2 : count 30 cm' | sed -n 2p | xargs)"
    same mass '10 g' "$("$DOMINO" -e 'set mass 0.01; effect row 1; row' | awk 'NR == 2 { unit = $4 } NR == 3 { print $5, unit }')"
    # An expression has the base unit, whatever a table shows.
    same 'ans' 0.048 "$(json 'count 1 m; print ans.first_height' | tail -n 1 | values value)"
    # All digits are right in every unit.
    same digits '4.8 cm' "$(shown first_height 'set digits 33; set precision quad; count 1 m')"
}
