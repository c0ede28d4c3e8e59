#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of placement: studies, complete and in parts, and budgets.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load ../shell/common

study='set q hollow; set r 5/3; effect friction 0.3; effect row 11; effect placement 1 mm'

parts() { # PARTS ROWS
    for part in $(seq "$1"); do "$DOMINO" --shard "$part/$1" -e "set output csv; $study; placement $2"; done
}

@test "placement: the rows depend on the seed but not on the number of threads, and the interval is right" {
    scene='set q hollow; set r 5/3; effect friction 0.3; effect row 11; effect placement 1 mm'
    one=$(json "$scene; set threads 1; placement 400")
    for threads in 2 3 7 0; do same "$threads threads" "$one" "$(json "$scene; set threads $threads; placement 400")"; done
    differ 'another seed' "$one" "$(json "$scene; set seed 2; placement 400")"
    # Without errors all 200 rows fall, and the interval is exactly 0.025^(1/200) .. 1.
    exact=$(json 'effect row 5; effect placement 0; placement 200')
    same all '200 1' "$(values fall <<<"$exact") $(values high <<<"$exact")"
    close low "$(awk 'BEGIN { printf "%.15g", exp(log(0.025) / 200) }')" "$(values low <<<"$exact")"
    # With the sigma that budget finds, 80 % to 81 % of the rows fall.
    sigma=$(json "$scene; budget 0.8 400" | values sigma)
    share=$(json "$scene; effect placement $sigma m; placement 400" | values probability)
    within 'the share that falls' 0.8 "$share" 'd >= 0 && d < 0.0125'
}

@test "placement with a value that no row can have reads no uninitialized memory" { # under UBSan
    wrong 'effect edges 0.2; effect row 4; effect placement 1 mm; placement 20' 'radius'
    wrong 'effect slope 1; effect row 4; effect placement 1 mm; placement 20' 'no domino can stand upright'
}

@test "budget finds sigma while the effect placement is off, and says how many rows fall with this sigma" {
    said=$("$DOMINO" -e 'effect row 13; budget 0.95 300')
    grep -qE '^Keep the gaps accurate to within 1\.9 mm \(one standard deviation\): then 95 of 100 rows fall \(95 % interval: 92 to 98\)\.$' <<<"$said"
    same 'no effect is on' off "$(json 'effect row 13; budget 0.95 50; show placement' | tail -n 1 | values value)"
    # The interval agrees with a study of placement with this sigma.
    answer=$(json 'effect row 13; effect placement 1.9 mm; placement 300')
    same low 92 "$(values low <<<"$answer" | awk '{ print int(100 * $1) }')"
    same high 98 "$(values high <<<"$answer" | awk '{ print int(100 * $1) + 1 }')"
    same 'gaps of the effect are not used' "$(json 'effect row 13; budget 0.95 50')" \
        "$(json 'effect row 13; effect placement 9 mm; budget 0.95 50')"
    differ 'its heights are' "$(json 'effect row 13; budget 0.95 50')" \
        "$(json 'effect row 13; effect placement 9 mm 0.02; budget 0.95 50')"
}

@test "after a signal that ends a script, placement and budget answer for the rows that were counted" {
    for call in 'placement 9000000' 'budget 0.95 20000'; do
        for wait in 0.3 1 3 9; do # wait until some rows have been counted
            "$DOMINO" -n -e "set output csv; effect row 13; effect placement 8 mm; $call; print 7" >out 2>err 3>&- &
            sleep "$wait"
            kill -TERM $!
            wait $! && status=0 || status=$?
            same "$call: ended by SIGTERM" 143 "$status"
            same "$call: said" "-e:1: ${call%% *}: interrupted" "$(cat err)"
            ! grep -q '^[0-9].*interrupted' out || break
        done
        same "$call: names and numbers" 2 "$(wc -l <out)"
    done
    [[ $(sed -n 2p out) =~ ^0\.95,[0-9.e-]+,.*,interrupted ]]
}

@test "placement in parts: rows do not depend on the number of parts, and 'pool' gives the answer of the whole study" {
    parts 1 530 >whole
    same blocks 7 "$(wc -l <whole)"
    for n in 2 3 7; do
        parts "$n" 530 >parts
        cmp whole parts
    done
    same '3 threads' "$(cat whole)" \
        "$("$DOMINO" --shard 1/1 -e "set threads 3; set output csv; $study; placement 530")"
    for format in csv json table; do
        same "$format" "$("$DOMINO" -e "set output $format; $study; placement 530")" \
            "$("$DOMINO" -e "set output $format; pool parts")"
    done
    same 'any order, standard input' "$("$DOMINO" -e "pool whole")" \
        "$({ head -n 1 whole; sed 1d whole | sort; } | "$DOMINO" -e 'pool -')"
    same 'as a spreadsheet saves it' "$("$DOMINO" -e "pool whole")" \
        "$(sed 's/,/;/g; s/\./,/g; s/^\|;/&"/g; s/;\|$/"&/g' whole | "$DOMINO" -e 'pool -')"
    # Row number i is the same in every study, so a study of 100 rows agrees with the first 100 of 530 rows.
    same 'the first block' "$(parts 1 100 | tail -n 1 | cut -d , -f 7-)" "$(sed -n 2p whole | cut -d , -f 7-)"
}

