#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Lines without a command's name: expressions, names, assignments, questions; conversions, variables, functions.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

# Rows of LINE|ANSWER on stdin: what the line prints, its last line.
all_print() {
    local line answer
    while IFS='|' read -r line answer; do same "$line" "$answer" "$("$DOMINO" -e "$line" | tail -n 1)"; done
}

# Rows of LINE|COMMANDS: the two print the same, in json.
all_mean() {
    local line commands
    while IFS='|' read -r line commands; do same "$line" "$(json "$commands")" "$(json "$line")"; done
}

@test "a line that is an expression is evaluated" {
    all_print <<'END'
2+2|4
2 + 2|4
sin(30 deg)|0.5
ln(112/0.048)/ln(1.5)|19.1263
-1|-1
(2+3)*4|20
.5|0.5
pi|3.14159
r^2|2.25
rmax(0.3)|1.51445
rmax * 2|3.28846
rmax/2|0.822115
rmax - 1|0.644229
fuel.fuel_paper|0.592292
2+2 # four|4
rmax 0.3; ans.s|0.3
2+2; ans*3|12
112 m; ans/2|56 m
END
}

@test "commands keep their names, and a beginning that two have is the older one's" {
    all_mean <<'END'
se s 0.3; show s|set s 0.3; show s
pr 3|print 3
re; show s|reset; show s
l|launch
print(3)|print 3
show()|show
END
    same 'fuel is the command' 0.177287 "$("$DOMINO" -e fuel | awk '/^fuel_exact/ { print $2 }')"
}

@test "a parameter's name shows it, '=' and 'to' set it, '?' explains it" {
    all_mean <<'END'
q|show q
output|show output
friction|show friction
r = 2; r|set r 2; show r
r=rmax*0.99; r|set r 0.99*rmax; show r
set r = 2; r|set r 2; show r
set r=2; r|set r 2; show r
set r to 2; r|set r 2; show r
fuel = paper; show fuel|set fuel paper; show fuel
friction = 0.2; friction|effect friction 0.2; show friction
effect friction = 0.2; friction|effect friction 0.2; show friction
END
    for line in '?rmax' '? rmax' 'rmax?' 'rmax ?' 'help rmax?' '??rmax'; do
        same "$line" "$("$DOMINO" -e 'help rmax')" "$("$DOMINO" -e "$line")"
    done
    same '?' "$("$DOMINO" -e help)" "$("$DOMINO" -e '?')"
    same 'q does not leave' 3 "$("$DOMINO" -e 'q; 1+2' | tail -n 1)"
}

@test "'to' converts" {
    all_print <<'END'
112 m to ft|367.454 ft
rmax to percent|164.423 %
0.9*rmax(0.3) to %|136.301 %
10 g to oz|0.35274 oz
600 kg/m^3 to g/cm^3|0.6 g/cm^3
thetac to deg|36.8699 deg
pi/2 to deg|90 deg
print duration.speed to mm/s|214.37 mm/s
END
    same json '{"value":10000,"unit":"mm"}' "$(json '10 m to mm')"
    wrong '112 m to s' "the value is a length, and 's' is a unit of a time; its units: m mm cm km in ft yd"
    wrong '5 to m/s' "the value is a plain number, and 'm/s' is in m s\^-1; its units: percent"
    wrong '112 m to fot' "'fot' is not a unit; did you mean 'ft'"
    wrong '112 m to' "the unit after 'to' is missing; for example m mm"
    wrong '112 to m' 'the value is a plain number.*its units: percent'
    wrong '112 m ti ft' "'ti' is not a unit"
    wrong '112 m to ft 3' "'3' is one argument too many"
    wrong 'rmax to m/h' "'m/h' is not a unit"
}

@test "let: a variable keeps its value, and its unit" {
    all_print <<'END'
let x = 2; x|2
let x = 2; x = 3; x^2|9
let x = 0.9*rmax; set s 0.9; x|1.47981
let tall = 112 m; tall/2|56 m
let tall = 112 m; tall to ft|367.454 ft
let p = 600 kg/m^3; density = p; density*1|600 kg m^-3
let x = 0.3; rmax x; ans.s|0.3
let x = 1; let x = x + 1; x|2
let big = 0.5; rmax big; ans.s|0.5
END
}

