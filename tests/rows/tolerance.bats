#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Tolerance: how far the values of each domino of a row may be off.

load ../shell/common

scene='effect row 6; effect push 6; effect friction 0.1'

# Prints the verdict of the row after each single command: "yes" if all dominoes fall.
verdicts() { # COMMANDS...
    for commands in "$@"; do json "$scene; $commands; verdict" | values verdict; done | sed 's/all fall/yes/;t;s/.*/no/' | paste -sd ' ' -
}

@test "tolerance: all fall at both ends of a window, and not beyond" {
    "$DOMINO" -e "$scene; tolerance > t.csv"
    same head 'domino,place,from,to,gap,gap_low,gap_high,height,height_low,height_high,thickness,thickness_low,thickness_high,lean,lean_low,lean_high,friction_low,friction_high,first' \
        "$(head -n 1 t.csv)"
    same rows 7 "$(wc -l <t.csv)"
    while IFS=, read -r k place from to gap low high _; do
        [ "$k" != domino ] && [ "$k" -gt 1 ] || continue
        if [ "$low" != 0 ]; then
            same "gap $k below" 'yes no' "$(verdicts "place $k $low m" "place $k 0.9999*$low m")"
        fi
        same "gap $k above" 'yes no' "$(verdicts "place $k $high m" "place $k 1.0001*$high m")"
        [ "$k" -lt 6 ] || continue
        next=$(awk -F , -v k="$k" '$1 == k + 1 { print $5 }' t.csv)
        moved() { echo "place $k ($gap + $1) m; place $((k + 1)) ($next - ($1)) m"; }
        by=$(awk "BEGIN { printf \"%.9f\", $to - $place }")
        same "place $k to" 'yes no' "$(verdicts "$(moved "0.9999*$by")" "$(moved "1.001*$by")")"
        by=$(awk "BEGIN { printf \"%.9f\", $place - $from }")
        same "place $k from" yes "$(verdicts "$(moved "-0.9999*$by")")"
    done <t.csv
    high=$(sed -n 2p t.csv | cut -d , -f 18)
    same friction 'yes no' "$(verdicts "effect friction $high" "effect friction 1.0001*$high")"
}

@test "tolerance: the window of a height is for one domino, whose mass changes with the height" {
    "$DOMINO" -e "$scene; set mass 0.01; row > row.csv; tolerance > t.csv"
    for k in 1 3 6; do
        for column in 9 10; do
            height=$(awk -F , -v k="$k" -v c="$column" '$1 == k { print $c }' t.csv)
            for off in 1 $([ "$column" = 9 ] && echo 0.999 || echo 1.001); do
                awk -F , -v OFS=, -v k="$k" -v to="$height" -v off="$off" \
                    '$1 == k { $5 *= to * off / $2; $2 = to * off } 1' CONVFMT=%.12g row.csv >changed.csv
                json "effect row changed.csv; effect push 6; effect friction 0.1; verdict" 2>&1 | grep -c "all fall" || true
            done | sed "s/1/yes/;s/0/no/" | paste -sd " " - >verdicts
            same "height $k, column $column" 'yes no' "$(cat verdicts)"
        done
    done
}

