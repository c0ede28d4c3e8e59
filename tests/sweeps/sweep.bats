#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Sweeps on any number of threads, and the scripts for clusters.

load ../shell/common

# Workers share data that the first of them makes: functions, rows, the engine, leans, studies, designs.
# bats test_tags=rows,chance,engine,planning,errors
@test "the output is the same on any number of threads, in csv, json and tables" {
    cat >sweeps <<'END'
sweep s 0.1 0.9 81 d 0.05 0.3 6 : rmax
sweep s 0.02 0.98 200 : barrier
sweep s 0.1 0.9 30 : count 112 0.9*rmax
sweep s 0.1 0.9 30 : theta1 40 deg
sweep s 0.1 0.9 9 : chain 0.05
sweep r 1.2 2.4 13 : cycle 4
sweep friction 0 0.4 5 s 0.2 0.4 3 : duration
sweep row 3 9 3 push 5, 6.5 : fall
sweep fuel exact, paper s 0.1 0.4 3 : fuel
sweep precision float, double, quad : rmax
set mass 1; sweep s 0.4, 0.9, 0.1 : step 3
set errors on; sweep s 0.9 0.3 13 : barrier
set angle deg; sweep r 1.2 2 5 : thetac
curve 0.02 0.9 100
let f(x) = rmax(x)*x; sweep s 0.1 0.9 8 : f(s)+pair(s)
set friction 0.2; set row 4; sweep r 1 1.4 5 : verdict; tolerance
set row 4; set feet 0.5; sweep s 0.2 0.5 4 : verdict; set placement 2 mm; placement 8
set row 4; set edges 0.01; sweep s 0.2 0.5 4 : rowmax
set q hollow; sweep s 0.3 0.5 3 : design 1 m
END
    for threads in 1 2 3 4 0; do
        while IFS= read -r line; do
            for format in csv json table; do echo "reset; set threads $threads; set output $format; $line"; done
        done <sweeps | "$DOMINO" --bail >"out.$threads"
        same_file out.1 "out.$threads"
    done
    [ "$(wc -l <out.1)" -gt 2500 ]
}

# bats test_tags=rows
@test "each row is the answer of the command for this point" {
    csv 'sweep s 0.1 0.5 5 d 0.1 0.3 3 : rmax' >rows
    same rows 16 "$(wc -l <rows)"
    while IFS=, read -r s d r ends exact paper _; do
        same "s = $s, d = $d" "$(csv "set d $d; rmax $s" | tail -n 1 | cut -d, -f 1-5)" "$s,$r,$ends,$exact,$paper"
    done < <(tail -n +2 rows)
    # The first parameter changes slowest.
    same order '0.1 0.1,0.1 0.2,0.3 0.1,0.3 0.2' \
        "$(json 'sweep s 0.1 0.3 2 d 0.1 0.2 2 : fuel' | sed -E 's/\{"s":([^,]*),"d":([^,]*),.*/\1 \2/' | paste -sd , -)"
    same 'like curve' "$(csv 'curve 0.02 0.9 33' | tail -n +2 | cut -d , -f 1,2)" \
        "$(csv 'sweep s 0.02 0.9 33 : rmax' | tail -n +2 | cut -d , -f 1,2)"
    same effects "$(json 'effect row 6; effect push 5; verdict' | values seconds)" \
        "$(json 'sweep row 6, 7 push 5, 6 : verdict' | head -n 1 | values seconds)"
    same 'of a row from a file' "$(json "effect row $root/examples/record.csv; effect push 4; verdict" | values short_by)" \
        "$(json "effect row $root/examples/record.csv; effect push 3; sweep push 3 4 2 : verdict" | tail -n 1 | values short_by)"
}

@test "an effect is swept over off, numbers, and on, which means its usual value" {
    for value in off 0.1 on; do differ "$value" "$(json 'effect friction 0.5; rmax' | values r_max)" \
        "$(json "effect friction $value; rmax" 2>/dev/null | values r_max)"; done
    same 'r_max' "$(for value in off 0.1 on; do json "effect friction $value; rmax" 2>/dev/null | values r_max; done)" \
        "$(json 'effect friction 0.5; sweep friction off, 0.1, on : rmax' | values r_max)"
    same 'values' 'off 0.1 0.2' "$(json 'sweep friction off, 0.1, on : rmax' | values friction | paste -sd ' ' -)"
}

