#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# maximize and minimize.

load ../shell/common

# The digits that 'within' promises are right: |EXPECTED - OBTAINED| <= WITHIN, and WITHIN is small.
promised() { # WHAT EXPECTED OBTAINED WITHIN
    expects "$1" "$2" || return
    [[ $3 =~ [0-9] && $4 =~ [0-9] ]] && awk -v e="$2" -v o="$3" -v w="$4" \
        'BEGIN { d = e - o; exit !((d < 0 ? -d : d) <= w + 1e-15 && w < 2e-4) }' ||
        { printf '%s\nexpected: %s\nobtained: %s\nwithin: %s\n' "$1" "$2" "$3" "$4" && false; }
}

# The last two lines have two maxima, of which the larger one in the range is found.
@test "one parameter: maxima and minima in closed form" {
    while IFS='|' read -r line place value; do
        best=$(json "$line")
        promised "place of $line" "$(awk "BEGIN { printf \"%.17g\", $place }")" "$(values value <<<"$best")" "$(values within <<<"$best")"
        promised "value of $line" "$(awk "BEGIN { printf \"%.17g\", $value }")" "$(values answer <<<"$best")" "$(values answer_within <<<"$best")"
        same "end of $line" inside "$(values end <<<"$best")"
    done <<'END'
maximize s : s*(1-s)|0.5|0.25
minimize s : s + 0.09/s|0.3|0.6
maximize r : r^(1/r)|exp(1)|exp(exp(-1))
minimize s 0.1 to 0.9 : (s-1/3)^2|1/3|0
maximize s from 0.1 to 0.9 : sin(3*s)|atan2(1,0)/3|1
maximize s 0.02 1 : -(s-0.3)^2*(s-0.7)^2 + s/100|0.725971945688398|0.00713732240219101
maximize s 0.02 0.36 : -(s-0.3)^2*(s-0.7)^2 + s/100|0.345752546070536|0.0031948351772779
END
}

@test "one parameter: a dense grid has nothing better, and its best point is a neighbour" {
    while IFS='|' read -r what from to answer sign; do
        best=$(json "$what s $from $to : $answer")
        csv "sweep s $from $to 8001 : $answer" | awk -F, -v x="$(values value <<<"$best")" \
            -v y="$(values answer <<<"$best")" -v sign="$sign" -v step="$(awk "BEGIN { print ($to - $from) / 8000 }")" '
            NR > 1 && $2 != "" { count++; if (count == 1 || sign * $2 > top) { top = sign * $2; at = $1 } }
            END { print count, top, at, x, y
                exit !(count > 100 && sign * y >= top - 1e-11 && sign * y - top < 1e-3 * (y < 0 ? -y : y) && x - at <= step && at - x <= step) }'
    done <<'END'
maximize|0.1|0.66|duration.speed|1
minimize|0.3|0.66|duration.tau*duration.seconds|-1
maximize|0.02|0.9|rmax|1
minimize|0.02|0.6|barrier.margin|-1
END
    same best "$(json best | values s | cut -c 1-8)" "$(json 'maximize s : rmax' | values value | cut -c 1-8)"
}

# The first two of the points that are tried are nearly equally high, and the maximum lies between them.
@test "a smooth maximum near an end of the range is no plateau" {
    local scene='set h 5 cm; set d 8 mm; set r 1' place
    place=$(csv "$scene; sweep s 0.02 0.021 1001 : duration.speed" | awk -F, 'NR > 1 && $2 > top { top = $2; at = $1 } END { print at }')
    while IFS='|' read -r line expected; do
        best=$(json "$line")
        same "$line: low and high" "$(values value <<<"$best") $(values value <<<"$best")" "$(values low <<<"$best") $(values high <<<"$best")"
        within "$line" "$expected" "$(values value <<<"$best")" 'd < 3e-5 && d > -3e-5'
        same "$line: end" inside "$(values end <<<"$best")"
    done <<END
$scene; maximize s : duration.speed|$place
$scene; minimize s 0.02 1 : 1/duration.speed|$place
maximize s 0.02 1 : -(s-0.0204)^2|0.0204
maximize s 0.02 0.8 : -(s-0.7996)^2|0.7996
maximize s 0.02 1 : -abs(s-0.0202)|0.0202
END
    best=$(json 'set r 1; set d 0.16; maximize s 0.0201 1 : duration.speed')
    within 'another thickness' 0.0204 "$(values value <<<"$best")" 'd < 1e-4 && d > -1e-4'
    run -0 "$DOMINO" -e "$scene; maximize s : duration.speed"
    same say 'duration.speed is largest, 2.09617 m/s, at s = 0.0204 (1.02 mm).' "$output"
}

