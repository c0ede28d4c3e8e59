#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Answers with a proof: statements, keys, incomplete proofs, and the table of proved growths.

load ../shell/common

root=$BATS_TEST_DIRNAME/../..

@test "prove says in words what is proved, and r_max is within the bounds" {
    says 'set d 7/48; prove rmax 0.4' 'Proved: for every growth from 1 to 1.644229039535 the train keeps falling; at 1.644229039536 it stops.'
    says 'set tol 1e-4; prove rmax 0.4' 'for every growth from 1 to 1.6442 the train keeps falling; at 1.6443 it stops.'
    says 'prove rmax 0.7' 'Proved: for every growth from 1 up to 1/s the train keeps falling.'
    says 'prove rmax 0.005' 'Proved: at growth 1 the train stops.'
    says 'set q hollow; prove pair 0.3' 'to 1.654207309921 the first domino topples the next one even if it only just tips over; at 1.654207309922 it does not.'
    # With both fuels and with several exponents of the mass.
    for scene in 'set fuel paper' 'set q hollow' 'set q 3.7; set d 0.1'; do
        row=$(json "$scene; prove rmax 0.3")
        awk -v r="$(json "$scene; rmax 0.3" | values r_max)" -v low="$(values low <<<"$row")" -v high="$(values high <<<"$row")" \
            'BEGIN { exit !(low <= r && r <= high && high - low < 4e-12 * r) }' || { echo "$scene: $row"; false; }
    done
}

@test "prove barrier, verdict and count" {
    same keys 's what low high result' "$(json 'prove verdict' | keys)"
    for what in barrier verdict; do
        row=$(json "prove $what")
        key=${what/verdict/margin}
        within "$what" "$(values low <<<"$row")" "$(json barrier | values "$key")" 'd <= 1e-10'
        within "$what" "$(values high <<<"$row")" "$(json barrier | values "$key")" 'd <= 1e-10'
    done
    same verdicts 'goes on stops out of reach no fuel' \
        "$(json 'prove verdict; set r 1.7; prove verdict; set r 2.6; prove verdict; set r 1; set s 0.005; prove verdict' |
            values result | paste -sd ' ' -)"
    same 'a power that is exact' '12 13' "$(json 'set r 2; prove count 196.608 m; prove count 196.7 m' | values low | paste -sd ' ' -)"
    same 'and for sure' '12 13' "$(json 'set r 2; prove count 196.608 m; prove count 196.7 m' | values high | paste -sd ' ' -)"
    [[ $("$DOMINO" -e 'prove count 112 m') == *'Proved: 20 dominoes are enough at growth 1.5, and fewer are not.'* ]]
}

@test "bounds are rounded outwards" {
    # To 13 digits the largest growth is 10, so the upper bound has one more digit before the point than the lower
    # bound.
    ten='set s 0.05; set q hollow; set d 0.00066373441778146873; set tol 1e-12; prove rmax'
    same 'the upper bound' 10.00000000004 "$(json "$ten" | values high)"
    [[ $("$DOMINO" -e "$ten") == *$'\n'high*' 10.00000000004 '* ]]
    # The sentence has 12 digits of 9.99999999997566.
    [[ $("$DOMINO" -e "set tol 3e-14; ${ten/set tol 1e-12; /}") == *'Only this is proved: for every growth from 1 to 9.99999999992 the'* ]]
    # The tilts of close equal dominoes converge slowly, here by 0.2 % from domino to domino.
    row=$(json 'set s 0.001; set d 0.001; set r 1; prove verdict')
    within 'close dominoes' "$(values low <<<"$row")" "$(values high <<<"$row")" 'd >= 0 && d < 1e-6'
    # Before a dip of the margin of 4e-9 of the energy, strips are wide enough only if all derivatives are bounded.
    within 'a dip' 4.466885565832 "$(json 'set d 0.254524; set q 0.474363; prove rmax 0.119202042' | values low)" 'd < 0 && d > -1e-8'
    # There may be too many powers to multiply.
    row=$(json 'set r 1.0000001; prove count 112 m')
    same 'a small growth' 'not proved 100000 null' "$(for key in result low high; do values $key <<<"$row"; done | paste -sd ' ')"
}

@test "an incomplete proof is reported, with the reason" {
    row=$(json 'effect friction 0.1; prove rmax 0.4')
    same result 'not proved' "$(values result <<<"$row")"
    same low null "$(values low <<<"$row")"
    for row in "$row" "$(json 'effect friction 0.1; prove count 112 m')"; do
        same reason 'not proved: there is no proof for trains with effects that change their motion' "$(values reason <<<"$row")"
    done
    # The verdict at an r that differs from r_max only by rounding.
    same result 'not proved' "$(json 'set d 7/48; set r 1.6442290395351491; prove verdict' | values result)"
    for line in 'prove rmax 2' 'prove nothing' 'prove' 'prove count' 'prove verdict 3' 'prove rmax 0.2 m'; do
        run -1 --separate-stderr "$DOMINO" --keep-going -e "$line"
        same "lines of $line" 1 "${#stderr_lines[@]}"
        same "answer of $line" '(nothing)' "$output"
    done
}

# bats test_tags=sweeps
@test "prove works in a sweep, with the same output on any number of threads" {
    grid='sweep s 0.2 0.5 4 q 3, 4 : prove rmax'
    same rows "$(json "set threads 1; $grid" | md5sum)" "$(json "set threads 4; $grid" | md5sum)"
    same results 8 "$(json "$grid" | values result | grep -c barrier)"
}

# bats test_tags=sweeps
@test "a run reproduces the atlas of proved growths, and an independent check confirms its rows" {
    cd "$BATS_TEST_TMPDIR" || false
    table=$(realpath "$root")/examples/atlas.csv
    same rows 228 "$(grep -vc '^[#s]' "$table")"
    sed 's/^sweep.*/sweep s 0.5 0.5 1 d 0.05 0.15 3 q 3, 4 : prove rmax/' "$root/examples/atlas.dom" | "$DOMINO" -n -f - >part.csv
    [ "$(wc -l <part.csv)" -eq 7 ]
    grep -v '^s' part.csv | while IFS= read -r row; do grep -qFx -- "$row" "$table"; done
    run -0 "$root/tests/atlas" "$table" 57
    same checked '4 rows checked, 0 not confirmed' "$output"
    # The check rejects a wrong digit in either number.
    grep '^s,\|^0.4,0.15,4,' "$table" >one.csv
    run -0 "$root/tests/atlas" one.csv
    low=$(tail -n 1 one.csv | cut -d , -f 5) high=$(tail -n 1 one.csv | cut -d , -f 6)
    for change in "$high,$(awk -v h="$high" 'BEGIN { printf "%.12f", h + 1e-12 }')" "$(awk -v l="$low" 'BEGIN { printf "%.12f", l - 1e-12 }'),$low"; do
        sed "s/$low,$high/$change/" one.csv >other.csv
        ! cmp -s one.csv other.csv
        run ! "$root/tests/atlas" other.csv
    done
}

# bats test_tags=sweeps
@test "prove count says that the start of the row is computed, but not proved" {
    answer=$(json 'set r 1.64; prove count 112')
    same 'a train that moves' 'no start' "$(values result <<<"$answer")"
    grep -q '"reason":"if its first domino just tips over, the fall ends at domino 2' <<<"$answer"
    same 'with growth 1.5' 'goes on' "$(json 'prove count 112' | values result)"
    "$DOMINO" -e 'prove count 112' | grep -q 'Computed, but not proved: the row starts if its first domino just tips over'
    run -1 "$DOMINO" -e 'set r 1.64; assert prove count 112'
}
