#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Scripts that check: assert, and the status of a script.

load ../shell/common

@test "assert: a condition" {
    same 'true' '(nothing)' "$("$DOMINO" -n -e 'assert rmax(0.4) < 1.7; assert if(r > 1, 1, 0); assert (s > 0.1) and not r == 2')"
    wrong 'assert rmax(0.4) < 1.6' 'assert: not true: rmax\(0.4\) < 1.6'
    wrong 'assert 1/0 < 2' 'assert: .*division by zero'
    wrong 'assert rmax' "'rmax' has no verdict; .* 'assert rmax < 1.7'"
    wrong 'assert rmax > 2' "here '>' would write the answer to a file, .* parentheses"
    wrong 'assert (rmax(0.4) > 2)' 'assert: not true'
}

# bats test_tags=rows,proof,planning
@test "assert: a script fails where a row does not fall" {
    run -0 "$DOMINO" -e 'effect row 5; assert verdict; assert fall; assert barrier; assert count 1 1.2; assert design 1 m'
    same answers "$("$DOMINO" -e 'effect row 5; verdict')" "$("$DOMINO" -e 'effect row 5; assert verdict')"
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'effect row 5; effect friction 2; assert verdict; print 7'
    same message '-e:1: assert: not true: all dominoes fall' "$stderr"
    same 'goes on' 7 "${lines[-1]}"
    run -1 --separate-stderr "$DOMINO" --bail -e 'set r 2.2; assert barrier; print 77'
    same bail '-e:1: assert: not true: the train keeps falling' "$stderr"
    [[ $output != *77* ]]
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'assert design 8 m hall 9 m'
    same design '-e:1: assert: not true: a row meets the wishes' "$stderr"
    run -1 "$DOMINO" --keep-going -e 'assert count 8 2.2'
    same csv 'verdict,domino' "$("$DOMINO" -e 'set output csv; effect row 5; assert verdict' | head -n 1 | cut -d , -f 1,2)"
    "$DOMINO" -e 'effect row 5; assert verdict > verdict.csv'
    same file 'all fall' "$(tail -n 1 verdict.csv | cut -d , -f 1)"
    "$DOMINO" -e 'assert prove verdict; assert prove rmax 0.4; assert prove count 1' >proved
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'set r 2; assert prove verdict'
    same proof '-e:1: assert: not true: there is a proof that the train keeps falling' "$stderr"
    wrong 'assert' 'COMMAND is missing; usage: assert COMMAND'
}
