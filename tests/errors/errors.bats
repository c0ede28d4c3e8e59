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
                [[ $call != cycle* || $key != theta* ]] &&
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
    same 'off again' 's r_max ends_by r_max_exact r_max_paper r_start' "$(json 'set errors on; set errors off; rmax' | keys)"
}
