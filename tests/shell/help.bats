#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Help and apropos.

load common

# bats test_tags=lesson
@test "lesson: in a pipe it shows the tutorial without waiting, and within a file it shows the rest of the file" {
    (cd /; "$DOMINO" -f "$root/examples/tutorial.dom") >tutorial
    same steps 10 "$(grep -c '^---- ' tutorial)"
    # What the texts say about the answers.
    for words in '^20 solid dominoes' ' 1.64422 times as large' ' has 62 % of ' ' 0.5337 times the height' '^12 hollow dominoes' '^  *0.3  *0.520312  *1.54536$' \
        '^All 8 fall in 3.092 s' '^194 of 200 rows fall' 'misses the next domino' "'place 5 52.2 cm'" 'more than 100 times the energy'; do
        grep -q -- "$words" tutorial || same 'the tutorial' "$words" "$(cat tutorial)"
    done
    for way in -e stdin; do
        session "$way" 'set s 0.3; lesson; print s' | diff <(cat tutorial; echo 0.3) - || same "$way" 'the tutorial' ''
    done
    printf '%s\n' 'set s 0.3' lesson '# Two dominoes.' '#' '#  pair' 'pair.s; foo' >own.dom
    run -1 --separate-stderr "$DOMINO" --safe -f own.dom
    same 'own file' $'Two dominoes.\n\n pair\ndomino> pair.s; foo\n0.4' "$output"
    same 'an error' "unknown command 'foo'; 'help' lists the commands" "$stderr"
    printf 'lesson\n# a\xe2\x80\xaeb\nprint 1 # a\xe2\x80\xaeb\n' >hostile.dom
    same 'a hostile file' '0' "$("$DOMINO" -f hostile.dom | grep -c $'\xe2\x80\xae')"
    same 'its lines are shown' '2' "$("$DOMINO" -f hostile.dom | grep -cF '\u202e')"
    run -1 "$DOMINO" -e 'set output json; lesson'
    [[ $output == *"a lesson needs tables; first enter 'set output table'"* ]]
}

@test "apropos: lists everything that mentions a word, in upper or lower case; or an error" {
    while IFS='|' read -r word found; do
        answer=$("$DOMINO" -e "apropos $word")
        expects "apropos $word" "$answer"
        for name in $found; do
            grep -Eq "^(set )?$name( |\$)" <<<"$answer" || same "apropos $word" "$name" "$answer"
        done
        same "apropos ${word^^}" "$answer" "$("$DOMINO" -e "apropos ${word^^}")"
    done <<'END'
fuel|fuel
barrier|barrier rmax
separation|rmax pair best s
significant|digits
c7|fuel
END
    all_wrong <<'END'
0|apropos zzzz|^apropos: .*'zzzz'
8|apropos|^apropos: WORD is missing; usage: apropos WORD
END
}

# bats test_tags=rows,explain
@test "help NAME for every command and parameter; its example is what the program prints" {
    "$DOMINO" -e 'help all' | sed -n 's/^  \([a-z0-9]*\) .*/\1/p' | uniq >"$PWD/names"
    [ "$(wc -l <names)" -ge 22 ]
    examples=0
    names=$(paste -sd ' ' "$PWD/names")
    help=$("$DOMINO" -e 'help all')
    # The example is run in a fresh session, whatever has been set, and does not change this session.
    changed='set s 0.3; set digits 4; set fuel paper; set angle deg'
    "$DOMINO" -e "$changed; show" -e "$(sed 's/.*/help & > "&.txt"/' names | paste -sd ';' -)" -e show >shows
    same 'help changes nothing' "$(head -n "$(($(wc -l <shows) / 2))" shows)" "$(tail -n "$(($(wc -l <shows) / 2))" shows)"
    shown() { awk '/^Example: / { on = 1; getline; next } /^See also: / { on = 0 } on' "$@"; }
    while read -r name; do
        run -0 --separate-stderr "$DOMINO" -e "help $name"
        same "help $name: stderr" '(nothing)' "$stderr"
        usage=$(awk -v name="$name" '$1 == name { sub(/^  /, ""); sub(/  +.*/, ""); print; exit }' <<<"$help")
        [[ ${lines[0]} == "$usage"* ]] || same "help $name: its usage" "$usage" "${lines[0]}"
        example=$(sed -n 's/^Example: //p' <<<"$output")
        [ -n "$example" ] || continue
        examples=$((examples + 1))
        same "help $name: $example" "$("$DOMINO" -e "$example")" "$(shown <<<"$output")"
        same "help $name elsewhere" "$(shown <<<"$output")" "$(shown "$name.txt")"
        # Every topic to which help refers exists.
        while read -r other; do
            [[ " $names " == *" $other "* ]] || same "help $name: see also" "a command" "$other"
        done < <(sed -n 's/^See also: //p' <<<"$output" | tr ' ' '\n')
    done <"$PWD/names"
    [ "$examples" -ge 25 ]
    for name in h tol q digits; do
        says "help $name" "$(json "show $name" | values meaning)" "$(json "show $name" | values range)" default "set $name"
    done
    # 'help set' names the commands that show the present values.
    [[ $("$DOMINO" -e 'help set') == *'See also: show reset'* ]]
}

