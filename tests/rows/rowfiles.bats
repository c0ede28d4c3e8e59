#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Rows in files as people write them: names of columns, units, decimal commas.

load ../shell/common

@test "rows from csv: many ways to write the same row" {
    file plain.csv <<'END'
height (m),thickness (m),gap (m),mass (kg)
0.048,0.007,,0.008
0.06,0.009,0.025,0.016
0.08,0.012,0.03,0.04
END
    file units.csv <<'END'
# made by hand
"gap (mm)"; height (cm); mass (g); thickness (mm)

-; 4.8; 8; 7
# a comment
25; 60 mm; 16; 9
30; 8; 40; 12
END
    printf '\xef\xbb\xbfheight (m)\tthickness (m)\tgap (m)\tmass (kg)\r\n0.048\t0.007\t0\t0.008\r\n0.06\t0.009\t0.025\t0.016\r\n0.08\t0.012\t0.03\t0.04' | file crlf.csv
    plain=$("$DOMINO" -e 'set row plain.csv; set push 8; verdict; fall')
    [[ $plain == *'All 3 fall'* ]] || same 'the row' 'All 3 fall' "$plain"
    for name in units crlf; do same "$name" "$plain" "$("$DOMINO" -e "set row $name.csv; set push 8; verdict; fall")"; done
}

@test "rows from csv: an error names the file, the line and the column, and nothing is loaded" {
    while IFS='|' read -r name text pattern; do
        printf '%b' "$text" | file "$name.csv"
        wrong "effect row $name.csv" "$name\\.csv:$pattern"
        same "$name: nothing is loaded" 'there is no row' \
            "$("$DOMINO" --keep-going -e "effect row $name.csv; fall" 2>&1 | grep -o 'there is no row')"
    done <<'END'
hight|hight,thickness,gap\n1,1,1\n|1:1: unknown column 'hight'; did you mean 'height'\?
gap|height (m),thickness (m),gap (m)\n1,0.1,0\n1,0.1,-0.2\n|3:7: gap = -0.2 m is negative
zero|height (m),thickness (m),gap (m)\n0,0.1,0\n|2:1: height = 0
nothing|height (m),thickness (m),gap (m)\n|[0-9]+:[0-9]+: the file has no rows
both|height (m),thickness (m),gap (m),mass (kg),density\n1,.1,0,1,1\n|1:[0-9]+: both mass and density are given; leave
END
    wrong "effect row none.csv" "cannot read '.*none.csv': No such file"
    wrong "effect row $PWD" 'cannot read'
}

@test "a file next to the script is found from any folder; a safe session reads no file" {
    cd / || false
    "$DOMINO" -f "$root/examples/record.dom" | grep -q 'All 10 fall'
    run --separate-stderr "$DOMINO" --safe -e "effect row $root/examples/record.csv"
    [ "$status" -eq 1 ]
    grep -q 'safe session' <<<"$stderr"
}

@test "a length or a mass without a unit is an error that shows what it could mean" {
    while IFS='|' read -r name text pattern; do
        printf '%b' "$text" | file "$name.csv"
        wrong "effect row $name.csv" "$name\\.csv:$pattern"
    done <<'END'
height|height,thickness (mm),gap (mm)\n48,7,-\n|2:1: height has no unit: '48' would mean 48 m; write 'height \(mm\)' in the first line$
mass|height (mm),thickness (mm),gap (mm),mass\n48,7,-,10\n|2:8: mass has no unit: '10' would mean 10 kg; write 'mass \(g\)' in the first line$
density|height (mm);thickness (mm);gap (mm);density\n48;7;-;600\n|2:8: density has no unit: '600' would mean 600 kg/m\^3; write 'density \(g/cm\^3\)' in the first line$
END
    # Units may be in every cell, and 0 needs no unit.
    printf 'domino,height,thickness,gap,relative\n1,48 mm,7 mm,0,1\n2,4.8 cm,0.7 cm,0,2\n3,48 mm,7 mm,2 cm,1' | file cells.csv
    same cells '0.048 0.048 0.048' "$(json 'effect row cells.csv; row' | values height | paste -sd ' ')"
}

