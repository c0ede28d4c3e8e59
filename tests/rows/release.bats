#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# A first domino that is released at a tilt, or leans against the second.

load ../shell/common

scene='set r 1; set s 0.5; set row 6'
deg=0.017453292519943295

@test "a first domino released at 20 degrees hits the second with the energy that it has lost" {
    fall=$(json "$scene; set mass 10 g; set release 20 deg; fall")
    same hits 6 "$(wc -l <<<"$fall")"
    same 'it starts at rest, at time 0' '0 0 0' "$(head -n 1 <<<"$fall" | sed -E 's/.*"hit":([^,]*).*"omega":([^,]*),"kinetic":([^,]*).*/\1 \2 \3/')"
    # omega of domino 2, by the energy and the collision of two equal dominoes: omega = omega_1 k/(1 + k), where k = 1
    close omega "$(awk -v a="$(awk "BEGIN { print 20 * $deg }")" 'BEGIN {
        h = 0.048; d = 0.007; c = atan2(0.5, sqrt(0.75))
        e = 9.81 / 2 * (h * (cos(a) - cos(c)) + d * (sin(a) - sin(c)))
        printf "%.15g", sqrt(2 * e / ((h * h + d * d) / 3)) / 2 }')" "$(sed -n 2p <<<"$fall" | values omega)" 1e-5
    same 'the clock starts with the release' true "$(json "$scene; set release 20 deg; verdict; set release 25 deg; verdict" |
        values seconds | awk 'NR == 1 { slow = $1 } NR == 2 && $1 < slow && $1 > 0.2 { print "true" }')"
    same quad "$(json "$scene; set release 20 deg; verdict" | values seconds | cut -c 1-12)" \
        "$(json "set precision quad; $scene; set release 20 deg; verdict" | values seconds | cut -c 1-12)"
}

@test "a tilt that is too small: the first domino falls back, and mend names a push" {
    run -0 "$DOMINO" -n -e "$scene; set release 5 deg; verdict"
    same words 'The fall ends at domino 1 of 6: it falls back, because the tilt at which it is released is too small.' "$output"
    same verdict 'falls back' "$(json "$scene; set release 5 deg; verdict" | values verdict)"
    same 'just beyond' 'all fall' "$(json "$scene; set release 8.3 deg; verdict" | values verdict)"
    push=$("$DOMINO" -n -e "$scene; set release 5 deg; mend" | sed -n "s/^With 'set push \(.*\)', all dominoes fall\.$/\1/p")
    same "a push of $push" 'all fall' "$(json "$scene; set release 5 deg; set push $push; verdict" | values verdict)"
    less=$(awk -v push="$push" 'BEGIN { print 0.998 * push }')
    same "a push of $less" 'falls back' "$(json "$scene; set release 5 deg; set push $less; verdict" | values verdict)"
    # downhill it tips over earlier
    same slope 'all fall' "$(json "$scene; set slope 4 deg; set release 5 deg; verdict" | values verdict)"
}

@test "touch: the first domino leans against the second, and both start at rest" {
    fall=$(json "$scene; set release touch; fall")
    same rest '0 0' "$(values omega <<<"$fall" | head -n 2 | paste -sd ' ' -)"
    same time '0 0' "$(values hit <<<"$fall" | head -n 2 | paste -sd ' ' -)"
    same 'it pushes the second over' 'all fall' "$(json "$scene; set release touch; verdict" | values verdict)"
    same 'the same tilt as a number' "$(json "$scene; set release touch; verdict" | values seconds | cut -c 1-12)" \
        "$(json "$scene; set release asin(0.5); verdict" | values seconds | cut -c 1-12)"
    same 'it is too light' 2 "$(json "$scene; set s 0.2; set release touch; verdict" | values domino)"
    wrong "$scene; set release 31 deg; fall" "cannot be released at 31 deg, since it touches the second at 30 deg; enter 'set release 30 deg' or less, or 'set release touch'$"
    same 'the tilt that the message names' 'all fall' "$(json "$scene; set release 30 deg; verdict" | values verdict)"
    wrong 'set row 1; set release touch; fall' 'cannot lean against a second, since the row has only one'
    wrong "$scene; place 2 60 mm; set release touch; fall" 'out of its reach'
    same 'a single domino' 'all fall' "$(json 'set row 1; set release 50 deg; verdict' | values verdict)"
}

# bats test_tags=sweeps,save
@test "release is a parameter: save, undo, reset, show, with, sweep, completion" {
    "$DOMINO" -n -e "$scene; set release touch; save a.dom; set release 0.25; save b.dom"
    grep -qx 'set release touch' a.dom
    grep -qx 'set release 0.25' b.dom
    same saved 'touch 0.25' "$("$DOMINO" -n -e 'source a.dom; show release; source b.dom; show release' | awk '/^release/ { print $2 }' | paste -sd ' ' -)"
    close on "$(awk "BEGIN { printf \"%.15g\", 20 * $deg }")" "$(json 'set release on; show release' | values value)"
    same with "$(json "$scene; set release touch; verdict" | values seconds)" "$(json "$scene; verdict with release touch" | values seconds)"
    same sweep "$(json "$scene; set release 20 deg; verdict; set release touch; verdict" | values seconds)" \
        "$(json "$scene; sweep release 20 deg, touch : verdict" | values seconds)"
    same complete 'off on touch' "$(completed 'set release ')"
    wrong 'set release 20' "in the range 0 \.\. 1\.57079 rad \(0 \.\. 90 deg\); enter degrees as in '20 deg'$"
    wrong 'set release 95 deg' 'in the range 0 \.\. 1\.57079 rad \(0 \.\. 90 deg\)$'
    same 'the largest' 1.570796326794896 "$(json 'set release 90 deg; show release; set precision quad; set release 90 deg; show release' | values value | cut -c 1-17 | uniq)"
    wrong 'set release 20 cm' "ANGLE is an angle, not a length; enter a value such as '10 deg'$"
    wrong 'set release toch' "did you mean 'touch'"
}