# bats test_tags=fit,planning
@test "help shows the whole text of a topic, however long" {
    for name in design improve fit print friction; do
        text=$("$DOMINO" -e "set output json; help $name" | sed -n 's/.*"text":"\([^"]*\)".*/\1/p' | sed 's/\\u000a\\u000a/ /g')
        [ "${#text}" -gt 300 ] || same "help $name in json" 'a long text' "$text"
        shown=$("$DOMINO" -e "help $name" | tr -s '\n' ' ')
        [[ $shown == *"$text"* ]] || same "help $name" "$text" "$shown"
    done
}

# bats test_tags=rows
@test "help answers for the words that people use with the topics that are about them" {
    while read -r word topic; do
        "$DOMINO" -e "help $word" | grep -qE "^$topic( |\$)" || same "help $word" "$topic" "$("$DOMINO" -e "help $word")"
    done <<'END'
growth set r
gap set s
thickness set d
hollow set q
tower count
END
    same json 'launch omega cost fall push' "$(json 'help speed' | values name | paste -sd ' ' -)"
}

# bats test_tags=rows,pictures,lesson
@test "help begins with eleven lines to type, all of which work in this order" {
    "$DOMINO" -e help | sed -nE 's/^> (.{14}) [^ ].*$/\1/p' >lines
    same 'first, last, lines' 'count 112 m quit 11' "$(sed -n '1p;$p' lines | xargs) $(wc -l <lines)"
    run -0 --separate-stderr "$DOMINO" --bail - <lines
    same 'what went wrong' '(nothing)' "$stderr"
    for words in '20 solid dominoes' 1.64422 1.51445 '^rmax \[S\]: ' '^   \[h\] ' '^    12 '; do
        grep -q -- "$words" <<<"$output" || same 'the answers' "$words" "$output"
    done
}

# bats test_tags=chance,pictures,engine,sweeps
@test "apropos finds everyday words, and lists the best match first" {
    while read -r word wanted; do
        same "apropos $word" "$wanted" "$("$DOMINO" -e "apropos $word" | grep -oxE "$wanted( .*)?" | cut -c "-${#wanted}")"
    done <<'END'
tower count
picture draw
spacing set s
undo reset
script source
slope set slope
probability placement
Domtoren count
solid set q
sandpaper set friction
speed duration
END
    for about in thetac 'set push' 'set release'; do "$DOMINO" -e 'help tip' | grep -q "^$about "; done
    same 'first what is about it' 'set slope' "$("$DOMINO" -e 'apropos slope' | sed -n '1s/ \{2,\}.*//p')"
    wrong 'apropos money' "^-e:1: apropos: nothing was found about 'money'; try another word, such as"
    for word in picture gap; do expects "$word" "$("$DOMINO" -e "apropos $word")"; done
}

@test "help is one screen; a group has a line for each of its commands, and 'help all' for every command" {
    run -0 "$DOMINO" -e help
    [ "${#lines[@]}" -le 24 ] && [ "$(wc -L <<<"$output")" -le 80 ]
    "$DOMINO" -e help | sed -nE '/^cycles/,$s/^([a-z]+ |  )//p' | tr -s ' ' '\n' | grep . | sort -u >names
    json help | grep '"kind":"command"' | values name | grep -vxE 'back|goto|where|scene|effect' | sort -u >all
    same_file all names
    while read -r name; do "$DOMINO" -e 'help all' | grep -qE "^  $name( |$)"; done <names
    same 'json' "$("$DOMINO" -e "set output json; help" | wc -l)" "$("$DOMINO" -e "set output json; help all" | wc -l)"
    # The names that follow a group's word on the screen are those of its lines.
    "$DOMINO" -e help | awk '/^cycles/ { found = 1 } /^[^a-z ]/ { found = 0 }
        found && /^[a-z]/ { printf "%s%s", end, $1 "|"; $1 = ""; end = "\n" } found { $1 = $1; printf "%s ", $0 } END { print "" }' |
        sed 's/| */|/; s/ *$//; s/  */ /g' >groups
    [ "$(wc -l <groups)" -ge 4 ]
    while IFS='|' read -r group names; do
        expects "$group" "$names"
        same "$group" "$names" "$("$DOMINO" -e "help $group" | sed -nE 's/^  ([a-z0-9]+).*/\1/p' | uniq | paste -sd ' ' -)"
    done <groups
}