@test "tolerance: windows in sentences are rounded inwards; for a row that does not fall, they say what saves it" {
    said=$("$DOMINO" -e 'effect row 5; tolerance details')
    grep -qF 'The place of domino 2 has the tightest limits: 3.25 cm to 4.64 cm; it is ' <<<"$said"
    grep -qE '^The height of domino 1 has the tightest limits: 4\.07 cm to 7\.75 cm; it is 4\.8 cm now\.$' <<<"$said"
    grep -qE '^The friction between the dominoes may be 0 to 0\.17[0-9]*; it is 0 now\.$' <<<"$said"
    grep -qxF 'The lean of domino 2 has the tightest limits: -1.7 mm to 1.03 cm; it is 0 mm now.' <<<"$said"
    same marks '1 height 2 place' "$(awk '$NF ~ /^(place|height|both)$/ { print $1, $NF }' <<<"$said" | paste -sd ' ' -)"
    exact=$(json 'effect row 5; tolerance' | sed -n 2p)
    within from "$(values from <<<"$exact")" 0.0325 'o >= e && d < 0.01'
    within to "$(values to <<<"$exact")" 0.0464 'o <= e && d > -0.01'
    within 'top backwards' "$(values lean_low <<<"$exact")" -0.0017 'd <= 0 && d > -0.01'
    # The first domino may lean until its centre is above its front edge: the top is off by h sin(theta_u).
    within 'top forwards' "$(json 'effect row 5; tolerance' | head -n 1 | values lean_high)" 0.00692673 'd*d < 1e-10'
    # If leans are not computed, they are not mentioned.
    run ! grep -q '^The lean' <<<"$("$DOMINO" -e 'effect row 3; effect edges 0.01; tolerance details')"
    same 'no lean' 'null null null' "$(json 'effect row 3; effect edges 0.01; tolerance' | values lean_high | paste -sd ' ' -)"
    said=$("$DOMINO" -e 'effect row 3; place 2 4 m; tolerance details')
    grep -q 'does not fall as it is; a change of one value can save it\.' <<<"$said"
    low=$(json 'effect row 3; place 2 4 m; tolerance' | values gap_low | sed -n 2p)
    same mended 'all fall' "$(json "effect row 3; place 2 $low m; verdict" | values verdict)"
    # Uphill, a domino that is far lower than it is thick never tips over, so its height is not in the window.
    says 'effect row 12; effect slope -6 deg; tolerance' 'no change of one gap, height or thickness was found that saves it'
    wrong tolerance 'there is no row'
}

@test "tolerance suggests commands, and each of these leads to a row that falls" {
    local scene commands
    for scene in 'effect row 3; place 2 4 m' 'effect row 4; place 4 30 cm'; do
        commands=$("$DOMINO" -e "$scene; tolerance details" | grep -oE "^'change [^']*'" | tr -d "'")
        [ "$(wc -l <<<"$commands")" -ge 1 ]
        while read -r command; do
            same "$scene; $command" 'all fall' "$(json "$scene; $command; verdict" | values verdict)"
        done <<<"$commands"
    done
    same 'the last row stops' 0 "$(json "$scene; verdict" | values verdict | grep -c 'all fall')"
}

@test "tolerance: radii that no effect uses change no window" {
    printf 'height (mm), thickness (mm), gap (mm), radius (mm)\n48, 8, 0, 1\n60, 9, 20, 1\n70, 10, 20, 1\n' >radii.csv
    sed 's/, [^,]*$//' radii.csv >plain.csv
    same windows "$(csv 'effect row plain.csv; effect push 6; tolerance')" "$(csv 'effect row radii.csv; effect push 6; tolerance')"
}

# bats test_tags=sweeps
@test "tolerance: 'change' agrees with the windows of boxes, whose walls keep their thickness" {
    printf 'height (mm),thickness (mm),gap (mm)\n48,10.498,0\n56.343,11.041,32.42\n84.451,12.29,38.007\n119.643,22.966,26.517\n149.523,32.78,70.316\n' > boxes.csv
    awk -F, -v OFS=, '{ print $0, NR == 1 ? "width (mm)" : 6 + NR }' boxes.csv > narrow.csv
    for row in 'effect row boxes.csv; effect walls 1 mm' 'effect row narrow.csv; effect walls 1 mm' 'effect row 5; effect walls 1 mm' 'effect row 5; effect walls 1 mm 10 cm'; do
        high=$(csv "$row; tolerance" | awk -F, '$1 == 3 { print $13 }')
        echo "$row: $high"
        "$DOMINO" -e "$row; change 3 thickness $high*0.9999 m; assert verdict" > /dev/null
        wrong "$row; change 3 thickness $high*1.0001 m; assert verdict" 'not true: all dominoes fall'
    done
}
