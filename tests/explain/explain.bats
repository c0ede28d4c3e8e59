#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Derivations of numbers: explain.

load ../shell/common

check=$root/tests/derivations/check.py

@test "the equations of 2,000 derivations, evaluated in Python, give the numbers of the library" {
    cd "$BATS_TEST_TMPDIR"
    python "$check" commands 20121 2000 >scenes.dom
    "$DOMINO" --keep-going <scenes.dom >answers.json 2>errors || true
    run python "$check" check <answers.json
    [ "$status" -eq 0 ] || { echo "$output" && false; }
    read -r scenes lines ended <<<"$output"
    echo "$output"
    [ "$scenes" -gt 1250 ] && [ "$lines" -gt 5500 ] && [ "$ended" -gt 180 ]
    # The check finds a number that is off by a hundred-millionth of its value.
    perl -pe '!$n and s/("quantity":"K".*?"value":)([0-9.e-]+)/$n = 1; $1 . $2 * 1.00000001/e' answers.json >wrong.json
    run -1 python "$check" check <wrong.json
}

@test "explain shows symbols, numbers and the result, one below the other" {
    answer=$("$DOMINO" -e 'explain theta1 0.2')
    for words in '^    theta_1 = theta \+ asin\(X\)    \(12; b8\)$' '^      = 0\.2 \+ asin\(0\.58368\)$' '^      = 0\.823253 rad$' \
        '^Tilt of the follower that leans on the head:$' '^    slope_1 = a/b    \(14; b10\)$'; do
        grep -qE "$words" <<<"$answer" || same theta1 "$words" "$answer"
    done
    same 'nothing but the equations' '8' "$(grep -c . <<<"$answer")"
    rest=$("$DOMINO" -e 'explain theta1 0.2 > /dev/null; details')
    for words in '^    X = 0\.58368: sine of the angle' "'explain theta1 0.2 deep' also shows"; do
        grep -qE "$words" <<<"$rest" || same details "$words" "$rest"
    done
    answer=$("$DOMINO" -e 'explain theta1 0.2 deep')
    for words in '^    Y = sqrt\(1 - X\^2\)' '^    X = r\*\(L\*cos\(theta\) - d\)' '^    r = 1\.5: growth'; do
        grep -qE "$words" <<<"$answer" || same deep "$words" "$answer"
    done
    same 'the numbers' "$(json 'theta1 0.2' | values theta_1)" "$(json 'explain theta1 0.2' | grep '"quantity":"theta_1"' | values value)"
    same tree 'K B' "$(json 'explain why' | grep '"quantity":"margin"' | values needs)"
    # At the largest growth the margin is 0, and r is that growth.
    close r "$(json 'rmax 0.3' | values r_max)" "$(json 'explain rmax 0.3 deep' | grep '"quantity":"r",' | values value)"
    close margin 0 "$(json 'explain rmax 0.3' | grep '"quantity":"margin"' | values value)" 1e-9
    "$DOMINO" -e 'explain rmax 0.3' | grep -qx '      = 0 mgh/2' # and no rounding error
}

# bats test_tags=lesson
@test "explain says where equations end, and has the equations of effects" {
    cd "$BATS_TEST_TMPDIR"
    "$DOMINO" -e 'effect friction 0.2; explain launch deep' | grep -q "with friction, energy is not conserved, so the equation of motion is integrated"
    # The equations of the law of motion and of the effects that are on follow, and only then.
    have=$("$DOMINO" -e 'effect friction 0.2; effect edges 0.01; explain launch deep')
    for line in '(A/2) dw/dtheta + B w = C' 'a = Y/r - L x - mu d' 'l = 1 - 2 rho'; do
        grep -qxF "    $line" <<<"$have"
    done
    [ "$("$DOMINO" -e 'effect slope 1 deg; effect walls 1 mm; explain launch' | grep -c '^with ')" -eq 0 ]
    "$DOMINO" -e 'help friction' | grep -qxF '    b = (Y + mu X)/r'
    "$DOMINO" -e 'effect edges 0.01; explain theta1 0.2' | grep -q "with rounded edges the contact is found by iteration"
    "$DOMINO" -e 'effect slope 1 deg; explain fuel' | grep -q 'cos(start_i + alpha)'
    "$DOMINO" -e 'effect slope 1 deg; explain thetac' | grep -q 'theta_u = asin(d/sqrt(1 + d^2)) - alpha    (4; b1)'
    # on a slope, a round edge rolls: the balance of its centre above the line of contact
    "$DOMINO" -e 'set d 0.16; set s 0.4; set r 1; set edges 0.03; set slope 2 deg; explain thetac' >have
    grep -qxF '    theta_u = atan((d - 2*rho)/(1 - 2*rho)) - alpha - asin(2*rho*sin(alpha)/sqrt((1 - 2*rho)^2 + (d - 2*rho)^2))' have
    grep -qx "      = $(awk 'BEGIN { alpha = 2 * atan2(0, -1) / 180; s = 0.06 * sin(alpha) / sqrt(0.94^2 + 0.1^2)
        printf "%.6g", atan2(0.1, 0.94) - alpha - atan2(s, sqrt(1 - s * s)) }') rad" have
    "$DOMINO" -e 'set fuel paper; explain fuel' | grep -q 'P = 1 - cos(theta_f) - d\*sin(theta_f)    (25; c7)'
    "$DOMINO" -e 'set s 0.6; set r 1.6; set q hollow; explain theta1 0.9' | grep -q 'slid off the head'
    "$DOMINO" -e 'explain barrier' | grep -q 'found by a search over all tilts'
}

