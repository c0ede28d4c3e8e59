#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Expressions: arithmetic, functions, names, answers, comparisons, the end of a value, and errors.

load common

# Prints TEXT COUNT times. The text is doubled in each step, because a million calls of printf would take a
# long time.
repeat() { # TEXT COUNT
    awk -v text="$1" -v n="$2" 'BEGIN {
        for (many = text; n > 0; many = many many) { if (n % 2) printf "%s", many; n = int(n / 2) } }'
}

@test "numbers, precedence, signs, powers and parentheses" {
    all_worth <<'END'
0.5|-|.5
19.5|-|(2+3)*4-1/2
0.25|-|1/2/2
4|-|(-2)^2
512|-|2^3^2
0.25|-|2 ^ -2
-6|-|2*-3
0.14583333333333334|-|0.7/4.8
7e-17|-|7/1e17
END
}

@test "functions and pi" {
    all_worth <<'END'
3.1415926535897931|-|pi
1|-|sin(90 deg)
1.0471975511965979|rad|acos(0.5)
2.3561944901923448|rad|atan2(1 m,-1 m)
3|-|log10(1000)
2|m|sqrt(4 m^2)
3|m|abs(-3 m)
-3|-|floor(-2.5)
5|m|hypot( 3 m , 4 m )
0.01|m|min(1 cm, 2 cm)
4|-|max(1,2)*min(3,2)
END
}

# bats test_tags=sweeps
@test "the end of a value: '1 - 0.5' is one value, '0.1 -0.5' are two" {
    all_worth <<'END'
0.5|-|1 - 0.5
0.5|-|1- 0.5
END
    all_wrong <<'END'
12|theta1 0.1 -0.5|^theta1: '-0.5' is one argument too many
9|print 1 -0.5|^print: '-0.5' is one argument too many
9|print 1 2|^print: '2' is one argument too many
9|print 2 (3)|^print: '\(3\)' is one argument too many
END
    same 'one argument' "$(json 'count 111')" "$(json 'count 112 - 1')"
    same 'two arguments' "$(json 'count 112 2')" "$(json 'count 112 +2')"
    same 'two words of an expression' "$(json 'curve 0.05 0.3 3')" "$(json 'curve 0.1 - 0.05 0.3 3')"
}

@test "in an expression, names of parameters, commands and answers stand for their values" {
    all_worth <<'END'
0.4|-|s
0.048|m|h
9.81|m s^-2|g
20.833333333333333|m^-1|1/h
END
    # Compare each name with the answer of the command.
    while IFS='|' read -r expression command key unit; do
        all_worth <<<"$(json "$command" | values "$key")|${unit}|$expression"
    done <<'END'
thetac|thetac|theta_c|rad
energy(0.1)|energy 0.1|dH|-
launch.omega0|launch|omega0|s^-1 rad
duration.speed|duration|speed|m s^-1
rmax(0.3).r_max_paper|rmax 0.3|r_max_paper|-
best.s|best|s|-
count(112 m, 2)|count 112 2|dominoes|-
count(112, 2).last_height|count 112 2|last_height|m
END
    close 'nested' "$(json 'rmax 0.2' | values r_max)" "$(json 'print rmax(rmax(0.3)/rmax(0.3)/5)' | values value)"
    close 'set r 0.99*rmax' "$(json 'print 0.99*rmax' | values value)" "$(json 'set r 0.99*rmax; show r' | values value)"
}

@test "ans is the last answer, and ans.KEY is one of its numbers" {
    while IFS='|' read -r commands expression command key; do
        expected=$(json "$command" | values "$key")
        close "$commands; $expression" "$expected" \
            "$(json "$commands; print $expression" | tail -n 1 | values value)"
    done <<'END'
rmax 0.3|ans.r_max_paper|rmax 0.3|r_max_paper
thetac; set s 0.3|ans|thetac|theta_c
rmax; foo|ans|rmax|r_max
rmax; print pair(0.3)|ans.r_max|rmax|r_max
fuel > /dev/null|ans|fuel|fuel
END
    same 'as an argument' "$(json "set s 0.3; rmax $(json fuel | values fuel)")" \
        "$(json 'fuel; set s 0.3; rmax ans' | tail -n 1)"
    same 'an angle' "$(json 'theta1 theta1(0.1)/2' | tail -n 1)" "$(json 'theta1 0.1; theta1 ans/2' | tail -n 1)"
    # An answer without a value cannot be used.
    run -1 --separate-stderr json 'set s 0.001; rmax; set r ans'
    [[ $stderr =~ ^-e:1:.*'has no value here' ]] || same 'no growth' 'has no value here' "$stderr"
}

