#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Units: with numbers, in products, after "to", in columns of tables; angles in degrees.

load common

# Prints the value and the unit of a key in a table.
shown() { # KEY COMMANDS
    "$DOMINO" -e "$2" | awk -v key="$1" '$1 == key { print $2, $3 }'
}

# bats test_tags=sweeps
@test "s and d as lengths are divided by h" {
    same 's' "$(json 'set s 0.5; set d 7/48; duration')" "$(json 'set s 2.4 cm; set d 7 mm; duration')"
    same 'of another h' 0.25 "$(json 'set h 8 cm; set s 2 cm; show s' | values value)"
    same 'as an argument' "$(json 'rmax 0.5')" "$(json 'rmax 24 mm')"
    same 'in a grid' "$(json 'sweep s 0.25, 0.5 : rmax')" "$(json 'sweep s 12 mm, 24 mm : rmax')"
    wrong 'set s 2 ms' 's is a plain number, not a time'
    wrong 'set r 2 cm' 'r is a plain number, not a length'
}

@test "units: with and without a blank, products and powers" {
    all_worth <<'END'
0.03|m|3 cm
0.3048|m|1 ft
0.009525|m|3/8 in
0.01905|m|2*3/8 in
0.5|m s^-1|1 / 2 m/s
1|-|h/48 mm
25|m s^-1|90 km/h
0.00694444444444|m s^-2|90 km/h^2
10800|s|3 hours
0.005|kg|(2 + 3) g
0.038349523125|kg|10 g + 1 oz
600|kg m^-3|0.6 g/cm^3
0.0048929663608562693|s^2|h/g
0.00981|kg m s^-2|1 g*g
1.5707963267948966|rad|90 deg
0|rad|180 deg - pi
END
}

# bats test_tags=sweeps
@test "set and arguments take numbers as people write them, with units" {
    while IFS='|' read -r name text value; do
        close "set $name $text" "$value" "$(json "set $name $text; show $name" | values value)"
    done <<'END'
d|7 mm / 48 mm|0.14583333333333334
mass|600 kg/m^3 * 7 mm * 24 mm * 48 mm|0.0048384
density|0.6 g/cm^3|600
g|2 * 4.905 m / (1 s)^2|9.81
END
    same 'count 0.112 km 4/2' "$(json 'count 112 2')" "$(json 'count 0.112 km 4/2')"
    same 'curve' "$(json 'curve 0.25 0.5 3')" "$(json 'curve 1/4 (s+0.1) 6/2')"
}

# bats test_tags=rows
@test "a rotation may be given as a frequency, since radians are often left out; a growth that is nearly 1 is not shown as 1" {
    same 'push' "$("$DOMINO" -n -e 'set output csv; effect row 6; effect push 8 rad*sqrt(g/h); verdict')" \
        "$("$DOMINO" -n -e 'set output csv; effect row 6; effect push 8*sqrt(g/h); verdict')"
    says 'count 1e9 m 1.0000001 details' 'each 1.0000001 times as large'
}

# bats test_tags=sweeps
@test "units of kinds that do not fit: the message names both kinds" {
    all_wrong <<'END'
7|count 112 deg|^count: H is a length, not an angle
7|count 3 m^2|^count: H is a length, not in m\^2
7|set r h|^set: r is a plain number, not a length
10|set mass 3 mm|^set: mass is a mass, not a length; enter a value such as '10 g'$
7|set h 10 g|^set: h is a length, not a mass; enter a value such as '48 mm'$
13|set density 5 kg|^set: density is a density, not a mass; enter a value such as '600 kg/m\^3'$
7|set q 3 kg|^set: q is a plain number, not a mass; enter it without a unit$
13|set mass 10 kgs|^set: 'kgs' is not a unit; did you mean 'kg'
7|print sqrt(4 kg)|^print:.*sqrt of a value with this unit is not defined
8|theta1 0.1 rad * 1 rad|^theta1: T is an angle, not in rad\^2
11|count 112 2 m|^count: R is a plain number, not a length
7|curve 0.1 m 0.3 3|^curve: FROM = 2.08333[0-9]* is out of range; FROM is a value of s
11|print 1 m + 1 s|^print:.*a length and a time
7|print sin(1 m)|^print:.*sin of a length
7|print max(1 m, 1 s)|^print:.*max .* two
13|print (2 m)^0.5|^print:.*exponent
END
}