# The sum is cut off where the rest no longer matters, so that it falls in steps, of which the first are tiny.
# bats test_tags=sums
@test "a step below the best values ends the range of the maximum" {
    says 'maximize s 0.02 0.6 : sum(chain(0).weight)' 'sum(chain(0).weight) is largest, 1.24615, for every s from 0.02 '
}

# With growth r, ln(20 m/h) / ln r dominoes are needed, rounded up.
@test "a plateau: all places with the best number, which is a whole one" {
    best=$(json 'minimize r 1.2 1.45 : count(20 m)')
    close dominoes 17 "$(values answer <<<"$best")"
    close low "$(awk 'BEGIN { printf "%.12f", exp(log(20/0.048)/17) }')" "$(values low <<<"$best")" 1e-7
    close high 1.45 "$(values high <<<"$best")"
    run -0 "$DOMINO" -e 'minimize r 1.2 1.45 : count(20 m)'
    same people 'count(20 m) is smallest, 17, for every r from 1.426 to 1.45.' "$output"
    for r in 1.426 1.45; do
        same "at $r" 17 "$(json "set r $r; count 20 m" | values dominoes)"
    done
}

@test "rows of 'count' fall where it is smallest, and do not just beyond" {
    best=$(json 'minimize r : count(112 m)')
    high=$(values high <<<"$best")
    close exhaustive "$(csv 'sweep r 1.2 2 201 : count 112 m' | awk -F, '
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
        NR > 1 && $column["feasible"] == "true" && (!n || $column["dominoes"] < n) { n = $column["dominoes"] } END { print n }')" \
        "$(values answer <<<"$best")"
    same inside true "$(json "set r $high-1e-6; count 112 m" | values feasible)"
    same beyond false "$(json "set r $high+1e-6; count 112 m" | values feasible)"
    same end hole "$(values end <<<"$best")"
    says 'minimize r : count(112 m)' "For a larger r it has no answer: the verdict of 'count' is no: "
    same 'print still answers there' 10 "$(json 'set r 2.2; print count(112 m)' | values value)"
}

@test "edges of a hole, the ends of a range, and two equal maxima" {
    while IFS='|' read -r line place value end; do
        best=$(json "$line")
        close "place of $line" "$place" "$(values value <<<"$best")" 1e-9
        close "value of $line" "$value" "$(values answer <<<"$best")" 1e-5
        same "end of $line" "$end" "$(values end <<<"$best")"
    done <<'END'
maximize s 0.02 0.45 : s - 10*sqrt((s-0.4)^2-0.01)|0.3|0.3|hole
maximize s : s - 10*sqrt((s-0.4)^2-0.01)|0.5|0.5|hole
minimize s : s + 10*sqrt((s-0.4)^2-0.01)|0.3|0.3|hole
maximize s 0.1 0.8 : s^2|0.8|0.64|to
maximize s 0.1 0.8 : 1/s|0.1|10|from
maximize s : fuel|0.66666666666667|0.854166666667|hole
END
    run -0 "$DOMINO" -e 'minimize s : (s-0.3)^2*(s-0.7)^2'
    grep -qE ' is smallest, 0, at s = 0\.[37] ' <<<"$output"
    run -0 "$DOMINO" -e 'maximize s 0.1 0.8 : s^2'
    same end 's^2 is largest, 0.64, at s = 0.8 (3.84 cm), the largest value that was tried.' "$output"
}

