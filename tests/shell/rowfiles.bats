#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Rows in files as people have them: names of columns, units, decimal commas; and gaps without a unit.
# shellcheck disable=SC2154 # 'run' sets what it looks at

load common

setup() { answers_at_all && cd "$BATS_TEST_TMPDIR" || false; }

@test "names of columns: synonyms in any case, with units in brackets of either kind" {
    printf 'height (mm), thickness (mm), gap (mm), mass (g)\n48, 7.5, -, 10\n50, 7.5, 20, 12\n' >plain.csv
    printf 'Nr;LENGTH [mm];Thick(mm);Spacing [cm];Weight (g);Note\n1;48;7.5;-;10;red\n2;50;7.5;2;12;x, y\n' >synonyms.csv
    printf 'no\tlength_mm\tdepth_mm\tdistance_mm\tweight_g\n1\t48\t7.5\t-\t10\n2\t50\t7.5\t20\t12\n' >tabs.csv
    printf '\xef\xbb\xbfsep=;\r\n"height, mm";"thickness, mm";"gap, mm";"mass, g"\r\n48;7.5;-;10\r\n50;7.5;20;12\r\n' >sheet.csv
    printf '"height, mm","thickness [mm]","gap, cm","mass, g"\n48,7.5,-,10\n50,7.5,2,12\n' >quoted.csv
    printf 'sep=;\nheight;thickness;gap;mass\ncm;mm;mm;g\n4,8;7,5;-;10\n5;7,5;2,0 cm;12,0\n' >commas.csv
    for file in synonyms tabs sheet quoted commas; do
        same "$file" "$("$DOMINO" -e 'effect row plain.csv; row')" "$("$DOMINO" -e "effect row $file.csv; row" 2>&1)"
    done
}

@test "other columns are named once, and written back with the row; a wrong spelling is an error" {
    printf 'colour, height (mm), thickness (mm), gap (mm), shop\nred, 48, 7.5, -, a\nblue, 50, 7.5, 20, b\n' >more.csv
    run -0 --separate-stderr "$DOMINO" -e 'effect row more.csv; verdict'
    same 'one note' "-e:1: effect: more.csv:1: not used: the columns 'colour', 'shop'; those that are: height, thickness, gap, and, if known, mass or density, width, radius, lean" "$stderr"
    printf 'height (mm);thickness (mm);gap (mm);"a;b";note\r\n48,5;7;-;red;"1 "" wide\nor # 2"\r\n50;7;20\r\n' >more.csv
    "$DOMINO" -e 'effect row more.csv; place 2 3 cm; row > saved.csv; effect row saved.csv; row > again.csv'
    same_file saved.csv again.csv
    printf '%s\n' 'domino,height (m),thickness (m),gap (m),relative,"a;b",note' '1,0.0485,0.007,0,1,red,"1 "" wide' 'or # 2"' >expected.csv
    same_file expected.csv <(head -n 3 saved.csv)
    same 'the second row' '0.03,1.0628122010840684,,' "$(sed -n 4p saved.csv | cut -d , -f 4-)"
    same 'rows of another scene' '(nothing)' "$("$DOMINO" -e 'effect row more.csv; effect row 2; row > other.csv' 2>/dev/null; grep red other.csv)"
    printf 'height (mm), thickness (mm), gap (mm), mas (g)\n48, 7.5, -, 10\n' >typo.csv
    wrong 'effect row typo.csv' "typo.csv:1:40: unknown column 'mas'; did you mean 'mass'\?"
    printf 'height (mm), length (mm), thickness (mm), gap (mm)\n48, 50, 7.5, -\n' >twice.csv
    wrong 'effect row twice.csv' "'length' is the height, as column 1 is; name one of them otherwise"
}

@test "numbers without units, without names, and with decimal commas are explained" {
    printf 'height, thickness, gap\n48, 7.5, -\n' >bare.csv
    wrong 'effect row bare.csv' "'48' would be 48 m; write 'height \(mm\)' in the first line, or '48 mm' in the cell"
    printf '48, 7.5, 20\n' >nameless.csv
    wrong 'effect row nameless.csv' "the first line has a number, but it names the columns: write 'height \(mm\), "
    printf 'height (mm),thickness (mm),gap (mm)\n48,0,7,5,-\n' >commas.csv
    wrong 'effect row commas.csv' "commas.csv:2:8: too many cells: 5, .*'48,0' is read as the cells 48 and 0: if it is one number, write 48\.0"
    printf 'height (mm)\tthickness (mm)\tgap (mm)\n1,234\t75\t-\n' >thousands.csv
    wrong 'effect row thousands.csv' "thousands.csv:2:1: '1,234' can be read as 1\.234 or as 1234; write 1\.2340 or 1234"
    printf 'LC_NUMERIC\ndecimal_point ","\nthousands_sep ""\ngrouping -1\nEND LC_NUMERIC\n' >comma.src
    if localedef -c -i comma.src -f UTF-8 ./comma >/dev/null 2>&1 || [ -d comma ]; then
        same 'with decimal commas' 0.001234 "$(LOCPATH=$PWD LC_ALL=comma json 'effect row thousands.csv; row' | values height)"
    fi
    printf 'height (mm);thickness (mm);gap (mm)\n48;7;-;;\n50;7;20;;\n' >cells.csv
    same 'empty cells at the end' 0.02 "$(json 'effect row cells.csv; row' | values gap | tail -n 1)"
    # As many cells as can be read in the first line, and a row with more of them.
    { printf 'height (mm),thickness (mm),gap (mm)%s\n' "$(printf ',x%s' {4..64})" && printf '48,7,-%s,é\n' "$(printf ',%s' {4..64})"; } >most.csv
    wrong 'effect row most.csv' 'most.csv:2:185: too many cells: 65, but the first line has 64'
}