# bats test_tags=rows
@test "explain writes files, and refuses what it cannot write" {
    cd "$BATS_TEST_TMPDIR"
    "$DOMINO" -e 'explain launch deep > a.txt; explain launch > a.csv'
    grep -q 'omega_0 = sqrt(w_0)/tau' a.txt
    same head quantity "$(head -n 1 a.csv | cut -d, -f1)"
    same 'all quantities in the equation of the answer have a row' 'd h r s seconds' \
        "$("$DOMINO" -e 'set output csv; explain duration' | cut -d, -f1 | grep -x '[dhrs]\|seconds' | sort | paste -sd ' ' -)"
    wrong 'explain foo' "unknown question 'foo'; use one of: thetac, theta1"
    wrong 'explain theta1' "'explain theta1' needs a value, for example 'explain theta1 0.2'"
    wrong 'explain theta1 3' 'outside the cycle'
    wrong 'explain why depp' "did you mean 'deep'"
    wrong 'set s 0.001; explain rmax' 'no growth is possible here'
    wrong 'set r 3; explain why' 'falls past the next domino'
}

@test "recipe: each step of the paper with its numbers, and where the program differs" {
    answer=$(json 'set q hollow; recipe')
    at() { grep "\"quantity\":\"$1" <<<"$answer" | values "$2"; }
    close 'J(0)' "$(json 'set q hollow; launch' | values J0)" "$(at 'J(0) (20' program)"
    close 'J(0), printed' "$(json 'print 1 + 1.5^-4' | values value)" "$(at 'J(0) as' paper)"
    close 'P' "$(json 'set q hollow; fuel' | values fuel_exact)" "$(at P program)"
    close 'P of the paper' "$(json 'set q hollow; fuel' | values fuel_paper)" "$(at P paper)" 1e-6
    close 'r_max' 2.06377177 "$(at 'r_max' program)" 1e-7
    close 'r_max of the paper' 2.1686 "$(at 'r_max' paper)" 1e-4
    close 'best s' 0.432413 "$(at 's at' paper)" 1e-6
    close 'best s' 0.443615 "$(at 's at' program)" 1e-6
    # The paper's search ends at the first maximum, which is at theta = 0 here.
    answer=$(json 'set q hollow; set s 0.54; set r 1.8518; set tol 1e-8; recipe')
    close 'first maximum' 0 "$(at 'H(theta_m)' paper)"
    close 'largest maximum' "$(json 'set q hollow; set s 0.54; set r 1.8518; barrier' | values barrier)" "$(at 'H(theta_m)' program)"
    grep -q 'takes the first maximum of H, and the program the largest' <<<"$answer"
    run -1 "$DOMINO" -e 'effect friction 0.1; recipe'
    grep -q "does not include friction; first enter 'set friction off'" <<<"$output"
}

# bats test_tags=rows
@test "paper: its figures, limits and relations, recomputed with both fuels" {
    answer=$(json 'set d 0.2; set q 3.5; paper') # the scene does not matter
    row() { grep "\"what\":\"$1[^\"]*\",\"q\":$2,\"s\":$3," <<<"$answer"; }
    while IFS='|' read -r what q s paper exact; do
        close "$what $q $s" "$paper" "$(row "$what" "$q" "$s" | values paper)" 1e-4
        close "$what $q $s" "$exact" "$(row "$what" "$q" "$s" | values exact)" 1e-4
    done <<END
largest growth|3|0.2|1.9130|1.5548
largest growth|3|0.4|2.1686|2.0638
maximum of the curve: separation|3|null|0.432413|0.443615
maximum of the curve: growth|3|null|2.202558|2.172869
maximum of the curve: separation|4|null|0.520419|0.533651
maximum of the curve: growth|4|null|1.831348|1.810436
two dominoes: largest growth|3|0.4|2.04654|2.04654
112 m tower: dominoes, r = 1.5|4|null|20|20
END
    same differences '(25; c7) leaves out the weights r^(-q i)' "$(row 'largest growth' 3 0.2 | values why)"
    same 'no difference' '0' "$(row 'largest growth: the reach' 3 0.8 | values difference)"
    "$DOMINO" -e 'paper details' | grep -q 'A rigid-body engine agrees with the exact values'
}

