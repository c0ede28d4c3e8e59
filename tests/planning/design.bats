#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Design: a row that fulfils a wish.

load ../shell/common

wood='set q hollow; effect friction 0.3'

# The published rows have s = 0.46, 0.48 and 0.54, and were found in steps of 0.02 in s. The first of these
# rows is 12.0 m long before it falls.
# bats test_tags=engine
@test "design: rows from 48 mm to 8 m, with friction 0.3" {
    while read -r q safety s r steps feet; do
        answer=$(json "$wood; set q $q; design 8 m safety $safety")
        within "s $q $safety" "$s" "$(values s <<<"$answer")" 'd > -0.02 && d < 0.021'
        close "r $q $safety" "$r" "$(values r <<<"$answer")" 5e-4
        same "steps $q $safety" "$steps" "$(values steps <<<"$answer")"
        within "feet $q $safety" "$feet" "$(values feet <<<"$answer")" 'd > -0.02 && d < 0.021'
        within "safety $q $safety" "$safety" "$(values safety <<<"$answer")" 'o >= e'
        within "train $q $safety" "$safety" "$(values train <<<"$answer")" 'o >= e'
    done <<'END'
hollow 2 0.46 1.668 10 12.03
hollow 3 0.48 1.592 11 13.39
massive 2 0.54 1.482 13 16.77
END
}

@test "design: the numbers agree with 'barrier' and 'verdict'" {
    json "$wood; design 8 m; barrier; verdict" >answers
    close train "$(awk -v k="$(values kinetic <answers)" -v b="$(values barrier <answers)" 'BEGIN { printf "%.12g", k / b }')" \
        "$(values train <answers)" 1e-9
    close safety "$(awk -v s="$(values spare <answers)" 'BEGIN { printf "%.12g", s + 1 }')" "$(values safety <answers)" 1e-9
    same weakest "$(sed -n 's/.*"verdict".*"weakest":\([0-9]*\).*/\1/p' answers)" "$(values weakest <answers | head -n 1)"
    same fall 'all fall' "$(values verdict <answers | tail -n 1)"
    close seconds "$(values seconds <answers | tail -n 1)" "$(values seconds <answers | head -n 1)" 1e-9
}

# bats test_tags=sweeps
@test "design: the row becomes the row of the session, and 'set row' can read it from a file" {
    "$DOMINO" -e "$wood; design 8 m hall 20 m > hall.csv; fall > typed.csv; show s > s.json"
    same head 'domino,height (m),thickness (m),gap (m),relative' "$(head -n 1 hall.csv)"
    same last 12,8 "$(tail -n 1 hall.csv | cut -d , -f 1,2)"
    "$DOMINO" -e "$wood; effect row hall.csv; fall > read.csv"
    cut -d , -f 1-6 typed.csv | sed 's/\([0-9]\.[0-9]\{7\}\)[0-9]*/\1/g' >typed
    cut -d , -f 1-6 read.csv | sed 's/\([0-9]\.[0-9]\{7\}\)[0-9]*/\1/g' >read
    same_file typed read
    close s "$(values value <s.json)" "$(sed -n 3p hall.csv | awk -F , '{ printf "%.12g", $4 / $2 }')"
    # The row fits into the hall.
    awk -F , 'NR > 1 { sum += $3 + $4; last = $2 } END { exit !(sum + last <= 20 && sum + last > 19.97) }' hall.csv
    same off 1 "$("$DOMINO" -e "$wood; design 8; effect row off; verdict" 2>&1 | grep -c 'there is no row')"
}

@test "design: keeps walls, width and thickness as they were typed" {
    local kept='set d 8 mm; set width 24 mm; set walls 2 mm 9 cm; set h 60 mm'
    same 'kept' 'd 8 mm,width 24 mm,walls 2 mm,' \
        "$("$DOMINO" -e "$kept; design 1 m; show" | awk '/^(d|width|walls) / { print $1, $2, $3 }' | paste -sd ,)"
    same 'and in the row' '0.008 0.024' "$(json "$kept; design 1 m; row" | values thickness | sed -n 1p) $(json "$kept; design 1 m; row" | values width | sed -n 1p)"
    json "$kept; design 1 m > made.csv" >made
    same 'and in a file' "$(json "$kept; design 1 m; row" | tail -n 1 | keys)" "$(json "set row made.csv; set walls 2 mm 9 cm; row" | keys)"
    wrong 'set walls 12 mm; design 1 m' "walls of 1.2 cm do not fit"
    [ "$(json 'set walls 1.2 cm 17 cm; design 1 m' | values steps)" -gt 3 ]
}