@test "angle: input and output" {
    deg() { awk -v x="$1" 'BEGIN { printf "%.17g", x * 180 / atan2(0, -1) }'; }
    while IFS='|' read -r command keys others; do
        rad=$(json "$command")
        answer=$(json "set angle deg; $command")
        for key in $keys; do
            close "$command: $key" "$(deg "$(values "$key" <<<"$rad")")" "$(values "$key" <<<"$answer")"
        done
        for key in $others; do # these values do not change
            same "$command: $key" "$(values "$key" <<<"$rad")" "$(values "$key" <<<"$answer")"
        done
    done <<'END'
thetac|theta_c theta_u theta_inf theta_f|
set r 2; thetac|theta_leave|
theta1 10 deg|theta theta_1|slope
energy 0.1 rad|theta|J
omega 0.1 rad|theta omega|
launch|omega0|kinetic
barrier|theta_m|kinetic
END
    close csv 10 "$(csv 'set angle deg; theta1 10 deg' | sed -n '2s/,.*//p')"
    same 'a value has its unit with it' "$(json 'set angle deg; theta1 thetac.theta_c')" \
        "$(json 'set angle deg; theta1 thetac')"
    answer=$("$DOMINO" -e 'set angle deg; thetac; launch; chain 10')
    for line in '^theta_c *36\.8699 deg ' '^omega0 .*deg/s' '^  *deg '; do
        grep -q "$line" <<<"$answer" || same deg "$line" "$answer"
    done
    same 'no radians' '(nothing)' "$(grep -w rad <<<"$answer")"
    theta_c=$(json 'set angle deg; thetac' | values theta_c)
    wrong 'set angle deg; theta1   37' ":25: .*T = 37 deg .* \[0, ${theta_c:0:15}[0-9]*\]"
    same 'both ends' 2 "$(json "set angle deg; theta1 0; theta1 $theta_c" | grep -c '"theta_1":[0-9]')"
}

@test "a message suggests the right unit after a misspelling, and functions and units are help topics" {
    wrong_at 11 'theta1 10 dge' "^theta1: 'dge' is not a unit; did you mean 'deg'"
    wrong_at 9 'print 3 furlong' "^print: 'furlong' is one argument too many"
    for topic in sin pi cm units ans; do "$DOMINO" -e "help $topic" | grep -q '^print VALUE'; done
}

# bats test_tags=rows,chance,sweeps,engine
@test "units as words, singular and plural; decimal commas and percent are explained" {
    same words '0.0508 0.6096 2.7432 0.005 0.05 1.5708' "$(printf '%s\n' '2 inch' '2 feet' '3 yards' '5 grams' '50 millimetres' '90 degrees to rad' |
        "$DOMINO" | awk 'NF { print $1 }' | paste -sd ' ' -)"
    same percent '0.95 1.05 0.3' "$(printf '%s\n' '95%' '1 + 5 %' '2 * 15 %' | "$DOMINO" | awk 'NF { print $1 }' | paste -sd ' ' -)"
    same 'the effect of this name goes on with a grid' '0.4 0.6 0.4 0.6' \
        "$(json 'effect row 6; sweep push 5 9 2 feet 0.4 0.6 2 : print h' | values feet | paste -sd ' ' -)"
    all_wrong <<'END'
8|set s 0,3|^set: unexpected ',3' after the value of s; use a decimal point, as in 0\.5$
10|count 112,5 m|^count: unexpected ',5 m' after the value of H; use a decimal point
29|print rmax with friction 0.2, s 0.3|^print: unexpected ', s 0.3' after the value of MU; separate values by blanks
END
}

