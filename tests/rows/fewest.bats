#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The gap and the growth that need the fewest dominoes: count H fewest.

load ../shell/common

# Prints the values of keys in the row of KIND and START.
row() { # SCENE HEIGHT KIND START KEY...
    local line key
    line=$(json "$1; count $2 fewest" | grep "\"kind\":\"$3\",\"start\":\"$4\"")
    for key in "${@:5}"; do values "$key" <<<"$line"; done | paste -sd ' ' -
}

# bats test_tags=sums,landmarks
@test "count 112 m fewest: the quiz with the best gap, in a table, two sentences and details" {
    same 'the table' "kind     start          dominoes             r             s
                                                           h
solid    tips over            14          1.75          0.55
solid    moving               14          1.75          0.55
hollow   tips over            10       2.17169        0.4442
hollow   moving               10         2.172         0.443
These are the fewest dominoes that topple one that is 112 m tall. From its start, each row was run with exactly this growth r and gap s, and falls; 'count 112 m 1.75 with s 0.55' explains one." \
        "$("$DOMINO" -e 'count 112 m fewest')"
    for way in 'fewest 112 m' 'fewest domtoren' 'count domtoren fewest' 'count dom tower fewest'; do
        same "$way" "$(csv 'count 112 m fewest')" "$(csv "$way")"
    done
    same 'the columns' 'kind,start,dominoes,r,s,gap,last,reach,reason' "$(csv 'count 112 m fewest' | head -n 1)"
    "$DOMINO" -e 'count 112 m fewest details' | grep -qE '^hollow +tips over .* 4\.63[0-9]* +51\.5729 +112$'
    # gap and heights are those of the row
    scene='set r 2.17169; set s 0.4442; set q hollow; set row 11'
    read -r gap last reach <<<"$(row reset '112 m' hollow 'tips over' gap last reach)"
    close 'gap' "$(json "$scene; row 2" | values gap)" "$gap"
    close 'last' "$(json "$scene; print max(if(row.domino < 11, row.height, 0 m))" | values value)" "$last"
    close 'reach' "$(json "$scene; print max(row.height)" | values value)" "$reach"
    # the sentence shows a command that runs the row
    same 'the row' 14 "$(json 'count 112 m 1.75 with s 0.55' | values dominoes)"
    same 'the row falls' true "$(json 'count 112 m 1.75 with s 0.55' | values feasible)"
    same 'in an expression' 10 "$(json 'print min(fewest(112 m).dominoes)' | values value)"
}

@test "the growth and the gap that are printed reach the height, and such a row falls" {
    while IFS='|' read -r scene height; do
        answer=$(json "$scene; count $height fewest")
        [ "$(grep -c '"dominoes":[0-9]' <<<"$answer")" -ge 2 ] || same "$scene" 'rows' "$answer"
        while read -r line; do
            n=$(values dominoes <<<"$line") r=$(values r <<<"$line") s=$(values s <<<"$line")
            q=$(values kind <<<"$line")
            scene_of="$scene; set q ${q#q = }; set r $r; set s $s"
            same "$scene: $line" "$n" "$(json "$scene_of; count $height" | values dominoes | tail -n 1)"
            if [ "$(values start <<<"$line")" = moving ]; then
                same "$scene: $line" true "$(json "$scene_of; count $height" | values goes_on | tail -n 1)"
            else
                same "$scene: $line" 'all fall' "$(json "$scene_of; set row $((n + 1)); verdict" | values verdict | tail -n 1)"
            fi
        done < <(grep '"dominoes":[0-9]' <<<"$answer")
    done <<'END'
reset|112 m
reset|7 cm
set d 0.01|112 m
set d 0.3; set friction 0.2|3 m
set edges 0.05|2 m
set push 20 rad/s; set slope 3 deg|20 m
set q 3.5; set slope -2 deg|20 m
set release 20 deg|20 m
set release touch|20 m
set walls 1 mm|112 m
set h 1 cm; set density 700 kg/m^3; set air 1.2|8 m
END
}

# bats test_tags=sweeps
@test "no smaller number of dominoes falls at any gap or growth of a grid" {
    # Every growth with which fewer dominoes would reach the height, at 60 gaps each, run as a row.
    while IFS='|' read -r scene height ratio; do
        for q in solid hollow; do
            n=$(row "$scene" "$height" "$q" 'tips over' dominoes)
            [ "$n" -ge 2 ] || same "$scene, $q" 'a number' "$n"
            for ((k = n; k >= 1 && k >= n - 2; k--)); do
                least=$(awk -v x="$ratio" -v k="$k" 'BEGIN { printf "%.12g", exp(log(x) / k) * (1 + 1e-11) }')
                verdicts=$(json "$scene; set q $q; set row $((k + 1)); sweep r $least $(awk -v r="$least" 'BEGIN { print 1.4 * r }') 5 s 0.01 0.9 60 : verdict" |
                    values verdict)
                [ "$(grep -c . <<<"$verdicts")" -eq 300 ] || same "$scene, $q, $k" '300 rows' "$verdicts"
                falls=$(grep -c 'all fall' <<<"$verdicts") || true
                [ "$((falls > 0))" -eq "$((k == n))" ] || same "$scene, $q: $k dominoes, the fewest are $n" "$((k == n))" "$falls"
            done
        done
    done <<'END'
set h 0.1|1 m|10
set h 0.1|0.3 m|3
set h 0.1; set d 0.05|10 m|100
set h 0.1; set d 0.3|0.5 m|5
set h 0.1; set friction 0.3|1 m|10
END
}

@test "where no such row exists, and what is wrong, is said in one line" {
    grep -q '"dominoes":null.*"reason":"no such train keeps falling, whatever its gaps and its growth"' <<<"$(json 'set d 1.5; count 112 m fewest')"
    [[ $("$DOMINO" -e 'set d 1.5; count 112 m fewest') == *'no such row starts by itself, whatever its gaps and its growth'* ]]
    [[ $("$DOMINO" -e 'set push 1 rad/s; count 2 m fewest') == *'no such row falls from this start'* ]]
    same 'too low' 'No other domino is needed: the first is already 4.8 cm tall.' "$("$DOMINO" -e 'count 1 cm fewest')"
    all_wrong <<'END'
20|count 112 m fewest 3|'3' is one argument too many; usage: fewest H
15|count 112 m 2 fewest|'fewest' is one argument too many; usage: count H .R.
7|count 2 kg fewest|H is a length, not a mass
7|print fewest(2 m)|'fewest' has no value
0|set slope 20 deg; count 112 m fewest|no domino can stand upright on a slope of 20 deg
0|set air 1; count 112 m fewest|needs the mass of the dominoes
END
    # absurd heights do not lead to absurd rows
    [ "$(row reset '1e300 m' solid 'tips over' dominoes)" -gt 1000 ]
}

# bats test_tags=engine
@test "with the rigid-body engine, only the moving train has an answer" {
    grep -q '"start":"tips over","dominoes":null.*"reason":"the rigid-body engine would take too long' <<<"$(json 'set bounce 0.3; count 112 m fewest')"
    same 'moving' 14 "$(row 'set bounce 0.3' '112 m' solid moving dominoes)"
}