# bats test_tags=rows,chance,explain
@test "grids: even, by equal ratios, lists, words, units, one point, in degrees" {
    grid() { csv "sweep $1 : print 0" | tail -n +2 | cut -d , -f "1-${2:-1}" | paste -sd ' ' -; }
    same even '0.1 0.3 0.5' "$(grid 's 0.1 0.5 3')"
    same ratios '0.001 0.01 0.1 1' "$(grid 's 0.001 1 4 log')"
    same list '0.3 0.1 0.25' "$(grid 's 0.3, 0.1,1/4')"
    same words '3 4' "$(grid 'q hollow, massive')"
    same units '0.01 0.02' "$(grid 'h 1 cm 20 mm 2')"
    same one 0.4 "$(grid 's 0.4 0.4 1')"
    same whole '1 4 7' "$(grid 'seed 1 7 3')"
    same 'whole, by ratios' '5 16 50' "$(grid 'row 5 50 3 log')"
    same 's is no second here' '0.1,0.2 0.1,0.4' "$(grid 'd 0.1 0.1 1 s 0.2 0.4 2' 2)"
    same 'nor behind a list' '0.1,0.4 0.2,0.4' "$(grid 'd 0.1, 0.2 s 0.4 0.4 1' 2)"
    same 'g is gravity here' '0.1,1 0.1,2 0.2,1 0.2,2' "$(grid 'h 0.1, 0.2 g 1, 2' 2)"
    same 'but a gram of a mass' '0.001 0.01' "$(grid 'mass 1 g 10 g 2')"
    same 'without blanks' '0.1 0.2' "$(csv 'sweep s 0.1 0.2 2: print 0' | tail -n +2 | cut -d , -f 1 | paste -sd ' ' -)"
    same 'tol follows precision' '1e-05 1e-12 1e-30' \
        "$(csv 'sweep precision float, double, quad : print tol' | tail -n +2 | cut -d , -f 2 | paste -sd ' ' -)"
}

# bats test_tags=rows,explain,errors
@test "columns: none occurs twice, and columns that repeat a parameter are left out" {
    same rmax s,r_max,ends_by,r_max_exact,r_max_paper,reason "$(csv 'sweep s 0.2 0.4 2 : rmax' | head -n 1)"
    same 'rmax S' s,r_max,ends_by,r_max_exact,r_max_paper,reason "$(csv 'sweep s 0.2 0.4 2 : rmax s/2' | head -n 1)"
    same fuel fuel,fuel.fuel,fuel_exact,fuel_paper,reason "$(csv 'sweep fuel exact, paper : fuel' | head -n 1)"
    same count r,height,dominoes,exact,first_height,last_height,feasible,goes_on,stops_at,push,r_start,reason "$(csv 'sweep r 1.2 1.5 2 : count 112 m' | head -n 1)"
    same errors s,s_error,theta,theta_error,omegasq,omegasq_error,omega,omega_error,reason \
        "$(csv 'set errors on; sweep s 0.001 0.4 2 : omega 0' | head -n 1)"
    # Rows have the same columns with and without friction, and with and without masses.
    same friction 14 "$(csv 'sweep friction 0, 0.2 : step' | awk -F , '{ print NF }' | sort -u)"
    csv 'effect row 3; sweep mass 0, 1 : row' |
        awk -F , 'NR > 1 && ($1 == 0 ? $6 != "" : $7 != "") { bad = 1 } END { exit bad || NR != 7 }'
}

