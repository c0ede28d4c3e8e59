#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Bad input: one line on stderr that says where, what was wrong and what would be right; nothing else changes.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

# Checks rows of COMMAND|COLUMN|MESSAGE on stdin (column 0: the error is about the whole; MESSAGE is a regular
# expression). Before and after each command one session shows all parameters: a bad command may not change a byte of
# what it says, and its message must match and point at the column.
all_bad() {
    local rows row rest i way line place script=$BATS_TEST_TMPDIR/bad.dom first='set s 0.3; set output json' all='show; fuel'
    local shown=$BATS_TEST_TMPDIR/shown expected=$BATS_TEST_TMPDIR/expected each=()
    mapfile -t rows
    "$DOMINO" -e "$first; $all" >"$shown"
    [ "$(wc -l <"$shown")" -gt 20 ] || same 'what is shown' 'all parameters' "$(cat "$shown")"
    { echo "$first" && echo "$all"; } >"$script"
    cp "$shown" "$expected"
    for row in "${rows[@]}"; do
        printf '%s\n%s\n' "${row%%|*}" "$all" >>"$script"
        { echo 'an error' && cat "$shown"; } >>"$expected"
        each+=(-e "${row%%|*}" -e "$all")
    done
    for way in -e stdin "$script"; do
        case $way in
        -e) run -1 --separate-stderr "$DOMINO" --keep-going -e "$first" -e "$all" "${each[@]}" ;;
        stdin) run -1 --separate-stderr "$DOMINO" <"$script" ;;
        *) run -1 --separate-stderr "$DOMINO" --keep-going -f "$script" ;;
        esac
        sed -E 's/^\{"command":[^,]*,"error":".*"source":".*","line":[0-9]+,"column":.*\}$/an error/' <<<"$output" |
            same_file "$expected" - || same "${rows[0]} and more ($way)" 'what is shown does not change' 'it does'
        mapfile -t lines <<<"$stderr"
        same "${rows[0]} and more ($way): lines on stderr" "${#rows[@]}" "${#lines[@]}"
        for i in "${!rows[@]}"; do
            row=${rows[i]} rest=${rows[i]#*|} line=$((2 * i + 3))
            if [ "$way" = -e ]; then line=1; fi
            place=$way:$line:
            if [ "${rest%%|*}" -gt 0 ]; then place=$place${rest%%|*}:; fi
            same "${row%%|*} ($way): place" "$place" "${lines[i]%% *}"
            expects "${row%%|*}" "${rest#*|}"
            [[ ${lines[i]#* } =~ ${rest#*|} ]] || same "${row%%|*} ($way)" "${rest#*|}" "${lines[i]}"
        done
    done
}

# What a stream says, with a last line that shows that the session goes on.
junk() { # EXPECTED MESSAGE; the junk is in $PWD/junk
    printf '\nset output json; show s\n' >>junk
    run -1 --separate-stderr "$DOMINO" --keep-going junk
    same 'the session goes on' 0.4 "$(tail -n 1 <<<"$output" | values value)"
    same stdout 1 "${#lines[@]}"
    same 'lines on stderr' 1 "$(wc -l <<<"$stderr")"
    [[ $stderr =~ $1 ]] || same message "$1" "$stderr"
    [ "${#stderr}" -lt 300 ]
}

@test "unknown commands and parameters: named, with where to find the right ones" {
    all_bad <<'END'
foo|1|^unknown command 'foo'.*'help'
xyzzy|1|^unknown command 'xyzzy'.*'help'
q 3|1|^'q' is a parameter; 'q = VALUE' gives it a value
sqrt 2|1|^'sqrt' is a function; its values are in parentheses, as in 'sqrt\(2\)'$
4.8 cm in mm|8|'to' converts, as in '4.8 cm to mm'$
Fuel|1|^unknown command 'Fuel'; did you mean 'fuel'\?$
fuell|1|^unknown command 'fuell'; did you mean 'fuel'\?$
  foo 1 2|3|^unknown command 'foo'.*'help'
set foo 1|5|^set: unknown parameter 'foo'
set S 0.4|5|^set: unknown parameter 'S'
set s=0.4 1|11|^set: '1' .*too many.*set NAME VALUE
show foo|6|^show: unknown parameter 'foo'
reset foo|7|^reset: unknown parameter 'foo'
help foo|6|^help: unknown (topic|command) 'foo'
END
}

@test "missing and surplus arguments: the usage of the command" {
    all_bad <<'END'
set|4|^set: .*missing.*set NAME VALUE
set s|6|^set: .*missing.*set NAME VALUE
set s 0.4 1|11|^set: '1' .*too many.*set NAME VALUE
show s r|8|^show: 'r' .*too many.*show \[NAME\]
reset s r|9|^reset: 'r' .*too many.*reset \[NAME\]
help set show|10|^help: 'show' .*too many.*help \[NAME\]
quit now|6|^quit: 'now' .*too many.*usage: quit
exit now|6|^exit: 'now' .*too many.*usage: exit
thetac 1|8|^thetac: '1' .*too many.*usage: thetac
theta1|7|^theta1: .*missing.*theta1 T
theta1 0.1 0.2|12|^theta1: '0.2' .*too many.*theta1 T
chain|6|^chain: .*missing.*chain T
energy|7|^energy: .*missing.*energy T
fuel 1|6|^fuel: '1' .*too many.*usage: fuel
launch 1|8|^launch: '1' .*too many
omega|6|^omega: .*missing.*omega T
barrier 1|9|^barrier: '1' .*too many
duration 1|10|^duration: '1' .*too many
rmax 0.3 0.4|10|^rmax: '0.4' .*too many.*rmax \[S\]
pair 0.3 0.4|10|^pair: '0.4' .*too many.*pair \[S\]
best 1|6|^best: '1' .*too many
curve 0.1 0.9|14|^curve: .*missing.*curve FROM TO N
curve 0.1 0.9 5 6|17|^curve: '6' .*too many.*curve FROM TO N
count|6|^count: .*missing.*count H \[R\]
count 1 2 3|11|^count: '3' .*too many.*count H \[R\]
print|6|^print: .*missing.*print VALUE
print 1 2|9|^print: '2' .*too many.*print VALUE
save|5|^save: .*missing.*save FILE
save a b|8|^save: 'b' .*too many.*save FILE
source|7|^source: .*missing.*source FILE
source a b|10|^source: 'b' .*too many.*source FILE
fuel a b c d e f g h i j k l m n o p q r s t u|6|^fuel: 'a' .*too many.*usage: fuel
END
}

@test "a value other than a number: where and what" {
    sed -E 's/^([0-9]+) (.*)/set s \2|\1|^set: s/' <<'END' | all_bad
7 nan
7 NaN
8 -nan
7 inf
8 -inf
7 infinity
7 0x10
8 1,5
7 abc
7 0.4m
10 0.4.1
8 1e
8 1e+
7 .
8 -
8 +
9 1/
7 /2
9 1//2
9 1/0x2
7 '0.4'
7 "0.4"
END
    all_bad <<'END'
set s 1e5000|7|^set: s.*too large
set s -1e5000|8|^set: s.*too large
set s 1e-5000|7|^set: s.*too small
set s 1e-5000|7|^set: s.*too small
set h 1e4900/1e-90|13|^set: h.*not a finite number
set s 1/0|8|^set: s.*division by zero
set s 1 / (2 - 2)|9|^set: s.*division by zero
set q wooden|7|^set: .*q.*'wooden'
set fuel diesel|10|^set: unknown value of fuel 'diesel'.*exact.paper
set fuel 1|10|^set: unknown value of fuel '1'.*exact.paper
set output xml|12|^set: unknown value of output 'xml'.*table.csv.json
set angle grad|11|^set: unknown value of angle 'grad'.*rad.deg
set timing maybe|12|^set: unknown value of timing 'maybe'.*off.on
theta1 nan|8|^theta1: T.*'nan' has no value
chain inf|7|^chain: T.*'inf' has no value
energy 0x0|8|^energy: T.*'0x0'
omega 0,1|8|^omega: T .*',1'
rmax nan|6|^rmax: S.*'nan' has no value
pair x|6|^pair: S.*'x' has no value
curve x 0.9 3|7|^curve: FROM.*'x' has no value
curve 0.1 x 3|11|^curve: TO.*'x' has no value
curve 0.1 0.9 x|15|^curve: N.*'x' has no value
count x|7|^count: H.*'x' has no value
count 1e5000|7|^count: H.*too large
count 1 x|9|^count: R.*'x' has no value
END
}

@test "a value out of its range: the value and the range" {
    while read -r name below above range; do
        for text in $below $above; do
            echo "set $name $text|$((${#name} + 6))|^set: $name = .* is out of range; $name is .* $range"
        done
    done <<'END' | all_bad
s 0 1.0001 1e-06 \.\. 1( |$)
s -0.4 1e300 1e-06 \.\. 1( |$)
s 9e-7 1+1e-9 1e-06 \.\. 1( |$)
r 0.9999 1.1e6 1 \.\. 1e\+06$
r -1 1e300 1 \.\. 1e\+06$
d 0 101 1e-12 \.\. 100( |$)
d -1 1e300 1e-12 \.\. 100( |$)
q 0 101 1e-06 \.\. 100
tol -1e-3 1 1e-15 \.\. 0.1$
h 0 1e10 1e-09 \.\. 1e\+09( |$)
g -9.81 1e10 1e-09 \.\. 1e\+09( |$)
digits 0 37 1 \.\. 36$
digits -3 1e300 1 \.\. 36$
END
    all_bad <<'END'
rmax 0|6|^rmax: S = 0 is out of range; S is a value of s, 1e-06 \.\. 1$
rmax -0.4|6|^rmax: S = -0.4 is out of range; S is a value of s, 1e-06 \.\. 1$
rmax 2|6|^rmax: S = 2 is out of range; S is a value of s, 1e-06 \.\. 1$
pair 2|6|^pair: S = 2 is out of range; S is a value of s, 1e-06 \.\. 1$
curve 0 1 3|7|^curve: FROM = 0 is out of range; FROM is a value of s, 1e-06 \.\. 1$
curve 0.1 1.1 3|11|^curve: TO = 1.1 is out of range; TO is a value of s, 1e-06 \.\. 1$
curve 0.1 0.9 0|15|^curve: N = 0 .*integer in 1 \.\. [0-9]+$
curve 0.1 0.9 -5|15|^curve: N = -5 .*integer in 1 \.\. [0-9]+$
curve 0.1 0.9 2.5|15|^curve: N = 2.5 .*integer in 1 \.\. [0-9]+$
curve 0.1 0.9 1e12|15|^curve: N = 1e\+12 .*integer in 1 \.\. [0-9]+$
curve 0.1 0.9 1|0|^curve: one row .*at least 2, for example
count 0|7|^count: H = 0 .*metres, larger than 0$
count -112|7|^count: H = -112 .*metres, larger than 0$
count 112 0.5|11|^count: R = 0.5 is out of range; R is a value of r, 1 \.\. 1e\+06$
END
}

@test "an angle outside [0, theta_c]: theta_c, in full" {
    theta_c=$(json 'set s 0.3; thetac' | values theta_c)
    for command in theta1 chain energy omega; do
        while read -r theta shown; do
            echo "$command $theta|$((${#command} + 2))|^$command: T = ${shown/+/\\+} rad .*\\[0, theta_c\\] = \\[0, $theta_c\\]"
        done <<'END' | all_bad
-0.1 -0.1
-1e-300 -1e-300
0.5 0.5
1e300 1e+300
END
        # Both ends are inside.
        same "$command" "0 $theta_c" "$(json "set s 0.3; $command 0; $command $theta_c" | grep -E '^.("i":0,)?"(theta|theta_i)":' |
            sed -E 's/^.("i":0,)?"[a-z_]*":([^,]*),.*/\2/' | paste -sd ' ' -)"
    done
}

@test "r s > 1 where a command needs both: r s, and how large r may be" {
    for command in thetac 'theta1 0' 'chain 0' 'energy 0' fuel launch 'omega 0' barrier duration; do
        run -1 --separate-stderr "$DOMINO" --keep-going -e 'set s 0.8' -e "$command" -e 'set output json; rmax'
        same "$command: the session goes on" 1.25 "$(values r_max <<<"$output")"
        same "$command: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [[ $stderr =~ ^-e:1:\ ${command% *}:\ 'r s = 1.2 > 1: '.*1/s\ =\ 1.25$ ]] || same "$command" 'r s = 1.2 > 1: ... 1/s = 1.25' "$stderr"
    done
    # Where it has no meaning, the program accepts it.
    for command in rmax pair best 'curve 0.5 0.9 3' 'count 112' show; do
        same "$command" '{' "$(json "set s 0.8; $command" | cut -c 1 | sort -u)"
    done
}

@test "more than can be computed: what would be right" {
    while IFS='|' read -r state calls message; do
        IFS=, read -ra calls <<<"$calls"
        for command in "${calls[@]}"; do
            run -1 --separate-stderr "$DOMINO" --keep-going -e "$state; $command" -e 'reset; set output json; fuel'
            same "$state; $command: the session goes on" "$(json fuel)" "$(tail -n 1 <<<"$output")"
            same "$state; $command: lines on stderr" 1 "$(wc -l <<<"$stderr")"
            [[ $stderr =~ $message ]] || same "$state; $command" "$message" "$stderr"
        done
    done <<'END'
set s 1e-6; set d 1e-12; set r 1|chain 0,energy 0,fuel,barrier|use a larger s, d or tol
set s 1e-6; set r 1e6; set q 100|fuel,barrier,duration|range of the precision.*(smaller|lower|larger|less|fewer|at most|up to)
END
}

@test "file:line counts every line, in each file, also in text with CRLF" {
    printf '# a comment\n\nfuel; foo; fuel\n  qux # baz' >one
    printf 'fuel\r\nfoo\r\n\r\nqux\r\n' >two
    run -1 --separate-stderr "$DOMINO" --keep-going -f one two -e 'foo' -
    same messages "one:3:7: unknown command 'foo'
one:4:3: unknown command 'qux'
two:2:1: unknown command 'foo'
two:4:1: unknown command 'qux'
-e:1:1: unknown command 'foo'" "${stderr//; \'help\' lists the commands/}"
} </dev/null

@test "lines in the text of -e are counted, too" {
    run -1 --separate-stderr "$DOMINO" --keep-going -e $'set s 0.3\n\nfoo'
    [[ $stderr == -e:3:1:* ]] || same place -e:3:1: "$stderr"
}

@test "every error has its line, and a line of several errors several" {
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'foo; set s 9; theta1; qux'
    same places '-e:1:1: -e:1:12: -e:1:21: -e:1:23:' "$(cut -d' ' -f1 <<<"$stderr" | paste -sd ' ' -)"
    same stdout '(nothing)' "$output"
}

@test "a NUL byte in a line" {
    for text in 'set s 0.3\0' '\0' 'set s 0.\0 3' '\0set s 0.3'; do
        # shellcheck disable=SC2059 # the text is a format: \0
        printf "$text" >junk
        junk 'junk:1: .*NUL.*text'
    done
}

@test "lines of a megabyte: one word, a number, blanks, many commands" {
    million=$(head -c 1000000 /dev/zero | tr '\0' 7)
    tr 7 z <<<"$million" >junk
    junk "junk:1:1: unknown command 'z+\.\.\.'"
    printf 'set s %s' "$million" >junk
    junk "junk:1:7: set: s.*too large.*"
    printf 'set s 9%s' "$(tr 7 ' ' <<<"$million")" >junk
    junk 'junk:1:7: set: s = 9 is out of range'
    printf 'set s 0.3 %s' "$(tr 7 'x ' <<<"$million" | sed 's/xx/x /g')" >junk
    junk "junk:1:11: set: 'x' is not a unit and has no value"
    { sed 's/7777777/set r 2;/g; s/7*$/foo/' <<<"$million"; } >junk
    junk "junk:1:[0-9]+: unknown command 'foo'"
    same 'a long number is a number' 0.5 "$({ echo 'set output json'; printf 'set s 0.5%s\nshow s' "$(tr 7 0 <<<"$million")"; } |
        "$DOMINO" | values value)"
}

@test "control characters are not handed on to the terminal" {
    printf 'a\033]0b\007\177\001' >junk
    junk "junk:1:1: unknown command 'a[^[:cntrl:]]*'"
    printf 'set s \033[31m' >junk
    junk "junk:1:7: set: s [^[:cntrl:]]*a value is missing"
}

@test "binary junk: an error status, readable messages, no crash" {
    for junk in "$DOMINO" /dev/zero; do
        head -c 200000 "$junk" >junk
        printf '\nset output json; show tol\n' >>junk
        run -1 --separate-stderr "$DOMINO" --keep-going junk
        same 'the session goes on' tol "$(tail -n 1 <<<"$output" | values name)"
        grep -aq '^junk:[0-9]*:[0-9:]* ' <<<"$stderr"
        same 'all lines say where' '(nothing)' "$(grep -av '^junk:[0-9]*:[0-9:]* ' <<<"$stderr" || true)"
    done
}