@test "names of columns: synonyms in English, German, Dutch and French, and units as spreadsheets write them" {
    printf 'height (mm), thickness (mm), gap (mm), mass (g)\n48, 7.5, -, 10\n50, 7.5, 20, 12\n' >plain.csv
    printf 'Nr;LENGTH [mm];Thick(mm);Spacing [cm];Weight (g);Note\n1;48;7.5;-;10;red\n2;50;7.5;2;12;x, y\n' >synonyms.csv
    printf 'no\tlength_mm\tdepth_mm\tdistance_mm\tweight_g\n1\t48\t7.5\t-\t10\n2\t50\t7.5\t20\t12\n' >tabs.csv
    printf '\xef\xbb\xbfsep=;\r\n"height, mm";"thickness, mm";"gap, mm";"mass, g"\r\n48;7.5;-;10\r\n50;7.5;20;12\r\n' >sheet.csv
    printf '"height, mm","thickness [mm]","gap, cm","mass, g"\n48,7.5,-,10\n50,7.5,2,12\n' >quoted.csv
    printf 'sep=;\nheight cm;thickness mm;gap in mm;mass g\n4,8;7,5;-;10\n5;7,5;2,0 cm;12,0\n' >commas.csv
    printf 'Domino #;Höhe in mm;Dicke mm;Abstand [cm];Masse (g)\n1;48;7,5;–;10\n2;50;7,5;2;12\n' >german.csv
    printf '#\thoogte (mm)\tdikte mm\tafstand_mm\tmassa g\n1\t48\t7,5\t-\t10\n2\t50\t7,5\t20\t12\n' >dutch.csv
    printf '"HAUTEUR\n(mm)","Épaisseur (mm)","Écart (mm)","masse, g"\n48,7.5,-,10\n50,7.5,20,12\n' >french.csv
    for file in synonyms tabs sheet quoted commas german dutch french; do
        same "$file" "$("$DOMINO" -e 'effect row plain.csv; row')" "$("$DOMINO" -e "effect row $file.csv; row" 2>&1)"
    done
}

@test "unknown columns are reported once" {
    printf 'colour, height (mm), thickness (mm), gap (mm), shop\nred, 48, 7.5, -, a\nblue, 50, 7.5, 20, b\n' >more.csv
    run -0 --separate-stderr "$DOMINO" -e 'effect row more.csv; verdict'
    same 'one note' "-e:1: effect: more.csv:1: ignored columns: 'colour', 'shop'; recognized columns: height, thickness, gap (or pitch, or position), and, if known, mass or density, width, radius, lean" "$stderr"
    "$DOMINO" -e 'effect row more.csv; place 2 3 cm; row > saved.csv; effect row saved.csv; row > again.csv'
    same_file saved.csv again.csv
}

@test "a file without names is explained; decimal commas, and empty cells at the end" {
    printf '48, 7.5, 20\n' >nameless.csv
    wrong 'effect row nameless.csv' "the first line has a number, but must name height, thickness, gap "
    printf 'height (mm)\tthickness (mm)\tgap (mm)\n1,234\t0,75\t-\n' >commas.csv
    same 'tabs: decimal commas' 0.001234 "$(json 'effect row commas.csv; row' | values height)"
    printf 'height (mm);thickness (mm);gap (mm)\n48;7;-;;\n50;7;20;;\n' >cells.csv
    same 'empty cells at the end' 0.02 "$(json 'effect row cells.csv; row' | values gap | tail -n 1)"
}

@test "masses in pounds, ounces and tonnes" {
    while IFS='|' read -r unit number kilograms; do
        printf 'height (mm), thickness (mm), gap (mm), weight (%s)\n48, 7.5, -, %s\n' "$unit" "$number" >mass.csv
        close "$unit" "$kilograms" "$(json 'effect row mass.csv; row' | values mass)" 1e-15
    done <<'END'
lb|2|0.90718474
oz|16|0.45359237
t|0.001|1
kg|3|3
END
}

