#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The width of dominoes: as a share and as a length, in masses, boxes, rows, designs and plans.

load common

# bats test_tags=rows,sweeps,explain,save
@test "width: a parameter like the others, and 'w' is short for it" {
    same 'show' 'width 24 mm' "$("$DOMINO" -e 'set width 24 mm; show' | awk '$1 == "width" { print $1, $2, $3 }')"
    for name in w wi width Width; do
        same "set $name" 0.25 "$(json "set $name 12 mm; print width" | values value)"
        same "show $name" width "$(json "show $name" | values name)"
        same "reset $name" 0.5 "$(json "set width 2; reset $name; print width" | values value)"
        same "with $name" 0.25 "$(json "print width with $name 12 mm" | values value)"
        same "sweep $name" '0.1 0.2' "$(json "sweep $name 0.1, 0.2 : print width" | values value | paste -sd ' ')"
    done
    same completion 'width' "$(completed 'set wi')"
    [[ $("$DOMINO" -e 'help width') == *'across the row'* ]]
    same 'it stays a length' '0.012 24 mm' "$(json 'set w 12 mm; set h 20 cm; print width*h; save w.dom' | values value) $(grep -q '^set width 12 mm$' w.dom && echo 24 mm)"
    same 'saved' 0.12 "$(json 'source w.dom; set output json; set h 10 cm; print width' | values value)"
    wrong 'set width 0' 'width = 0 is out of range; width must be in the range 1e-12 .. 100 h'
    wrong 'set width 3 kg' 'length'
    same 'a variable w stays one' 3 "$(json 'let w = 3; print w' | values value)"
}

# bats test_tags=rows,planning
@test "width: masses from a density, and boxes" {
    local mass
    mass=$(awk 'BEGIN { print 700 * 48 * 7 * 30 / 1e9 }')
    close 'of a block' "$mass" "$(json 'set density 700; set width 30 mm; set row 3; row' | values mass | head -n 1)"
    close 'of a narrow box' "$(awk 'BEGIN { print 700 * (48 * 7 * 12 - 46 * 5 * 10) / 1e9 }')" \
        "$(json 'set density 700; set width 12 mm; set walls 1 mm; set row 3; row' | values mass | head -n 1)"
    close 'energies follow' 2 "$(json 'set density 700; set row 2; fall; set width 1; fall' | values kinetic | sed -n '2p;4p' | paste -sd ' ' | awk '{ print $2 / $1 }')"
    # The moment of inertia of a box, from its hollow (domino-effects(7)).
    close 'times of a box' "$(awk 'BEGIN { d = 7 / 48; t = 1 / 48; w = 12 / 48; v = (1 - 2*t) * (1 - 2*t/d) * (1 - 2*t/w)
        u = ((1 - 2*t)^2 + (d - 2*t)^2) / (1 + d*d); print sqrt(1 + v * (1 - u) / (4 * (1 - v))) }')" \
        "$(json 'duration; set width 12 mm; set walls 1 mm; duration' | values seconds | paste -sd ' ' | awk '{ print $2 / $1 }')"
    same 'solid dominoes take as long' "$(json 'duration')" "$(json 'set width 3; duration')"
    same 'columns' 'domino height thickness gap relative width' "$(json 'set width 0.3; set row 3; row' | keys)"
    same 'no column for the usual width' 'domino height thickness gap relative' "$(json 'set width 24 mm; set row 3; row' | keys)"
}

# bats test_tags=rows
@test "width: rows from files, in which a width of their own counts" {
    printf 'height (mm), thickness (mm), gap (mm), density (g/cm^3)\n48, 7, -, 0.7\n72, 10, 20, 0.7\n' >plain.csv
    printf 'height (mm), thickness (mm), gap (mm), density (g/cm^3), width (mm)\n48, 7, -, 0.7, 20\n72, 10, 20, 0.7, 20\n' >wide.csv
    same 'a length for all' "$(json 'set row wide.csv; row; verdict')" "$(json 'set width 20 mm; set row plain.csv; row; verdict')"
    same 'in any order' "$(json 'set row wide.csv; row')" "$(json 'set row plain.csv; set width 20 mm; row')"
    close 'a share of each height' "$(awk 'BEGIN { print 700 * 72 * 10 * 18 / 1e9 }')" "$(json 'set row plain.csv; set width 0.25; row' | values mass | tail -n 1)"
    same 'the usual width' "$(json 'set row plain.csv; row')" "$(json 'set row plain.csv; set width 20 mm; reset width; row')"
    same 'the widths of the file' "$(json 'set row wide.csv; row')" "$(json 'set row wide.csv; set width 0.25; row')"
    same 'and says so' 'width does not change the row, whose widths come from wide.csv.' "$(echo 'set row wide.csv; set width 0.25' | "$DOMINO")"
    same 'boxes' "$(json 'set row wide.csv; set walls 2 mm; row; verdict')" "$(json 'set width 20 mm; set row plain.csv; set walls 2 mm; row; verdict')"
    json 'set row plain.csv; set width 20 mm; row > made.csv' >/dev/null
    same 'written and read' "$(json 'set row wide.csv; row')" "$(json 'set row made.csv; row')"
    same 'changed' '0.02 0.03' "$(json 'set row plain.csv; set width 20 mm; change 2 width 3 cm; row' | values width | paste -sd ' ')"
}

# bats test_tags=rows,planning
@test "width: designs, and the tower" {
    close 'mass of a design' 2 "$(json 'set density 700; design 1 m; undo; set width 1; design 1 m' | values mass | paste -sd ' ' | awk '{ print $2 / $1 }')"
    close 'blocks and boxes' "$(awk 'BEGIN { OFMT = "%.17g"; h = 1; t = 7 / 48; print 600 * (0.3 * t - (h - 0.024) * (0.3 - 0.024) * (t - 0.024)) }')" \
        "$(json 'set density 600; set width 0.3; set walls 12 mm 30 cm; design 1 m; row' | values mass | tail -n 1)" 1e-9
    same 'the session has it' 0.3 "$(json 'set width 0.3; design 1 m; row' | values width | tail -n 1)"
    same 'and as a length' '0.0144 0.3' "$(json 'set width 14.4 mm; design 1 m; row' | values width | sed -n '1p;$p' | paste -sd ' ')"
}
