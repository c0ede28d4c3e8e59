#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The time that accuracy costs: 'cost'.

load ../shell/common

# bats test_tags=explain
@test "cost: a row for each method, precision and tolerance, and a summary in words" {
    run -0 "$DOMINO" -e 'cost rmax details'
    for word in paper ours float double quad; do grep -q "\b$word\b" <<<"$output"; done
    same 'a line each' 'r_max, the time for one answer:|ours    N us for 3 digits, N us for 6, N us for 12|quad    N times as long as ours, for 12 digits|paper   N times as long as ours, for 6 digits' \
        "$(head -n 4 <<<"$output" | sed -E 's/ [0-9][0-9.e+]* (us|times)/ N \1/g' | paste -sd '|' -)"
}

# bats test_tags=explain,engine
@test "cost: errors are as small as requested for every method that answers, down to 1e-33 for our own method" {
    for command in rmax barrier duration pair; do
        "$DOMINO" -e "set output csv; cost $command" >cost
        same "$command" method,precision,tol,error,dominoes,passes,time,times "$(head -n 1 "$PWD/cost")"
        awk -F, -v command="$command" 'NR > 1 {
            # The recipe of the paper has steps of sqrt(tol) / 2, so its errors are of the order of tol. In double and float,
            # rounding errors are added.
            room = $1 == "paper" ? 20 * $3 : $3
            floor = $2 == "float" ? 3e-6 : $2 == "double" ? 1e-14 : 1e-31
            if (!($4 <= room + floor && $5 >= 1 && $6 >= 1 && $7 > 0 && $8 >= 1)) { print command ": " $0; bad = 1 }
            if ($1 == "ours" && $2 == "quad" && $3 == 1e-33) finest = 1
            rows++
        } END { exit bad || !finest || rows < 20 }' cost
        # From the first to the last tolerance, more digits take more work. In between, the number of dominoes may
        # decrease, where the rest of the train becomes a series. A tolerance of 0.1 can take more passes, since it leaves
        # more samples in doubt.
        awk -F, '$1 == "ours" && $2 == "quad" { last = $5; passes = $6; rows++
            if (rows == 1) first = $5; if (rows == 2) few = $6 } END { exit rows < 3 || last < first || passes < few - (few > 20) * few / 3 }' \
            cost
    done
}

@test "cost: a command without a tolerance or an answer gives a one-line error" {
    run -1 "$DOMINO" --keep-going -e 'cost thetac'
    same thetac "-e:1:6: cost: unknown command with a tolerance 'thetac'; use one of: barrier, duration, rmax, pair" "$output"
    for state in 'set s 0.001; cost duration' 'set s 0.001; cost rmax' 'set r 1.7; cost duration'; do
        run -1 "$DOMINO" --keep-going -e "$state"
        same "$state" 1 "${#lines[@]}"
        [[ $output == *'there is no answer to measure here'* ]]
    done
}