@test "let: what is defined is shown, explained, forgotten and completed" {
    local all='let xx = 2 m; let ff(a) = 2*a'
    while IFS='|' read -r line commands; do same "$line" "$(json "$all; $commands")" "$(json "$all; $line")"; done <<'END'
xx?|help xx
? ff|help ff
ff|show ff
END
    same 'let alone' 'xx ff(a)' "$("$DOMINO" -e "$all; let" | awk 'NR > 1 { print $1 }' | paste -sd ' ' -)"
    same 'let with a name' 'xx' "$("$DOMINO" -e "$all; let xx" | awk 'NR > 1 { print $1 }')"
    same 'forgotten' 'ff(a)' "$("$DOMINO" -e "$all; reset xx; let" | awk 'NR > 1 { print $1 }')"
    same 'back again' '2 m' "$("$DOMINO" -e "$all; reset xx" -e 'undo; xx' | tail -n 1)"
    same 'reset keeps them' '2 m' "$("$DOMINO" -e "$all; reset; xx")"
    wrong "$all; reset xx; xx" "unknown command 'xx'"
    wrong "$all; set xx 3" "'xx' is a variable; 'xx = VALUE' changes it"
    while IFS='|' read -r line words; do
        same "complete $line" "$words" "$("$DOMINO" -e "$all" -e "complete $line" | paste -sd ' ' -)"
    done <<'END'
x|xx
show x|xx
reset x|xx
help x|xx
let x|xx
let y = 3*x|3*xx
print 2+x|2+xx
print 2+ff|2+ff(
count x|xx
rmax x|(nothing)
END
}

@test "the last values of other calculators lead to what is here" {
    local line
    for line in _ % %1 ans2 _*2; do wrong "2+2; $line" "the last value is 'ans'"; done
}

@test "words of other programs: the message names what is meant" {
    wrong 'bye' "unknown command 'bye'; did you mean '(exit|quit)'"
    wrong 'RMAX' "unknown command 'RMAX'; did you mean 'rmax'"
    wrong 'Show s' "did you mean 'show'"
    wrong '2**10' "a power is written with '\^'"
    wrong 'help(rmax)' "'help' has no value; the command is entered without parentheses"
    wrong 'let xx = 3; xx += 1' "'xx' is a variable; 'xx = VALUE' changes it"
    wrong 'nonesuch' "unknown command 'nonesuch'; 'help' lists the commands"
}

@test "watch is for the prompt, and says so" {
    wrong 'watch s 0.1 0.9: rmax' 'keys need the prompt on a terminal .* lists the answers'
    wrong 'watch s 0.9 0.1: rmax' 'FROM is less than TO'
    wrong 'watch s' "the form is 'watch s : rmax'"
    wrong 'watch s 0.1 0.9:' "the answer is missing after ':'"
}

@test "let: a function of one line" {
    all_print <<'END'
let f(s) = rmax(s)*s; f(0.3)|0.454336
let f(a, b) = a^b; f(2, 10)|1024
let f(s) = s^2; let g2(s) = f(s + 1) + s; g2(2)|11
let f(s) = r*s; r = 2; f(3)|6
let f(x) = sin(x); angle = deg; f(30)|0.5
END
    same 'its own values hide names' 5 "$("$DOMINO" -e 'let f(s) = s' -e 'f(5)')"
    same 'in a sweep' '0.2 0.3' "$(json 'let f(a) = a; sweep s 0.2 0.3 2 : print f(s)' | values value | paste -sd ' ' -)"
    same 'an expression in a sweep' '0.4 0.6' "$(json 'let f(a) = a; sweep s 0.2 0.3 2 : 2*f(s)' | values value | paste -sd ' ' -)"
    same 'in solve' 2 "$(json 'let f(x) = x^2; solve r : f(r) = 4' | values value | head -n 1 | sed 's/\(1.99999\).*/2/')"
}

@test "let: names that have a meaning, and texts that are none" {
    wrong 'let r = 2' "'r' is a parameter; choose another name"
    wrong 'let rmax = 2' "'rmax' is a command"
    wrong 'let m = 2' "'m' is a unit"
    wrong 'let sin = 2' "'sin' is a value"
    wrong 'let ans = 2' "'ans' is a value"
    wrong 'let x' "a definition is 'let x"
    wrong 'let x =' "the value of 'x' is missing"
    wrong 'let x 2' "a definition is 'let x"
    wrong 'let f(a = 3' 'a definition is'
    wrong 'let f(a,b,c,d,e) = 3' 'a function of 1 .. 4 values'
    wrong 'let f(a,a) = 3' "two values of 'f' have the name 'a'"
    wrong 'let f(a) = a +' "ends before '\+'"
    wrong 'let f(a) = (a' "this '\(' is never closed"
    wrong 'let f(a) = a; f(1, 2)' "'f\(a\)' takes 1 value"
    wrong 'let f(a) = foo*a; f(1)' "in 'f\(a\)': 'foo' has no value"
    wrong 'let f(a) = f(a); f(1)' "'f\(a\)' uses itself"
    wrong 'let f(a) = a; let k(a) = f(a); let f(a) = k(a); k(1)' "'k\(a\)' uses itself"
    wrong 'let x = (1 m)^12' 'an exponent above 9'
    wrong 'y = 3' "'y' is no parameter; 'let y = VALUE' defines a variable"
    wrong 'frictoin = 0.2' "did you mean 'friction'"
    wrong 'z(a) = 3' "'let z\(...\) = VALUE' defines a function"
    wrong 'foo+1' "'foo' has no value"
    wrong '1/0' 'division by zero'
    wrong '.help' "commands have no '.' before"
    wrong 's 0.3' "'s' is a parameter; 's = VALUE'"
    wrong 'q 3' "'q' is a parameter"
}

@test "variables are listed by 'show' and read back after 'save'" {
    cd "$BATS_TEST_TMPDIR"
    "$DOMINO" -e 'let p = 600 kg/m^3/3; let a = 10 deg; let f(x, y) = x*p + y; let n = 1/3; save s.dom; show' >shown
    "$DOMINO" -e 'source s.dom; save t.dom; show' >again
    same_file s.dom t.dom
    same_file shown again
    same 'the function' 'f(x, y) x*p + y' "$(awk '/^f\(/ { print $1, $2, $3, $4, $5 }' shown)"
    same 'in a quotient' 0.2 "$("$DOMINO" -e 'source s.dom; p/(1000 kg/m^3)')"
    same 'quad' 0 "$("$DOMINO" -e 'source s.dom; n*3 - 1')"
}

@test "a definition may not make a session hang" {
    {
        echo 'let f0(x) = x'
        for i in {1..60}; do echo "let f$i(x) = f$((i - 1))(x)"; done
        for i in {61..200}; do echo "let f$i(x) = ((f$((i - 1))(x)))"; done
        echo 'f60(7); f200(7); 41+1'
    } >"$BATS_TEST_TMPDIR/deep.dom"
    run --separate-stderr "$DOMINO" --keep-going -f "$BATS_TEST_TMPDIR/deep.dom"
    same deep '7 42' "$(grep . <<<"$output" | paste -sd ' ' -)"
    [[ $stderr == *'nested too deeply'* ]]
    repeat=$(printf '(%.0s' {1..300})
    wrong "let f(x) = $repeat" 'nested too deeply'
}

@test "undo and redo: whatever changes the scene" {
    cd "$BATS_TEST_TMPDIR"
    printf 'set s 0.3\nset r 1.2\n' >two.dom
    printf 'height (mm), thickness (mm), gap (mm)\n48, 7, -\n60, 8, 20\n80, 9, 30\n' >row.csv
    local before change state
    while IFS='|' read -r before change; do
        state='show; diff; row'
        "$DOMINO" --keep-going -e "$before; $state" >as_was 2>&1 || true
        "$DOMINO" --keep-going -e "$before; $change > /dev/null; $state" >changed 2>&1 || true
        "$DOMINO" --keep-going -e "$before; $change > /dev/null; undo > /dev/null; $state" >undone 2>&1 || true
        "$DOMINO" --keep-going -e "$before; $change > /dev/null; undo > /dev/null; redo > /dev/null; $state" >redone 2>&1 || true
        clean() { grep . "$1" | sed 's/^-e:[0-9:]* //'; }
        same "$change" "$(clean as_was)" "$(clean undone)"
        same "$change again" "$(clean changed)" "$(clean redone)"
        ! cmp -s as_was changed || differ "$change" "$(clean as_was)" "$(clean changed)"
    done <<'END'
s = 0.5|s = 0.3
s = 0.5|reset
effect row row.csv|place 2 25 mm
effect row row.csv; place 2 25 mm|reset
effect row row.csv; place 2 25 mm|effect row 3
set d 0.2|precision = quad
set d 0.2|friction = 0.2
friction = 0.1|effect friction off
set d 0.2|let x = 3
let x = 4|x = 3
let x = 4|let x(a) = a
set d 0.2|source two.dom
set q hollow|design 1
END
}

@test "undo: what it says, where it ends, and a change that is none" {
    same 'says' 'undone: r = 2' "$("$DOMINO" -e 'r = 2; undo')"
    same 'again' 'done again: r = 2' "$("$DOMINO" -e 'r = 2; undo > /dev/null; redo')"
    same 'as data' '{"change":"s = 0.3"} {"change":"s = 0.3"}' "$(json 's = 0.3; undo; redo' | paste -sd ' ' -)"
    same 'in order' '0.3 0.2 0.4' "$("$DOMINO" -e 's = 0.2; s = 0.3; print s; undo > /dev/null; print s; undo > /dev/null; print s' |
        grep . | paste -sd ' ' -)"
    same 'no change' 0.4 "$("$DOMINO" -e 's = 0.2; s = 0.2; undo > /dev/null; print s')"
    wrong undo 'there is no change to take back'
    wrong redo 'there is nothing to do again'
    wrong 's = 0.2; undo > /dev/null; s = 0.3; redo' 'there is nothing to do again'
    for i in {1..150}; do echo "seed = $i"; done >"$BATS_TEST_TMPDIR/many.dom"
    for i in {1..100}; do echo 'undo > /dev/null'; done >>"$BATS_TEST_TMPDIR/many.dom"
    same 'the last 100' 50 "$("$DOMINO" -f "$BATS_TEST_TMPDIR/many.dom" -e 'seed*1')"
}

