#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Sheet: a page for a class that times a row, and a page with the answers.

load ../shell/common

block='set h 44 mm; set d 7 mm; set r 1; set s 20 mm; set push 5; '

# How long a row of equal blocks without friction takes to fall, by plain sums of energies.
seconds() { awk -v n="$1" -v h=0.044 -v d=0.007 -v gap="$2" -v push=5 -f "$BATS_TEST_DIRNAME/../fit/row.awk" | tail -n 1; }

@test "the times to expect are those of plain sums of energies" {
    "$DOMINO" -e "$block set row 28; sheet" >sheet
    for row in '28 0.02' '28 0.012' '28 0.028' '56 0.02'; do
        read -r n gap <<<"$row"
        line="$n dominoes of 44 mm with gaps of $(awk "BEGIN { print 1000*$gap }") mm: $(seconds "$n" "$gap" | awk '{ printf "%.2f", $1 }') s"
        grep -qxF "$line" sheet || same 'a time' "$line" "$(grep 'with gaps of' sheet)"
        close "$row" "$(seconds "$n" "$gap")" "$(json "$block set row 28; sheet" | jq "select(.dominoes == $n and .gap > $gap - 1e-9 and .gap < $gap + 1e-9).seconds")" 1e-6
    done
    # The row is 28*7 mm + 27*20 mm long.
    grep -qF "1. 736 mm / $(seconds 28 0.02 | awk '{ t = sprintf("%.2f", $1); printf "%s s = %.3g", t, 736/t }') mm/s." sheet || same 'the speed' '736 mm / ...' "$(grep '736 mm' sheet)"
    for words in 'Name ____' 'From the' 'it is 27 mm' 'Push domino 1 so that its top moves at 0.22 m/s.' "'fit friction class.csv'" 'gap (mm), dominoes, time (s)' 'There is no friction.'; do
        tr '\n' ' ' <sheet | grep -qF "$words" || same 'the sheet' "$words" "$(cat sheet)"
    done
}

@test "what a class types from its sheet is what 'fit' reads" {
    # The first line is that of the sheet; the times are those of the sheet, so the push is that of the sheet.
    "$DOMINO" -e "$block set row 28; sheet" | tr '\n' ' ' | grep -o 'gap (mm), dominoes, time (s)' >class.csv
    json "$block set row 28; sheet" | jq -r 'select(.dominoes) | "\(1000*.gap), \(.dominoes), \(.seconds)"' >>class.csv
    same 'lines' 5 "$(wc -l <class.csv)"
    close push 5 "$(json "$block set push 4; fit push class.csv" | values push | head -n 1)" 1e-4
}

@test "the units of the session, and what the scene has" {
    # How the class starts the row, and the clock: a tipped domino, a release, a lean, and a push from a tilt.
    while IFS='|' read -r scene words; do
        "$DOMINO" -e "set r 1; $scene; sheet" | tr '\n' ' ' >sheet
        while IFS= read -r -d '|' part; do
            grep -qF "$part" sheet || same "$scene" "$part" "$(cat sheet)"
        done <<<"$words|"
    done <<'END'
set h 2 in; set d 0.3 in; set s 0.75 in; set friction 0.2; set slope 2 deg; set walls 0.05 in; set row 28|28 dominoes, each 2 in tall and 0.3 in thick, with gaps of 0.75 in|The floor slopes down in the direction of the fall, by 2 degrees|Tip domino 1 until it falls by itself. Start the clock at the first hit|gap (in)|in/s|from the first hit|Slower: friction
set h 44 mm; set d 7 mm; set s 20 mm; set release 20 deg; set row 9|Hold domino 1 at 20 deg and let it go. Start the clock at the release|The clock runs from the release
set h 5 cm; set d 8 mm; set s 20 mm; set row 6; set release touch|Lean domino 1 against domino 2 and let it go. Start the clock at the release
set h 44 mm; set d 7 mm; set s 20 mm; set release 12 deg; set push 2; set row 9|Hold domino 1 at 12 deg and push it. Start the clock at the release
END
}

@test "what is computed from times agrees with the times on the paper" {
    for row in 'set h 5 cm; set d 8 mm; set s 20 mm; set row 30; set push 3' 'set h 5 cm; set d 8 mm; set s 20 mm; set row 20; set push 3' \
        'set h 44 mm; set d 7 mm; set s 15 mm; set row 9; set push 4' 'set h 1 cm; set d 1 mm; set s 4 mm; set row 2; set push 20'; do
        "$DOMINO" -e "set r 1; $row; sheet" >sheet
        read -r length unit _ time _ _ speed _ <<<"$(sed -n 's/^1\. \([0-9.]* [a-z]* \/ .*\/s\)\.$/\1/p' sheet)"
        same "$row: $length $unit / $time s" "$(awk "BEGIN { v = $length/$time; printf v < 100 ? \"%.3g\" : \"%.0f\", v }")" "$speed"
        # The list has the same time, first for the row of the session.
        same "$row: the list" "$time" "$(sed -n 's/.* with gaps of .*: \([0-9.]*\) s$/\1/p' sheet | head -n 1)"
        twice=$(sed -n 's/.* It takes \([0-9.]*\) times as long.*/\1/p' sheet)
        [ -z "$twice" ] || same "$row: twice as many" \
            "$(sed -n 's/.* with gaps of .*: \([0-9.]*\) s$/\1/p' sheet | awk 'NR == 1 { first = $1 } END { printf "%.2f", $1/first }')" "$twice"
    done
}

@test "a scene without a row that falls gets one line" {
    wrong "$block sheet" "a sheet needs a row; first enter, for example, 'set r 1; set s 20 mm; set push 3; set row 28'"
    for row in 'set row 1' 'set row 10; change 3 thickness 9 mm' 'set r 1.1; set row 10' "set row $root/examples/measured/tape.csv"; do
        wrong "$block $row; sheet" "a sheet needs a row of at least two dominoes, all equal, with equal gaps; 'plan' describes other rows"
    done
    wrong "$block set row 9; set push 1; sheet" 'the row does not fall to its end, so nobody can time it: the fall ends at domino 1 of 9'
    wrong "$block set row 9; sheet > class.png" "a sheet has two pages, which a picture such as 'class.png' cannot have; use .pdf, .gp or .txt"
    wrong "$block set row 9; sheet > class.gif" "class.gif"
    # Gaps at which the row would not fall are left out.
    "$DOMINO" -e "$block set s 44 mm; set row 9; sheet" >sheet
    run ! grep -q 'gaps of 62 mm' sheet
    grep -q 'gaps of 44 mm: ' sheet
}

@test "a sheet for the printer has two pages, with all that the text says" {
    command -v pdftotext >/dev/null || skip 'no pdftotext'
    "$DOMINO" -e "$block set row 28; sheet > class.pdf; sheet > class.txt; sheet > class.gp"
    pdftotext -layout class.pdf pages
    same pages 2 "$(tr -cd '\f' <pages | wc -c)"
    same 'pages of text' 1 "$(tr -cd '\f' <class.txt | wc -c)"
    squeeze() { tr -s ' \n' '\n'; }
    sed '1,/^\f*Set up/d; s/______*//g' class.txt | squeeze | sed 's/\f//; /^$/d' | sort -u >words
    same 'words that the printer lacks' '(nothing)' "$(squeeze <pages | sed 's/\f//; s/______*//g' | sort -u | comm -23 words -)"
    "$DOMINO" -e "$block set row 3000; sheet > long.pdf"
    same 'a long row' 2 "$(pdftotext long.pdf - | tr -cd '\f' | wc -c)"
}
