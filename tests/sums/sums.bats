#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Numbers made of the columns of a table in expressions: sum, min, max and count.

load ../shell/common

@test "sums over the chain give the inertia of the train, and the paper's collision law (e5) to (e8)" {
    # Domino i has the energy weight r^(-q i), and its moment of inertia is smaller by another r^-i.
    while read -r scene; do
        all=$(json "$scene; let J(t) = sum(chain(t).weight * r^-chain(t).i * chain(t).slope^2); print J(0)
            print J(0.1)
            print 1 + r^-(q + 1) * J(thetac)
            energy 0.1")
        mapfile -t inertia < <(values value <<<"$all")
        close "$scene: (e6)" "$(values J0 <<<"$all")" "${inertia[0]}" 1e-11
        close "$scene: J(0.1)" "$(values J <<<"$all")" "${inertia[1]}" 1e-11
        close "$scene: (e7)" "$(values J0 <<<"$all")" "${inertia[2]}" 1e-11
    done <<'END'
reset
set q hollow; set r 1.9
set r 1; set s 0.6
set tol 1e-4; set precision quad; set tol 1e-20
END
}

# bats test_tags=landmarks
@test "aggregates are those of the columns in csv, computed by awk" {
    csv 'chain 0.2' >chain.csv
    awks() { awk -F, "NR > 1 { $1 } END { printf \"%.17g\", $2 }" chain.csv; }
    while IFS='|' read -r expression body end; do
        close "$expression" "$(awks "$body" "$end")" "$(json "print $expression" | values value)" 1e-14
    done <<'END'
sum(chain(0.2).arm_a * chain(0.2).weight)|x += $4 * $6|x
sum(2*chain(0.2).arm_a - chain(0.2).arm_b^2)|x += 2 * $4 - $5 ^ 2|x
min(chain(0.2).weight)|x = (NR == 2) + ($6 < x) ? $6 : x|x
max(-chain(0.2).arm_b)|x = (NR == 2) + (-$5 > x) ? -$5 : x|x
count(chain(0.2).weight)|x++|x
sum(chain(0.2).weight > 0.01)|x += $6 > 0.01|x
sum(if(chain(0.2).i > 0, chain(0.2).weight, 0))|x += $1 > 0 ? $6 : 0|x
END
    # by hand, with units, in all places where an expression may stand
    all_print <<'END'
let twice(x) = 2*x; print sum(twice(landmarks.height)) / sum(landmarks.height)|2
print max(landmarks.height) to m|8848.86 m
print count(landmarks.name) - count(landmarks.height)|0
print sum(chain(0).weight / sum(chain(0).weight))|1
set s 0.3; let a = sum(chain(0).arm_a); set s 0.4; print sum(chain(0).arm_a) - a with s 0.3|0
print count(112 m) + count(112 m, 2)|32
print max(3, 4) + min(3, 4)|7
let f(sum) = 3*sum; print f(rmax) - 3*rmax|0
END
}

# bats test_tags=rows,sweeps
@test "aggregates of a row, in a sweep, in assert and in solve" {
    scene='set row 4; set r 2; set s 0.3'
    wrong 'print sum(curve(0.1, 0.9, 3).s)' "'curve' has no value"
    close 'the gaps' "$(awk 'BEGIN { print 0.3 * 0.048 * (2 + 4 + 8) }')" "$(json "$scene; print sum(row.gap)" | values value)"
    same 'the unit' m "$(json "$scene; print sum(row.gap)" | values unit)"
    close 'the last hit' "$(json "set row 4; fall" | tail -n 1 | values hit)" \
        "$(json 'set row 4; print max(if(fall.domino > 1, fall.hit, 0 s))' | values value)"
    close 'mass' "$(awk 'BEGIN { print 0.01 * (1 + 1.5^2 + 1.5^4) }')" "$(json 'set q 3; set row 3; set mass 10 g; print sum(row.mass)' | values value)"
    expected=$(for s in 0.2 0.4 0.6; do json "set s $s; print sum(chain(0).slope)" | values value; done)
    same 'sweep' "$expected" "$(json 'sweep s 0.2 0.6 3 : print sum(chain(0).slope)' | values value)"
    "$DOMINO" -e 'assert (sum(chain(0).weight) > 1.2)'
    wrong 'assert (sum(chain(0).weight) > 1.3)' 'not true'
    close 'solve' 2 "$(json 'set row 3; solve r : max(row.height) = 4*h' | values value)" 1e-9
}

# bats test_tags=rows,landmarks
@test "no column, no number, no row, or columns of different lengths: an error of one line" {
    all_wrong <<'END'
7|print chain(0).weight|'chain' has no value: its answer is a table; .* as in 'sum.chain.0..weight.'
11|print sum(chain(0))|'chain' has no value: its answer is a table
11|print sum(chain(0).foo)|unknown key of chain 'foo'; its keys are i, theta_i, slope_i, arm_a, arm_b, weight$
11|print sum(chain.weight)|'chain' needs a value in parentheses: 'chain.T.\.weight'$
11|print sum(chain(0, 1).weight)|'chain T' does not take 2 values
7|print sum(3)|'sum' takes a column of a table, as in 'sum.chain.0..weight.'
7|print max(3)|'max' takes a column of a table, as in 'max.chain.0..weight.', or two values
7|print count(chain(0).weight > 0.1)|'sum.CONDITION.' counts the rows for which a condition is true
11|print sum(landmarks.what)|landmarks.what is the word .*; only 'count' takes words
36|print sum(landmarks.height/(1 m) + chain(0).weight)|'chain' is another table; all columns must be of one table
28|print sum(landmarks.height + 1)|a length and a plain number cannot be added
17|print sum(chain(chain(0).weight).weight)|'chain' has no value: its answer is a table
7|print max(fall.hit)|there is no row
END
    wrong 'set row 3; print max(fall.hit)' "fall.hit has no value in row 1; 'if' can choose another value there"
    wrong 'set row 3; print sum(row.mass)' "row.mass is not in the table here; enter 'row' to see why"
    wrong 'set row 3; print sum(if(row.domino == 1, 0, row.gap))' 'a plain number and a length are in different rows of the same column'
    for name in 'sum(x)' sum 'min(x)' 'max(x, y)' 'count(x)'; do # a function of the user would hide the sums
        wrong "let $name = 1" "'${name%%(*}' is a (built-in value|command|unit); choose another name, such as 'my_${name%%(*}'"
    done
    wrong 'let w(t) = chain(t).weight; print w(0)' "in 'w\(t\)': 'chain' has no value: its answer is a table"
}

# bats test_tags=rows
@test "completion offers sum, tables within it, and their columns" {
    while IFS='|' read -r line expected; do same "$line" "$expected" "$(completed "$line")"; done <<'END'
print su|sum(
print 2*sum(ch|2*sum(chain(
print max(chain(0).w|max(chain(0).weight
END
    same 'help sum' "$("$DOMINO" -e 'help print')" "$("$DOMINO" -e 'help sum')"
}