@test "explain names the terms of sums, and says when a quantity has no value" {
    "$DOMINO" -e 'explain fuel details' | grep -q '^    next_i: tilt of domino i when the head hits the next domino, at theta_c$'
    answer=$("$DOMINO" -e 'set s 0.05; explain why')
    grep -q "^      = no value: this train has no complete cycle; 'why' says more" <<<"$answer"
    ! grep -qi 'nan' <<<"$answer"
    same 'in json' null "$(json 'set s 0.05; explain why' | head -n 1 | values value)"
    # Each name that a quantity needs has its own row.
    json 'explain omega 0.1 deep' >tree
    for name in $(values needs <tree | tr ' ' '\n' | sort -u); do
        grep -q "\"quantity\":\"$name\"" tree || same needs "$name" '(nothing)'
    done
}

@test "explain takes the label or the number of an equation, and its value is that of the command" {
    while IFS='|' read -r label number quantity command; do
        answer=$(json "explain $label 0.2" 2>/dev/null || json "explain $label")
        close "$label" "$(json "print $command" | values value)" "$(grep "\"quantity\":\"$quantity\"" <<<"$answer" | head -n 1 | values value)" 1e-12
        for word in "$number" "($label)" "($number)"; do
            same "$word" "$(json "explain $label")" "$(json "explain $word")"
            same "$word, in words" "$("$DOMINO" -e "explain $label")" "$("$DOMINO" -e "explain $word")"
        done
    done <<'END'
a1|1|tau|duration.tau
a2|2|theta_c|thetac.theta_c
b1|4|theta_u|thetac.theta_u
b8|12|theta_1|theta1(0.2).theta_1
c6|24|w_0|launch.omega0sq
c7|25|P|fuel.fuel
A18|42|theta_f|thetac.theta_f
END
    # All equations of the paper answer, in the order of the man page.
    answers=$("$DOMINO" -e "$(printf 'set output json; '; printf 'explain %s; ' {1..59})")
    labels=$(sed -n '/^no\.  label/,/^\.Ed/s/^[0-9][0-9]*  *\([a-eA][0-9]*\) .*/\1/p' "$root/man/domino-model.7")
    same labels 59 "$(wc -l <<<"$labels")"
    same 'by label' "$answers" "$("$DOMINO" -e "set output json; $(sed 's/.*/explain &;/' <<<"$labels")")"
    same 'the answer has no empty value' 0 "$(grep '"depth":0' <<<"$answers" | grep -c '"value":null')"
    close 'collision' "$(json 'print launch.J0*launch.omega0' | values value)" "$(json 'explain c4' | grep c4_right | values value)" 1e-11
    wrong 'explain 99' 'the paper has no equation \(99\), only \(1; a1\) to \(59; e8\)'
    wrong 'set friction 0.2; explain c4' "equation \(c4\) does not include friction; first enter 'set friction off'"
    wrong 'set s 0.05; explain b4' '\(5; b0\) does not hold: domino 1 hits before it tips over'
    wrong 'set s 0.6; set r 1.6; set q hollow; explain A9 0.9' 'domino 2 has slid off domino 1'
    wrong 'explain P' "unknown question 'P'.*; an equation is named by its label in the paper, as in 'explain c7'$"
}

@test "explain: corrected equations say what the paper prints, and (41; A17) whether it holds" {
    while IFS='|' read -r commands words; do
        run -0 "$DOMINO" -e "$commands"
        grep -qF -- "$words" <<<"$output" || same "$commands" "$words" "$output"
    done <<'END'
explain c7|(corrected):
explain c7|      = 0.592292 mgh/2
explain c8|The condition as the paper prints it, without the factor J(0) of K:
explain d6|(corrected: the paper prints sine and cosine swapped):
explain A17|(41; A17), which does not hold: no follower slides off
explain A18|      = 0.99084
set r 3; set s 0.3; explain A18|(41; A17), which holds: followers slide off
explain rmax|which 'why' explains
END
}

# bats test_tags=rows,chance,engine
@test "effects: its list, its details, and the method of the scene" {
    # 'effects' lists all of them, and each random error that is on; its details have sources.
    run -0 "$DOMINO" -e 'effect row 3; effect error_mass 1 %; effects'
    [ "${#lines[@]}" -le 24 ]
    same 'a random error' 'error_mass' "$(sed -n 's/^\(error_[a-z]*\) .*/\1/p' <<<"$output")"
    "$DOMINO" -e 'effects > /dev/null; details' | grep -q 'Am\. J\. Phys'
    # 'effects' names the method that each effect needs, and that of the scene.
    for method in 'energy balance|slope 1 deg' 'equation of motion|friction 0.1; effect row 3' 'rigid-body engine|row 2; effect push 9; effect feet 0.5'; do
        "$DOMINO" -n -e "effect ${method#*|}; effects" | grep -q "computed by the ${method%|*}\.$"
    done
    local on='effect row 3; effect feet 1; effect error_floor 1; effect error_mass 1 %; effects'
    same 'method of each' 'motion balance balance balance engine engine' "$(json "$on" |
        jq -r 'select(.effect | IN("friction", "slope", "floor", "feet", "error_mass", "error_floor")).method' | paste -sd ' ')"
    same 'air' 'motion motion' "$(json 'effects' | jq -r 'select(.effect == "air" or .effect == "drag").method' | paste -sd ' ')"
}
