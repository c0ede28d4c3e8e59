#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Values as people write them: expressions with units, names and answers in them; near misses and beginnings
# of names; the settings, files after '>', save and source; completion and help.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

# Rows of VALUE|UNIT|EXPRESSION on stdin, where '-' is no unit: what print makes of them.
all_worth() {
    local value unit expression rows answers
    mapfile -t rows
    mapfile -t answers < <({ echo 'set output json'; printf 'print %s\n' "${rows[@]#*|*|}"; } | "$DOMINO")
    same 'one answer each' "${#rows[@]}" "${#answers[@]}"
    for i in "${!rows[@]}"; do
        IFS='|' read -r value unit expression <<<"${rows[i]}"
        close "$expression" "$value" "$(values value <<<"${answers[i]}")"
        [ "$unit" != - ] || unit='(nothing)'
        same "$expression: unit" "$unit" "$(values unit <<<"${answers[i]}")"
    done
}

# One error at this column of -e, nothing else on stderr, nothing more on stdout than without it.
wrong() { # COLUMN COMMANDS MESSAGE; COLUMN 0: the error is about the whole
    run --separate-stderr "$DOMINO" --keep-going -e "$2" -e 'set output json; show s'
    same "$2: status" 1 "$status"
    same "$2: lines on stderr" 1 "$(wc -l <<<"$stderr")"
    local place=-e:1:
    if [ "$1" -gt 0 ]; then place=$place$1:; fi
    same "$2: place" "$place" "${stderr%% *}"
    expects "$2" "$3"
    [[ ${stderr#* } =~ $3 ]] || same "$2" "$3" "$stderr"
    same "$2: the session goes on" 0.4 "$(tail -n 1 <<<"$output" | values value)"
    same "$2: stdout" 1 "$(bare <<<"$output" | wc -l)"
}

# Rows of COLUMN|COMMAND|MESSAGE on stdin, all in one session: one error each, in their order, and no answer.
all_wrong() {
    local column command message place rows errors i
    mapfile -t rows
    for i in "${rows[@]}"; do
        command=${i#*|}
        printf '%s\nreset\nset output json; show s\n' "${command%%|*}"
    done >"$BATS_TEST_TMPDIR/rows"
    run --separate-stderr "$DOMINO" <"$BATS_TEST_TMPDIR/rows"
    same 'status' 1 "$status"
    same 'the session goes on, and nothing else is on stdout' "${#rows[@]} 0.4" \
        "$(values value <<<"$output" | uniq -c | sed 's/^ *//')"
    same 'lines on stdout' "${#rows[@]}" "$(bare <<<"$output" | wc -l)"
    mapfile -t errors <<<"$stderr"
    same 'lines on stderr' "${#rows[@]}" "${#errors[@]}"
    for i in "${!rows[@]}"; do
        IFS='|' read -r column command message <<<"${rows[i]}"
        place=stdin:$((3 * i + 1)):
        if [ "$column" -gt 0 ]; then place=$place$column:; fi
        same "$command: place" "$place" "${errors[i]%% *}"
        expects "$command" "$message"
        [[ ${errors[i]#* } =~ $message ]] || same "$command" "$message" "${errors[i]}"
    done
}

# Prints TEXT COUNT times: twice as much in each step, since a million of printf take their time.
repeat() { # TEXT COUNT
    awk -v text="$1" -v n="$2" 'BEGIN {
        for (many = text; n > 0; many = many many) { if (n % 2) printf "%s", many; n = int(n / 2) } }'
}

# ---- Expressions ----

@test "numbers, precedence, signs, powers and parentheses" {
    all_worth <<'END'
1|-|1
0.5|-|.5
5|-|5.
1500|-|1.5e3
0.0025|-|2.5E-3
5.5|-|.5 + 5.
14|-|2 + 3 * 4
20|-|(2 + 3) * 4
14|-|2 * ( 3 + 4 )
19.5|-|(2+3)*4-1/2
3|-|8 - 3 - 2
0.25|-|1/2/2
9|-|6/2*3
1|-|6/(2*3)
50|-|2+3*4^2
-4|-|-2^2
4|-|(-2)^2
512|-|2^3^2
64|-|(2^3)^2
0.5|-|2^-1
0.25|-|2 ^ -2
1.4142135623730951|-|2^0.5
-6|-|2*-3
-2|-|-(2)
1|-|--1
5|-|2--3
-1|-|+-+1
1|-|((((1))))
0.14583333333333334|-|0.7/4.8
0.3|-|0.1+0.2
7e-17|-|7/1e17
END
}

@test "functions and pi" {
    all_worth <<'END'
3.1415926535897931|-|pi
0.17453292519943295|-|pi/18
1|-|sin(pi/2)
1|-|sin(90 deg)
0.5|-|cos(60 deg)
1|-|tan(45 deg)
1.5707963267948966|rad|asin(1)
1.0471975511965979|rad|acos(0.5)
0.78539816339744828|rad|atan(1)
2.3561944901923448|rad|atan2(1, -1)
2.3561944901923448|rad|atan2(1 m,-1 m)
2.7182818284590451|-|exp(1)
2|-|ln(exp(2))
2|-|log(exp(2))
3|-|log10(1000)
3|-|sqrt(9)
2|m|sqrt(4 m^2)
3|-|abs(-3)
3|m|abs(-3 m)
-3|-|floor(-2.5)
-2|-|ceil(-2.5)
3|-|round(2.7)
5|-|hypot(3, 4)
5|m|hypot( 3 m , 4 m )
1|-|min(1,2)
2|-|max(1,2)
0.01|m|min(1 cm, 2 cm)
0.5|-|sin( asin( 0.5 ) )
4|-|max(1,2)*min(3,2)
END
}

@test "units: with and without a blank, their products and powers" {
    all_worth <<'END'
3|m|3 m
0.003|m|3mm
0.03|m|3 cm
3000|m|3 km
0.0762|m|3 in
0.3048|m|1 ft
0|m|12 in - 1 ft
0.9144|m|1 yd
2|kg|2 kg
0.01|kg|10 g
0.01|kg|10g
0.005|kg|(2 + 3) g
2000|kg|2 t
0.45359237|kg|1 lb
0.028349523125|kg|1 oz
0.038349523125|kg|10 g + 1 oz
0|kg|16 oz - 1 lb
600|kg m^-3|600 kg/m^3
600|kg m^-3|0.6 g/cm^3
2|kg|sqrt(4 kg^2)
0.002|kg|min(1 kg, 2 g)
5|-|5 g / 1 g
9.81|m s^-2|g
19.62|m s^-2|2*g
0.0048929663608562693|s^2|h/g
0.0048929663608562693|s^2|4.8 cm/g
9.81|m^2 s^-2|1 m*g
9.81|kg m s^-2|1 kg*g
0.00981|kg m s^-2|1 g*g
2|s|2 s
0.002|s|2 ms
2|rad|2 rad
1.5707963267948966|rad|90 deg
1.1|m|10 cm + 1 m
250|-|10 m/4 cm
5|m s^-1|5 m/s
9.81|m s^-2|981 cm/s^2
9.81|m s^-2|9.81 m*s^-2
5|m^2|5m^2
25|m^2|(5 m)^2
0.0004|m^2|4 cm^2
0.5|m s^-1|1 m/2 s
6|m|2 * 3 m
0.05|m|(2 + 3) cm
90|-|asin(1) / 1 deg
0|rad|180 deg - pi
0.5|-|24 mm / 4.8 cm
END
}

@test "set and arguments take values with units" {
    while IFS='|' read -r name text value; do
        close "set $name $text" "$value" "$(json "set $name $text; show $name" | values value)"
    done <<'END'
d|0.7/4.8|0.14583333333333334
d|7 mm / 48 mm|0.14583333333333334
d|7 mm/h|0.14583333333333334
h|4.8 cm|0.048
h|48mm|0.048
h|1 ft|0.3048
h|1.5|1.5
mass|10 g|0.01
mass|2 oz|0.05669904625
mass|0.01|0.01
mass|600 kg/m^3 * 7 mm * 24 mm * 48 mm|0.0048384
density|600 kg/m^3|600
density|0.6 g/cm^3|600
density|600|600
g|9.81 m/s^2|9.81
g|981 cm/s^2|9.81
g|2 * 4.905 m / (1 s)^2|9.81
s|0.5 * 0.6|0.3
s|3/2 - 1|0.5
tol|10^-9|1e-9
q|hollow|3
q|7/2|3.5
digits|2*4|8
END
    same 'theta1 10 deg' "$(json "theta1 pi/18")" "$(json 'theta1 10 deg')"
    same 'theta1 10deg' "$(json "theta1 pi/18")" "$(json 'theta1 10deg')"
    close 'rmax 0.9*s' "$(json 'rmax 0.36' | values r_max)" "$(json 'rmax 0.9*s' | values r_max)"
    same 'count 112 m' "$(json 'count 112')" "$(json 'count 112 m')"
    same 'count 11200 cm' "$(json 'count 112')" "$(json 'count 11200 cm')"
    same 'count 0.112 km 4/2' "$(json 'count 112 2')" "$(json 'count 0.112 km 4/2')"
    same 'curve' "$(json 'curve 0.25 0.5 3')" "$(json 'curve 1/4 (s+0.1) 6/2')"
}

@test "where a value ends: '1 - 0.5' is one, '0.1 -0.5' are two" {
    all_worth <<'END'
0.5|-|1 - 0.5
0.5|-|1-0.5
0.5|-|1- 0.5
1.5|-|1 + 0.5
0.5|-|1 /2
2|-|1 *2
END
    all_wrong <<'END'
12|theta1 0.1 -0.5|^theta1: '-0.5' is one argument too many
9|print 1 -0.5|^print: '-0.5' is one argument too many
9|print 1 +0.5|^print: '\+0.5' is one argument too many
9|print 1 2|^print: '2' is one argument too many
9|print 2 pi|^print: 'pi' is one argument too many
9|print 2 (3)|^print: '\(3\)' is one argument too many
END
    same 'one argument' "$(json 'count 111')" "$(json 'count 112 - 1')"
    same 'two arguments' "$(json 'count 112 2')" "$(json 'count 112 +2')"
    same 'two words of an expression' "$(json 'curve 0.05 0.3 3')" "$(json 'curve 0.1 - 0.05 0.3 3')"
}

@test "parameters, commands and answers are names" {
    all_worth <<'END'
0.4|-|s
0.048|m|h
9.81|m s^-2|g
4|-|q
0.6|-|r * s
20.833333333333333|m^-1|1/h
END
    # Each against what the command itself answers.
    while IFS='|' read -r expression command key unit; do
        all_worth <<<"$(json "$command" | values "$key")|${unit}|$expression"
    done <<'END'
thetac|thetac|theta_c|rad
thetac.theta_u|thetac|theta_u|rad
theta1(0.1)|theta1 0.1|theta_1|rad
theta1(10 deg)|theta1 10 deg|theta_1|rad
theta1(0.1).slope|theta1 0.1|slope|-
energy(0.1)|energy 0.1|dH|-
energy(0.1).J|energy 0.1|J|-
fuel|fuel|fuel|-
fuel.fuel_paper|fuel|fuel_paper|-
launch|launch|omega0sq|-
launch.omega0|launch|omega0|s^-1 rad
omega(0.1)|omega 0.1|omega|s^-1 rad
barrier|barrier|barrier|-
barrier.margin|barrier|margin|-
duration|duration|duration|-
duration.seconds|duration|seconds|s
duration.speed|duration|speed|m s^-1
rmax|rmax|r_max|-
rmax(0.3)|rmax 0.3|r_max|-
rmax(s/2)|rmax 0.2|r_max|-
rmax(0.3).r_max_paper|rmax 0.3|r_max_paper|-
pair|pair|r_max|-
pair(0.3)|pair 0.3|r_max|-
best.s|best|s|-
best.r_max|best|r_max|-
count(112)|count 112|dominoes|-
count(112 m, 2)|count 112 2|dominoes|-
count(112, 2).exact|count 112 2|exact|-
count(112, 2).last_height|count 112 2|last_height|m
END
    close 'nested' "$(json 'rmax 0.2' | values r_max)" "$(json 'print rmax(rmax(0.3)/rmax(0.3)/5)' | values value)"
    close 'set r rmax' "$(json rmax | values r_max)" "$(json 'set r rmax; show r' | values value)"
    close 'set r 0.99*rmax' "$(json 'print 0.99*rmax' | values value)" "$(json 'set r 0.99*rmax; show r' | values value)"
    same 'the train just goes on' 'goes on' "$(json 'set r 0.999*rmax; barrier' | values verdict)"
    same 'and just stops' 'stops' "$(json 'set r 1.001*rmax; barrier' | values verdict)"
    same 'theta1 thetac' "$(json "theta1 $(json thetac | values theta_c)")" "$(json 'theta1 thetac')"
}

@test "ans is the last answer, ans.KEY a number of it" {
    while IFS='|' read -r commands expression command key; do
        expected=$(json "$command" | values "$key")
        close "$commands; $expression" "$expected" \
            "$(json "$commands; print $expression" | tail -n 1 | values value)"
    done <<'END'
rmax|ans|rmax|r_max
rmax|ans.r_max|rmax|r_max
rmax|ans.s|rmax|s
rmax 0.3|ans.r_max_paper|rmax 0.3|r_max_paper
barrier|ans.margin|barrier|margin
count 112|ans|count 112|dominoes
count 112|ans.exact|count 112|exact
theta1 10 deg|ans.theta|theta1 10 deg|theta
thetac; set s 0.3|ans|thetac|theta_c
rmax; foo|ans|rmax|r_max
rmax; theta1 9|ans|rmax|r_max
rmax; print pair(0.3)|ans|pair 0.3|r_max
rmax; print pair(0.3)|ans.r_max|rmax|r_max
rmax 0.3; set s 0.4 + 0*rmax|ans|rmax 0.3|r_max
fuel > /dev/null|ans|fuel|fuel
END
    same 'as an argument' "$(json "set s 0.3; rmax $(json fuel | values fuel)")" \
        "$(json 'fuel; set s 0.3; rmax ans' | tail -n 1)"
    same 'an angle' "$(json 'theta1 theta1(0.1)/2' | tail -n 1)" "$(json 'theta1 0.1; theta1 ans/2' | tail -n 1)"
    # What has no value is not worth anything.
    run -1 --separate-stderr json 'set s 0.001; rmax; set r ans'
    [[ $stderr =~ ^-e:1:.*'does not exist' ]] || same 'no growth' 'does not exist' "$stderr"
}

@test "the field's letters are accepted, wherever they are typed" {
    all_worth <<'END'
3.1415926535897931|-|π
0.43633231299858238|rad|25°
-1|-|−1
6|-|2 × 3
6|-|2·3
1.5|-|3÷2
9|-|3²
2|-|5 − 3
9.81|m s^-2|9.81 m/s²
END
    same 'θ1' "$(json 'theta1 0.1')" "$(json 'θ1 0.1')"
    same 'θc' "$(json thetac)" "$(json 'θc')"
    same '°' "$(json 'theta1 10 deg')" "$(json 'theta1 10°')"
    same 'a blank that does not break' "$(json 'theta1 0.1')" "$(json $'theta1\u00a00.1')"
    printf '\357\273\277set output json\r\nset s 0.3\r\nfuel' >"$BATS_TEST_TMPDIR/bom"
    same 'byte order mark, CRLF, no last newline' "$(json 'set s 0.3; fuel')" "$("$DOMINO" "$BATS_TEST_TMPDIR/bom" 2>&1)"
}

# ---- What is wrong with a value ----

@test "a rotation may be given as a frequency, since radians are often left out; a growth that is nearly 1 is not shown as 1" {
    same 'push' "$("$DOMINO" -n -e 'set output csv; effect row 6; effect push 8 rad*sqrt(g/h); verdict')" \
        "$("$DOMINO" -n -e 'set output csv; effect row 6; effect push 8*sqrt(g/h); verdict')"
    run "$DOMINO" -n -e 'count 1e9 m 1.0000001'
    [[ $output == *'each 1.0000001 times as large'*'Falling with growth 1.0000001'* ]]
}

@test "kinds that do not fit: both are named" {
    all_wrong <<'END'
7|count 112 deg|^count: H is a length, not an angle
7|count 3 s|^count: H is a length, not a time
7|count 3 m^2|^count: H is a length, not in m\^2
7|set s 3 m|^set: s = 62.5 is out of range
7|set s 0.3 rad|^set: s is a plain number, not an angle
7|set r h|^set: r is a plain number, not a length
7|set h 3 s|^set: h is a length, not a time
0|set h 5|^set: a height of 5 without a unit would be 5 m, and it is 4\.8 cm now; write 'set h 5 m'
0|set h 1e-4|^set: a height of 0\.0001 without a unit would be 0\.1 mm
23|effect row 6; place 5 +1 cm|^place: GAP is the gap itself, not a change of it; leave out the '[+]'$
7|set h 3 m/s|^set: h is a length, not in m s\^-1
10|set mass 3 mm|^set: mass is a mass, not a length; enter one such as '10 g'$
7|set h 10 g|^set: h is a length, not a mass; enter one such as '48 mm'$
13|set density 5 kg|^set: density is a density, not a mass; enter one such as '600 kg/m\^3'$
7|set s 3 g|^set: s is a plain number, not a mass; enter it without a unit, or as a length$
7|set q 3 kg|^set: q is a plain number, not a mass; enter it without a unit$
13|set mass 10 kgs|^set: 'kgs' is not a unit; did you mean 'kg'
11|print 1 g + 1|^print:.*a mass and a plain number
7|print sqrt(4 kg)|^print:.*sqrt of this is not defined
7|print max(1 kg, 2)|^print:.*max needs two values of the same kind
7|set g 3 m|^set: g is in m s\^-2, not a length
7|set q 1 m|^set: q is a plain number, not a length
9|set tol 1 ms|^set: tol is a plain number, not a time
12|set digits 3 m|^set: digits is a plain number, not a length
8|theta1 0.1 m|^theta1: T is an angle, not a length
8|theta1 h|^theta1: T is an angle, not a length
6|rmax 10 deg|^rmax: S is a plain number, not an angle
9|pair    1 s|^pair: S is a plain number, not a time
11|count 112 2 m|^count: R is a plain number, not a length
7|curve 0.1 m 0.3 3|^curve: FROM = 2.08333[0-9]* is out of range; FROM is a value of s
15|curve 0.1 0.3 3 s|^curve: N is a plain number, not a time
11|print 1 m + 1 s|^print:.*a length and a time
11|print 1 m + 1|^print:.*a length and a plain number
8|print h+g|^print:.*a length and in m s\^-2
11|print 1 s - 1 m|^print:.*a time and a length
7|print sin(1 m)|^print:.*sin of a length
7|print exp(1 deg)|^print:.*exp of an angle
7|print ln(2 s)|^print:.*ln of a time
7|print max(1 m, 1 s)|^print:.*max .* two
9|print 2^(1 m)|^print:.*exponent
13|print (2 m)^0.5|^print:.*exponent
END
}

@test "the square of an angle is no angle, and is called what it is" {
    wrong 8 'theta1 0.1 rad * 1 rad' '^theta1: T is an angle, not in rad\^2'
}

@test "where an expression is wrong: the column, also after letters of several bytes" {
    all_wrong <<'END'
7|print foo|^print:.*'foo' has no value
11|print 1 + foo|^print:.*'foo' has no value
11|print π + foo|^print:.*'foo' has no value
13|print π×2 − foo|^print:.*'foo' has no value
7|print é|^print:.*'é'
11|print 2 × é|^print:.*'é'
19|fuel > /dev/null; foo|^unknown command 'foo'
10|θ1 0.1 > foo bar|^theta1: only one word
7|θ1 0.1é|^theta1:.*'é'
11|print 1 + |^print:.*missing at the end
7|print *2|^print:.*'\*2'.*missing|^print:.*missing.*'\*2'
11|print 2 * )|^print:.*missing
7|print (1+2|^print:.*'\(' is never closed
9|print 1*(2*(3)|^print:.*'\(' is never closed
8|print 1)|^print:.*'\)'
8|print 2q|^print:.*'q' is not a unit
8|print 3foo|^print:.*'foo' is not a unit
10|print 0.4.1|^print:.*'.1'
8|print 1,5|^print:.*',5'
8|print 1/0|^print:.*division by zero
12|print 1 + 1/(2-2)|^print:.*division by zero
7|print sqrt(-1)|^print:.*sqrt
7|print ln(0)|^print:.*finite
7|print asin(2)|^print:.*finite
9|print 10^5000|^print:.*finite
11|print (-8)^0.5|^print:.*finite
7|print 1e5000|^print:.*too large
11|print 1 + 1e-5000|^print:.*too small
7|print sin()|^print:.*sin takes 1 value
7|print sin(1,2)|^print:.*sin takes 1 value
7|print atan2(1)|^print:.*atan2 takes 2 values
7|print rmax(1,2)|^print:.*2 values for 'rmax \[S\]'
7|print theta1|^print:.*0 values for 'theta1 T'
12|print rmax(foo)|^print:.*'foo' has no value
7|print output|^print:.*'output' has no value
7|print set|^print:.*'set' has no value
7|print chain|^print:.*'chain' has no value
7|print nan|^print:.*'nan' has no value
7|print inf|^print:.*'inf' has no value
7|print 0x10|^print:.*decimal number
7|print "1"|^print:.*'"1"'
7|print rmax.foo|^print:.*unknown key of rmax 'foo'
7|print rmax.ends_by|^print:.*rmax.ends_by is the word 'barrier'
7|print pair(0.1)|^print:.*does not exist here: 'pair' says why
11|print 2 + thetac.theta_leave|^print:.*does not exist here: 'thetac' says why
END
    wrong 7 'print ans' '^print:.*no earlier answer'
    wrong 7 'print ans.r_max' '^print:.*no earlier answer'
}

@test "a ',' with no value after it" {
    all_wrong <<'END'
17|print rmax(0.3, )|^print:.*missing
13|print sin(1,)|^print:.*missing
11|print sin(,1)|^print:.*missing
END
}

@test "what is neither a comment nor an argument is not skipped" {
    # A comment begins at a blank, or at the beginning.
    wrong 8 'print 2#3' "^print:.*'#3'"
    wrong 10 'set s 0.3#4' "^set:.*'#4'"
    same 'a comment' 2 "$(json 'print 2 #3; print 4' | values value)"
}

@test "what makes no sense deep down or a megabyte long: one line, no crash" {
    deep() { # BEGIN REPEATED COUNT END
        printf '%s' "$1" >"$BATS_TEST_TMPDIR/deep"
        repeat "$2" "$3" >>"$BATS_TEST_TMPDIR/deep"
        printf '%s\nset output json; show s\n' "$4" >>"$BATS_TEST_TMPDIR/deep"
        run --separate-stderr "$DOMINO" --keep-going "$BATS_TEST_TMPDIR/deep"
        same "$1$2...: status" "${5:-1}" "$status"
        same "$1$2...: the session goes on" 0.4 "$(tail -n 1 <<<"$output" | values value)"
        [ "${5:-1}" -eq 0 ] || same "$1$2...: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [ "${#stderr}" -lt 400 ] || same "$1$2...: length" '< 400' "${#stderr}"
    }
    deep 'print ' '(' 10000 1
    deep 'print ' '(' 10000 "1$(repeat ')' 10000)"
    for text in '(' '-' '2^' 'sin(' 'rmax(' 'a' '9' '.' 'θ' '1-(' ')' '1,' '1 ' '"' 'ans.' '*' '/' '1e'; do
        deep 'print ' "$text" 10000 1
        deep 'print ' "$text" 1000000 ''
    done
    deep 'set s ' 'é' 1000000 ''
    deep 'theta1 ' '1 m' 1000000 ''
    deep 'fuel > ' 'a' 1000000 ''
    deep 'save ' 'a' 1000000 ''
    deep 'help ' 'a' 1000000 ''
    deep 'apropos ' 'a' 1000000 ''
    deep '' 'θ' 1000000 ''
    # What is long, but right.
    deep 'print ' '1+' 100000 1 0
    deep 'print 1' ' ' 1000000 '' 0
    deep 'print 0.5' '0' 1000000 '' 0
    deep 'complete ' 'a' 1000000 '' 0
    deep 'complete set s ' '(' 1000000 '' 0
    close 'a sum of a hundred thousand' 100001 \
        "$({ echo 'set output json'; printf 'print '; repeat 1+ 100000; echo 1; } |
            "$DOMINO" | values value)"
}

@test "a NUL byte in an expression" {
    printf 'set output json\nprint 1\0002\nprint 3\n' >"$BATS_TEST_TMPDIR/nul"
    run -1 --separate-stderr "$DOMINO" --keep-going "$BATS_TEST_TMPDIR/nul"
    same 'the other line' 3 "$(values value <<<"$output")"
    same 'lines on stderr' 1 "$(wc -l <<<"$stderr")"
    [[ $stderr =~ nul:2:.*NUL ]] || same message NUL "$stderr"
}

# ---- Names, nearly right ----

@test "unique beginnings of commands, parameters, topics, words and keys" {
    plain=$(json 'fuel; thetac; show digits')
    while IFS='|' read -r short long; do
        same "$short" "$(json "$long")" "$(json "$short")"
        differ "$long is a question of its own" "$plain" "$(json "$long")"
    done <<'END'
bar|barrier
thetac|thetac
ch 0.1|chain 0.1
du|duration
cou 112|count 112
set s 0.3; sh s|set s 0.3; show s
pri rmax|print rmax
set dig 3; show dig|set digits 3; show digits
set fuel p; fuel|set fuel paper; fuel
set ang d; thetac|set angle deg; thetac
print rmax.r_max_p|print rmax.r_max_paper
rmax; print ans.r_max_p|rmax; print ans.r_max_paper
END
    same 'cou' 20 "$(json 'cou 112' | values dominoes)"
    same 'help bar' "$("$DOMINO" -e 'help barrier')" "$("$DOMINO" -e 'help bar')"
    differ 'help fu' "$("$DOMINO" -e 'help bar')" "$("$DOMINO" -e 'help fu')"
    same 'set output j' "$(json fuel)" "$("$DOMINO" -e 'set output j; fuel')"
}

@test "near misses: what was meant; ambiguous beginnings: the candidates" {
    all_wrong <<'END'
1|barier|^unknown command 'barier'; did you mean 'barrier'\?$
1|brarier|^unknown command 'brarier'; did you mean 'barrier'\?$
1|lauch|^unknown command 'lauch'; did you mean 'launch'\?$
1|Thetac|^unknown command 'Thetac'; did you mean 'thetac'\?$
5|set outptu json|^set: unknown parameter 'outptu'; did you mean 'output'\?$
6|show digts|^show: unknown parameter 'digts'; did you mean 'digits'\?$
7|reset timng|^reset: unknown parameter 'timng'; did you mean 'timing'\?$
6|help barier|^help: unknown topic 'barier'; did you mean 'barrier'\?$
6|help digist|^help: unknown topic 'digist'; did you mean 'digits'\?$
1|mu 0.2|^unknown command 'mu'; did you mean 'effect friction MU'\?$
1|separation 0.3|^unknown command 'separation'; did you mean 's'\? 's = VALUE' gives it a value$
1|height|^unknown command 'height'; did you mean 'h'\?
5|set mu 0.2|^set: unknown parameter 'mu'; did you mean 'friction'\?$
6|help zzz|^help: unknown topic 'zzz'$
8|effect mu 0.2|^effect: unknown effect 'mu'; did you mean 'friction'\?$
7|sweep mu 0 0.3 4 : rmax|^sweep: unknown parameter 'mu'; did you mean 'friction'\?$
7|solve growth : verdict|^solve: unknown parameter 'growth'; did you mean 'r'\?$
1|mu = 0.2|^'mu' is no parameter; did you mean 'friction'\? 'let mu = VALUE' defines a variable$
7|print gravity|'gravity' has no value; did you mean 'g'\?$
37|set output csv; animate a.gif speed 2 rad|animate: the speed is a plain number
12|set output jsno|^set: .*'jsno'; did you mean 'json'\?
10|set fuel ecaxt|^set: .*'ecaxt'; did you mean 'exact'\?
11|set angle degs|^set: .*'degs'; did you mean 'deg'\?
7|print sqr(2)|^print:.*'sqr' has no value; did you mean 'sqrt'\?
7|print baricr|^print:.*'baricr' has no value; did you mean 'barrier'\?
7|print rmax.r_max_papr|^print:.*unknown key of rmax 'r_max_papr'; did you mean 'r_max_paper'\?
1|b|^'b' may be barrier, back, best, budget$
1|the|^'the' may be thetac, theta1$
6|show t|^show: 't' may be tol, threads, timing$
5|set t 1|^set: 't' may be tol, threads, timing$
12|set timing o|^set: 'o' may be off, on
7|print rmax.r_|^print:.*'r_' may be r_max, r_max_exact, r_max_paper
END
}

@test "words of q: beginnings and near misses, too" {
    same 'set q hol' 3 "$(json 'set q hol; show q' | values value)"
    wrong 7 'set q hollwo' "^set: .*'hollwo'.*did you mean 'hollow'"
    wrong 7 'set q masive' "^set: .*'masive'.*did you mean 'massive'"
}

# ---- Settings ----

@test "digits: in tables, and only there" {
    same 'table' '0.177287 0.177 0.177287017325' \
        "$("$DOMINO" -e 'fuel; set digits 3; fuel; set digits 17; fuel' | awk '$1 == "fuel" { print $2 }' | paste -sd ' ' -)"
    same 'rows' 0.738 "$("$DOMINO" -e 'set digits 3; set tol 1e-3; chain 0.1' | awk '$1 == 1 { print $2 }')"
    same 'print' 0.333 "$("$DOMINO" -e 'set digits 3; print 1/3')"
    for format in csv json; do
        same "$format" "$("$DOMINO" -e "set output $format; fuel; chain 0.1; print 1/3")" \
            "$("$DOMINO" -e "set output $format; set digits 3; fuel; chain 0.1; print 1/3")"
    done
    # The heading of a column is above it, for any number of digits.
    for digits in 1 5 17; do
        "$DOMINO" -e "set digits $digits; set tol 1e-3; chain 0.1" >"$BATS_TEST_TMPDIR/table"
        same "digits $digits: columns" 1 "$(sed 2d "$BATS_TEST_TMPDIR/table" | awk '{ print length }' | sort -u | wc -l)"
    done
    same 'all lines as many fields' 6 "$(sed 2d "$BATS_TEST_TMPDIR/table" | awk '{ print NF }' | sort -u)"
}

@test "digits are a whole number" {
    wrong 12 'set digits 2.5' '^set: digits = 2.5 .*1 \.\. 36'
}

@test "angle: typed and answered, in each output" {
    deg() { awk -v x="$1" 'BEGIN { printf "%.17g", x * 180 / atan2(0, -1) }'; }
    for format in csv json; do
        while IFS='|' read -r command keys; do
            rad=$("$DOMINO" -e "set output $format; $command")
            answer=$("$DOMINO" -e "set output $format; set angle deg; $command")
            for key in $keys; do
                if [ "$format" = csv ]; then
                    column() {
                        awk -F, -v key="$key" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == key) k = i }
                            NR == 2 { print $k }' <<<"$1"
                    }
                else
                    column() { values "$key" <<<"$1"; }
                fi
                value=$(column "$rad")
                case $key,$value in theta_leave,null | theta_leave,) value='(nothing)' ;; *) value=$(deg "$value") ;; esac
                obtained=$(column "$answer")
                close "$command in $format: $key" "$value" "${obtained:-null}"
            done
            # The rest is as before.
            for key in slope J kinetic; do
                value=$(values $key <<<"$rad")
                same "$command: $key" "${value:-(nothing)}" "$(values $key <<<"$answer")"
            done
        done <<'END'
thetac|theta_c theta_u theta_inf theta_f theta_leave
set r 2; thetac|theta_c theta_u theta_inf theta_f theta_leave
theta1 10 deg|theta theta_1
energy 0.1 rad|theta
omega 0.1 rad|theta omega
launch|omega0
barrier|theta_m
END
    done
    for command in theta1 energy omega; do
        same "$command 10" "$(json "set angle deg; $command 10 deg")" "$(json "set angle deg; $command 10")"
        same "$command 0.1 rad" "$(deg 0.1 | cut -c1-14)" "$(json "set angle deg; $command 0.1 rad" | values theta | cut -c1-14)"
    done
    same 'a value has its unit with it' "$(json 'set angle deg; theta1 thetac.theta_c')" \
        "$(json 'set angle deg; theta1 thetac')"
    same 'ans' "$(json 'theta1 theta1(0.1)/2' | values theta_1)" \
        "$(json 'theta1 0.1; set angle deg; set angle rad; theta1 ans/2' | values theta_1 | tail -n 1)"
    answer=$("$DOMINO" -e 'set angle deg; thetac; launch; chain 10')
    for line in '^theta_c *36\.8699 deg ' '^omega0 .*deg/s' '^  *deg '; do
        grep -q "$line" <<<"$answer" || same deg "$line" "$answer"
    done
    same 'no radians' '(nothing)' "$(grep -w rad <<<"$answer")"
    theta_c=$(json 'set angle deg; thetac' | values theta_c)
    wrong 25 'set angle deg; theta1   37; set output json' "T = 37 deg .* \[0, ${theta_c:0:15}[0-9]*\]"
    same 'both ends' 2 "$(json "set angle deg; theta1 0; theta1 $theta_c" | grep -c '"theta_1":[0-9]')"
}

@test "timing: a time after every answer, where it does not disturb" {
    number='[0-9.e+-]+ ms'
    for commands in fuel 'chain 0.1' 'count 112' 'print 1' 'show s' 'curve 0.2 0.4 2'; do
        run -0 --separate-stderr "$DOMINO" -e "set timing on; $commands"
        [[ ${lines[-1]} =~ ^time:\ $number$ ]] || same "$commands" 'time: ... ms' "$output"
        same "$commands: once" 1 "$(grep -c '^time: ' <<<"$output")"
        same "$commands: the answer" "$("$DOMINO" -e "$commands")" "$(sed '$d' <<<"$output")"
        for format in csv json; do
            run -0 --separate-stderr "$DOMINO" -e "set output $format; set timing on; $commands"
            same "$commands in $format" "$("$DOMINO" -e "set output $format; $commands")" "$output"
            [[ $stderr =~ ^time:\ $number$ ]] || same "$commands in $format" 'time: ... ms' "$stderr"
        done
    done
    same 'nothing to time' '(nothing)' "$("$DOMINO" -e 'set timing on; set s 0.3; reset s' 2>&1)"
    same 'off' "$(json fuel)" "$(json 'set timing on; set timing off; fuel' 2>&1)"
}

# ---- Files ----

# A directory of its own, since bats keeps files in that of the test.
enter() {
    mkdir "$BATS_TEST_TMPDIR/box"
    cd "$BATS_TEST_TMPDIR/box" || return
}
inside() { find . ! -name . | sed 's,^\./,,' | LC_ALL=C sort | paste -sd , -; }
mode() { find "$1" -prune -perm "$2"; }

@test "'> FILE' and '>> FILE' after any command" {
    enter
    while IFS='|' read -r call _; do
        case $call in design*) continue ;; esac # a file gets its row, see plan.bats
        plain='set header off; ' asked=$plain # else a file that has the head gets no other
        for format in table csv json; do
            plain+="set output $format; $call; "
            asked+="set output $format; $call > $format; $call >> $format; $call; "
        done
        expected=$("$DOMINO" -e "$plain" | grep .)
        run -0 --separate-stderr "$DOMINO" -e "$asked"
        same "$call > FILE: stdout" "$expected" "$(grep . <<<"$output")"
        for part in head tail; do # the one that '>' wrote, and the one that '>>' added
            same "$call > FILE: the $part" "$expected" \
                "$(for file in table csv json; do $part -n $(($(wc -l <$file) / 2)) $file; done | grep .)"
        done
    done <<<"$commands"
    for call in help 'help fuel' show 'print 1' 'source nested'; do
        echo 'fuel; rmax' >nested
        "$DOMINO" -e "$call >out"
        same "$call" "$("$DOMINO" -e "$call")" "$(cat out)"
    done
    echo old >out
    "$DOMINO" -e 'fuel > out'
    same 'the old file is gone' "$("$DOMINO" -e fuel)" "$(cat out)"
    "$DOMINO" -e 'fuel > "with  blanks"; fuel >> "with  blanks"; fuel >"x;y #z" # and on; foo'
    same 'blanks' 6 "$(wc -l <'with  blanks')"
    same "';' and '#'" "$("$DOMINO" -e fuel)" "$(cat 'x;y #z')"
    "$DOMINO" -e 'rmax 0.3>close; fuel>/dev/null'  2>/dev/null || true
    same 'no blank before it' "$("$DOMINO" -e 'rmax 0.3')" "$(cat close)"
    same 'nothing else' 'close,csv,json,nested,out,table,with  blanks,x;y #z' "$(inside)"
}

@test "'apropos WORD' ends where every command does" {
    same "';'" "$("$DOMINO" -e 'apropos hollow')"$'\n'1 "$("$DOMINO" -e 'apropos hollow; print 1' | grep .)"
    "$DOMINO" -e "apropos hollow > $BATS_TEST_TMPDIR/out"
    same '>' "$("$DOMINO" -e 'apropos hollow')" "$(cat "$BATS_TEST_TMPDIR/out")"
}

@test "'complete LINE' takes the whole line, and nothing of it is run" {
    run -0 --separate-stderr "$DOMINO" -e 'complete fuel; th'
    same "';'" "$("$DOMINO" -e 'complete th')" "$output"
    same "';': stderr" '(nothing)' "$stderr"
    same "'set'" output "$("$DOMINO" -e 'complete thetac; set ou' 2>&1)"
    same "'quit'" "$("$DOMINO" -e 'complete q')"$'\n'1 "$("$DOMINO" -e 'complete fuel; q' -e 'print 1' | grep .)"
}

@test "a file is written whole or not at all" {
    enter
    "$DOMINO" -e 'fuel > good' # as a good one is
    grep -q '^fuel ' good
    rm good
    for call in 'theta1 9' 'set s 0.9; fuel' 'foo' 'rmax 2' 'print 1 +' 'show foo' 'fuel 1' \
        'set s 1e-6; set r 1e6; set q 100; fuel' 'apropos zzzz' 'source nonexistent'; do
        for to in '>' '>>'; do
            echo old >file
            run -1 "$DOMINO" --keep-going -e "$call $to file; reset; $call $to new"
            expects "$call $to file: a reason" "$output"
            same "$call $to file" old "$(cat file)"
            same "$call $to: what is left" file "$(inside)"
        done
    done
}

@test "files keep their permissions, links their targets" {
    enter
    touch private && chmod 600 private
    "$DOMINO" -e 'fuel > private'
    same mode private "$(mode private 600)"
    (umask 027 && "$DOMINO" -e 'fuel > new')
    same 'umask' new "$(mode new 640)"
    echo old >target
    ln -s target link
    "$DOMINO" -e 'fuel > link'
    [ -L link ] || same 'link' 'a link still' 'a file'

    same 'through the link' "$("$DOMINO" -e fuel)" "$(cat target)"
}

@test "paths that cannot be written: named, with the reason; the session goes on" {
    enter
    mkdir directory
    echo old >file
    all_wrong <<'END'
8|fuel > /nonexistent/file|^fuel: cannot write '/nonexistent/file': No such file
9|fuel >> /nonexistent/file|^fuel: cannot write '/nonexistent/file': No such file
8|fuel > directory|^fuel: cannot write 'directory': Is a directory
9|fuel >> directory|^fuel: cannot write 'directory': Is a directory
8|fuel > file/below|^fuel: cannot write 'file/below': Not a directory
7|fuel >|^fuel: .*missing
8|fuel >>|^fuel: .*missing
8|fuel > ""|^fuel: .*missing
8|fuel > a b|^fuel: only one word
8|fuel > a > b|^fuel: only one word
8|fuel > a rmax|^fuel: only one word
END
    all_wrong_somewhere() {
        while IFS='|' read -r command message; do
            run -1 --separate-stderr "$DOMINO" --keep-going -e "$command" -e 'print 7'
            same "$command: lines on stderr" 1 "$(wc -l <<<"$stderr")"
            [[ $stderr =~ ^-e:1:.*$message ]] || same "$command" "$message" "$stderr"
            same "$command: the session goes on" 7 "$(tail -n 1 <<<"$output")"
        done
    }
    all_wrong_somewhere <<'END'
save /nonexistent/file|save: cannot write '/nonexistent/file': No such file
save directory|save: cannot write 'directory': Is a directory
save ""|save: .*missing
source /nonexistent/file|source: cannot read '/nonexistent/file': No such file
source directory|source: cannot read 'directory': Is a directory
source ""|source: .*missing
END
    if [ -c /dev/full ]; then
        all_wrong_somewhere <<'END'
fuel > /dev/full|fuel: cannot write '/dev/full': No space
fuel >> /dev/full|fuel: cannot write '/dev/full': No space
help > /dev/full|help: cannot write '/dev/full': No space
curve 0.1 0.9 200 > /dev/full|curve: cannot write '/dev/full': No space
save /dev/full|save: cannot write '/dev/full': No space
END
    fi
    same 'nothing was written' 'directory,file' "$(inside)"
}

@test "a '\"' that is never closed is no file name" {
    enter
    wrong 8 'fuel > "a b' '^fuel: '
    wrong 6 'save "a b' '^save: '
    wrong 8 'source "a b' '^source: '
    same 'nothing was written' '(nothing)' "$(inside)"
}

@test "save and source: every parameter comes back as it was" {
    enter
    json show | values name >names
    [ "$(wc -l <names)" -ge 12 ]
    while read -r name value; do
        before=$(json "set $name $value; show")
        [ "$before" != "$(json show)" ]
        "$DOMINO" -e "set $name $value; save $name.dom"
        same "$name" "$before" "$(json "source $name.dom; set output json; show")"
        same "$name: -f" "$before" "$("$DOMINO" -f "$name.dom" -e 'set output json; show')"
        same "$name: again" "$(cat "$name.dom")" "$("$DOMINO" -e "source $name.dom; save again" && cat again)"
        same "$name: is saved" 1 "$(grep -c "^set $name " "$name.dom")"
    done <<'END'
s 1/3
r pi/3
d 7.1 mm / 48 mm
q hollow
q 10/3
tol 1e-9/3
h 1 ft
g 1.62 m/s^2
fuel paper
digits 17
angle deg
timing on
END
    # And output, which the others need for looking at them.
    "$DOMINO" -e 'set output csv; set s 0.3; save output.dom; set s 0.2; save output.dom'
    same output "$("$DOMINO" -e 'set output csv; set s 0.2; show')" "$("$DOMINO" -e 'source output.dom; show')"
    # All at once, over everything else.
    changed='set s 1/3; set r pi/3; set d 0.1; set q 10/3; set tol 1e-9; set h 1 ft; set g 1.62; set fuel paper
        set digits 17; set angle deg'
    before=$(json "$changed; show; theta1 5")
    "$DOMINO" -e "$changed; save \"all of it\""
    same 'all' "$before" "$(json 'set s 0.9; source "all of it"; set output json; show; theta1 5')"
    same 'again' "$(cat 'all of it')" "$("$DOMINO" -e 'source "all of it"; save again' && cat again)"
    same 'nothing else is left' 0 "$(find . -name '*.??????' | wc -l)"
}

@test "source: the commands of a file, its errors with its name; one that sources itself" {
    enter
    printf 'set s 0.3\nfoo\n\n  show s; qux 1\n' >inner
    printf 'set output json\nsource inner\nshow s' >outer
    run -1 --separate-stderr "$DOMINO" --keep-going outer
    same 'answers' '0.3 0.3' "$(values value <<<"$output" | paste -sd ' ' -)"
    same 'places' 'inner:2:1: inner:4:11:' "$(cut -d' ' -f1 <<<"$stderr" | paste -sd ' ' -)"
    run -1 --separate-stderr "$DOMINO" --bail outer
    same '--bail: answers' '(nothing)' "$output"
    same '--bail: places' 'inner:2:1:' "$(cut -d' ' -f1 <<<"$stderr" | paste -sd ' ' -)"
    # After an error in a file the line goes on where it was.
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'source inner; foo; print 7'
    same 'the place is back' '-e:1:15:' "$(tail -n 1 <<<"$stderr" | cut -d' ' -f1)"
    echo 'quit' >leave
    same 'quit in a file' '(nothing)' "$("$DOMINO" -e 'source leave; fuel' -e fuel)"

    echo 'source itself' >itself
    printf 'source two\n' >one
    printf 'source one\n' >two
    for file in itself one; do
        run -1 --separate-stderr "$DOMINO" --keep-going -e "source $file; print 7"
        same "$file: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [[ $stderr =~ nested.*itself ]] || same "$file" 'nested ... itself' "$stderr"
        same "$file: the session goes on" 7 "$output"
    done
    # Side by side is not inside each other.
    echo 'set s 0.3' >plain
    same 'forty in a row' 0.3 \
        "$(json "$(for _ in $(seq 40); do echo 'source plain'; done); show s" | values value)"
    run -1 --separate-stderr "$DOMINO" --keep-going -f itself
    same '-f: lines on stderr' 1 "$(wc -l <<<"$stderr")"
}

@test "--safe: commands reach no file, the rest is as it was" {
    enter
    echo 'set s 0.3' >plain
    while IFS='|' read -r command place; do
        run -1 --separate-stderr "$DOMINO" --keep-going --safe -e "$command; print 7"
        same "$command: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [[ $stderr =~ ^-e:1:$place:?.*'safe' ]] || same "$command" "safe" "$stderr"
        same "$command: the session goes on" 7 "$output"
    done <<'END'
save file|1
source plain|1
fuel > file|[0-9]
fuel >> file|[0-9]
fuel > plain|[0-9]
help > /dev/null|[0-9]
END
    same 'nothing was written' 'plain,set s 0.3' "$(inside),$(cat plain)"
    same 'no file names are told' '(nothing)' "$("$DOMINO" --safe -e 'complete source p')"
    for call in fuel 'count 112' 'help fuel' 'set s 0.3; show'; do
        same "$call" "$("$DOMINO" -e "$call")" "$("$DOMINO" --safe -e "$call")"
    done
    # What the user names is read.
    same '-f' 0.3 "$("$DOMINO" --safe -f plain -e 'set output json; show s' | values value)"
}

@test "-n is accepted; no start-up file is read without a terminal" {
    enter
    mkdir -p config/domino
    echo 'set s 0.3' >config/domino/init.dom
    close fuel 0.177287017324780688790030782681 "$(json fuel | values fuel)"
    differ 'what the file would change' "$(json fuel)" "$(json 'set s 0.3; fuel')"
    for option in -n --no-init --safe --bail --keep-going; do
        same "$option" "$(json fuel)" "$(XDG_CONFIG_HOME=$PWD/config "$DOMINO" "$option" -e 'set output json; fuel')"
        same "$option, stdin" "$(json fuel)" \
            "$(echo 'set output json; fuel' | XDG_CONFIG_HOME=$PWD/config "$DOMINO" "$option")"
    done
}

# ---- Completion and help ----

completed() { "$DOMINO" -e "complete $1" | paste -sd ' ' -; }

@test "complete: commands, parameters, topics, words, names of expressions, files" {
    all=$("$DOMINO" -e help | sed -n 's/^  \([a-z0-9]*\) .*/\1/p' | paste -sd ' ' -)
    parameters=$(json show | values name | paste -sd ' ' -)
    effects=$(completed 'effect ')
    [ "$(wc -w <<<"$effects")" -ge 5 ]
    [ "$(wc -w <<<"$all")" -ge 22 ]
    while IFS='|' read -r line expected; do
        same "complete $line" "$expected" "$(completed "$line")"
    done <<END
|$all
th|thetac theta1
bar|barrier
zzz|(nothing)
set |$parameters $effects
show |$parameters $effects
reset |$parameters $effects
set friction |off on
effect floor |off on
set placement 0.1 |m mm cm km in ft yd
set ou|output
set d|d density digits
show t|tol threads timing
set ti|timing
set output |table csv json
set output j|json
set fuel |exact paper
set angle |rad deg
set timing |off on
set q |hollow solid
set q h|hollow
help b|barrier back best budget bounce
help dig|digits
theta1 at|atan( atan2(
rmax 0.9*rm|0.9*rmax
rmax (rm|(rmax
count |h
count 112 |r rmax pair m mm cm km in ft yd
count 112 m |r rmax pair
set h 48 |m mm cm km in ft yd
set h 48m|48m 48mm
set mass 10 |kg g t lb oz
set s 0.3 |mm cm in
curve 0.1 0.9 |mm cm in
theta1 |thetac where
sweep s |(nothing)
sweep fuel |exact paper
sweep h 40 mm 60 mm 3 den|density
count 2*sq|2*sqrt(
print an|ans
0.9*rm|0.9*rmax
r = 0.9*rm|0.9*rmax
rmax.r_max_e|rmax.r_max_exact
foo |(nothing)
fuel |(nothing)
END
    # In an expression: parameters with a number, commands with a value, functions; nothing else.
    names=" $(completed 'print ') "
    for name in s r d q tol h g rmax barrier 'count(' ans 'sin(' 'sqrt(' pi; do
        [[ $names == *" $name "* ]] || same 'print' "$name" "$names"
    done
    for name in output angle timing chain curve set help quit; do
        [[ $names != *" $name "* ]] || same 'print' "no $name" "$names"
    done
    for call in 'theta1 2*' 'count 1 + ' 'rmax (' 'curve 0.1 0.9*'; do
        same "$call" "$names" " $(completed "$call" | sed 's/[^ ]*[*(]\([a-z]\)/\1/g') "
    done
    # Everything that is offered there has a value, or is a function.
    [ "$(wc -w <<<"$names")" -ge 40 ]
    for name in $names; do
        [[ $name != *\( ]] || continue
        run --separate-stderr json "effect row 4; effect placement 5 mm; rmax; print $name"
        [ "$status" -eq 0 ] || same "$name" 'a value' "$stderr"
    done
}

@test "complete: nothing is offered twice" {
    while IFS='|' read -r line word; do
        offered=$("$DOMINO" -e "complete $line")
        same "'$line' offers $word once" 1 "$(grep -cx "$word" <<<"$offered")"
        same "'$line'" '(nothing)' "$(sort <<<"$offered" | uniq -d)"
    done <<'END'
|barrier
help |barrier
set |output
print |sqrt(
help fu|fuel
print |pi
END
}

@test "complete: keys after a dot" {
    same 'rmax.' 'rmax.s rmax.r_max rmax.r_max_exact rmax.r_max_paper' "$(completed 'print rmax.' | sed 's/ rmax\.ends_by//')"
    same 'barrier.m' 'barrier.margin' "$(completed 'print barrier.m')"
    same 'no functions' '(nothing)' "$("$DOMINO" -e 'complete print rmax.' | grep -x 'rmax\.sin')"
}

@test "complete: files, where files belong" {
    enter
    touch alpha.dom beta.dom
    mkdir alps
    for line in 'source ' 'save ' 'fuel > ' 'fuel >> ' 'rmax 0.3 > '; do
        same "$line" 'alpha.dom alps beta.dom' "$("$DOMINO" -e "complete $line" | sed 's,/$,,' | sort | paste -sd ' ' -)"
        same "${line}b" 'beta.dom' "$(completed "${line}b")"
    done
    touch alps/gamma.dom
    same 'in a directory' 'alps/gamma.dom' "$(completed 'source alps/')"
    same 'no match' '(nothing)' "$(completed 'source zzz')"
    same 'nowhere else' '(nothing)' "$(completed 'theta1 alpha')"
}

@test "apropos: what mentions a word, in any case; or an error" {
    while IFS='|' read -r word found; do
        answer=$("$DOMINO" -e "apropos $word")
        expects "apropos $word" "$answer"
        for name in $found; do
            grep -Eq "^(set )?$name( |\$)" <<<"$answer" || same "apropos $word" "$name" "$answer"
        done
        same "apropos ${word^^}" "$answer" "$("$DOMINO" -e "apropos ${word^^}")"
    done <<'END'
fuel|fuel
barrier|barrier rmax
hollow|q
json|output
separation|rmax pair best curve s
seconds|duration
significant|digits
leave|quit thetac
c7|fuel
END
    all_wrong <<'END'
0|apropos zzzz|^apropos: .*'zzzz'
END
}

@test "apropos without a word: its usage" {
    wrong 8 apropos '^apropos: WORD is missing; usage: apropos WORD'
}

@test "help NAME for every command and parameter; its example is what the program prints" {
    enter
    "$DOMINO" -e help | sed -n 's/^  \([a-z0-9]*\) .*/\1/p' >"$BATS_TEST_TMPDIR/names"
    cp "$BATS_TEST_TMPDIR/names" names
    [ "$(wc -l <names)" -ge 22 ]
    examples=0
    names=$(paste -sd ' ' "$BATS_TEST_TMPDIR/names")
    help=$("$DOMINO" -e help)
    # Whatever the session has been set to, the example is that of a fresh one, and changes nothing.
    changed='set s 0.3; set digits 4; set fuel paper; set angle deg'
    "$DOMINO" -e "$changed; show" -e "$(sed 's/.*/help & > "&.txt"/' names | paste -sd ';' -)" -e show >shows
    same 'help changes nothing' "$(head -n "$(($(wc -l <shows) / 2))" shows)" "$(tail -n "$(($(wc -l <shows) / 2))" shows)"
    shown() { awk '/^Example: / { on = 1; getline; next } /^See also: / { on = 0 } on' "$@"; }
    while read -r name; do
        run -0 --separate-stderr "$DOMINO" -e "help $name"
        same "help $name: stderr" '(nothing)' "$stderr"
        usage=$(awk -v name="$name" '$1 == name { sub(/^  /, ""); sub(/  +.*/, ""); print; exit }' <<<"$help")
        [[ ${lines[0]} == "$usage"* ]] || same "help $name: its usage" "$usage" "${lines[0]}"
        example=$(sed -n 's/^Example: //p' <<<"$output")
        [ -n "$example" ] || continue
        examples=$((examples + 1))
        same "help $name: $example" "$("$DOMINO" -e "$example")" "$(shown <<<"$output")"
        same "help $name elsewhere" "$(shown <<<"$output")" "$(shown "$name.txt")"
        # Each that it sends to is there.
        while read -r other; do
            [[ " $names " == *" $other "* ]] || same "help $name: see also" "a command" "$other"
        done < <(sed -n 's/^See also: //p' <<<"$output" | tr ' ' '\n')
    done <"$BATS_TEST_TMPDIR/names"
    [ "$examples" -ge 25 ]
    seen=0
    json show | values name >"$BATS_TEST_TMPDIR/parameters"
    while read -r name; do
        # 'fuel' is a command, too.
        if grep -qx "$name" "$BATS_TEST_TMPDIR/names"; then continue; fi
        seen=$((seen + 1))
        run -0 --separate-stderr "$DOMINO" -e "help $name"
        range=$(json "show $name" | values range)
        meaning=$(json "show $name" | values meaning)
        expects "help $name: meaning" "$meaning"
        for words in "$meaning" "$range" default "set $name"; do
            [[ $output == *"$words"* ]] || same "help $name" "$words" "$output"
        done
    done <"$BATS_TEST_TMPDIR/parameters"
    [ "$seen" -ge 12 ]
    # 'help set' shows all of them as they are now.
    answer=$("$DOMINO" -e 'set s 0.3; set fuel paper; help set')
    while read -r name; do
        grep -q "^ *$name " <<<"$answer" || same 'help set' "$name" "$answer"
    done <"$BATS_TEST_TMPDIR/parameters"
    grep -q '^ *s  *0\.3 ' <<<"$answer"
    grep -q '^ *fuel  *paper ' <<<"$answer"
}

@test "help fuel, a command and a parameter, describes both" {
    answer=$("$DOMINO" -e 'help fuel')
    for words in 'It answers' 'set fuel' 'exact|paper'; do
        [[ $answer == *"$words"* ]] || same 'help fuel' "$words" "$answer"
    done
}

@test "'> FILE' keeps links and names, needs no blank, and finds standard output" {
    cd "$BATS_TEST_TMPDIR" || false
    echo old >one && ln one two
    "$DOMINO" -e 'print 1>one; print 2 >> two'
    same 'a file of two names' $'1\n2' "$(cat two)"
    "$DOMINO" -e 'print 1; print 5 > /dev/stdout; print 2' | grep . >through-a-pipe
    "$DOMINO" -e 'print 1; print 5 > /dev/stdout; print 2' >file
    same 'to a pipe' $'1\n5\n2' "$(cat through-a-pipe)"
    same 'to a file' $'1\n5\n2' "$(grep . file)"
}

@test "angle deg: functions take degrees, print answers in them" {
    same 'sin(90)' 1 "$("$DOMINO" -e 'set angle deg; print sin(90)')"
    same 'thetac' '36.8699 deg' "$("$DOMINO" -e 'set angle deg; print thetac')"
    same 'atan(1)' '45 deg' "$("$DOMINO" -e 'set angle deg; print atan(1)')"
    same 'sin(90 deg)' 1 "$("$DOMINO" -e 'print sin(90 deg)')"
}

@test "a misspelt unit is named, and functions and units are topics of help" {
    wrong 11 'theta1 10 dge' "^theta1: 'dge' is not a unit; did you mean 'deg'"
    wrong 9 'print 3 furlong' "^print: 'furlong' is not a unit"
    for topic in sin pi cm units ans; do "$DOMINO" -e "help $topic" | grep -q '^print VALUE'; done
}

@test "units as words, in one and in many; decimal commas and percent are explained" {
    same words '0.0508 0.6096 2.7432 0.005 0.05 1.5708' "$(printf '%s\n' '2 inch' '2 feet' '3 yards' '5 grams' '50 millimetres' '90 degrees to rad' |
        "$DOMINO" | awk 'NF { print $1 }' | paste -sd ' ' -)"
    same 'the effect of this name goes on with a grid' '0.4 0.6 0.4 0.6' \
        "$(json 'effect row 6; sweep push 5 9 2 feet 0.4 0.6 2 : print h' | values feet | paste -sd ' ' -)"
    all_wrong <<'END'
8|set s 0,3|^set: s ends before ',3'; decimals have a point, as in 0\.5$
10|count 112,5 m|^count: H ends before ',5 m'; decimals have a point
10|budget 95%|^budget: P ends before '%'; write a share as 0\.95 or 95/100$
END
}

@test "help answers for the words that people use: one topic is explained, several are listed" {
    while IFS='|' read -r word topic; do
        same "$word" "$("$DOMINO" -e "help $topic")" "$("$DOMINO" -e "help $word")"
        same "$word, json" "$(json "help $topic")" "$(json "help $word")"
    done <<'END'
growth|r
train|r
gap|s
separation|s
thickness|d
solid|q
hollow|q
tower|count
END
    same speed 'omega fall cost timing push' "$("$DOMINO" -e 'help speed' | sed -n 's/^\([a-z]*\)   .*/\1/p' | paste -sd ' ' -)"
    same 'speed, json' 'omega fall cost timing push' "$(json 'help speed' | values name | paste -sd ' ' -)"
    # Each word of the README's table has an answer that mentions it.
    sed -n '/^## Words/,/^## Does/s/^| \([a-z]*\) |.*/\1/p' "$BATS_TEST_DIRNAME/../../README.md" | grep -vx word >"$BATS_TEST_TMPDIR/words"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/words")" -ge 6 ]
    while read -r word; do "$DOMINO" -e "help $word" | grep -qi "\b$word\b"; done <"$BATS_TEST_TMPDIR/words"
}