@test "diff: what differs from the defaults" {
    same none 'All parameters have their defaults, and no effect is on.' "$("$DOMINO" -e diff)"
    same some 's r output friction' "$(json 's = 0.3; friction = 0.2; r = 2; diff' | values name | paste -sd ' ' -)"
    same 'and variables' 's x f(a)' "$(json 's = 0.3; let x = 2; let f(a) = 2*a; diff' | values name | grep -v output | paste -sd ' ' -)"
    same 'and gaps' "1 gap of the row was changed by 'place'; 'row' lists the row." \
        "$("$DOMINO" -e 'effect row 3; place 2 20 mm; diff' | tail -n 1)"
}

@test "a line goes on below after a backslash" {
    cd "$BATS_TEST_TMPDIR"
    printf '2 + \\\n3 + \\  \n4\nset s \\\n  0.3; print s\n1 # no \\\n2\nset s x\n' >a.dom
    run --separate-stderr "$DOMINO" a.dom
    same joined '9 0.3 1 2' "$(grep . <<<"$output" | paste -sd ' ' -)"
    [[ $stderr == a.dom:8:* ]] || same 'lines are counted' a.dom:8: "$stderr"
    same stdin '9 0.3 1 2' "$("$DOMINO" <a.dom 2>/dev/null | grep . | paste -sd ' ' -)"
    same 'at the end' 7 "$(printf '7 \\' | "$DOMINO")"
}