# bats test_tags=rows,explain
@test "a point without an answer has a row with the reason, and the sweep goes on" {
    csv 'sweep s 0.1 0.9 9 : theta1 40 deg' >rows
    same rows 10 "$(wc -l <rows)"
    same 'tilt too large' 4 "$(grep -c '^[0-9.]*,,,,,,"T = .* is outside the cycle' rows)"
    same 'out of reach' 3 "$(grep -c '^[0-9.]*,,,,,,r s = .* > 1: the head falls past' rows)"
    same answers 2 "$(grep -c '^[0-9.]*,[^,].*,$' rows)"
    json 'sweep s 0.1 0.9 9 : theta1 40 deg' >objects
    same null 2 "$(grep -c '"reason":null}$' objects)"
    same reason 7 "$(grep -c '"arm_b":null,"reason":".*"}$' objects)"
    run -0 "$DOMINO" -e 'sweep s 0.1 0.9 9 : theta1 40 deg'
    same table 7 "$(grep -cE '^ +0\.[0-9] +- +- +- +- +-$' <<<"$output")"
    grep -q '^7 of 9 points have no answer\. The first is s = 0\.1: T = 0\.69.* csv and json give the reason for each of them\.$' <<<"$output"
    # The command, an argument, an expression, a row or an effect may be the cause.
    grep -q "rmax.r_max has no value here" <<<"$(csv 'sweep s 0.001 0.4 2 : count 112 rmax')"
    grep -q 'division by zero' <<<"$(csv 'sweep s 0.4 0.5 2 : print 1/(s - 0.4)')"
    grep -q ',all fall$' <<<"$(csv 'effect row 5; effect push 6; sweep s 0.3 0.4 2 : mend')"
    # A train that stops has its rows before the stop, and then a row with the reason.
    same 'stops' 3 "$(csv 'sweep r 1.9 1.9 1 : step 9' | wc -l)"
    grep -q 'the train has stopped' <<<"$(csv 'sweep r 1.9 1.9 1 : step 9' | tail -n 1)"
    run -0 "$DOMINO" -e 'sweep s 0.9 0.1 3 : cycle 2'
    same 'the head of a table shows units though its first point has no answer' 'h s rad rad rad rad/s mgh/2 mgh/2' \
        "$(sed -n 2p <<<"$output" | xargs)"
}

# bats test_tags=rows
@test "a sweep leaves no trace in the session" {
    before=$(json 'goto top; show; where; print ans.theta')
    after=$(json 'goto top; show; where; sweep s 0.1 0.9 5 q hollow, massive friction 0, 0.1 : step 2; print ans.theta' | grep -v '"q":')
    same 'parameters, walk and ans' "$before" "$after"
    differ 'what a trace would be' "$before" "$(json 'goto top; show; where; step 2; print ans.theta')"
    same 'effects' "$("$DOMINO" -e 'effect row 4; show')" \
        "$("$DOMINO" -e 'effect row 4; sweep row 3, 5 > /dev/null : verdict' 2>/dev/null; "$DOMINO" -e 'effect row 4; sweep row 3, 5 : verdict > /dev/null; show')"
}

# bats test_tags=rows,chance,pictures,explain
@test "an error in a line gives one message and no row" {
    wrong_line 'sweep' 'GRID is missing; usage: sweep GRID : ANSWER'
    wrong_line 'sweep s 0.1 0.9 9' "':' and an answer are missing; enter, for example,"
    wrong_line 'sweep s 0.1 0.9 9 :' "the answer is missing after ':'; enter, for example,"
    wrong_line 'sweep s 0.1 0.9 : rmax' ':17: .*s: N, the number of values, is missing'
    wrong_line 'sweep output 1 2 3 : rmax' "'output' is a setting of the calculator"
    wrong_line 'sweep s 0.1 0.9 9 0.5 : rmax' "'0.5' is not the name of a parameter"
    wrong_line 'sweep r 1 1.5 3, s 0.3 0.5 3 : thetac' "',' separates values, not parameters"
    wrong_line 'sweep s 0.1 0.9 2.5 : rmax' 'N = 2.5 is not a count'
    wrong_line 'sweep s 0.1 0.9 9 s 0.1 0.9 9 : rmax' "'s' is named twice"
    wrong_line 'sweep fuel exact paper 2 : rmax' "the values of fuel are words; list them, as in 'sweep fuel exact, paper : rmax'"
    wrong_line 'sweep seed 1 10 5 : rmax' 'seed takes whole numbers'
    wrong_line 'sweep mass 0 1 3 log : rmax' "with 'log', FROM and TO must be above 0"
    wrong_line 'sweep s 0.1 0.9 1e7 d 0.1 0.9 1e7 : rmax' 'more than 1000000000000 points'
    wrong_line 'sweep s 0.1 0.9 9 : set s 0.1' "'set' has no answer"
    wrong_line 'sweep s 0.1 0.9 9 : cost rmax' "'cost' cannot be swept: it measures computing time"
    wrong_line 'sweep s 0.1 0.9 9 : sweep d 0.1 0.2 2 : rmax' 'name all parameters in one grid'
    wrong_line 'sweep s 0.1 0.9 9 : theta1 foo' ":28: theta1: T at 'foo': 'foo' has no value"
}

