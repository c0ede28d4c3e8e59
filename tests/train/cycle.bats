#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# A cycle as a table, and the walk through cycles event by event.

load ../shell/common

# Prints the values of a key in json answers, in one line.
all() { values "$1" | paste -sd ' ' -; }

# Checks that there are COUNT steps on stdin, and that all are equal.
evenly() { # COUNT
    awk -v count="$1" 'NR == 1 { step = $1 } { d = $1 / step - 1; if (!(d <= 1e-9 && d >= -1e-9)) bad = 1 }
        END { if (bad || NR != count) { print NR " steps, not even"; exit 1 } }'
}

@test "cycle: N rows and the events in order; the columns agree with omega, energy, chain, duration" {
    rows=$(json 'cycle 7')
    same events 'launch top hit' "$(values event <<<"$rows" | grep . | paste -sd ' ' -)"
    same 'rows' 8 "$(wc -l <<<"$rows")"
    close t_f "$(json duration | values seconds)" "$(values t <<<"$rows" | tail -n 1)"
    close theta_m "$(json barrier | values theta_m)" "$(grep '"event":"top"' <<<"$rows" | values theta)"
    while IFS= read -r row; do
        theta=$(values theta <<<"$row")
        close omega "$(json "omega $theta" | values omega)" "$(values omega <<<"$row")"
        close potential "$(json "energy $theta" | values dH)" "$(values potential <<<"$row")"
        close theta_1 "$(json "theta1 $theta" | values theta_1)" "$(values theta_1 <<<"$row")"
        close theta_2 "$(json "chain $theta" | sed -n 3p | values theta_i)" "$(values theta_2 <<<"$row")"
    done <<<"$rows"
    # Rows are evenly spaced in time or in tilt.
    json 'cycle 5 tilt' | grep '"event":""' | values theta | awk 'NR > 1 { print $1 - before } { before = $1 }' |
        evenly 2
    json 'cycle 5' | grep -v '"event":"top"' | values t | awk 'NR > 1 { print $1 - before } { before = $1 }' | evenly 4
}

@test "cycle: energies in J where a mass or a density is set" {
    plain=$(json 'cycle 2' | tail -n 1 | values kinetic)
    # There are five rounding errors of 1.1e-16, and 17 digits are printed.
    close mass "$(awk -v k="$plain" 'BEGIN { printf "%.17g", k * 0.008 * 9.81 * 0.048 / 2 }')" \
        "$(json 'set mass 0.008; cycle 2' | tail -n 1 | values kinetic)" 1e-15
    # 48 x 24 x 7 mm at 1000 kg/m^3 are 8.064 g.
    same density "$(json 'set mass 0.008064; why' | values kinetic | cut -c 1-14)" \
        "$(json 'set density 1000; why' | values kinetic | cut -c 1-14)"
    "$DOMINO" -e 'set mass 0.008; cycle 2' | grep -q '\bJ\b'
    "$DOMINO" -e 'cycle 2' | grep -q 'mgh/2'
}

# bats test_tags=rows
@test "cycle: a follower that detaches is an event, before or after the top" {
    same 'fall, then top' 'launch fall top hit' \
        "$(json 'set q hollow; set s 0.54; set r 1.8518; cycle 4' | values event | grep . | paste -sd ' ' -)"
    same 'top, then fall' 'launch top fall hit' \
        "$(json 'set q hollow; set s 0.5; set r 1.9; cycle 4' | values event | grep . | paste -sd ' ' -)"
}

@test "cycle of a train that stops or does not start: rows up to the stop, and the reason" {
    rows=$(json 'set r 1.7; cycle 4')
    same 'stops' stop "$(tail -n 1 <<<"$rows" | values event)"
    same 'at rest' 0 "$(tail -n 1 <<<"$rows" | values omega)"
    "$DOMINO" -e 'set r 1.7; cycle 4' | grep -q 'The train stops, because it has too little energy to keep falling'
    says 'set s 0.001; cycle' 'falling releases no energy: the fuel P is not positive (25; c7)'
}

