#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Parameters and settings: set, show and reset; digits.

load common

# bats test_tags=rows,chance,engine,errors
@test "show: all parameters with defaults, units, ranges and meanings; show NAME" {
    json show >all
    same names 's r d q width tol h g mass density fuel precision output header digits angle threads seed method errors' "$(values name <all | paste -sd ' ' -)"
    while read -r name unit value; do
        row=$(json "show $name")
        same "show $name" "$(grep "\"name\":\"$name\"" "$PWD/all")" "$row"
        same "keys" 'name value unit range default meaning' "$(keys <<<"$row")"
        [ "$unit" != - ] || unit='(nothing)'
        same "$name: unit" "$unit" "$(values unit <<<"$row")"
        case $value in
        *[0-9]*)
            close "$name: value" "$value" "$(values value <<<"$row")"
            close "$name: default" "$value" "$(values default <<<"$row")"
            ;;
        *) same "$name: default" "$value" "$(values default <<<"$row")" ;;
        esac
        grep -q '"range":"[^"]' <<<"$row"
        grep -q '"meaning":"[^"]' <<<"$row"
        # The table has one header and one row.
        same "show $name: lines" 2 "$("$DOMINO" -e "show $name" | wc -l)"
    done <<END
s h 0.4
d h 0.14583333333333334
q - 4
tol - 1e-12
h m 0.048
fuel - exact
output - table
angle - rad
END
}

@test "reset and reset NAME restore the defaults; output belongs to the session" {
    changed='set s 0.3; set r 1.2; set d 0.2; set q 3; set tol 1e-10; set h 1; set g 1.6; set fuel paper'
    defaults=$(json show)
    differ 'what is reset' "$(json "$changed; show")" "$defaults"
    same 'reset' "$defaults" "$(json "$changed; reset; show")"
    same 'reset s' "$(json "$changed; set s 0.4; show")" "$(json "$changed; reset s; show")"
    same 'reset output' "$("$DOMINO" -e fuel)" "$("$DOMINO" -e 'set output json; reset output; fuel')"
}

@test "each 'set' is checked alone: r s > 1 is an error in a command that needs both, and another 'set' corrects it" {
    run -1 --separate-stderr json 'set s 0.9; thetac; set r 1.1; thetac'
    same 'one answer' 1 "${#lines[@]}"
    close 'theta_c' "$(awk 'BEGIN { x = 0.9 * 1.1; printf "%.17g", atan2(x, sqrt(1 - x * x)) }')" \
        "$(values theta_c <<<"$output")"
    grep -q 'r s = 1.35 > 1' <<<"$stderr"
    for order in 'set s 0.9; set r 1.1' 'set r 1.1; set s 0.9' 'set r 3; set s 0.9; set r 1.1'; do
        same "$order" "$output" "$(json "$order; thetac")"
    done
    # r s = 1 belongs to the range, even if 1/s is rounded.
    for s in 0.5 0.3 0.7 0.9 1; do
        same "s $s, r 1/s" 2 "$(json "set s $s; set r 1/$s; thetac; barrier" | grep -cE '"(theta_c|barrier)":[0-9]')"
    done
}

@test "a parameter's name shows it, '=' and 'to' set it, '?' explains it" {
    all_mean <<'END'
q|show q
r = 2; r|set r 2; show r
r=rmax*0.99; r|set r 0.99*rmax; show r
set r = 2; r|set r 2; show r
set r to 2; r|set r 2; show r
fuel = paper; show fuel|set fuel paper; show fuel
friction = 0.2; friction|effect friction 0.2; show friction
effect friction = 0.2; friction|effect friction 0.2; show friction
END
    for line in 'rmax?' 'rmax ?' 'help rmax?'; do
        same "$line" "$("$DOMINO" -e 'help rmax')" "$("$DOMINO" -e "$line")"
    done
    same 'q does not leave' 3 "$("$DOMINO" -e 'q; 1+2' | tail -n 1)"
}

# bats test_tags=rows,chance
@test "show: 'walls' with both lengths" {
    same both 'walls 18 mm, 0.3 m' "$("$DOMINO" -e 'set walls 18 mm 30 cm; show walls' | awk 'NR == 2 { print $1, $2, $3, $4, $5 }')"
}

# bats test_tags=rows,planning
@test "set s, r and d say that they do not change a row from a file, and which command makes a row from them" {
    for name in s r d; do
        same "$name" "$name does not change the row, whose dominoes come from record.csv; 'set row N' makes a row from s, r, d and h." \
            "$("$DOMINO" -e "effect row $root/examples/record.csv; set $name 1")"
        run -0 --separate-stderr "$DOMINO" -e "set output json; effect row $root/examples/record.csv; set $name 1"
        grep -q "does not change the row" <<<"$stderr"
    done
    same 'a changed gap' "s does not change the gaps that 'change', 'place' or 'improve' has set (1 of 4); 'set row N' makes a row from s and r." \
        "$("$DOMINO" -e 'effect row 5; place 3 1 cm; set s 0.3' | tail -n 1)"
    same 'other values, and other rows, say nothing' '(nothing)' \
        "$("$DOMINO" -e "effect row $root/examples/record.csv; set q 3; effect row 4; set s 0.3" | grep 'does not')"
}
