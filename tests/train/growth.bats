#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The largest growth: rmax, pair and best; answers that are a physical "no".

load ../shell/common

@test "no fuel, no growth or a stop: null with a reason, status 0, nothing on stderr" {
    while IFS='|' read -r calls nulls reason; do
        run --separate-stderr json "$calls"
        same "$calls: status" 0 "$status"
        same "$calls: stderr" '(nothing)' "$stderr"
        row=$(tail -n 1 <<<"$output")
        for key in $nulls; do same "$calls: $key" null "$(values "$key" <<<"$row")"; done
        grep -q "\"reason\":\"[^\"]*${reason}[^\"]*\"}$" <<<"$row" || same "$calls" "$reason" "$row"
        # The table has the same reason, or its details have.
        expects "$calls" "$reason"
        "$DOMINO" -e "$calls; details" 2>&1 | grep -q "$reason" || same "$calls details" "$reason" "$("$DOMINO" -e "$calls details")"
    done <<END
set s 0.001; fuel||releases no energy: the fuel P is not positive
set s 0.001; launch|omega0sq omega0 kinetic|fuel P is not positive
set s 0.001; barrier|kinetic margin|fuel P is not positive
rmax 0.001|r_max r_max_exact r_max_paper|no growth possible.*releases no energy
pair 0.1|r_max|no growth possible
set d 1; best|s r_max|no growth possible
set r 1.8; duration|duration seconds speed|before the top of the barrier
set r 1.8; omega 0.2|omegasq omega|before the top of the barrier
set r 1.8; barrier||too little energy, and stops before the top of the barrier
END
}

# bats test_tags=rows
@test "rmax names two limits if they differ: for a row that starts, and for a train that is already moving" {
    answer=$("$DOMINO" -e 'set r 1.64; rmax details')
    for words in '1\.64422 times as large' 'A row that starts from rest can have a growth of up to 1\.59459 if its first domino just tips over'; do
        grep -q "$words" <<<"$answer" || same rmax "$words" "$answer"
    done
    "$DOMINO" -e 'set q hollow; rmax 0.1' | grep -q 'from rest, no row falls if its first domino just tips over, whatever its growth'
    "$DOMINO" -e 'effect row 2; effect push 6; rmax' | grep -q 'A row that starts from rest can have a growth of up to 1\.63[0-9]* with a push of 6 rad/s'
    # If the reach limits both growths, they are equal.
    "$DOMINO" -e 'rmax 0.8' | grep -q '1\.25'
    ! "$DOMINO" -e 'rmax 0.8' | grep -q 'from rest'
    # In json, 'rmax' and 'count' give the same r_start.
    answer=$(json 'rmax; count 112; set q hollow; rmax 0.1')
    same r_start "$(sed -n 2p <<<"$answer" | values r_start)" "$(head -n 1 <<<"$answer" | values r_start)"
    close ans 1.59459196 "$(json 'rmax; print ans.r_start' | values value)" 1e-8
    # The second row does not start with equal dominoes. In the third, the energy to spare decreases slowly.
    close 'r_start, friction' 1.29183480 "$(json 'set q hollow; set friction 0.2; rmax 0.25' | values r_start)" 1e-8
    close 'r_start, slow' 1.70033272 "$(json 'set q 3.5; set d 0.198; rmax 0.5826' | values r_start)" 1e-8
    wrong 'print rmax.r_start' "rmax.r_start is not available in expressions, because it takes a long time to compute; enter 'rmax', and then 'ans.r_start'"
    grep -q '"r_start":null,"reason":"r_start has no value: from rest, no row falls' <<<"$answer"
}

@test "best: the train with the numbers of the sentence goes on, also where r_max jumps at the best separation" {
    local scene words
    for scene in 'd 0.134101; set q 0.370576' 'd 0.0124453; set q 0.522' 'd 0.0758594; set q 0.312005' 'q 3'; do
        words=$("$DOMINO" -e "set $scene; best")
        [[ $words =~ 'the best gap, '([0-9.]+)' times the height, '.*' can each be '([0-9.]+)' times' ]] || same "$scene" 'a sentence' "$words"
        less "${BASH_REMATCH[2]}" "$(json "set $scene; rmax ${BASH_REMATCH[1]}" | values r_max)"
    done
}

# bats test_tags=explain
@test "an open limit is no number: a dip of the margin touches 0 within rounding errors, even in quad" {
    local scene='set precision quad; set d 0.254524; set q 0.474363'
    wrong "$scene; rmax 0.1192020420696138643273314766323029" 'r_max is open: at the growth 4.4669'
    local s=0.1192020420696138643273314766323029
    local named='r_max is open: at the growth 4.4669[0-9]* the margin is 0 within rounding errors, even in quad; if a train passes this growth, r_max is [5-9]'
    for call in "rmax $s" "set s $s; why" "set s $s; count 112" "set s $s; recipe" "set s $s; explain rmax"; do
        run --separate-stderr "$DOMINO" -e "$scene; $call"
        same "$call: status" 1 "$status"
        grep -q "$named" <<<"$stderr" || same "$call" "$named" "$stderr"
    done
}

# bats test_tags=sweeps,explain
@test "tables and sentences round a limit down, csv keeps all digits" {
    limit='1\.64422'
    for command in 'rmax; details' why explain 'sweep s 0.4 0.5 2 : rmax' 'curve 0.3 0.5 3'; do
        command=${command/#explain/explain rmax} command=${command/#why/why; details}
        run -0 "$DOMINO" -e "$command"
        grep -q "$limit" <<<"$output" || same "$command" "$limit" "$output"
        if grep '1\.64423' <<<"$output"; then same "$command: rounded up" '(nothing)' "$output"; fi
    done
    same csv 1.6442290 "$(csv 'rmax' | tail -n 1 | cut -d , -f 2 | cut -c 1-9)"
    wrong 'set s 0.9; why' 'the largest r for this s is 1/s = 1\.11111$'
}