@test "';', comments and '>' end the command that is swept" {
    same ';' '0.4 3' "$(csv "sweep s 0.1 0.3 2 : print s > out; print s # done" | tail -n 1 | cut -d , -f 1) $(wc -l <out)"
    same 'a comment' 3 "$(csv 'sweep s 0.1 0.3 2 : print s # : rmax' | wc -l)"
    rm out
    csv "sweep s 0.1 0.3 2 : theta1 foo > out" 2>/dev/null || true
    [ ! -e out ]
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'set output csv; set threads 4; sweep s 0.1 0.9 20000 : print s > /dev/full'
    grep -q 'No space left on device' <<<"$stderr"
}

@test "examples/cluster: the tasks of a job array add up to the whole" {
    for SLURM_ARRAY_TASK_ID in $(seq 18); do
        export SLURM_ARRAY_TASK_ID
        sh "$root/examples/cluster/slurm.sh" "$root/examples/cluster/sweep.dom"
    done
    awk 'NR == 1 || FNR > 1' part-??.csv >sweep.csv
    same 'the whole' "$(sed 's,part/20 part/20 1,0.05 0.9 18,' "$root/examples/cluster/sweep.dom" | "$DOMINO" -f -)" "$(cat sweep.csv)"
    same array '#SBATCH --array=1-18' "$(grep -x '#SBATCH --array=.*' "$root/examples/cluster/slurm.sh")"
}

@test "curve: separations are evenly spaced, and values agree with rmax and pair" {
    answer=$(json 'set q hollow; curve 0.3 0.5 3; rmax 0.4; pair 0.4; set fuel paper; rmax 0.4')
    same s '0.3 0.4 0.5' "$(head -n 3 <<<"$answer" | values s | paste -sd ' ')"
    same values "$(sed 1,3d <<<"$answer" | values r_max | sort | paste -sd ' ') 2.5" \
        "$(sed -n 2p <<<"$answer" | for key in exact paper pair; do values $key <<<"$(sed -n 2p <<<"$answer")"; done | sort | paste -sd ' ') $(sed -n 2p <<<"$answer" | values reach)"
    same 'one row' 0.5 "$(json 'curve 0.5 0.5 1' | values s)"
    same 'a hole in a curve' 'null 1.6442290' "$(json 'curve 0.001 0.4 2' | values exact | cut -c1-9 | paste -sd ' ' -)"
}

# bats test_tags=explain
@test "curve: a point whose limit is open has no value there, and says why" {
    local scene='set precision quad; set d 0.254524; set q 0.474363' s=0.1192020420696138643273314766323029
    run "$DOMINO" -e "$scene; curve 0.2 $s 2"
    same 'curve: status' 0 "$status"
    grep -qE '^ +0\.2 +[0-9.]+ +[0-9.]+ +[0-9.]+ +5$' <<<"$output" || same 'a point with values' '0.2 ...' "$output"
    grep -qE '^ +0\.119202 +- +[0-9.]+ +[0-9.]+ ' <<<"$output" || same 'the open point' '0.119202 -' "$output"
    grep -q "a limit is open" <<<"$output"
    same 'with reasons' 's,exact,paper,pair,reach,reason' "$(csv 'curve 0.1 0.2 2' | head -n 1)"
    csv 'curve 0.1 0.2 2' | sed -n 2p | grep -q "no growth possible; 'rmax' and 'pair' explain why"
}

