#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Solve and sensitivity.

load ../shell/common

# The lines below have a parameter, 'less' or 'more' by 1 %, and the change of r_max in percent.
@test "sensitivity: known changes of r_max, the largest first" {
    json 'effect friction 0.2; sensitivity rmax' >answers
    same order 'edges slope q d friction s g h r width' "$(values parameter <answers | paste -sd ' ')"
    while read -r parameter key percent; do
        close "$parameter" "$percent" "$(grep "\"$parameter\"" answers | values "$key" | awk '{ print 100 * $1 }')" 2e-3
    done <<'END'
s more 0.1953
d more -0.3387
friction more -0.2762
q less 0.4894
END
    same none 0 "$(grep '"g"' answers | values more)"
    run -0 "$DOMINO" -e 'effect friction 0.2; sensitivity rmax'
    same 'people: none' 'rmax does not depend on g, h, r, width.' "${lines[-1]}"
    grep -qE '^q +4 +1 % +0\.489 +-0\.477$' <<<"$output"
}

# bats test_tags=rows
@test "sensitivity accepts a key, arguments or an expression, and does not change the session" {
    close key -1 "$(json 'sensitivity duration.tau' | grep '"h"' | values less | awk '{ print 200 * $1 }')" 6e-3
    differ arguments "$(json 'sensitivity rmax 0.3' | grep '"d"' | values more)" "$(json 'sensitivity rmax' | grep '"d"' | values more)"
    same 's is given' 0 "$(json 'sensitivity rmax 0.3' | grep '"s"' | values more)"
    close power 10.4622 "$(json 'sensitivity h*r^10' | grep '"r"' | values more | awk '{ print 100 * $1 }')" 1e-5
    same stays '0.4 0.048' "$(json 'sensitivity rmax; print s; print h' | values value | tail -n 2 | paste -sd ' ')"
    same row 0 "$(json 'effect row 5; sensitivity design.length 2 m; verdict' | values short_by)"
    wrong 'sensitivity fall' "'fall' gives several numbers; use one of fall.domino"
    wrong 'sensitivity barrier.verdict' 'barrier.verdict is a word'
    wrong 'solve s : thetac.detaches = 1' "thetac.detaches is 'yes' or 'no', not a number"
    wrong 'set r 3; sensitivity duration' 'r s = 1\.2 > 1'
}

@test "solve: finds all values with their branches, and each is a solution" {
    while IFS='|' read -r scene parameter answer value expected; do
        found=$(json "$scene; solve $parameter : $answer = $value")
        same "$parameter $answer" "$expected" "$(values value <<<"$found" | while read -r x; do printf '%.5f ' "$x"; done)$(
            values branch <<<"$found" | paste -sd ' ')"
        for x in $(values value <<<"$found"); do
            put="set $parameter $x"
            [ "$parameter" != friction ] || put="effect friction $x"
            close "$parameter $answer at $x" "$(json "$scene; print $value" | values value)" \
                "$(json "$scene; $put; print $answer" | values value)" 1e-9
        done
    done <<'END'
set r 1.5|d|rmax|5/3|0.14040 falling
set r 1.5|s|rmax|1.6|0.36497 0.62500 rising falling
set q hollow|friction|rmax|1.7|0.35540 falling
set r 1.2|h|duration.speed|1 m/s|0.26745 rising
set r 1.2|s|thetac.theta_c|30 deg|0.41667 rising
END
    same 'a range' '0.14040' "$(json 'solve d 0.1 0.3 : rmax = 5/3' | values value | xargs printf %.5f)"
    same 'beside the range' 'none' "$(json 'solve d 0.2 0.3 : rmax = 5/3' | values branch)"
}

@test "solve: a value that is reached only between two samples, and one that is just not reached" {
    best=$(json 'best' | values r_max)
    same 'just below' 2 "$(json "solve s : rmax = $best - 1e-7" | grep -c branch)"
    same 'just above' none "$(json "solve s : rmax = $best + 1e-7" | values branch)"
}

# bats test_tags=rows
@test "solve: finds where a verdict changes" {
    limit=$(json 'solve friction : barrier' | values value)
    same below 'goes on' "$(json "effect friction $limit*0.999999; barrier" | values verdict)"
    same above stops "$(json "effect friction $limit*1.000001; barrier" | values verdict)"
    limit=$(json 'set q hollow; set r 5/3; effect row 11; solve friction : verdict' | values value)
    same 'row below' 'all fall' "$(json "set q hollow; set r 5/3; effect row 11; effect friction $limit*0.999999; verdict" | values verdict)"
    same 'row above' stops "$(json "set q hollow; set r 5/3; effect row 11; effect friction $limit*1.000001; verdict" | values verdict)"
    run -0 "$DOMINO" -e 'set r 1.2; solve friction 0 0.2 : barrier'
    same always 'barrier: the train keeps falling for every friction = 0 .. 0.2.' "$output"
}

@test "solve: no solution is an answer with a reason, and an error is one line" {
    run -0 "$DOMINO" -e 'solve d : rmax = 5'
    same largest 'rmax is never 5 for d = 0.01 .. 1: the largest value is 2.5, at d = 0.01.' "$output"
    says 'solve s 0.3 0.5 : rmax = 1.1' 'rmax is never 1.1 for s = 0.3 .. 0.5: the smallest value is 1.5'
    same csv 'value,answer,branch,reason' "$("$DOMINO" -e 'set output csv; solve d : rmax = 5' | head -n 1)"
    [[ $("$DOMINO" -e 'set d 0.207; solve r : count(5 m) = 96.7') == 'count(5 m) is never 96.7 for r = 1 .. 4: it jumps over this value at r = 1.049'* ]]
    wrong 'solve g : rmax = 1.5' "rmax does not change: it is 1.64.* everywhere in g = .*'sensitivity' shows"
    wrong 'solve h : duration.speed = 1 m' 'duration.speed is in m s\^-1, but VALUE is a length'
    wrong 'solve d 0.3 0.2 : rmax = 1.5' 'FROM must be less than TO'
    wrong 'solve d 0.3 : rmax = 1.5' 'TO is missing; enter, for example,'
    wrong 'solve d : rmax' "'= VALUE' is missing after 'rmax'"
    wrong 'solve d' "':' and an answer are missing"
    wrong 'solve d : rmax = ' 'VALUE: a value is missing'
    wrong 'solve d -1 1 : rmax = 5/3' 'd = -1 is out of range'
}

@test "solve: a root at an end of the range is found once" {
    for s in 0.1 0.9; do
        json "solve s 0.1 0.9 : s = $s" >answer
        same "$s: one" 1 "$(wc -l <answer)"
        close "$s" "$s" "$(values value <answer)" 1e-9
        same "$s: rises" rising "$(values branch <answer)"
    done
}

# bats test_tags=rows
@test "solve: no value of the range makes a verdict true" {
    same push 'verdict: for no push = 0 .. 30 rad/s is it true that all dominoes fall.' \
        "$("$DOMINO" -e 'set s 0.2; set row 12; solve push : verdict')"
}
