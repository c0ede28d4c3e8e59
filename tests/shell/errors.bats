#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Bad input: one line on stderr says where the error is, what is wrong and what would be right, and nothing
# changes.

load common

@test "unknown commands and parameters: the message names them, and says where the right ones are listed" {
    all_wrong stdin -e script <<'END'
1|foo|^unknown command 'foo'.*'help'
1|q 3|^'q' is a parameter; enter 'set q 3'$
1|q hollow  |^'q' is a parameter; enter 'set q hollow'$
1|air off|^'air' is an effect; enter 'set air off'$
1|h 5 cm|^'h' is a parameter; enter 'set h 5 cm'$
8|4.8 cm in mm|'in' is one argument too many; usage: print VALUE \[to U\]$
6|rmax hollow|^rmax: S at 'hollow': 'hollow' is a value of q; enter 'set q hollow', or write 'with q hollow' at the end$
1|hollow|^'hollow' is a value of q; enter 'set q hollow', or write 'with q hollow' at the end$
5|set foo 1|^set: unknown parameter 'foo'; 'show all' lists them$
24|rmax with friction 0.2 and q hollow|^rmax: unexpected 'and'; after 'with', separate values by blanks, without 'and'$
20|rmax with q hollow and friction 0.2|^rmax: unexpected 'and'
23|rmax 0.4 with q hollow, s 0.3|^rmax: unexpected ',' after 'hollow'; separate values by blanks, without a comma$
15|set output csv, json|^set: unexpected ','
14|2*(1 - (rmax with q hollow))|'with' belongs at the end of the command
11|set s=0.4 1|^set: '1' .*too many.*set NAME VALUE
6|help zzz|^help: unknown topic 'zzz'
END
    wrong 'rmax with foo 3; print s == 0 and s == 1' "unknown parameter 'foo'" # the 'and' belongs to another command
}

# bats test_tags=sweeps,save
@test "missing and surplus arguments: the usage of the command" {
    all_wrong <<'END'
4|set|^set: .*missing.*set NAME VALUE
10|help set show|^help: 'show' .*too many.*help \[NAME\]
12|theta1 0.1 0.2|^theta1: '0.2' .*too many.*theta1 T
6|count|^count: .*missing.*count H \[R\]
8|save a b|^save: 'b' .*too many.*save FILE
6|fuel a b c d e f g h i j k l m n o p q r s t u|^fuel: 'a' .*too many.*usage: fuel
END
}

# bats test_tags=sweeps
@test "a value that is not a number: the message says where and what" {
    sed -E 's/^([0-9]+) (.*)/\1|set s \2|^set: (s at|s:|s =|unexpected .* after the value of s;)/' <<'END' | all_wrong
7 nan
8 -
7 /2
7 '0.4'
END
    all_wrong <<'END'
8|set s -1e5000|^set: s.*too large
7|print 1e4930 km|^print: VALUE at '1e4930': this number is too large
13|set h 1e4900/1e-90|^set: h.*not a finite number
8|set s 1/0|^set: s.*division by zero
7|set q wooden|^set: .*q.*'wooden'
10|set fuel diesel|^set: unknown value of fuel 'diesel'; use one of: exact, paper
12|set output xml|^set: unknown value of output 'xml'.*table, csv, json
6|rmax nan|^rmax: S.*'nan' has no value
15|curve 0.1 0.9 x|^curve: N.*'x' has no value
END
}

# bats test_tags=sweeps
@test "a value out of range: the message has the value and the range" {
    while read -r name below above range; do
        for text in $below $above; do
            echo "$((${#name} + 6))|set $name $text|^set: $name = .* is out of range; $name must be in the range $range"
        done
    done <<'END' | all_wrong
s 0 1.0001 1e-06 \.\. 1( |$)
s 9e-7 1+1e-9 1e-06 \.\. 1( |$)
r 0.9999 1.1e6 1 \.\. 1e\+06$
d 0 101 1e-12 \.\. 100( |$)
q 0 101 1e-06 \.\. 100
tol -1e-3 1 1e-15 \.\. 0.1$
g -9.81 1e10 1e-09 \.\. 1e\+09( |$)
END
    all_wrong <<'END'
6|rmax 2|^rmax: S = 2 is out of range; S is a value of s, 1e-06 \.\. 1$
7|curve 0 1 3|^curve: FROM = 0 is out of range; FROM is a value of s, 1e-06 \.\. 1$
11|curve 0.1 1.1 3|^curve: TO = 1.1 is out of range; TO is a value of s, 1e-06 \.\. 1$
15|curve 0.1 0.9 0|^curve: N = 0 .*integer in 1 \.\. [0-9]+$
15|curve 0.1 0.9 1e12|^curve: N = 1e\+12 .*integer in 1 \.\. [0-9]+$
0|curve 0.1 0.9 1|^curve: one value of s .*at least 2, for example
7|count -112|^count: H = -112 .*metres, larger than 0$
END
}

