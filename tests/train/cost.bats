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
        # More digits take more work, unless a root of double's is known: then 2 digits take nearly as much as 33. (0.1 takes
        # more, since it leaves samples in doubt. With more digits the far series begin after fewer dominoes.)
        awk -F, '$1 == "ours" && $2 == "quad" { work = $5 * $6; if (++rows == 2) few = work }
            END { exit rows < 3 || work < 0.9 * few }' \
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