@test "design: the details list the row, with masses if they are known" {
    run -0 "$DOMINO" -e "$wood; set mass 0.01; design 8 m details"
    same row "$("$DOMINO" -e "$wood; set mass 0.01; design 8 m; row" | tail -n 14)" "$(tail -n 14 <<<"$output")"
    grep -qE '^ +11 +8 +1\.16667 +3\.752 ' <<<"$output"
    grep -qE '^mass +433\.6' <<<"$output"
}

@test "design: masses are density times volume, in air and without it, for boxes and solid dominoes" {
    local sum file
    for walls in 0 0.018; do
        for air in '' 'set air on; '; do
            scene="${air}set friction 0.3; set density 650; set h 10 cm; set d 12 mm"
            [ $walls = 0 ] || scene+="; set walls $walls m 30 cm"
            run -0 "$DOMINO" -n -e "$scene; design 9 m hall 40 m > row.csv"
            read -r sum file < <(awk -F, -v walls=$walls 'NR > 1 {
                w = $2 / 2
                sum += 650 * ($2 * $3 * w - (walls && $2 > 0.3) * ($2 - 2 * walls) * ($3 - 2 * walls) * (w - 2 * walls))
                file += $5
            } END { printf "%.9g %.9g\n", sum, file }' row.csv)
            close "$scene: the file" "$sum" "$file" 1e-8
            close "$scene: the answer" "$sum" "$(json "$scene; design 9 m hall 40 m" | values mass)" 1e-8
        done
    done
}

@test "design: if no row meets the wishes, the answer says which value would help" {
    run -0 "$DOMINO" -e "$wood; design 8 m hall 18 m"
    same hall "infeasible: the shortest row that was found with a safety of 2 is 19.59 m long, including its fallen last domino; 'hall 19.6 m' is long enough." "$output"
    same 'hall 19.6 m' 11 "$(json "$wood; design 8 m hall 19.6 m" | values steps)"
    close shortest 19.591852 "$(json "$wood; design 8 m hall 19.6 m" | values length)" 1e-6
    run -0 "$DOMINO" -e "set q hollow; effect friction 5; design 8 m"
    same friction 'infeasible: not even equal dominoes keep falling here, whatever the gap; enter a smaller friction.' "$output"
    run -0 "$DOMINO" -e "set q hollow; effect friction 3; design 8 m"
    below=$(sed -n 's/.*a safety below \([0-9.]*\) .*/\1/p' <<<"$output")
    within 'below' 1.617 "$below" 'd < 1e-3 && d > -1e-3'
    run -0 "$DOMINO" -e "$wood; set push 0.5; design 8 m"
    push=$(sed -n "s/.*needs a push of .* m\/s at its top; first enter 'set push \([0-9.]*\)'\.$/\1/p" <<<"$output")
    same "push $push" 10 "$(json "$wood; set push $push; design 8 m" | values steps)"
    # Without a row, no file is written.
    run -1 "$DOMINO" --keep-going -e "$wood; design 8 m hall 18 m > hall.csv"
    [ ! -e hall.csv ]
}

@test "design: with boards, a hall that is too short is named, and the length that is enough" {
    local scene='set friction 0.3; set density 650; set h 10 cm; set d 12 mm; set walls 18 mm 30 cm; set q hollow'
    run -0 "$DOMINO" -e "$scene; design 9 m hall 22 m boards 12, 18, 24 mm"
    same hall "infeasible: the shortest row that was found with a safety of 2 is 22.42 m long, including its fallen last domino; 'hall 22.42 m' is long enough." "$output"
    same '22.42 m' 10 "$(json "$scene; design 9 m hall 22.42 m boards 12, 18, 24 mm" | values steps)"
    # Not all dominoes are hollow.
    says "$scene; design 9 m hall 40 m" '11 dominoes, those above 30 cm hollow, each '
    wrong "$scene; set walls 18 mm 20 cm; design 9 m hall 40 m" "walls of 1.8 cm do not fit into each domino taller than 20 cm here; enter a larger height, as in 'set walls 1.8 cm 40 cm'$"
    within '31 cm' 11 "$(json "$scene; set walls 1.8 cm 31 cm; design 9 m hall 40 m" | values steps)" 'd < 0.5 && d > -0.5'
    wrong "$scene; set d 7/48; design 9 m hall 40 m boards 12, 18, 24 mm; set d 12 mm; rowmax" "walls of 1.8 cm do not fit into each domino taller than 30 cm here; enter a larger height, as in 'set walls 1.8 cm 60 cm'$"
    # In air, a row that is not solid is designed without air.
    wrong "$scene; set air on; design 9 m hall 40 m" 'in air only solid dominoes'
    same 'in air' 'all fall' "$(json "$scene; set air on; set air off; design 9 m hall 40 m; set air on; verdict" | values verdict)"
}