@test "two parameters: maxima on a slanting ridge, at bounds and at edges" {
    while IFS='|' read -r line s r value; do
        best=$(json "$line")
        same "names of $line" 's r' "$(values parameter <<<"$best" | paste -sd ' ')"
        promised "s of $line" "$s" "$(values value <<<"$best" | head -n 1)" "$(values within <<<"$best" | head -n 1)"
        promised "r of $line" "$r" "$(values value <<<"$best" | tail -n 1)" "$(values within <<<"$best" | tail -n 1)"
        close "value of $line" "$value" "$(values answer <<<"$best" | head -n 1)" 1e-10
    done <<'END'
maximize s, r 1 2 : 3-(s-0.3)^2-(r-1.3)^2-(s-0.3)*(r-1.3)|0.3|1.3|3
minimize s, r 1 2 : 1+100*(r-1-s^2)^2+(s-0.6)^2|0.6|1.36|1
maximize s 0.1 0.8, r 1 2 : s*(3-r)|0.8|1|1.6
maximize s 0.1 1, r 1 2 : s/3+r+0*sqrt(2.5-s^2-r^2)|0.5|1.5|1.66666666667
END
}

# A train keeps falling up to r_max(s), so its largest growth over all gaps is what 'best' finds.
@test "two parameters: the largest growth with an answer is that of 'best'" {
    best=$(json 'maximize s, r : r + 0*duration')
    close growth "$(json best | values r_max)" "$(values answer <<<"$best" | head -n 1)" 1e-6
    within gap "$(json best | values s)" "$(values value <<<"$best" | head -n 1)" 'd < 0.01 && d > -0.01'
    same end 'inside hole' "$(values end <<<"$best" | paste -sd ' ')"
}

@test "the answer depends neither on the number of threads nor on what was set before" {
    line='maximize s 0.3 0.6, r 1.2 1.6 : duration.speed'
    same threads "$(json "set threads 1; $line")" "$(json "set threads 4; $line")"
    same 'the session keeps its parameters' '0.4 1.5' "$(json "$line; print s; print r" | values value | tail -n 2 | paste -sd ' ')"
}

# bats test_tags=rows
@test "a parameter that is a whole number" {
    best=$(json 'set r 1.1; minimize row 5 40 : abs(verdict.seconds - 2 s)')
    close row "$(csv 'set r 1.1; sweep row 5 40 36 : verdict.seconds' | awk -F, '
        NR > 1 { off = $2 > 2 ? $2 - 2 : 2 - $2; if (NR == 2 || off < least) { least = off; at = $1 } } END { print at }')" \
        "$(values value <<<"$best")"
    wrong 'minimize row : verdict' 'row needs a range'
}

@test "no optimum, and errors in the line" {
    wrong 'maximize s : 3' '3 does not change: it is 3 everywhere in s = 0.02 .. 1'
    wrong 'maximize s 0.2 0.3 : sqrt(s-1)' 'has no answer for any s = 0.2 .. 0.3: .*sqrt of a negative'
    wrong 'maximize s, s : rmax' "'s' is named twice"
    wrong 'maximize s, r, d : rmax' 'at most 2 parameters'
    wrong 'maximize s' "':' and an answer are missing; enter, for example, 'maximize s : duration.speed'"
    wrong 'maximize s 0.3 0.1 : rmax' 'FROM must be less than TO'
    wrong 'maximize s : cycle' "'cycle' gives several numbers"
    wrong 'maximize s : s + duration.seconds' 'a plain number and a time cannot be added'
    wrong 'maximize s : barrier.verdict' 'is a word, not a number'
    run -0 "$DOMINO" -e 'maximize s : duration.speed details'
    grep -qE '^The first of the [0-9]+ values of s without an answer: ' <<<"$output"
}
