#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Names: abbreviations, misspellings, words of other programs, and suggestions.

load common

@test "a unique beginning stands for a command, a parameter, a topic, a word or a key" {
    plain=$(json 'fuel; thetac; show digits')
    while IFS='|' read -r short long; do
        same "$short" "$(json "$long")" "$(json "$short")"
        differ "$long is a question of its own" "$plain" "$(json "$long")"
    done <<'END'
bar|barrier
set s 0.3; sho s|set s 0.3; show s
print(3)|print 3
set fuel p; fuel|set fuel paper; fuel
print rmax.r_max_p|print rmax.r_max_paper
rmax; print ans.r_max_p|rmax; print ans.r_max_paper
END
    same 'cou' 20 "$(json 'cou 112' | values dominoes)"
    same 'help bar' "$("$DOMINO" -e 'help barrier')" "$("$DOMINO" -e 'help bar')"
    differ 'help fu' "$("$DOMINO" -e 'help bar')" "$("$DOMINO" -e 'help fu')"
    same 'set output j' "$(json fuel)" "$("$DOMINO" -e 'set output j; fuel')"
}

# bats test_tags=rows,chance,pictures,sweeps
@test "messages suggest the right name after a misspelling, and list the candidates after an ambiguous abbreviation" {
    all_wrong <<'END'
1|lauch|^unknown command 'lauch'; did you mean 'launch'\?$
6|help barier|^help: unknown topic 'barier'; did you mean 'barrier'\?$
1|mu 0.2|^unknown command 'mu'; did you mean 'set friction MU'\?$
1|separation 0.3|^unknown command 'separation'; did you mean 'set s VALUE'\?$
7|sweep mu 0 0.3 4 : rmax|^sweep: unknown parameter 'mu'; did you mean 'friction'\?$
7|print gravity|'gravity' has no value; did you mean 'g'\?$
35|echo x > /dev/null; animate speed 2 rad|animate: speed is a plain number
10|set fuel ecaxt|^set: .*'ecaxt'; did you mean 'exact'\?
7|print rmax.r_max_papr|^print:.*unknown key of rmax 'r_max_papr'; did you mean 'r_max_paper'\?
1|b|^'b' is ambiguous: barrier, back, best, budget$
6|show t|^show: 't' is ambiguous: tol, threads$
12|set header o|^set: 'o' is ambiguous: off, on
END
}

@test "words of other programs: the message names the word to use here" {
    wrong 'bye' "unknown command 'bye'; did you mean '(exit|quit)'"
    same 'Show s' "$("$DOMINO" -e 'show s')" "$("$DOMINO" -e 'Show s')"
    wrong 'help(rmax)' "'help' has no value in an expression; enter the command alone"
}

@test "q accepts 'solid', its synonym and abbreviations, and completion offers no synonym" {
    same 'set q hol' 3 "$(json 'set q hol; show q' | values value)"
    same values '4 4 3' "$(for word in solid massive hollow; do "$DOMINO" -e "set q $word; print q"; done | paste -sd ' ' -)"
    same offered 'hollow solid' "$("$DOMINO" -e 'complete set q ' | paste -sd ' ' -)"
    same 'help q' 'hollow 3 solid 4' "$("$DOMINO" -e 'help q' | sed -n 's/^  \(hollow\|solid\|massive\) */\1 /p' | paste -sd ' ' -)"
}

# bats test_tags=rows,chance,pictures,sweeps,fit
@test "an unknown name: the message has a suggestion, the possible names, or where they are listed, but never two of these" {
    local plots
    plots=$("$DOMINO" --keep-going -e 'plot foo' 2>&1 | sed 's/.*use one of: //')
    [[ $plots == growth,*,*,*sweep* ]]
    while IFS='|' read -r line message; do
        message=${message/PLOTS/$plots}
        run -1 "$DOMINO" --keep-going -e "$line"
        same "$line" "$message" "${output#-e:*: }"
    done <<'END'
foo|unknown command 'foo'; 'help' lists the commands
ba|'ba' is ambiguous: barrier, back
friction 0.2|'friction' is an effect; enter 'set friction 0.2'
plot foo|plot: unknown picture 'foo'; use one of: PLOTS
plot enrgy|plot: unknown picture 'enrgy'; did you mean 'energy'?
goto lanch|step to: unknown event 'lanch'; did you mean 'launch'?
END
}

@test "of the numeric parameters, only q accepts words, and only 'help tol' explains the tolerance" {
    same q 3 "$("$DOMINO" -e 'set q hollow; print q')"
    for name in s r d tol h g mass; do
        wrong "set $name hollow" "^-e:1:[0-9]*: set: .*'hollow' is a value of q"
        same "help $name" '(nothing)' "$("$DOMINO" -e "help $name" | grep -E '^  (hollow|massive) ' || true)"
    done
    for name in s r d q h g; do [[ $("$DOMINO" -e "help $name") != *'The tolerance decides how'* ]]; done
    [[ $("$DOMINO" -e 'help tol') == *'The tolerance decides how'* ]]
}

@test "names in upper case and in the plural are understood" {
    same 'a command' "$("$DOMINO" -e 'rmax 0.3')" "$("$DOMINO" -e 'RMAX 0.3')"
    same 'parameters' 0.3 "$("$DOMINO" -e 'SET S 0.3; print s')"
    same 'a value' "$("$DOMINO" -e 'set fuel paper; fuel')" "$("$DOMINO" -e 'Set Fuel PAPER; fuel')"
    same 'an effect' "$("$DOMINO" -e 'effect friction 0.1; fuel')" "$("$DOMINO" -e 'effect Friction 0.1; FUELS')"
}
