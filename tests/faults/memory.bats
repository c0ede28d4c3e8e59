#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Failing allocations and a small stack must lead to an error or to the right answer, but never to a crash or to a
# wrong answer.

load faults

# Checks a session with --bail: every line of the output is one of the expected lines, and errors are reported.
# Sentences that explain an answer may be missing without an error.
outcome() { # WHAT STATUS
    no_crash "$1" "$2"
    obtained=$(grep -vE '\.$' out) said=$(cat err)
    [ -n "${errors_may_lack-}" ] || same "$1: other lines" '(nothing)' "$(grep -vxFf expected out)"
    if [ "$2" -eq 0 ]; then
        [ -n "${errors_may_lack-}" ] || same "$1: the answers" "$answers" "$obtained"
    else
        [[ $said =~ ^(-e|domino|in\.dom|[a-z.]*:[0-9]*).*[a-z] ]] || same "$1: a message" 'why' "$said"
        [ -z "$(LC_ALL=C grep -v '^[[:print:][:space:]]*$' err)" ] || same "$1: what is said" readable "$said"
    fi
    left=$(inside)
    [[ $left != *.?????? ]] || same "$1: no draft" '(nothing)' "$left"
}

# Makes each allocation fail, first alone and then with all later allocations. If there are many, tries at most
# FAULTS_OF_MEMORY of them (60 by default), evenly spaced.
every_allocation() { # SESSION
    enter
    printf 'fuel; theta1 0.1\n' >in.dom
    "$DOMINO" -e 'effect row 4; row > row.csv'
    fail=$(dirname "$DOMINO")/faults/fail_alloc.so
    # 'env' comes after 'timeout', so that the library counts the allocations of the program alone
    soon env LD_PRELOAD="$fail" FAIL_COUNT="$PWD/count" "$DOMINO" --bail -n -e "$1" >expected
    answers=$(grep -vE '\.$' expected)
    local count step n mode most=${FAULTS_OF_MEMORY:-60}
    count=$(cat count)
    [ "$count" -gt 3 ]
    step=$(((count + most - 1) / most))
    for mode in '' FAIL_ON=1; do
        for ((n = 1; n <= count; n += step)); do
            soon env LD_PRELOAD="$fail" FAIL_AT=$n $mode "$DOMINO" --bail -n -e "$1" >out 2>err && status=0 ||
                status=$?
            outcome "'$1', allocation $n $mode" "$status"
        done
    done
}

@test "failing allocations: answers" { every_allocation 'fuel; set output json; rmax 0.3; show s; print ans; help rmax'; }
@test "failing allocations: every step of a search" { FAULTS_OF_MEMORY=1000 every_allocation 'print 1; rmax 0.3'; }
@test "failing allocations: a design" { every_allocation 'set output csv; best; design 1 m'; }
@test "failing allocations: best with friction" { every_allocation 'set output csv; set friction 0.2; best'; }
@test "failing allocations: files" { every_allocation 'fuel > a; fuel >> a; save b.dom; source b.dom; source in.dom > c; fuel'; }
@test "failing allocations: a row" { every_allocation 'effect row row.csv; fall; place 3 5 mm; mend; verdict'; }
@test "failing allocations: studies" { every_allocation 'set output csv; set threads 2; sweep s 0.2 0.6 3 : rmax'; }
@test "failing allocations: friction, a walk, pictures" {
    every_allocation 'effect friction 0.2; step; goto 0.1; why; cycle 3; draw 0.2 forces'
}
@test "failing allocations: random rows" { every_allocation 'set output csv; set threads 2; set row 4; set placement 5 mm; placement 40'; }
@test "failing allocations: quad with friction, and sweeps" {
    every_allocation 'set precision quad; set friction 0.2; barrier; reset; rmax 0.3; curve 0.3 0.5 3'
}
@test "failing allocations: errors" {
    # If memory runs out in the computation with 30 digits, numbers have no errors.
    errors_may_lack=yes
    every_allocation 'set errors on; rmax 0.3; curve 0.3 0.5 3'
}

# Chipmunk does not check whether an allocation fails.
@test "the rigid-body engine under a memory limit gives an answer or a reason, and does not crash" {
    enter
    local k refused=0 solved=0
    for ((k = 5000; k < 40000 && solved < 3; k += 250)); do
        (ulimit -v "$k" && soon "$DOMINO" -n -e 'effect row 3; set method engine; verdict') >out 2>err && status=0 || status=$?
        [ "$status" -ne 127 ] || continue # the loader found no memory
        no_crash "$k kB" "$status"
        if [ "$status" -eq 0 ]; then solved=$((solved + 1)); elif grep -q 'verdict: out of memory' err; then refused=1; fi
    done
    same 'refused, solved' '1 3' "$refused $solved"
}

@test "a stack of 128 kB is enough" {
    enter
    ulimit -s 128
    local quad='set precision quad; effect friction 0.2;'
    while read -r call; do
        soon "$DOMINO" -n -e "$call" >out 2>err && status=0 || status=$?
        same "$call: $(cat err)" 0 "$status"
        [ -s out ]
    done <<END
$quad fuel; launch; barrier; duration; why; step; cycle 5; slip; draw forces
set precision quad; set errors on; rmax; pair; why; cycle 5; chain 0.2; curve 0.3 0.5 3
effect friction 0.2; set threads 4; sweep s 0.2 0.6 5 : rmax
$quad set threads 2; sweep s 0.3 0.5 2 : barrier
$quad effect row 4; fall; verdict
effect row 4; effect placement 5 mm; set threads 4; placement 40; rowmax; mend; budget 0.9 20; effect floor 0.5; fall
effect row 5; set output csv; row > row.csv; effect row row.csv; place 3 1 cm; row; save x.dom; source x.dom; show
help; help rmax; apropos fuel; complete f; effects; cost rmax; best; count 112
END
}