@test "'to' converts" {
    all_print <<'END'
rmax to percent|164.423 %
set angle deg; print sin(90)|1
set angle deg; print atan(1)|45 deg
0.9*rmax(0.3) to %|136.301 %
600 kg/m^3 to g/cm^3|0.6 g/cm^3
thetac to deg|36.8699 deg
print duration.speed to mm/s|214.37 mm/s
END
    same json '{"value":10000,"unit":"mm"}' "$(json '10 m to mm')"
    wrong '112 m to s' 'the value is a length, but 1 s is a time'
    wrong '5 to m/s' 'the value is a plain number, but 1 m/s is in m s\^-1'
    wrong '112 m to fot' "'fot' is not a unit; did you mean 'ft'"
    wrong '112 m to' "the unit after 'to' is missing; enter, for example, 'print 112 m to ft'"
    wrong '112 m ti ft' "'ti' is one argument too many; usage: print VALUE"
    wrong '112 m to ft 3' "'3' is one argument too many"
    wrong 'rmax to m/h' "'m/h' is not a unit"
}

# bats test_tags=rows,sweeps
@test "tables show lengths in mm, cm or m, and masses in g or kg; csv and json always have m and kg" {
    local pair
    for pair in '9.99 mm|9.99 mm' '10 mm|1 cm' '4.8 cm|4.8 cm' '99.9 cm|99.9 cm' '1 m|1 m' '112 m|112 m' '0.001 mm|0.001 mm'; do
        same "${pair%|*}" "${pair#*|}" "$(shown height "count ${pair%|*} details")"
    done
    same csv 0.048 "$("$DOMINO" -e 'set output csv; count 1 m' | tail -n 1 | cut -d , -f 5)"
    # A column has a single unit, which fits the largest value.
    same 'a row in tables' '4.8 0.7 0
7.2 1.05 2.88' "$("$DOMINO" -e 'effect row 2; row' | awk 'NR > 2 { print $2, $3, $4 }')"
    same 'a row for programs' '0.048,0.007,0
0.072,0.0105,0.0288' "$("$DOMINO" -e 'set output csv; effect row 2; row' | tail -n 2 | cut -d , -f 2-4)"
    same 'of a longer one' 'm cm cm cm rad/s' "$("$DOMINO" -e 'sweep h 1 cm 1 m 2 : count 30 cm' | sed -n 2p | xargs)"
    same mass '10 g' "$("$DOMINO" -e 'set mass 0.01; effect row 1; row' | awk 'NR == 2 { unit = $4 } NR == 3 { print $5, unit }')"
    # Expressions use the base unit, whatever unit a table shows.
    same 'ans' 0.048 "$(json 'count 1 m; print ans.first_height' | tail -n 1 | values value)"
    # All digits are right in every unit.
    same digits '4.8 cm' "$(shown first_height 'set digits 33; set precision quad; count 1 m details')"
}

@test "exponents of units do not overflow" {
    wrong 'print ((((((1 m)^64)^64)^64)^64)^64)^4' 'the unit has an exponent above 999'
    wrong 'print ((1 kg)^64)^64' 'the unit has an exponent above 999'
    wrong 'print (1 s)^-99^1 * (1/(1 m)^99)^99' 'the unit has an exponent above 999'
    same 'below that they count' '1 m^960' "$("$DOMINO" -e 'print ((1 m)^64)^15')"
    same 'and cancel' 1 "$("$DOMINO" -e 'print ((1 m)^64)^15 / ((1 m)^60)^16')"
}

# bats test_tags=sweeps,save
@test "lengths stay lengths: the order of commands does not matter, and show and save write what was typed" {
    local name value
    for name in 's 20 mm' 'd 9 mm' 'walls 1 mm' 'edges 0.5 mm'; do
        value=$(json "set r 1; set h 24 mm; set $name; barrier" | tail -n 1)
        same "$name, then h" "$value" "$(json "set r 1; set $name; set h 24 mm; barrier" | tail -n 1)"
    done
    same 'the gap' 0.02 "$(json 'set s 20 mm; set h 24 mm; print s*h' | values value)"
    same 'one undo' "$(json 'set s 20 mm; rmax')" "$(json 'set s 20 mm; set h 24 mm; undo; rmax' | tail -n 1)"
    same 'with' "$(json 'set r 1; set h 24 mm; set s 20 mm; rmax')" "$(json 'rmax with s 20 mm h 24 mm')"
    same 'in a sweep' '0.02 0.02' "$(json 'set s 20 mm; sweep h 24 mm, 48 mm : s*h' | values value | paste -sd ' ')"
    same 'show' 's 20 mm' "$("$DOMINO" -e 'set s 20 mm; set h 24 mm; show' | awk '$1 == "s" { print $1, $2, $3 }')"
    "$DOMINO" -e 'set precision quad; set s 2.52 cm; set walls 1.1 mm; set h 252 cm; save saved.dom' >/dev/null
    same 'as many digits as were typed' 'set s 2.52 cm,set h 2.52 m,set walls 1.1 mm' "$(grep -E '^set (s|h|walls) ' saved.dom | paste -sd ,)"
    same 'saved lengths' 0.0252 "$(json 'source saved.dom; set h 1 m; set output json; print s*h' | values value | tail -n 1)"
    # Nothing impossible is set; what another height makes possible is taken.
    wrong 'set s -1 mm' 's'
    wrong 'set s 0 mm' 's'
    same 'the height follows' 0.3 "$(json 'set s 60 mm; set h 200 mm; print s' | values value)"
    wrong 'set s 60 mm; rmax' 'the separation s is outside its range'
}