@test "every column of every answer has a meaning" {
    local pages=0
    for command in $("$DOMINO" -e 'complete '); do
        "$DOMINO" --keep-going -e "help $command" 2>/dev/null >"$BATS_TEST_TMPDIR/page" || true
        pages=$((pages + 1))
        same "$command" '(nothing)' "$(sed -n '/^It answers/,/^[A-Z]* *$/p' "$BATS_TEST_TMPDIR/page" |
            sed -n '2,$p' | awk '/^  [a-z]/ && NF < 2 || /^  [a-zA-Z_0-9]+ +[^ ]+ *$/')"
    done
    [ "$pages" -ge 40 ]
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
    wrong 'print 1 < 2 < 3' "comparisons joined by 'and'"
    wrong 'print 1 m < 2' 'a length and a plain number are not compared'
    wrong 'if(1 m, 1, 0)' 'a length is no condition'
    wrong 'if(1, 2)' 'if takes a condition and two values'
    wrong 'let and = 1' "'and' is a word of the language"
}

@test "assert: a condition" {
    same 'true' '(nothing)' "$("$DOMINO" -n -e 'assert rmax(0.4) < 1.7; assert if(r > 1, 1, 0); assert (s > 0.1) and not r == 2')"
    wrong 'assert rmax(0.4) < 1.6' 'assert: not true: rmax\(0.4\) < 1.6'
    wrong 'assert 1/0 < 2' 'assert: .*division by zero'
    wrong 'assert rmax' "'rmax' decides nothing; .* 'assert rmax < 1.7'"
}