@test "an angle outside [0, theta_c]: the message has all digits of theta_c" {
    theta_c=$(json thetac | values theta_c)
    for command in theta1 chain energy omega; do
        while read -r theta shown; do
            echo "$((${#command} + 2))|$command $theta|^$command: T = ${shown/+/\\+} rad .*\\[0, theta_c\\] = \\[0, ${theta_c:0:15}[0-9]*\\]"
        done <<'END' | all_wrong
-0.1 -0.1
-1e-300 -1e-300
0.7 0.7
END
        # Both ends belong to the range.
        same "$command" "0 $theta_c" "$(json "$command 0; $command $theta_c" | grep -E '^.("i":0,)?"(theta|theta_i)":' |
            sed -E 's/^.("i":0,)?"[a-z_]*":([^,]*),.*/\2/' | paste -sd ' ' -)"
    done
}

# bats test_tags=sweeps
@test "r s > 1 in a command that needs both: the message has r s, and the largest r" {
    for command in thetac 'theta1 0' 'chain 0' 'energy 0' fuel launch 'omega 0' barrier duration; do
        run -1 --separate-stderr "$DOMINO" --keep-going -e 'set s 0.8' -e "$command" -e 'set output json; rmax'
        same "$command: the session goes on" 1.25 "$(values r_max <<<"$output")"
        same "$command: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [[ $stderr =~ ^-e:1:\ ${command% *}:\ 'r s = 1.2 > 1: '.*1/s\ =\ 1.25$ ]] || same "$command" 'r s = 1.2 > 1: ... 1/s = 1.25' "$stderr"
    done
    # These commands do not need r s <= 1.
    for command in rmax pair best 'curve 0.5 0.9 3' 'count 112' show; do
        same "$command" '{' "$(json "set s 0.8; $command" | cut -c 1 | sort -u)"
    done
}

@test "more than can be computed: the message says what would be right" {
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
set s 1e-6; set r 1e6; set q 100|fuel,barrier,duration|too large for this precision; use a smaller r or q
END
}

@test "file:line counts every line of each file, even with CRLF line ends" {
    printf '# a comment\n\nfuel; foo; fuel\n  qux # baz' >one
    printf 'fuel\r\nfoo\r\n\r\nqux\r\n' >two
    run -1 --separate-stderr "$DOMINO" --keep-going -f one two -e $'\nfoo' -
    same messages "one:3:7: unknown command 'foo'
one:4:3: unknown command 'qux'
two:2:1: unknown command 'foo'
two:4:1: unknown command 'qux'
-e:2:1: unknown command 'foo'" "${stderr//; \'help\' lists the commands/}"
} </dev/null

@test "every error has one message, and a line with several errors has several" {
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'foo; set s 9; theta1; qux'
    same places '-e:1:1: -e:1:12: -e:1:21: -e:1:23:' "$(cut -d' ' -f1 <<<"$stderr" | paste -sd ' ' -)"
    same stdout '(nothing)' "$output"
}

@test "a NUL byte in a line" {
    for text in 'set s 0.3\0' '\0' 'set s 0.\0 3' '\0set s 0.3'; do
        printf "$text\nprint 42\n" >junk
        run -1 --separate-stderr "$DOMINO" --keep-going junk
        [[ $stderr =~ ^junk:1:\ .*NUL.*text && $output == 42 ]] || same "$text" 'NUL, and it goes on' "$stderr $output"
    done
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
