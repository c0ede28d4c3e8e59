#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Let: variables and one-line functions.

load common

@test "let: a variable keeps its value and its unit" {
    all_print <<'END'
let x = 2; x = 3; x^2|9
let x = 0.9*rmax; set s 0.9; x|1.47981
let tall = 112 m; tall to ft|367.454 ft
let p = 600 kg/m^3; density = p; density*1|600 kg m^-3
let big = 0.5; rmax big; ans.s|0.5
END
}

@test "let: definitions are shown, explained, removed and completed" {
    local all='let xx = 2 m; let ff(a) = 2*a'
    same shown "$(json "$all; show ff")" "$(json "$all; ff")"
    same 'forgotten' 'ff(a)' "$("$DOMINO" -e "$all; reset xx; show" | awk 'NR > 1 { print $1 }')"
    same 'back again' '2 m' "$("$DOMINO" -e "$all; reset xx" -e 'undo; xx' | tail -n 1)"
    same 'reset keeps them' '2 m' "$("$DOMINO" -e "$all; reset; xx")"
    wrong "$all; reset xx; xx" "unknown command 'xx'"
    wrong "$all; set xx 3" "'xx' is a variable; 'xx = VALUE' changes it"
    while IFS='|' read -r line words; do
        same "complete $line" "$words" "$("$DOMINO" -e "$all" -e "complete $line" | paste -sd ' ' -)"
    done <<'END'
x|xx
reset x|xx
let x|xx
print 2+x|2+xx
print 2+ff|2+ff(
count x|xx
rmax x|(nothing)
END
}

# bats test_tags=sweeps
@test "let: a one-line function" {
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

@test "let: names that already have a meaning, and invalid definitions" {
    wrong 'let r = 2' "'r' is a parameter; choose another name"
    wrong 'let rmax = 2' "'rmax' is a command"
    wrong 'let m = 2' "'m' is a unit"
    wrong 'let sin = 2' "'sin' is a built-in value"
    wrong 'let x' "enter, for example, 'let x"
    wrong 'let x =' "the value of 'x' is missing"
    wrong 'let f(a,b,c,d,e) = 3' 'a function with 1 to 4 arguments'
    wrong 'let f(a,a) = 3' "two values of 'f' have the same name 'a'"
    wrong 'let f(a) = a +' "'\+' is one argument too many"
    wrong 'let f(a) = a; f(1, 2)' "'f\(a\)' takes 1 value"
    wrong 'let f(a) = foo*a; f(1)' "in 'f\(a\)': 'foo' has no value"
    wrong 'let f(a) = f(a); f(1)' "'f\(a\)' uses itself"
    wrong 'let f(a) = a; let k(a) = f(a); let f(a) = k(a); k(1)' "'k\(a\)' uses itself"
    wrong 'let x = (1 m)^12' 'an exponent above 9'
    wrong 'z(a) = 3' "'let z\(...\) = VALUE' defines a function"
}

# bats test_tags=save
@test "variables are listed by 'show' and read back after 'save'" {
    "$DOMINO" -e 'let p = 600 kg/m^3/3; let a = 10 deg; let f(x, y) = x*p + y; let n = 1/3; save s.dom; show' >shown
    "$DOMINO" -e 'source s.dom; save t.dom; show' >again
    same_file s.dom t.dom
    same_file shown again
    same 'the function' 'f(x, y) x*p + y' "$(awk '/^f\(/ { print $1, $2, $3, $4, $5 }' shown)"
    same 'in a quotient' 0.2 "$("$DOMINO" -e 'source s.dom; p/(1000 kg/m^3)')"
    same 'quad' 0 "$("$DOMINO" -e 'source s.dom; n*3 - 1')"
}

@test "a definition cannot make a session hang" {
    {
        echo 'let f0(x) = x'
        for i in {1..60}; do echo "let f$i(x) = f$((i - 1))(x)"; done
        for i in {61..200}; do echo "let f$i(x) = ((f$((i - 1))(x)))"; done
        echo 'f60(7); f200(7); 41+1'
    } >deep.dom
    run --separate-stderr "$DOMINO" --keep-going -f deep.dom
    same deep '7 42' "$(grep . <<<"$output" | paste -sd ' ' -)"
    [[ $stderr == *'nested too deeply'* ]]
    repeat=$(printf '(%.0s' {1..300})
    wrong "let f(x) = $repeat" 'nested too deeply'
}

@test "a name that has a meaning is not recommended for a variable" {
    local name
    for name in pi mm rmax sin ans min to; do
        wrong "$name = 3" "'$name' is .*; choose another name, such as 'my_$name'"
        same "$name: as let says" "$("$DOMINO" -e "let $name = 3" 2>&1 | sed 's/.*: //')" "$("$DOMINO" -e "$name = 3" 2>&1 | sed 's/.*: //')"
    done
    wrong 'foo = 3' "'foo' is not a parameter; 'let foo = VALUE' defines a variable"
}