@test "errors in expressions: the column is right, even after multibyte letters" {
    all_wrong <<'END'
13|print π×2 − foo|^print:.*'foo' has no value
19|fuel > /dev/null; foo|^unknown command 'foo'
10|θ1 0.1 > foo bar|^theta1: only one word
7|print *2|^print:.*'\*2'.*missing|^print:.*missing.*'\*2'
9|print 1*(2*(3)|^print:.*'\(' is never closed
13|print (rmax 0.4)|^print:.*write 'rmax\(0.4\)' for 'rmax 0.4'
8|print 1)|^print:.*'\)'
8|print 2q|^print:.*'q' is not a unit
10|print 0.4.1|^print:.*'.1'
8|print 1,5|^print:.*',5'
12|print 1 + 1/(2-2)|^print:.*division by zero
7|print sqrt(-1)|^print:.*sqrt
9|print 10^5000|^print:.*finite
7|print 1e5000|^print:.*too large
7|print sin()|^print:.*sin takes 1 value
7|print rmax(1,2)|^print:.*'rmax \[S\]' does not take 2 values
7|print theta1|^print:.*'theta1' needs a value in parentheses: 'theta1.T.'
12|print rmax(foo)|^print:.*'foo' has no value
7|print output|^print:.*'output' has no value
7|print 0x10|^print:.*decimal number
7|print "1" + 1|^print:.*'"1"'
11|print sin(,1)|^print:.*missing
7|print rmax.foo|^print:.*unknown key of rmax 'foo'; its keys are s, r_max, 
7|print rmax.ends_by|^print:.*rmax.ends_by is the word 'barrier'
7|print pair(0.1)|^print:.*has no value here: no growth possible
11|print 2 + thetac.theta_leave|^print:.*has no value here; enter 'thetac' to see why
END
    same 'a comment begins after a blank' 2 "$(json 'print 2 #3; print 4' | values value)"
    wrong_at 7 'print ans' '^print:.*no earlier answer'
}