@test "step: launch, top, hit, then the next cycle, sqrt(r) slower and r times larger" {
    walk=$(json 'step; step; step; step; step; step')
    same events 'launch top hit launch top hit' "$(all event <<<"$walk")"
    same cycles '1 1 1 2 2 2' "$(all cycle <<<"$walk")"
    close 'times of the hits' "$(awk -v a="$(values t <<<"$walk" | sed -n 3p)" 'BEGIN { printf "%.17g", a * sqrt(1.5) }')" \
        "$(values t <<<"$walk" | sed -n 6p)" 1e-12
    same 'N steps' "$(sed -n 5p <<<"$walk")" "$(json 'step 5')"
    same 'back' "$(sed -n 2p <<<"$walk")" "$(json 'step 5; back 3' | tail -n 1)"
    same 'where' "$(sed -n 2p <<<"$walk")" "$(json 'step 2; where' | tail -n 1)"
    for words in 'back' 'to hit' 'where' 'to 0.2'; do
        same "step $words" "$(json "step 2; ${words/#to/goto}" | tail -n 1)" "$(json "step 2; step $words" | tail -n 1)"
    done
    says 'step 4 details' 'Cycle 2, event 1 of 3' '7.2 cm tall' 'explain launch' '(24; c6)' 'before 0.181561 mgh/2' 'of the first head'
}

@test "step of a train that stops: goes to the stop, and says where and why" {
    run -1 "$DOMINO" --keep-going -e 'set r 1.7; step; step; details; step; print 1'
    [[ $output == *'how much more the train needs (26; c8).'* ]]
    [[ $output == *"step: the train has stopped; 'why' explains it"* ]]
    same 'the session goes on' 1 "${lines[-1]}"
    wrong 'back' 'this is the launch of the first cycle'
}

# bats test_tags=rows
@test "goto: a tilt, an event; beyond the cycle or the stop is an error" {
    same 'tilt' '0.3 top' "$(json 'goto 0.3' | values theta) $(json 'goto 0.3' | values event)"
    same 'event' "$(json barrier | values theta_m)" "$(json 'goto top' | values theta)"
    same 'degrees' 0.17453292519943295 "$(json 'goto 10 deg' | values theta)"
    wrong 'goto 2' 'step to: PLACE = 2 rad is outside the cycle; PLACE is an angle in \[0, theta_c\]'
    wrong 'goto fall' "step to: there is no 'fall' in this cycle"
    for place in '0.2|between the top and the hit' '0.01|between the launch and the top'; do
        grep -q "^Cycle 1, ${place#*|}: the train " <<<"$("$DOMINO" -e "step to ${place%|*}")" || same "$place" "$place" ''
    done
    wrong 'energy 5' "; for degrees, write '5 deg'$"
    wrong 'energy 5 rad' "'thetac' gives theta_c$"
    same start '1 launch 0' "$(json 'step 8; step to start' | tail -n 1 | sed -E 's/.*"cycle":([0-9]*),"event":"([a-z]*)","theta":([^,]*),.*/\1 \2 \3/')"
    wrong 'set r 1.7; goto 0.3' 'the train stops before that, at theta = 0.02802163121 rad'
}

@test "after a change of parameters the walk begins again, and a message says so" {
    says 'step 2; set r 1.4; where' 'The parameters have changed, so the steps begin again at the launch.'
    same 'launch' launch "$(json 'step 2; set r 1.4; where' | tail -n 1 | values event)"
    for change in 'digits 5' 'tol 1e-9' 'precision float' 'tol 0.1'; do
        same "$change does not count" top "$(json "step 2; set $change; where" | tail -n 1 | values event)"
    done
    same 'a top with other digits' "$(json 'set precision quad; step to top' | values theta)" \
        "$(json 'step to top; set precision quad; where' | tail -n 1 | values theta)"
}

@test "why: the verdict, the term that decides it, and whether the dominoes stay in contact" {
    says 'why details' 'The train keeps falling: to push the next domino over, it needs 14 % of the energy that it has.' \
        'may be up to 1.64422 times as large' 'The dominoes stay in contact, as the paper assumes'
    says 'set r 1.7; why details' 'The train stops: it has 62 % of the energy that it needs to push the next domino over.'
    says 'set s 0.001; why details' 'The train does not fall: falling releases no energy.'
    says 'set s 0.1; set r 1.01; why' 'it has nothing to climb, so any motion is enough'
    same 'keys' "goes on" "$(json why | values verdict)"
    # The first two lines have no symbols. The second line gives advice: other gaps, less growth, thinner
    # dominoes.
    while IFS='|' read -r scene advice; do
        run -0 "$DOMINO" -e "$scene; why"
        same "$scene" "$advice" "${lines[1]}"
        [[ $(head -n 2 <<<"$output") != *[=\(]* ]]
    done <<'END'
set r 1.7|With gaps of 0.5337 times the height, each domino can be 1.81 times as large as the one before; with the present gaps, 1.644 times.
effect friction 0.2; set s 0.7; set r 1.42|With gaps of 0.5386 times the height, each domino can be 1.603 times as large as the one before; with the present gaps, 1.405 times.
set s 0.003; set r 1.2|With gaps of 0.5337 times the height, each domino can be 1.81 times as large as the one before.
set d 3|Make the dominoes thinner: no gap lets dominoes this thick topple larger ones.
END
    # A percentage that would be rounded to 100 % has more digits.
    for share in '1.00001|it has' '0.99999|it needs'; do
        "$DOMINO" -e "set r ${share%|*}*rmax; barrier" | grep -qE "(: |, )${share#*|} 99\.9[0-9]+ % of"
    done
}

# bats test_tags=rows,chance,pictures,explain
@test "draw without T shows the state of 'where', whatever has changed since the last step" {
    local change where
    for change in 'set s 0.3' 'set r 1.4' 'set d 0.2' 'set q 3' 'set fuel paper' 'effect friction 0.3'; do
        [[ $("$DOMINO" -e "goto 0.2; $change; where") == *'the steps begin again at the launch'* ]]
        same "$change" "$("$DOMINO" -e "$change > /dev/null; draw 0")" \
            "$("$DOMINO" -e "goto 0.2 > /dev/null; $change > /dev/null; draw")"
    done
    for change in 'set h 1' 'set mass 2' 'set digits 5' 'set seed 3' 'set tol 1e-9' 'set precision quad' 'effect row 5' \
        'effect floor 0.4'; do
        [[ $("$DOMINO" -e "goto 0.2; $change; where") != *'the steps begin again at the launch'* ]]
        same "$change" "$("$DOMINO" -e "$change; draw train 0.2")" \
            "$("$DOMINO" -e "goto 0.2 > /dev/null; $change; draw train")"
    done
}