# bats test_tags=pictures,engine
@test "lean: the top of a domino is off plumb" {
    {
        echo 'height (mm), thickness (mm), gap (mm), plumb (mm)'
        printf '48,7,-,0\n72,10.5,28.8,-1\n108,15.75,43.2,2\n162,23.625,64.8,0\n'
    } >lean.csv
    "$DOMINO" -e 'effect row lean.csv; row > again.csv; effect row again.csv; row > third.csv'
    same_file again.csv third.csv
    same leans '0 -0.001 0.002 0' "$(json 'effect row again.csv; row' | values lean | paste -sd ' ' -)"
    sed 's/,-1$/,0/; s/,2$/,0/' lean.csv >plumb.csv
    plumb=$(json 'effect row plumb.csv; verdict' | values spare)
    # Domino 2 leans backwards, so it has to be lifted further.
    within spare "$plumb" "$(json 'effect row lean.csv; verdict' | values spare)" 'o > 0 && d < -0.1'
    same 'one that leans is drawn so' 1 "$(json 'effect row lean.csv; draw' | values theta | awk '$1 < 0' | wc -l)"
    printf 'height (mm), thickness (mm), gap (mm), lean (mm)\n48,7,-,0\n72,10.5,28.8,-12\n' >over.csv
    wrong 'effect row over.csv' "3:14: with its top -1.2 cm off plumb, this domino falls over by itself; the limit is -1.039 cm$"
    sed 's/,-12$/,-10/' over.csv >slope.csv
    wrong 'effect slope -1 deg; effect row slope.csv' '3:14: .*the limit on this slope is -9.145 mm$'
    wrong 'effect row slope.csv; effect slope -1 deg; fall' 'fall: domino 2: .*on this slope is -9.145 mm$'
    wrong 'effect row slope.csv; effect slope 9 deg; fall' 'fall: domino 1 cannot stand upright on a slope of 9 deg; for this thickness'
    # On a slope, a domino may lean further back than on a level floor.
    same 'leans uphill' 'stops' "$(json 'effect slope 2 deg; effect row over.csv; verdict' | values verdict)"
    wrong 'effect row lean.csv; effect edges 0.01; fall' "a domino of this row leans, but the effect 'edges' needs upright dominoes; turn it off, or set all dominoes upright: 'change all lean = 0 mm'"
    wrong 'effect row lean.csv; set method engine; verdict' 'a domino of this row leans, but the rigid-body engine needs upright dominoes; turn it off'
    said=$("$DOMINO" -e 'effect row lean.csv; tolerance details')
    grep -qxF 'The lean of domino 2 has the tightest limits: -1.7 mm to 1.03 cm; it is -1 mm now.' <<<"$said"
}

# bats test_tags=errors
@test "'row > FILE' and then 'set row FILE' give the same row, digit for digit" {
    for scene in 'effect row 7' 'set q hollow; effect row 4; set mass 1; place 3 25 mm >/dev/null' 'set errors on; effect row 3'; do
        "$DOMINO" -e "$scene; row > out.csv; effect row out.csv; row > again.csv"
        same_file out.csv again.csv
        same "$scene: falls alike" "$("$DOMINO" -e "$scene; set errors off; fall")" \
            "$("$DOMINO" -e 'effect row out.csv; fall')"
    done
}

@test "a file that cannot be read changes nothing, and the message lists its columns" {
    printf 'Höhe (mm);b (mm);gap (mm)\n48;7;-\n' >bad.csv
    printf 'height (mm),thickness (mm),gap (mm)\n48,7,-\n50,7,20\n' >good.csv
    wrong 'effect row bad.csv' "the column 'thickness' is missing; .*; found: 'Höhe \(mm\)', 'b \(mm\)', 'gap \(mm\)'$"
    for bad in bad.csv none.csv "$PWD"; do
        for row in 5 good.csv; do
            same "$row stays after $bad" "$("$DOMINO" -e "effect row $row; effect push 3; row; fall")" \
                "$("$DOMINO" --keep-going -e "effect row $row; effect push 3; effect row $bad; row; fall" 2>/dev/null)"
        done
    done
}

@test "a file in Latin-1, and a title above the names of the columns" {
    printf 'H\xf6he (cm),Dicke (cm)\n10,1\n' >latin.csv
    wrong 'set row latin.csv' "latin.csv:1:1: the column 'height' is missing; .*this file is not in UTF-8; save it as 'CSV UTF-8'\); found: 'H"
    printf 'Record attempt\nheight (cm),thickness (cm)\n10,1\n' >title.csv
    wrong 'set row title.csv' "title.csv:1:1: the column 'height' is missing; .*separated by ',', ';' or tabs \(delete a title above it"
    printf 'Record, the hall\nheight (cm),thickness (cm)\n10,1\n' >title.csv
    wrong 'set row title.csv' "title.csv:1:1: the column 'height' is missing; .*delete a title above it, or begin the title with '#'"
}

@test "any file name that exists is one, with ./ or in quotes where it could be something else" {
    local name here=$PWD
    printf 'height (mm),thickness (mm),gap (mm)\n48,7,-\n50,7,20\n' >3d.CSV
    "$DOMINO" -e 'effect row 3d.CSV; row' >plain
    for name in '5.csv' 'a=b' 'a>b.csv' '-x.csv' '(1).csv' 'x"y' './2024-05-01' './s' './rmax' './2.5m' './é'; do
        cp -- 3d.CSV "./$name"
        same_file plain <("$DOMINO" -e "effect row $name; row")
        printf 'effect row %s\nrow\n' "$name" >script.dom
        same_file plain <(cd / && "$DOMINO" "$here/script.dom")
    done
    for name in 'row#1.csv' 'a b.csv' 'a;b.csv' '#1.csv' '> .csv' 'with' 'off' '12'; do
        cp -- 3d.CSV "./$name"
        same_file plain <("$DOMINO" -e "effect row \"$name\"; row")
    done
    same 'a number is the number of dominoes' 12 "$(json 'effect row 12; row' | wc -l)"
    same 'a safe session does not look' "$(cd / && "$DOMINO" --safe -e 'effect row 2.5m' 2>&1)" "$("$DOMINO" --safe -e 'effect row 2.5m' 2>&1)"
}