@test "deeply nested or megabyte-long nonsense gives a one-line error, and no crash" {
    deep() { # BEGIN REPEATED COUNT END [STATUS]
        printf '%s' "$1" >deep
        repeat "$2" "$3" >>deep
        printf '%s\nset output json; show s\n' "$4" >>deep
        run --separate-stderr "$DOMINO" --keep-going deep
        same "$1$2...: status" "${5:-1}" "$status"
        same "$1$2...: the session goes on" 0.4 "$(tail -n 1 <<<"$output" | values value)"
        [ "${5:-1}" -eq 0 ] || same "$1$2...: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [ "${#stderr}" -lt 400 ] || same "$1$2...: length" '< 400' "${#stderr}"
    }
    deep 'print ' '(' 10000 1
    deep 'print ' '(' 10000 "1$(repeat ')' 10000)"
    for text in '(' '-' '2^' 'sin(' 'rmax(' 'a' '9' '.' 'θ' '1-(' ')' '1,' '1 ' 'ans.' '*' '/' '1e'; do
        deep 'print ' "$text" 10000 1
        deep 'print ' "$text" 1000000 ''
    done
    deep 'print ' '"' 999999 ''
    deep 'print ' '"' 1000000 '' 0
    # Long expressions that are valid.
    deep 'print ' '1+' 100000 1 0
    deep 'print 0.5' '0' 1000000 '' 0
    deep 'complete set s ' '(' 1000000 '' 0
}

@test "a line that is an expression is evaluated" {
    all_print <<'END'
(1 -2)*3|-3
sin(30 deg)|0.5
ln(112/0.048)/ln(1.5)|19.1263
rmax(0.3)|1.51445
rmax/2|0.822115
fuel.fuel_paper|0.592292
2+2 # four|4
rmax 0.3; ans.s|0.3
112 m; ans/2|56 m
END
}

@test "comparisons, and, or, not, if: 1 is true, 0 is not" {
    local line
    for line in 'print 2 == 2' 'r == 1.5' 'r==1.5' '1 < 2 and 2 <= 2' '(2 > 1)' 'not 0' '(not 1 > 2) or 0' '1 m != 2 m' 'thetac < 90 deg' \
        'print if(rmax >= 1.5, 1, 0)' 'if(0, 1/0, 1)' '1 or 1/0 < 0' '2 >= 1 + 1' 'rmax(0.4) < 1.7 and not rmax(0.4) <= 1.6' '(rmax > 1.6)'; do
        same "$line" 1 "$("$DOMINO" -n -e "$line")"
    done
    for line in 'r == 2' '2 < 1 or 3 < 2' 'not 2' '(1 > 2 and 1/0)' 'if(1 < 2, 0, 1)' '0 and 1/0'; do
        same "$line" 0 "$("$DOMINO" -n -e "$line")"
    done
    wrong 'print 1 < 2 < 3' "join comparisons with 'and'"
    wrong 'print 1 m < 2' 'a length and a plain number cannot be compared'
    wrong 'if(1 m, 1, 0)' 'a length is not a condition'
    wrong 'if(1, 2)' "'if' takes a condition and two values"
    wrong 'let and = 1' "'and' is a word of the expression language"
}

# bats test_tags=rows,sweeps
@test "with: changes parameters for one answer only" {
    local alone
    alone=$("$DOMINO" -n -e 'set q hollow; set d 0.1; print rmax(0.4)')
    same 'command' "$alone" "$("$DOMINO" -n -e 'print rmax(0.4) with q hollow d 0.1')"
    same 'with =' "$alone" "$("$DOMINO" -n -e 'print rmax(0.4) with q=hollow d=0.1')"
    same 'a function' "$alone" "$("$DOMINO" -n -e 'let f(x) = rmax(x)*d/0.1; f(0.4) with q 3 d 0.1')"
    same 'solve' "$("$DOMINO" -n -e 'set output csv; set q hollow; solve s 0.1 0.9 : rmax = 2')" \
        "$("$DOMINO" -n -e 'set output csv; solve s 0.1 0.9 : rmax with q hollow = 2')"
    same 'a row' "$("$DOMINO" -n -e 'effect row 5; effect push 3; print verdict.seconds')" \
        "$("$DOMINO" -n -e 'print verdict.seconds with row 5 push 3')"
    same 'the session stays' "$("$DOMINO" -n -e 'set output csv; show; rmax')" \
        "$("$DOMINO" -n -e 'rmax with q hollow friction 0.2 row 5 > /dev/null; set output csv; show; rmax')"
    same 'assert' '(nothing)' "$("$DOMINO" -n -e 'assert barrier with r 1.2 > /dev/null')"
    wrong 'assert barrier with r 1.9' 'not true'
    wrong 'rmax with' "'with' takes parameters and effects"
    wrong 'rmax with q' 'the value of q after .with. is missing'
    wrong 'rmax with digits 3' "'digits' is a setting of the calculator"
    wrong 'verdict with push 3' 'there is no row'
    wrong 'rmax with s 2' 's = 2 is out of range'
    wrong 'set s 0.3 with r 2' "'with' can only follow a command that computes an answer"
}

# bats test_tags=rows,chance,planning
@test "a command with a principal column stands for that column, and any other command is an error" {
    local name key count=0
    for name in $("$DOMINO" -e 'complete '); do
        key=$("$DOMINO" -e "help $name" | sed -n "s/^In an expression, '$name' stands for the value \(.*\)\.\$/\1/p")
        if [ -n "$key" ]; then
            count=$((count + 1))
            run --separate-stderr "$DOMINO" --keep-going -e "print $name; print $name.$key"
            [ "${lines[0]}" = "${lines[1]}" ] || same "$name.$key" "${lines[0]}" "${lines[1]}"
        else
            run -1 --separate-stderr "$DOMINO" --keep-going -e "print $name"
            [[ $stderr == *"'$name"*"' has no value"* ]] || same "print $name" "'$name' has no value" "$stderr"
        fi
    done
    [ "$count" -ge 10 ]
}

# bats test_tags=rows,chance,pictures,sweeps,save
@test "commands that take a file or a word have no value in an expression" {
    wrong 'print save(1)' "'save' has no value in an expression; enter the command alone"
    same completion '(nothing)' "$("$DOMINO" -e 'complete print sav')"
    same help '(nothing)' "$("$DOMINO" -e 'help save' | grep 'In an expression' || true)"
}

# bats test_tags=rows,sweeps
@test "no nesting overflows the stack" {
    # 600 lines of nested values, most of them with a wrapper inside another, and each followed by 41+1. A wrapper that is
    # nested 6,000 deep overflowed the stack; those near the limit must not, either.
    awk 'BEGIN {
        n = split("(|sin(|-|not |2^|if(1, |rmax(|(0.1 + 2*", open, "|")
        split(")|)||||, 1)|)|)", close_, "|")
        split("print |let x = |let f(x) = |rmax |rmax with s |set s |assert 0 < |sweep r 1 2 2 : |solve s : rmax = |change 1 height ", command, "|")
        srand(7)
        for (line = 0; line < 600; line++) {
            first = 1 + line % n; second = 1 + int(n*rand())
            depth = int(10^(0.5 + 3.3*rand()))
            left = right = ""
            for (k = 0; k < depth; k++) {
                i = k % 7 ? first : second
                left = left open[i]; right = close_[i] right
            }
            print command[1 + int(line/n) % 10] left "0.3" right "\n41+1"
        }
        for (k = 0; k < 100; k++) {
            left = right = ""
            for (i = 0; i < 80; i++) { left = left "sin("; right = right ")" }
            print "let g" k "(x) = " left (k ? "g" k-1 "(x)" : "x") right "\ng" k "(1)\n41+1"
        }
    }' >deep.dom
    run --separate-stderr bash -c 'ulimit -s 1024; "$DOMINO" --keep-going -f deep.dom'
    [[ $status == 1 && $stderr == *'nested too deeply'* ]]
    same 'answers' 700 "$(grep -cx 42 <<<"$output")"
}

@test "print of a text writes it as echo does" {
    same 'print of a text' 'a;b > 4' "$("$DOMINO" -e 'print "a;b > 4"')"
    wrong 'print "a" b' "print: VALUE at '\"a\"': a value is missing"
}