@test "place: a gap without a unit that no domino reaches is an error; with a unit it is a gap" {
    wrong 'effect row 3; place 2 3' "3 without a unit would be 3 m, but domino 1 is 4\.8 cm tall; write 'place 2 3 mm'"
    wrong 'effect row 3; place 9 3' 'there is no gap before domino 9'
    same metres 0.03 "$(json 'effect row 3; place 2 0.03; row' | values gap | sed -n 2p)"
    same unit 3 "$(json 'effect row 3; place 2 3 m; row' | values gap | sed -n 2p)"
    "$DOMINO" -e 'effect row 3; place 2 3 m; place 3 0.03; save scene.dom; row > saved.csv'
    "$DOMINO" -e 'source scene.dom; row > read.csv; effect row saved.csv; row > again.csv'
    same_file saved.csv read.csv
    same_file saved.csv again.csv
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
    printf 'height (mm), thickness (mm), gap (yd), mass\n48, 7.5, -, 10 g\n50, 7.5, 0.02, 1 oz\n' >cells.csv
    close 'in the cell' 0.01 "$(json 'effect row cells.csv; row' | values mass | head -n 1)" 1e-15
    close 'each in its own' 0.028349523125 "$(json 'effect row cells.csv; row' | values mass | tail -n 1)" 1e-15
    close 'a gap in yards' 0.018288 "$(json 'effect row cells.csv; row' | values gap | tail -n 1)" 1e-15
    printf 'height (mm), thickness (mm), gap (mm), mass\n48, 7.5, -, 10 mm\n' >length.csv
    wrong 'effect row length.csv' "mass: this is a length; write a number in the unit of the first line, as in 'mass \(g\)'"
    printf 'height (mm), thickness (mm), gap (oz)\n48, 7.5, -\n' >gap.csv
    wrong 'effect row gap.csv' "is not a unit of gap; its units are: m, mm, cm"
}

@test "lean: how far the top of a domino is off plumb" {
    {
        echo 'height (mm), thickness (mm), gap (mm), plumb (mm)'
        printf '48,7,-,0\n72,10.5,28.8,-1\n108,15.75,43.2,2\n162,23.625,64.8,0\n'
    } >lean.csv
    "$DOMINO" -e 'effect row lean.csv; row > again.csv; effect row again.csv; row > third.csv'
    same_file again.csv third.csv
    same leans '0 -0.001 0.002 0' "$(json 'effect row again.csv; row' | values lean | paste -sd ' ' -)"
    sed 's/,-1$/,0/; s/,2$/,0/' lean.csv >plumb.csv
    plumb=$(json 'effect row plumb.csv; verdict' | values spare)
    # Its top is off against the fall: domino 2 has to be lifted further.
    within spare "$plumb" "$(json 'effect row lean.csv; verdict' | values spare)" 'o > 0 && d < -0.1'
    same 'one that leans is drawn so' 1 "$(json 'effect row lean.csv; draw' | values theta | awk '$1 < 0' | wc -l)"
    printf 'height (mm), thickness (mm), gap (mm), lean (mm)\n48,7,-,0\n72,10.5,28.8,-12\n' >over.csv
    wrong 'effect row over.csv' "3:14: with its top -1.2 cm off plumb this domino falls over by itself; the most this domino can lean is -1.039 cm$"
    sed 's/,-12$/,-10/' over.csv >slope.csv
    wrong 'effect slope -1 deg; effect row slope.csv' '3:14: .*the most this domino can lean on this slope is -9.145 mm$'
    wrong 'effect row slope.csv; effect slope -1 deg; fall' 'fall: domino 2: .*on this slope is -9.145 mm$'
    wrong 'effect row slope.csv; effect slope 9 deg; fall' 'fall: domino 1 cannot stand upright on a slope of 9 deg; for its thickness'
    # Uphill it may lean further back than on a level floor.
    same 'leans uphill' 'stops' "$(json 'effect slope 2 deg; effect row over.csv; verdict' | values verdict)"
    wrong 'effect row lean.csv; effect edges 0.01; fall' "dominoes of this row lean.*enter 'effect edges off', or a row whose file has no column lean"
    wrong 'effect row lean.csv; set method engine; verdict' 'dominoes of this row lean, and a rigid-body engine runs the row, since method is engine; turn that off'
    said=$("$DOMINO" -e 'effect row lean.csv; tolerance')
    grep -qxF 'The top of domino 2 may be off by 1.7 mm backwards to 1.03 cm forwards, the least room of all; it is off by 1 mm backwards now.' <<<"$said"
    sed 's/,-1$/,-3/' lean.csv >stops.csv
    said=$("$DOMINO" -e 'effect row stops.csv; tolerance')
    grep -qxF 'With the top of domino 2 off by 1.7 mm backwards to 1.03 cm forwards all would fall; it is off by 3 mm backwards now.' <<<"$said"
}

@test "s and d as lengths are divided by h" {
    same 's' "$(json 'set s 0.5; set d 7/48; duration')" "$(json 'set s 2.4 cm; set d 7 mm; duration')"
    same 'of another h' 0.25 "$(json 'set h 8 cm; set s 2 cm; show s' | values value)"
    same 'as an argument' "$(json 'rmax 0.5')" "$(json 'rmax 24 mm')"
    same 'in a grid' "$(json 'sweep s 0.25, 0.5 : rmax')" "$(json 'sweep s 12 mm, 24 mm : rmax')"
    wrong 'set s 2 ms' 's is a plain number, not a time'
    wrong 'set r 2 cm' 'r is a plain number, not a length'
}