@test "^C ends a script in the middle of a sweep; for terminals see prompt.bats" {
    env --default-signal=INT "$DOMINO" -e 'set output csv; set threads 4; sweep s 0.01 0.9 1e7 : rmax; print 1' >out 2>err 3>&- &
    until [ -s out ]; do kill -0 $!; done
    kill -INT $!
    wait $! && status=0 || status=$?
    same 'ended by SIGINT' 130 "$status"
    same 'no answer' '-e:1: sweep: interrupted' "$(cat err)"
    same 'and no other' s,r_max "$(grep -v '^[0-9]' out | cut -d, -f 1,2)"
}

# bats test_tags=rows
@test "several answers for each point: commands, keys and expressions have a column each" {
    local csv='set output csv; sweep r 1 2 5'
    same 'columns' "$(paste -d, <("$DOMINO" -n -e "$csv : barrier" | cut -d, -f1,5) <("$DOMINO" -n -e "$csv : fuel" | cut -d, -f2) \
        <("$DOMINO" -n -e "$csv : print 2*rmax(0.3)" | cut -d, -f2) | sed 1d)" \
        "$("$DOMINO" -n -e "$csv : barrier.margin, fuel, 2*rmax(0.3)" | sed 1d | sed 's/,$//')"
    same 'head' 'r,barrier.margin,fuel,2*rmax(0.3),reason' "$("$DOMINO" -n -e "$csv : barrier.margin, fuel, 2*rmax(0.3)" | head -n 1)"
    same 'threads' "$("$DOMINO" -n -e "set threads 1; $csv q 3, 4 : rmax, best.s")" "$("$DOMINO" -n -e "set threads 4; $csv q 3, 4 : rmax, best.s")"
    same 'with' "$("$DOMINO" -n -e "$csv : print rmax with q hollow" | cut -d, -f2 | sed 1d)" \
        "$("$DOMINO" -n -e "$csv : rmax with q hollow, rmax" | cut -d, -f2 | sed 1d)"
    wrong 'sweep r 1 2 3 : rmax, fall' "'fall' gives several numbers"
    wrong 'sweep r 1 2 3 : rmax,' "the answer is missing after ','"
    wrong 'sweep r 1 2 3 : rmax, foo' "'foo' has no value"
}

# bats test_tags=rows
@test "the unit in a head is that of every cell below it" {
    heads() { "$DOMINO" -n -e "$1" | sed -n 2p | xargs; }
    same 'a column that the first point does not have' 'rad s rad/s J J J J J J J' "$(heads 'set mass 10 g; sweep friction 0, 0.2 : goto 0.1')"
    same 'without masses' 'mgh/2' "$(heads 'sweep friction 0, 0.2 : goto 0.1' | awk '{ print $NF }')"
    same 'one number' J "$(heads 'set mass 10 g; sweep friction 0, 0.2 : why.kinetic, rmax')"
    same 'a mass of its own' 'g J' "$(heads 'sweep mass 0, 10 g : why.kinetic with mass 10 g, rmax')"
    [[ $("$DOMINO" -n -e 'sweep mass 0, 10 g : why') == *'fuel is in J here, but in mgh/2 at the first point.' ]]
    [[ $("$DOMINO" -n -e 'sweep s 0.4 0.6 2 : if(s > 0.5, 1 m, 2), rmax') == *'is in m here, but a plain number at the first point.' ]]
}

@test "sweep: the reason of an empty cell is that of the command" {
    same reason "duration.speed has no value here: falling releases no energy: the fuel P is not positive (25; c7); 'why' says what to change" \
        "$(csv 'sweep s 0.1 0.4 2 : rmax, duration.speed' | sed -n 's/^0.1,[0-9.]*,,//p')"
}