@test "with: what holds for one answer, and nothing else changes" {
    local alone
    alone=$("$DOMINO" -n -e 'set q hollow; set d 0.1; print rmax(0.4)')
    same 'command' "$alone" "$("$DOMINO" -n -e 'print rmax(0.4) with q hollow d 0.1')"
    same 'in parentheses' "$alone" "$("$DOMINO" -n -e 'print (rmax(0.4) with d 0.1 q hollow)')"
    same 'with =' "$alone" "$("$DOMINO" -n -e 'print rmax(0.4) with q = hollow d = 1/10')"
    same 'in a function' "$alone" "$("$DOMINO" -n -e 'let f(x) = (rmax(x) with q 3 d x/4); f(0.4)')"
    same 'sweep' "$("$DOMINO" -n -e 'set output csv; set q hollow; sweep s 0.2 0.4 3 : rmax')" \
        "$("$DOMINO" -n -e 'set output csv; sweep s 0.2 0.4 3 : rmax with q hollow')"
    same 'solve' "$("$DOMINO" -n -e 'set output csv; set q hollow; solve s 0.1 0.9 : rmax = 2')" \
        "$("$DOMINO" -n -e 'set output csv; solve s 0.1 0.9 : rmax with q hollow = 2')"
    same 'a row' "$("$DOMINO" -n -e 'effect row 5; effect push 3; print verdict.seconds')" \
        "$("$DOMINO" -n -e 'print verdict.seconds with row 5 push 3')"
    same 'precision' "$("$DOMINO" -n -e 'set output csv; set precision quad; rmax')" \
        "$("$DOMINO" -n -e 'set output csv; rmax with precision quad')"
    same 'the session stays' "$("$DOMINO" -n -e 'set output csv; show; rmax')" \
        "$("$DOMINO" -n -e 'rmax with q hollow friction 0.2 row 5 > /dev/null; set output csv; show; rmax')"
    same 'assert' '(nothing)' "$("$DOMINO" -n -e 'assert barrier with r 1.2 > /dev/null')"
    wrong 'assert barrier with r 1.9' 'not true'
    wrong 'rmax with' "'with' takes parameters and effects"
    wrong 'rmax with q' 'the value of q after .with. is missing'
    wrong 'rmax with digits 3' "'digits' is a setting of the calculator"
    wrong 'rmax with push 3' "'effect push' needs a row"
    wrong 'rmax with s 2' 's = 2 is out of range'
    wrong 'set s 0.3 with r 2' "'with' goes behind a command that only answers"
}
