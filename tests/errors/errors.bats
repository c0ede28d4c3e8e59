#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# 'set errors on': each number with its difference from a computation with 30 digits.

load ../shell/common

# bats test_tags=chance,sweeps,planning
@test "errors on: every number has an error, in table, csv and json" {
    while IFS='|' read -r call expected; do
        case $call in print* | fewest* | landmarks | slip | design* | sensitivity* | solve* | effect* | reset*) continue ;; esac # these commands have no errors
        table=$("$DOMINO" -e "set errors on; $call")
        grep -q ' +/- [0-9.]*e-[0-9]*' <<<"$table"
        answer=$(json "set errors on; $call" | tail -n 1)
        bounds=0
        for key in $expected; do
            value=$(values "$key" <<<"$answer")
            if [[ $value =~ ^-?[0-9] ]] && [[ " i dominoes cycle " != *" $key "* ]] &&
                [[ $call != c* || $key != stops_at ]]; then
                [[ $(values "${key}_error" <<<"$answer") =~ ^[0-9.]+(e[-+][0-9]+)?$ ]] || same "$call: $key" 'a bound' "$answer"
                bounds=$((bounds + 1))
            fi
        done
        [ "$bounds" -gt 0 ] || same "$call" 'bounds' "$answer"
        head=$("$DOMINO" -e "set errors on; set output csv; $call" | head -n 1)
        same "$call: csv" "$(json "set errors on; $call" | keys | tr ' ' ,)" "$head"
    done <<<"$commands"
    # The largest growth from rest is that of a pair, and known to nine digits at every precision.
    local precision pair answer
    for precision in double quad; do
        pair=$(json "set precision quad; pair" | values r_max)
        answer=$(json "set precision $precision; set errors on; rmax")
        awk -v p="$pair" -v r="$(values r_start <<<"$answer")" -v e="$(values r_start_error <<<"$answer")" \
            'BEGIN { d = p - r; exit !(r > 1.5 && e < 1e-8 && d * d <= e * e) }' || same "$precision: r_start" "$pair" "$answer"
    done
    same 'slip, which computes in double' null "$(json 'set errors on; slip' | values hit_error)"
    same 'off again' 's r_max ends_by r_max_exact r_max_paper r_start' "$(json 'set errors on; set errors off; rmax' | keys)"
}

# bats test_tags=rows
@test "errors on: the numbers of a list have errors in csv and json, and in quad all their digits" {
    local row='set row 3; set push 5' precision key exact answer
    exact=$(json "set precision quad; set tol 1e-30; $row; fall" | tail -n 1)
    [[ $(values falls <<<"$exact") =~ ^0\.[0-9]{30,}$ ]] || same 'all digits' '30 digits or more' "$exact"
    for precision in float double; do
        answer=$(json "set precision $precision; set errors on; $row; fall" | tail -n 1)
        for key in falls omega kinetic margin; do
            awk -v a="$(values $key <<<"$answer")" -v e="$(values ${key}_error <<<"$answer")" -v exact="$(values $key <<<"$exact")" \
                -v most="$([ $precision = float ] && echo 1e-6 || echo 1e-14)" \
                'BEGIN { d = a - exact; exit !(a > 0 && e > 0 && e < most && d * d <= e * e) }' ||
                same "$precision: $key" "an error that covers the difference from $exact" "$answer"
        done
    done
    [[ $("$DOMINO" -e "set errors on; $row; fall") == *"Where a column has no room for errors, 'set output csv' shows them."* ]]
}

# bats test_tags=rows,proof,engine,pictures,explain
@test "in quad, numbers that are computed in double are written as doubles" {
    local call
    for call in 'slip' 'prove rmax' 'prove barrier' 'set method engine; set row 3; fall' 'draw 0.1' 'set row 3; draw' 'set row 3; animate'; do
        run "$DOMINO" -e "set precision quad; set output csv; $call"
        [[ $output =~ [0-9]\.[0-9]+ && ! $output =~ [1-9][0-9]{18} ]] || same "$call" 'at most 18 digits' "$output"
    done
    same recipe 1 "$(json 'set precision quad; recipe' | grep -c '"paper":1.7664529936804025,')"
}