# bats test_tags=engine
@test "design: if the engine runs rows, the answer says that it is one of the model" {
    says 'set h 5 cm; set q hollow; set d 0.2; set friction 0.3; set feet 0.4; design 1 m' "This is an answer of the model, which treats feet as hinges; 'verdict' runs the row in the rigid-body engine, because feet is on."
}

@test "design: a row with friction and rounded edges; numbers that do not exist are null" {
    answer=$(json 'set q hollow; set d 0.2208; effect friction 0.142; effect edges 0.0203; design 5 m safety 3; verdict')
    same rounded 'all fall' "$(values verdict <<<"$answer")"
    same 'no barrier' 'null null null' "$(json 'design 8 m safety 1000' | while read -r a; do
        echo "$(values safety <<<"$a") $(values weakest <<<"$a") $(values train <<<"$a")"; done)"
    same 'no energy is needed' 'no domino after the first needs energy to fall over, so no safety is known' \
        "$(json "$wood; set release touch; design 8 m" | values reason)"
}

@test "design: an invalid wish gives a one-line error" {
    wrong 'design 4 cm' 'H = 4 cm is not more than the height of the first domino, h = 4\.8 cm'
    wrong 'design 8 m hall 7 m' 'the length of the hall is not greater than the height of the last domino'
    wrong 'design 8 m safety 1' 'the safety factor is not a finite number above 1'
    wrong 'design 8 m safety 2 m' 'the safety is a number without a unit; 2 means'
}

@test "design: boards and grids" {
    wrong 'design 1 m grid 1 m' 'a grid of 1 m is too coarse: domino 1 is 4.8 cm tall and cannot reach across a gap of this length'
    same 'a number has the unit at the end of the list' \
        "$("$DOMINO" -e 'set q hollow; set output csv; design 8 m boards 1 cm, 2 cm, 3 cm')" \
        "$("$DOMINO" -e 'set q hollow; set output csv; design 8 m boards 1, 2, 3 cm')"
    says 'set q hollow; design 8 m boards 1 m' 'infeasible: no row with a safety of 2 was found, whatever the push of domino 1; enter a smaller safety, other boards or a finer grid, or '
}

@test "design: with whole mm and boards, the rounded row still has the requested safety" {
    boards='boards 9, 12, 15, 18, 25, 30, 50, 70, 100, 150, 250, 400, 700, 1100 mm'
    json "$wood; design 8 m grid 1 mm $boards; row; fall" >answers
    values safety <answers >safety
    within safety 2 "$(cat safety)" 'o >= e'
    close verified "$(values energy <answers | awk 'NR > 2 && (m == "" || $1 < m) { m = $1 } END { print m }')" "$(cat safety)" 1e-6
    same 'whole mm' 0 "$(values gap <answers | awk '{ x = 1000 * $1; d = x - int(x + 0.5); n += d * d > 1e-12 } END { print n }')"
    same boards 0 "$(values thickness <answers | awk -v all="7 $boards" 'BEGIN { gsub(/[^0-9. ]/, " ", all); split(all, b, " "); for (k in b) ok[b[k]] } { n += !(sprintf("%.10g", 1000 * $1) in ok) } END { print n }')"
    within hall 20 "$(json "$wood; design 8 m grid 1 mm hall 20 m" | values length)" 'o <= e && o > 19'
}

@test "design: 'falls' finds the fewest dominoes for which the lower end of the interval reaches the probability" {
    scene='set q hollow; set friction 0.3; set placement 5 mm'
    answer=$(json "$scene; design 30 cm falls 90 %")
    steps=$(values steps <<<"$answer")
    within enough 0.9 "$(values low <<<"$answer")" 'o >= e'
    # 'placement' counts the same rows, and fewer dominoes are not enough.
    row="$scene; set s $(values s <<<"$answer"); set r (30/4.8)^(1/"
    same rows "$(values probability <<<"$answer")" "$(json "$row$steps); set row $((steps + 1)); placement 2000" | values probability)"
    within fewer 0.9 "$(json "$row$((steps - 1))); set row $steps; placement 2000" | values low)" 'o < e'
    run -0 "$DOMINO" -e "$scene; set placement 20 mm; design 4 m falls 99 %"
    grep -qE '^infeasible: no row that was tried falls with a probability of 99 %; of the last one, .* rows fall' <<<"$output"
    wrong 'design 1 m falls 90 %' "'falls' needs random errors; first enter 'set placement 1 mm'"
    wrong "$scene; design 1 m falls 2" "'falls' is a probability of at most 99.99 %"
}
