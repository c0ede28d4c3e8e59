#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Change: any property of any dominoes of a row, as a value, as a difference, or in percent.

load ../shell/common

# Prints the column KEY of the row after COMMANDS, in one line.
column() { json "$2; row" | values "$1" | paste -sd ' ' -; } # KEY COMMANDS

@test "change: the sentence for each kind of value, and for many dominoes" {
    "$DOMINO" -e "effect row $root/examples/record.csv; change 4,5 thickness +10 %; change 6 height 1.2 m
        change 3-4 gap +1 cm; place 8 -4 cm; change 2 lean = -2 mm; change 2 lean +0.1 deg; change 1 mass -76 g
        change all gap 110 %" | grep . >said
    diff said - <<'END'
domino 4: thickness 10 to 11 cm; 1 more changed, and 'row' lists all
domino 6: height 1.35 to 1.2 m
domino 3: gap 19 to 20 cm; 1 more changed, and 'row' lists all
domino 8: gap 64 to 60 cm
domino 2: lean 0 to -2 mm
domino 2: lean -2 to -1.4066 mm
domino 1: mass 760 to 684 g
domino 2: gap 13 to 14.3 cm; 8 more changed, and 'row' lists all
END
    same 'without masses' 'domino 3: mass 1.1 times as large as before' "$("$DOMINO" -e 'effect row 4; change 3 mass +10 %')"
    same 'named twice' "domino 2: height 7.2 to 7.92 cm; 1 more changed, and 'row' lists all" \
        "$("$DOMINO" -e 'effect row 4; change 3,2-3 height +10 %')"
    same 'for programs' '{"command":"change"}' "$("$DOMINO" -e 'set output json; effect row 4; change 2 gap 1 cm' | tail -n 1)"
}

@test "change: a domino keeps its density; masses are relative if they are not known in kilograms" {
    csv=$root/examples/record.csv
    same thickness '0.76 2.2 6.71 17' "$(column mass "effect row $csv; change 3 thickness +10 %" | cut -d' ' -f1-4)"
    same 'and height' 13.42 "$(column mass "effect row $csv; change 3 thickness +10 %; change 3 height 200 %" | cut -d' ' -f3)"
    same 'and mass' 26.84 "$(column mass "effect row $csv; change 3 mass +100 %; change 3 thickness 110 %; change 3 height 200 %" | cut -d' ' -f3)"
    same 'of the first' 0.9 "$(column mass 'set mass 1; effect row 3; change 1 mass 0.9 kg' | cut -d' ' -f1)"
    same 'relative' '1 3.375 11.390625' "$(column relative 'effect row 3')"
    same 'relative, changed' '1 6.75 11.390625' "$(column relative 'effect row 3; change 2 mass 200 %')"
    # Masses are relative to the first domino, so this change doubles the others.
    same 'relative, first' '1 6.75 22.78125' "$(column relative 'effect row 3; change 1 mass 50 %')"
    # Energies are in m g h / 2 of the first domino, so they do not change if all masses are
    # doubled.
    same energy "$(json 'effect row 4; fall' | values kinetic)" "$(json 'effect row 4; change all mass 200 %; fall' | values kinetic)"
    # A changed row has the same verdict as a file with the same values.
    "$DOMINO" -e "effect row $csv; change 4,5 thickness +10 %; change 3 lean 4 mm; row > by.csv" >/dev/null
    sed -E 's/^4,( *680, *)100,( *[0-9]+, *)17/4,\1110,\218.7/; s/^5,( *960, *)140,( *[0-9]+, *)47/5,\1154,\251.7/' "$csv" >hand.csv
    [ "$(diff "$csv" hand.csv | grep -c '^>')" -eq 2 ]
    for scene in 'effect friction 0.2' 'effect slope 0.5 deg' 'precision = quad' 'effect walls 2 mm'; do
        close "$scene" "$(json "$scene; effect row hand.csv; effect push 3; change 3 lean 4 mm; verdict" | values spare)" \
            "$(json "$scene; effect row by.csv; effect push 3; verdict" | values spare)"
    done
}

# bats test_tags=sweeps,save
@test "change: 'save' and 'row' save it, undo takes it back, and sweeps use it" {
    same 'a length is the radius of the first domino' 'radius 1.41667 to 2 cm' \
        "$("$DOMINO" -e "effect row $root/examples/record.csv; set edges 1 cm; change 2 radius 2 cm" | sed 's/.*: //')"
    says 'effect row 5; change 2 radius 1 mm' "Radii have no effect until you enter 'set edges on'."
    scene="set mass 1; effect row 5; change 2-4 thickness +10 %; change 2 mass 130 %; change 3 lean = -1 mm; change 5 gap 25 %
        change 4 radius 1 mm"
    "$DOMINO" -e "$scene; save scene.dom; row > saved.csv; change 2 height 7 cm; undo > /dev/null; row > undone.csv" >/dev/null
    "$DOMINO" -e 'source scene.dom; row > read.csv; effect row saved.csv; row > again.csv'
    same_file saved.csv undone.csv
    same_file saved.csv read.csv
    same_file saved.csv again.csv
    same swept "$(json 'effect row 5; change 3 thickness 2 cm; set s 0.5; verdict' | values spare)" \
        "$(json 'effect row 5; change 3 thickness 2 cm; sweep s 0.4, 0.5 : verdict' | tail -n 1 | values spare)"
}

@test "change: errors are reported, and change nothing" {
    local before command message
    before=$(json 'effect row 5; row')
    while IFS='|' read -r command message; do
        run --separate-stderr "$DOMINO" --keep-going -e "effect row 5; $command; set output json; row"
        same "$command: one line" 1 "$(wc -l <<<"$stderr")"
        grep -qF -- "$message" <<<"$stderr" || same "$command" "$message" "$stderr"
        same "$command: the row" "$before" "$(grep '"domino"' <<<"$output")"
    done <<'END'
change 3 thickness 12|thickness / height = 111.1111111 is out of range; the range is 1e-12 .. 100
change 9 height 1 m|there is no domino 9; this row has 5
change 1 gap 1 cm|there is no gap before domino 1
change 3 height 0|domino 3: height = 0 m is too small
change 2,3 thickness -100 %|domino 2: thickness = 0 m is too small
change 4 lean 5 cm|domino 4: with its top 5 cm off plumb, this domino falls over by itself
change 3 radius 20 mm|domino 3: radius = 0.02 m is more than 0.007875 m, half of the thickness
change 2 height|X is missing
change 5-2 gap 1 cm|'5-2' names no dominoes
change all gap +0.1|a change of the gap by 0.1 needs a unit, as in '+0.1 m'; to change the gap by a percentage, write a percent sign, as in '+10 %'
change 2 mass 20 g|the masses of this row are not known; enter the mass of its first domino with 'set mass'
change 2 gap -20 cm|domino 2: gap = -0.1712 m is negative
END
    wrong 'change 2 gap 1 cm' 'there is no row'
    wrong 'effect row 3; set walls 1 mm; change 2 thickness 1 mm; verdict' 'walls of 1 mm do not fit into domino 2'
}

@test "change takes a range with '-', ':' or '..'" {
    for range in 2-4 2:4 2..4 2,3,4; do
        same "$range" '0.048 0.09 0.09 0.09 0.243' "$(json "effect row 5; change $range height 9 cm; row" | values height | paste -sd ' ' -)"
    done
    wrong 'effect row 5; change 4:2 height 9 cm' "'4-2' names no dominoes; write the smaller number first"
}