@test "rmax and count speak of the release" {
    "$DOMINO" -n -e 'set release 22 deg; rmax 0.5' | grep -q 'A row that starts from rest can have a growth of up to .* if its first domino is released at 22 deg\.$'
    "$DOMINO" -n -e 'set release touch; rmax 0.5' | grep -q 'if its first domino is released against the second\.$'
    "$DOMINO" -n -e 'set release 22 deg; set push 3; rmax 0.5' | grep -q 'with a push of 3 rad/s at 22 deg\.$'
    # r_start is the growth at which the row just falls
    most=$(json 'set s 0.5; set release 22 deg; count 112' | values r_start)
    for x in 0.999999 1.000001; do
        json "set s 0.5; set r $(awk "BEGIN { printf \"%.12g\", $most * $x }"); set release 22 deg; set row 24; verdict" | values verdict
    done | same 'around r_start' $'all fall\nstops' "$(cat)"
}

# bats test_tags=engine
@test "release in the engine: the times agree with those of the model to 1 %" {
    for with in 'release 20 deg' 'release touch' 'release 15 deg; set push 2' 'release 20 deg; set edges 0.02' \
        'release 20 deg; set friction 0.2; set slope 1 deg'; do
        paste <(json "$scene; set $with; fall" | values hit | tail -n 1) <(json "$scene; set $with; set method engine; fall" | values hit | tail -n 1) |
            awk -v with="$with" 'NF == 2 { off = $2 / $1 - 1; good = off < 0.01 && off > -0.01 } END { if (!good) { print with, $0; exit 1 } }'
    done
    same back 'falls back' "$(json "$scene; set release 6 deg; set method engine; verdict" | values verdict)"
}

# bats test_tags=chance
@test "random rows: a first domino that has no room leans against the second" {
    same all '40' "$(json "$scene; set placement 0.2 mm; set release 20 deg; placement 40" | values fall)"
    # In about half of the rows the first gap is too narrow for this tilt.
    same narrow '40' "$(json "$scene; set placement 0.5 mm; set release 29.9 deg; placement 40" | values fall)"
    same 'falls back' '0' "$(json "$scene; set placement 0.5 mm; set release 8 deg; placement 40" | values fall)"
}

# bats test_tags=planning
@test "design and plan: the row that is found has room for the tilt, and starts from it" {
    for release in '20 deg' touch; do
        same "$release" 'all fall' "$(json "set release $release; design 1 m; verdict" | values verdict | tail -n 1)"
    done
    "$DOMINO" -n -e "$scene; set release 20 deg; plan details" | paste -sd ' ' - | grep -q 'Hold domino 1 at 20 deg and let it go\.'
    "$DOMINO" -n -e "$scene; set release touch; plan details" | paste -sd ' ' - | grep -q 'Lean domino 1 against domino 2 and let it go\.'
}

# bats test_tags=fit
@test "fit finds the tilt from which a row was released" {
    csv "$scene; set release 0.4; fall" | awk -F, 'NR == 1 { print "domino,time" } NR > 2 { printf "%d,%.9f\n", $1, $3 }' >hits.csv
    close tilt 0.4 "$(json "$scene; set release 20 deg; fit release hits.csv" | values release | head -n 1)" 1e-5
}

# bats test_tags=pictures
@test "draw shows the slanted first domino, before the fall and at the release" {
    for when in '' ' at 0'; do
        same "draw$when" "$(awk "BEGIN { printf \"%.12g\", 20 * $deg }") 0 0 0 0 0" \
            "$(json "$scene; set release 20 deg; draw$when" | values theta | awk '{ printf "%.12g\n", $1 }' | paste -sd ' ' -)"
    done
    "$DOMINO" -n -e "$scene; set release 20 deg; draw at 0.05" | grep -q '^0\.050 s after the release: domino 1 falls'
    wrong "$scene; set release 20 deg; draw at -1" "times count from the release and cannot be negative; 'draw at 0' shows the row at the release$"
}

@test "a first domino that tips over just before it hits has its speed to all digits, also with round edges on a slope" {
    local setting precision
    while read -r setting; do
        for precision in double quad; do
            values omega <<<"$(json "set precision $precision; set r 1; set edges 0.02; set row 2; $setting; fall" | tail -n 1)"
        done | awk 'NR == 1 { a = $1 } NR == 2 { exit !($1 > 0 && (a / $1 - 1) ^ 2 < 1e-18) } END { if (NR < 2) exit 1 }' ||
            same "$setting" 'the same speed in double and in quad' 'another'
    done <<'END'
set s 0.10739211319121669
set slope 1 deg; set s 0.08966817587603454
set slope -2 deg; set s 0.1427297927268681
END
}