@test "pool: missing rows are reported, and duplicate rows or rows of other studies are errors" {
    parts 3 400 >all
    grep -v ',101,100,' all >less
    same missing '"reason":"100 of the 400 rows are missing; the first missing row is number 101"}' \
        "$(json "pool less" | grep -o '"reason".*')"
    same 'of fewer' 300 "$(json "pool less" | values rows)"
    pool_fails() { # PATTERN < blocks
        cat >blocks
        wrong_line "pool blocks" "$1"
    }
    cat all less | pool_fails ':[0-9]+:1: row 1 of the study is in .* twice'
    study="$study; set seed 2" parts 1 100 | cat less - | pool_fails ':6:1: this block belongs to another study'
    study="$study; place 3 40 mm" parts 2 400 | cat less - | pool_fails ':6:1: this block belongs to another study'
    study="$study; change 3 lean 1 mm" parts 2 400 | cat less - | pool_fails ':6:1: this block belongs to another study'
    pool_fails 'has no blocks of a study' </dev/null
    pool_fails ":1:1: the column 'heights' is missing; .* 'domino --shard I/N' .* writes blocks" <<<'sigma,mass'
    sed '2s/,100,/,x,/' all | pool_fails ":2:[0-9]+: rows at 'x'"
    sed '2s/^[^,]*,/-1,/' all | pool_fails ':2:1: sigma = -1 is negative'
    sed 2s/,100,/,99,/ all | pool_fails ':2:1: the counts of this block do not add up'
    wrong_line "pool $PWD/none" 'No such file'
    run --separate-stderr "$DOMINO" --safe -e "pool all"
    grep -q 'safe session' <<<"$stderr"
}

# bats test_tags=sweeps,engine
@test "random errors of every kind are saved, undone and swept like effects, and may need the effect to which they apply" {
    scene='set q hollow; set r 1.6; effect friction 0.3; effect row 9; effect push 3'
    all='effect placement 2 mm uniform; effect error_place 1 mm; effect error_thickness 2 %; effect error_mass 5 % uniform
effect error_lean 0.1 deg; effect error_friction 0.05; effect error_slope 0.2 deg; effect error_push 0.2'
    whole=$(json "$scene; $all; placement 40")
    "$DOMINO" -e "$scene; $all; save scene.dom"
    same saved "$whole" "$(json 'source scene.dom; set output json; placement 40')"
    grep -qx 'set placement 2 mm 0 uniform' scene.dom
    same undone "$(json "$scene; effect placement 2 mm; placement 40")" \
        "$(json "$scene; effect placement 2 mm; effect error_mass 0.2; undo; placement 40" | tail -n 1)"
    same swept "$(json "$scene; effect placement 2 mm; effect error_friction 0.1; placement 40" | values fall)" \
        "$(json "$scene; effect placement 2 mm; sweep error_friction 0.05, 0.1 : placement 40" | values fall | tail -n 1)"
    wrong 'effect error_mass 0.1; placement' 'there is no row'
    wrong 'effect row 4; effect error_radius 0.1' "needs the effect edges; first enter 'set edges RADIUS'"
    wrong 'effect row 4; effect error_floor 0.1' 'feet'
    wrong 'effect row 4; effect error_push 0.1' 'push'
    wrong 'effect edges 0.01; effect row 4; effect error_lean 0.1 deg; placement 5' 'cannot be combined with rounded edges'
    wrong 'effect row 4; effect feet 0.4; effect error_lean 0.1 deg; placement 5' \
        "this row because feet is on; first enter 'set error_lean off'"
    wrong 'effect row 4; effect error_mass 0.1 foo' 'LIMITS is normal or uniform'
    wrong 'effect row 4; budget 0.9 20 all' 'there are no errors to scale'
}

@test "placement: the cost of an error agrees with a study without this error, and 'pool' adds up the costs" {
    row='set q hollow; set r 1.66; set s 0.45; effect friction 0.3; effect row 11'
    errors='effect placement 3 mm; effect error_thickness 1 %; effect error_friction 0.05'
    answer=$(json "$row; $errors; placement 330")
    off=$(values costs_most <<<"$answer")
    case $off in
    gap) off=placement ;;
    *) off=error_$off ;;
    esac
    same 'without it' "$(json "$row; $errors; effect $off off; placement 330" | values probability)" \
        "$(values without <<<"$answer")"
    for part in 1 2; do "$DOMINO" --shard $part/2 -e "set output csv; $row; $errors; placement 330"; done >parts
    same pooled "$answer" "$(json 'pool parts' | sed 's/"pool"/"placement"/')"
    "$DOMINO" -e "$row; $errors; placement 330" | grep -q '^Of all errors, .* the most rows: without '
}

@test "budget finds the size of any single error, and one factor for all errors" {
    row='set q hollow; set r 1.6; effect friction 0.3; effect row 9; effect placement 2 mm; effect error_thickness 2 %'
    size=$(json "$row; budget 0.8 100 thickness" | values sigma)
    share=$(json "$row; effect error_thickness $size; placement 100" | values probability)
    within 'the share that falls' 0.8 "$share" 'd >= 0 && d < 0.03'
    factor=$(json "$row; budget 0.8 100 all" | values sigma)
    share=$(json "$row; effect placement 2*$factor mm; effect error_thickness 0.02*$factor; placement 100" | values probability)
    within 'the share with all errors scaled' 0.8 "$share" 'd >= 0 && d < 0.03'
}
