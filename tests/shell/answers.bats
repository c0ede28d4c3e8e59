#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# What commands answer as values, into files, through pipes and in tables.

load common

# ---- Commands in expressions ----

@test "each command with a principal column stands for that column, each other one for nothing" {
    local name key list=''
    for name in $("$DOMINO" -e 'complete '); do
        key=$("$DOMINO" -e "help $name" | sed -n "s/^In an expression '$name' stands for its \(.*\)\.\$/\1/p")
        if [ -n "$key" ]; then
            list+=" $name.$key"
        else
            run -1 --separate-stderr "$DOMINO" -e "print $name"
            [[ $stderr == *"'$name' has no value"* ]] || same "print $name" "'$name' has no value" "$stderr"
        fi
    done
    same 'the principal columns' ' thetac.theta_c theta1.theta_1 energy.dH fuel.fuel launch.omega0sq omega.omega'`
        `' barrier.barrier duration.duration where.theta why.margin rmax.r_max pair.r_max best.s count.dominoes'`
        `' verdict.seconds rowmax.r_max placement.probability pool.probability budget.sigma slip.needs' "$list"
    for name in thetac.theta_c 'theta1(0.1).theta_1' 'energy(0.1).dH' fuel.fuel launch.omega0sq 'omega(0.1).omega' \
        barrier.barrier duration.duration where.theta why.margin rmax.r_max pair.r_max best.s 'count(112).dominoes' \
        verdict.seconds rowmax.r_max 'placement(50).probability' 'budget(0.9, 50).sigma' slip.needs; do
        same "$name" 0 "$("$DOMINO" -e "effect row 4; effect placement 5 mm; print $name - ${name%.*}" | cut -d ' ' -f 1)"
    done
}

# ---- One state for 'where' and 'draw' ----

@test "draw without T shows the state of 'where', whatever has changed since the last step" {
    local change where
    for change in 'set s 0.3' 'set r 1.4' 'set d 0.2' 'set q 3' 'set tol 1e-9' 'set fuel paper' \
        'set precision quad' 'effect friction 0.3'; do
        [[ $("$DOMINO" -e "goto 0.2; $change; where") == *'the walk begins anew'* ]]
        same "$change" "$("$DOMINO" -e "$change > /dev/null; draw 0")" \
            "$("$DOMINO" -e "goto 0.2 > /dev/null; $change > /dev/null; draw")"
    done
    for change in 'set h 1' 'set mass 2' 'set digits 5' 'set seed 3' 'effect row 5' 'effect floor 0.4'; do
        [[ $("$DOMINO" -e "goto 0.2; $change; where") != *'the walk begins anew'* ]]
        same "$change" "$("$DOMINO" -e "$change; draw 0.2")" "$("$DOMINO" -e "goto 0.2 > /dev/null; $change; draw")"
    done
    # The walk is computed to a tolerance of its own, so that every state that it stands in can be drawn.
    for change in 'set tol 0.1' 'set tol 0.01' 'set tol 1e-13'; do
        same "$change" "$("$DOMINO" -e 'set r 1.7; goto stop > /dev/null; draw')" \
            "$("$DOMINO" -e "$change; set r 1.7; goto stop > /dev/null; draw")"
    done
}
