#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Save and source: a session comes back as it was.

load ../shell/common

# bats test_tags=rows
@test "a saved session and its row file can be moved together, and are found from any folder" {
    mkdir -p here/rows other
    for height in 48 24; do
        printf '%s\n' 'height (mm), thickness (mm), gap (mm)' "$height, 7, -" "$height, 7, 20" >row$height.csv
    done
    cp row48.csv here/row.csv && cp row48.csv here/rows/below.csv && cp row24.csv other/row.csv
    "$DOMINO" -e 'effect row here/row.csv; save here/beside.dom; save other/elsewhere.dom' \
        -e 'effect row here/rows/below.csv; save here/below.dom'
    (cd here && "$DOMINO" -e 'effect row row.csv; save bare.dom')
    mv here there
    for name in beside below bare; do
        for from in . there other /; do
            same "$name from $from" '0.048 0.048' \
                "$(there=$PWD/there && cd "$from" && json "source $there/$name.dom; set output json; row" | values height | paste -sd ' ' -)"
        done
    done
    wrong 'source other/elsewhere.dom' "cannot read '$PWD/here/row.csv': No such file"
    same 'to a device' "set row \"$PWD/there/row.csv\"" "$("$DOMINO" -e 'effect row there/row.csv; save /dev/stdout' | grep 'set row')"
}

# bats test_tags=rows,chance
@test "save keeps the scene, and source brings it back" {
    scene="effect friction 0.3; effect row $root/examples/record.csv; effect push 3; place 8 0.75; effect placement 2 mm 0.01; effect floor 0.5"
    differ 'a scene' "$(json 'effect row 5; fall; verdict')" "$(json "$scene; fall; verdict")"
    same saved "$(json "$scene; fall; verdict")" "$(json "$scene; save scene.dom; reset; source scene.dom; fall; verdict")"
    grep -qx 'set friction 0.3' "scene.dom"
    grep -qx 'set placement 2 mm 0.01' "scene.dom"
}

@test "save and source: every parameter comes back as it was" {
    json show | values name >names
    [ "$(wc -l <names)" -ge 12 ]
    while read -r name value; do
        before=$(json "set $name $value; show")
        [ "$before" != "$(json show)" ]
        "$DOMINO" -e "set $name $value; save $name.dom"
        same "$name" "$before" "$(json "source $name.dom; set output json; show")"
        same "$name: -f" "$before" "$("$DOMINO" -f "$name.dom" -e 'set output json; show')"
        same "$name: again" "$(cat "$name.dom")" "$("$DOMINO" -e "source $name.dom; save again" && cat again)"
        same "$name: is saved" 1 "$(grep -c "^set $name " "$name.dom")"
    done <<'END'
s 1/3
r pi/3
q hollow
angle deg
END
    # All parameters at once, in a session with other values.
    changed='set s 1/3; set r pi/3; set d 0.1; set q 10/3; set tol 1e-9; set h 1 ft; set g 1.62; set fuel paper
        set digits 17; set angle deg'
    before=$(json "$changed; show; theta1 5")
    "$DOMINO" -e "$changed; save \"all of it\""
    same 'all' "$before" "$(json 'set s 0.9; source "all of it"; set output json; show; theta1 5')"
    same 'again' "$(cat 'all of it')" "$("$DOMINO" -e 'source "all of it"; save again' && cat again)"
}

@test "source runs the commands of a file, errors name the file, and a file that sources itself is an error" {
    printf 'set s 0.3\nfoo\n\n  show s; qux 1\n' >inner
    printf 'set output json\nsource inner\nshow s' >outer
    run -1 --separate-stderr "$DOMINO" --keep-going outer
    same 'answers' '0.3 0.3' "$(values value <<<"$output" | paste -sd ' ' -)"
    same 'places' 'inner:2:1: inner:4:11:' "$(cut -d' ' -f1 <<<"$stderr" | paste -sd ' ' -)"
    # After an error in a file, the rest of the line is run.
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'source inner; foo; print 7'
    same 'the place is back' '-e:1:15:' "$(tail -n 1 <<<"$stderr" | cut -d' ' -f1)"
    echo 'quit' >leave
    same 'quit in a file' '(nothing)' "$("$DOMINO" -e 'source leave; fuel' -e fuel)"

    echo 'source itself' >itself
    printf 'source two\n' >one
    printf 'source one\n' >two
    for file in itself one; do
        run -1 --separate-stderr "$DOMINO" --keep-going -e "source $file; print 7"
        same "$file: lines on stderr" 1 "$(wc -l <<<"$stderr")"
        [[ $stderr =~ nested.*itself ]] || same "$file" 'nested ... itself' "$stderr"
        same "$file: the session goes on" 7 "$output"
    done
}

# bats test_tags=rows
@test "a saved session names its csv file byte for byte, whatever its name is" {
    local name quoted
    for name in 'a b.csv' 'a"b.csv' 'a "" ";#>b.csv' 'θ − ×.csv' $'x\u00a0y.csv' $'\xff\x80.csv' 'a ~root b.csv' \
        '\x.csv' $'\u202e.csv' '#.csv' '"q".csv' '""' "it's" '~' ' ' '$(id);`id`'; do
        printf '%s\n' "$two_dominoes" >"$name"
        quoted=./${name//\"/\"\"}
        printf '%s\n' "set row \"$quoted\"" 'save s.dom' | "$DOMINO"
        printf '%s\n' 'source s.dom' 'save t.dom' 'set output json' 'verdict' | "$DOMINO" >answer
        cmp s.dom t.dom
        same "$name" 2 "$(values domino <answer)"
        rm -f -- "$name" ./?.dom answer
    done
}

# bats test_tags=rows,engine,chance
@test "a saved session can be sourced whatever effects are on" {
    "$DOMINO" -e 'save plain.dom'
    same 'nothing differs' "All parameters have their defaults, and no effect is on. 'show all' lists them." \
        "$("$DOMINO" -e 'effect row 5; effect feet 0.5; effect error_floor 0.05; effect error_place 1 mm; source plain.dom' -e show)"
}

# bats test_tags=rows
@test "save replaces no table, no picture and no file of the row" {
    printf '%s\n' "$two_dominoes" | tee mine.csv row >kept
    for name in mine.csv mine.json row.png row.SVG row.gif; do
        wrong "save $name" "'$name' is the name of a (data file|picture), but 'save' writes a script"
    done
    same 'no file' kept,mine.csv,row "$(inside)"
    same 'the row' "'row' has the dominoes of the row, and 'save' would replace them by a script; use another name, such as session.dom" \
        "$("$DOMINO" -e 'set row ./row; save row' 2>&1 | sed 's/.*: //')"
    same_file kept row
    same_file kept mine.csv
}