# bats test_tags=rows,sweeps,planning
@test "a push may be the speed of the first domino's upper edge, and stays this speed" {
    same 'in rad/s' "$(json 'set row 5; set push 3; verdict')" "$(json 'set row 5; set push 0.144 m/s; verdict')"
    same 'another height' 1.5 "$(json 'set row 5; set push 0.144 m/s; set h 96 mm; show push' | values value | tail -n 1)"
    printf 'height (cm), thickness (cm), gap (cm)\n12, 2, -\n18, 3, 5\n' >tall.csv
    same 'another row' '1.2 0.8 3' "$(json 'set row 5; set push 0.144 m/s; set row tall.csv; show push; remove 1; show push; set row 5; show push' | values value | paste -sd ' ')"
    same 'a design' '0.144 m/s' "$("$DOMINO" -e 'set row tall.csv; set push 0.144 m/s; design 1 m; show' | awk '$1 == "push" { print $2, $3 }')"
    same 'a sweep' '3 6' "$(json 'set row 5; sweep push 0.144 m/s, 0.288 m/s : verdict' | values push | paste -sd ' ')"
    same 'undo' '14.4 cm/s' "$("$DOMINO" -e 'set row 5; set push 14.4 cm/s; set push 4; undo; show' | awk '$1 == "push" { print $2, $3 }')"
    same 'an angular velocity stays one' 3 "$(json 'set row 5; set push 1 m/s; set push 3; set h 1; show push' | values value | tail -n 1)"
    same 'the unit of the sheet' 'Push domino 1 so that its top moves at 0.144 m/s.' "$("$DOMINO" -e 'set row 5; set push 0.144 m/s; plan details' | paste -sd ' ' | grep -o 'Push domino 1 so that its top moves at 0.144 m/s\.')"
    wrong 'set row 5; set push -1 m/s' 'is out of range'
    wrong 'set row 5; set push 3 kg' 'OMEGA is in rad/s, not a mass; enter it without a unit, or as the speed of the top, such as 0.5 m/s'
}

# bats test_tags=rows,planning
@test "masses: one unit in a table, which suits the heaviest" {
    masses() { "$DOMINO" -e "$1; row" 2>/dev/null | awk 'NR == 2 { print $NF } NR > 2 && $1 ~ /^[0-9]+$/ { print $5 }' | paste -sd ' '; }
    printf 'height (cm), thickness (cm), gap (cm), mass (lb)\n24, 3.5, -, 0.76\n34, 5, 13, 2200\n' >lb.csv
    same 'pounds' 'kg 0.34473 997.903' "$(masses 'set row lb.csv')"
    same 'light' 'g 4.8384 16.3296' "$(masses 'set density 600; set row 2')"
    same 'middle' kg "$(masses 'set density 600; set row 10' | cut -d ' ' -f 1)"
    same 'heavy' t "$(masses 'set density 600; set row 15' | cut -d ' ' -f 1)"
    same 'a design' kg "$("$DOMINO" -e 'set density 600; design 3 m; details' | awk '/^domino/ { getline; print $4 }')"
    same 'programs: always kg' 0.34473 "$(json 'set row lb.csv; row' | values mass | head -n 1 | cut -c 1-7)"
}