@test "a pitch or the position of a front face takes the place of the gap" {
    # Own gaps in mm; the pitch is the gap plus the domino's own thickness, and a position is the sum of the pitches.
    cat >gaps <<'END'
48 7.5 0 18
50 8 20 21
55 9 22.5 22
55 7 0 17.25
62 10 31 30
END
    awk 'BEGIN { print "height (mm),thickness (mm),gap (mm),mass (g)" } { print $1 "," $2 "," $3 "," $4 }' gaps >gap.csv
    awk 'BEGIN { print "height (in);thickness (inch);pitch in cm;mass (g)" }
        { printf "%.17g;%.17g;%s;%s\n", $1/25.4, $2/25.4, NR == 1 ? "-" : ($3 + $2)/10, $4 }' gaps >pitch.csv
    awk 'BEGIN { print "Masse (g),Höhe (mm),Dicke (mm),Position (cm)" }
        { at += NR == 1 ? -31.4 : $3 + $2; printf "%s,%s,%s,%.17g\n", $4, $1, $2, at/10 }' gaps >position.csv
    for file in pitch position; do
        while read -r of expected got; do
            close "$file: gap of domino $of" "$expected" "$got" 1e-15
        done < <(paste -d ' ' <(seq 5) <(awk '{ print $3/1000 }' gaps) <(json "set row $file.csv; row" | values gap))
        same "$file" "$("$DOMINO" -e 'set row gap.csv; set push 8; fall')" "$("$DOMINO" -e "set row $file.csv; set push 8; fall")"
    done
    printf 'height (mm),front face (in)\n48,0\n' >front.csv
    wrong 'set row front.csv' "found: 'height \(mm\)', 'front face \(in\)'$"
    # The examples: the last position minus the first, 42.5 in - 13 in, and the sum of the pitches.
    length() { jq -s '[.[1:][] | .gap + .thickness] | add*1000' <<<"$1"; }
    close tape "$(awk 'BEGIN { print 29.5*25.4 }')" "$(length "$(json "set row $root/examples/measured/tape.csv; row")")" 1e-5
    close pitch 245 "$(length "$(json "set row $root/examples/measured/pitch.csv; row")")" 1e-5
    try() { # PATTERN TEXT
        printf '%b' "$2" >wrong.csv
        wrong 'set row wrong.csv' "wrong.csv:$1"
    }
    try '1:48: both gap and pitch are given; leave one of these columns out' 'height (mm), thickness (mm), gap (mm),         pitch (mm)\n48, 7, -, -\n'
    try '1:40: both pitch and position are given' 'height (mm),thickness (mm),pitch (mm), position (mm)\n48, 7, -, 0\n'
    try '4:7: the front face of domino 3 is -0.01 m beyond that of domino 2, but must be at least its thickness, 0.007 m, beyond; list' 'height (mm),thickness (mm),position (mm)\n48,7,0\n48,7,30\n48,7, 20\n'
    try '3:6: the front face of domino 2 is 0.006 m beyond that of domino 1, but must be at least its thickness, 0.007 m, beyond;.* if these are gaps' 'height (mm),thickness (mm),pitch (mm)\n48,7,-\n48,7,6\n'
    try '2:6: domino 1 has no gap, because a gap is measured from the domino before; leave this cell empty, or if your numbers are measured to the next domino, move all one line down$' 'height (mm),thickness (mm),gap (mm)\n48,7,20\n48,7,30\n48,7,-\n'
    try '2:6: domino 1 has no pitch, ' 'height (mm),thickness (mm),pitch (mm)\n48,7,27\n48,7,2.8 cm\n'
    # The same gap in every line can mean only one row.
    printf 'height (mm),thickness (mm),gap (mm)\n48,7,20\n48,7,2 cm\n48,7,20\n' >equal.csv
    same equal '0 0.02 0.02' "$(json 'set row equal.csv; row' | values gap | paste -sd ' ')"
    try '2:6: position is missing' 'height (mm),thickness (mm),position (mm)\n48,7,-\n48,7,6\n'
    try "1:1: the column 'gap' is missing; the first line must name height, thickness, gap \(or pitch, or position\)" 'height (mm),thickness (mm)\n48,7\n'
    try '2:6: position = .* is too large' 'height (mm),thickness (mm),position (m)\n48,7,1e10\n'
}
