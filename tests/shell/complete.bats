#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion: the command 'complete' shows how a line may continue.

load common

@test "'complete LINE' takes the whole line, and runs none of it" {
    run -0 --separate-stderr "$DOMINO" -e 'complete fuel; th'
    same "';'" "$("$DOMINO" -e 'complete th')" "$output"
    same "';': stderr" '(nothing)' "$stderr"
    same "'set'" output "$("$DOMINO" -e 'complete thetac; set ou' 2>&1)"
    same "'quit'" "$("$DOMINO" -e 'complete q')"$'\n'1 "$("$DOMINO" -e 'complete fuel; q' -e 'print 1' | grep .)"
}

# bats test_tags=rows,chance,pictures,sweeps,explain,fit,engine,landmarks
@test "complete: commands, parameters, topics, words, names of expressions, files" {
    # 'step back', 'step to' and 'step where' and other phrases stand for commands that completion does not offer.
    all=$(json help | grep '"kind":"command"' | values name | grep -vxE 'back|goto|where|scene|effect' | paste -sd ' ' -)
    parameters=$(json show | values name | paste -sd ' ' -)
    effects=$(json help | grep '"kind":"effect"' | values name | paste -sd ' ' -)
    landmarks=$(csv landmarks | sed '1d; s/,.*//' | paste -sd ' ' -)
    formats=$(sed -n 's/^#define FORMATS(EACH) //p' "$root/src/shell/answer/answer.h" | sed 's/EACH(//g; s/)//g')
    [ "$(wc -w <<<"$formats")" -ge 3 ]
    [ "$(wc -w <<<"$effects")" -ge 5 ]
    [ "$(wc -w <<<"$all")" -ge 22 ]
    while IFS='|' read -r line expected; do
        same "complete $line" "$expected" "$(completed "$line")"
    done <<END
|$all
th|thetac theta1
zzz|(nothing)
set |$parameters $effects
show |$parameters $effects all
reset |$parameters $effects
set friction |off on
set placement 0.1 |m mm cm km in ft yd
show t|tol threads
set output |$formats
set fuel |exact paper
set q |hollow solid
help b|barrier back best budget bounce
rmax 0.9*rm|0.9*rmax
count |$landmarks
count 112 |fewest m mm cm km in ft yd
count 112 m |fewest
count 112 r|r rmax round(
set h 48 |m mm cm km in ft yd
set mass 10 |kg g t lb oz
curve 0.1 0.9 |mm cm in
theta1 |(nothing)
theta1 th|threads thetac
count 2*sq|2*sqrt(
rmax.r_max_e|rmax.r_max_exact
solve d 0.05 |m mm cm km in ft yd
rmax with q ho|hollow
q = |hollow solid
2*rmax with fri|friction
animate speed 2; set ou|output
draw |at tower train forces
draw at |domino end
animate |speed rate tower
animate speed 2 r|rate
plot f|fall
plot sweep fr|friction
plot sweep s 0.1 0.3 3 : rm|rmax
cost |barrier duration rmax pair
set s |(nothing)
foo |(nothing)
fuel |(nothing)
END
    # In an expression, only parameters with a number, commands with a value, and functions are
    # offered.
    names=" $(completed 'print ') "
    for name in s r d q tol h g rmax barrier 'count(' ans 'sin(' 'sqrt(' pi; do
        [[ $names == *" $name "* ]] || same 'print' "$name" "$names"
    done
    for name in output angle chain curve set help quit; do
        [[ $names != *" $name "* ]] || same 'print' "no $name" "$names"
    done
    for call in 'theta1 2*' 'count 1 + ' 'rmax (' 'curve 0.1 0.9*'; do
        same "$call" "$names" " $(completed "$call" | sed 's/[^ ]*[*(]\([a-z]\)/\1/g') "
    done
}

@test "complete: keys after a dot" {
    same 'rmax.' 'rmax.s rmax.r_max rmax.r_max_exact rmax.r_max_paper' "$(completed 'print rmax.' | sed 's/ rmax\.ends_by//')"
    same 'barrier.m' 'barrier.margin' "$(completed 'print barrier.m')"
    same 'no functions' '(nothing)' "$("$DOMINO" -e 'complete print rmax.' | grep -x 'rmax\.sin')"
}

@test "complete: file names, where a command takes a file" {
    touch alpha.dom beta.dom
    mkdir alps
    for line in 'source ' 'fuel > ' 'fuel >> ' 'rmax 0.3 > '; do
        same "$line" 'alpha.dom alps beta.dom' "$("$DOMINO" -e "complete $line" | sed 's,/$,,' | sort | paste -sd ' ' -)"
        same "${line}b" 'beta.dom' "$(completed "${line}b")"
    done
    touch alps/gamma.dom
    same 'in a directory' 'alps/gamma.dom' "$(completed 'source alps/')"
    same 'no match' '(nothing)' "$(completed 'source zzz')"
    same 'nowhere else' '(nothing)' "$(completed 'theta1 alpha')"
}
