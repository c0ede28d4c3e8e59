#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Landmarks: names of heights, for 'count' and in expressions.

load ../shell/common

@test "the name of a landmark is its height, in every expression" {
    all_worth <<'END'
112|m|domtoren
2240|-|domtoren / 5 cm
96|m|Big Ben
426|m|big ben + eiffel tower
2|-|Burj Khalifa / (828 m / 2)
20|-|count(domtoren)
END
    # the heights that are defined in other units, by these units; the table rounds them
    while IFS='|' read -r name value; do
        close "$name" "$(json "print $value" | values value)" "$(json "print $name" | values value)" 1e-3
    done <<'END'
liberty|305 ft + 1 in
washington_monument|555 ft + 5.125 in
giza|280 * 52.36 cm
END
}

@test "count takes a landmark as a height, with or without '_', and a growth after it" {
    for name in domtoren Domtoren 'dom tower'; do
        same "$name" "$("$DOMINO" -e 'count 112 m')" "$("$DOMINO" -e "count $name")"
    done
    for name in big_ben 'big ben' 'Big  Ben'; do
        same "$name" "$("$DOMINO" -e 'count 96 m 1.3')" "$("$DOMINO" -e "count $name 1.3")"
    done
    all_print <<'END'
big ben to ft|314.961 ft
set h big ben; print h|96 m
let tall(x) = 2*x; tall(taipei 101)|1016 m
END
}

@test "a name that 'let' defines hides a landmark" {
    all_print <<'END'
let eiffel = 3 m; print eiffel|3 m
let big_ben = 3 m; print big ben|3 m
let eiffel = 3 m; reset eiffel; print eiffel|330 m
let f(eiffel) = 2*eiffel; f(4)|8
END
    wrong_line 'let big = 4; print big ben' "'ben' is one argument too many"
}

@test "no landmark has a name that something else has" {
    names=$(csv landmarks | tail -n +2 | cut -d, -f1)
    [ "$(wc -l <<<"$names")" -le 20 ] || same 'at most 20' 20 "$names"
    same 'names' '(nothing)' "$(sort <<<"$names" | uniq -d)"
    for name in $names; do
        same "help $name" "$("$DOMINO" -e 'help landmarks' | head -n 1)" "$("$DOMINO" -e "help $name" | head -n 1)"
        "$DOMINO" -e "let $name = 1" || same "$name" 'free for let' taken
        [[ " $(completed "print 2*$name") " == *" 2*$name "* ]] || same "$name" 'completed' "$(completed "print 2*$name")"
    done
    grep -q ' big_ben ' <<<"$(completed 'count ')"
    same 'count bi' big_ben "$(completed 'count bi')"
    same 'each has a source' '(nothing)' "$(csv landmarks | grep -E ',$|,,')"
}

@test "messages about landmarks" {
    all_wrong <<'END'
7|count eifel|did you mean 'eiffel'
6|rmax eiffel|S = 6875 is out of range
15|count big ben ben|'ben' has no value
9|set h = eiffel(2)|.eiffel. has no value
END
}
