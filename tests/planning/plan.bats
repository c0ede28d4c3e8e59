#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Plan: the guide for building a row, in text, on paper and as data.

load ../shell/common

scene="effect row $root/examples/record.csv; effect push 3; effect friction 0.3; place 8 75 cm > /dev/null; effect placement 5 mm"

# bats test_tags=sweeps
@test "plan: the numbers agree with row, tolerance and placement" {
    "$DOMINO" -e "$scene; plan > plan.csv; row > row.csv; tolerance > windows.csv; placement 2000 > study.csv; plan > text.txt"
    python3 - <<'END'
import csv
plan, windows, study = (list(csv.DictReader(open(f"{name}.csv"))) for name in ("plan", "windows", "study"))
row = list(csv.reader(open("row.csv")))
text = " ".join(open("text.txt").read().split())
assert len(plan) == len(windows) == len(row) - 1 == 10
back = 0
for p, w, r in zip(plan, windows, row[1:]):
    height, thickness, gap, mass = (float(x) for x in r[1:5])
    back += gap
    assert abs(float(p["back"]) - back) < 1e-12 and abs(float(p["front"]) - back - thickness) < 1e-12
    assert (float(p["height"]), float(p["thickness"]), float(p["gap"]), float(p["mass"])) == (height, thickness, gap, mass)
    assert float(p["width"]) == height / 2
    for ours, theirs in (("back_low", "from"), ("back_high", "to"), ("height_low",) * 2, ("height_high",) * 2,
                         ("thickness_low",) * 2, ("thickness_high",) * 2):
        assert p[ours] == w[theirs], (p, w)
    back += thickness
assert f"{study[0]['fall']} of {study[0]['rows']} rows fall" in text
assert "With errors (gap 5 mm)" in text and "its top moves at 0.72 m/s" in text
END
    # Lower limits are rounded up and upper limits down. The three dimensions with the tightest limits
    # are marked.
    grep -qF '     2   165.0!  147.2!  207.8!  215.0   130.0' text.txt
    grep -qF '     8  2900.0! 1873.6!  2991.3!     420.0! 105.1!  427.4! 1450.0   440' text.txt
    [ "$(grep -c '!' text.txt)" -eq 3 ]
}

@test "plan: boards for solid blocks, for boxes, and for boxes with unknown walls" {
    board() { "$DOMINO" -e "$1; effect row 3; plan details" | sed -n '/^board/,/^$/p' | sed -n 2,4p | tr -s ' ' | paste -sd ';' -; }
    same solid ' 7.0 1 1 48.0 24.0; 10.5 2 1 72.0 36.0; 15.8 3 1 108.0 54.0' "$(board 'set r 1.5' | sed 's/ ;/;/g; s/ $//')"
    same box ' 1.0 1 2 48.0 5.0; 1 2 48.0 24.0; 1 2 22.0 5.0' "$(board 'effect walls 1 mm' | sed 's/ ;/;/g; s/ $//')"
    same 'blocks and boxes' ' 1.0 3 2 108.0 13.8; 3 2 108.0 54.0; 3 2 52.0 13.8' "$(board 'set r 1.5; effect walls 1 mm 9 cm' | sed 's/ ;/;/g; s/ $//')"
}

@test "plan: A4 pages for forty dominoes and for a single domino; a row that does not fall is an error" {
    "$DOMINO" -e "set h 4 cm; set r 1.12; effect row 40; plan title \"Forty 'long' rows\" > forty.pdf; plan > forty.svg
        plan > forty.gp; effect row 1; plan > one.svg"
    same A4 '/MediaBox [ 0 0 595' "$(tr '\0' '\n' <forty.pdf | grep -aoE '/MediaBox \[ 0 0 59[0-9]' | head -n 1)"
    pages=$(grep -c "^set label 'Forty.*page [0-9]" forty.gp || :)
    same 'the script has no title' 0 "$pages"
    for page in 2 3; do grep -q "^set label 'page $page'" forty.gp; done
    # The notes above the tables are broken into lines that fit on the page.
    grep -q "^set label 'moved, and its back stays between '" forty.gp
    same 'too long for the page' 0 "$(sed -n "s/^set label '\(.*\)' at screen.*/\1/p" forty.gp | sed "s/'\.\"[^\"]*\"\.'/'/g" | awk 'length > 79' | wc -l)"
    xmllint --noout forty.svg one.svg
    for text in ' 40  *332[0-9][.][0-9] ' 'For the hall' '>page'; do
        if [ "$text" = '>page' ]; then run ! grep -q "$text" forty.svg; else grep -q "$text" forty.svg; fi
    done
    wrong 'effect row 5; effect friction 3; plan' "the fall ends at domino 2, so there is nothing to build yet; 'mend' looks for"
    wrong 'effect row 3; plan foo' "write a title as in 'plan title"
}

# bats test_tags=save
@test "plan: widths come from the file, and a domino keeps its width when its height changes" {
    printf 'height (mm),thickness (mm),gap (mm),mass (g),width (mm)\n50,10,0,100,20\n60,10,20,110,33\n' > widths.csv
    widths() { "$DOMINO" -e "$1; plan > widths.out.csv" > /dev/null; cut -d, -f13 widths.out.csv | tail -n +2 | paste -sd ' ' -; }
    same file '0.02 0.033' "$(widths 'effect row widths.csv')"
    same 'saved and read again' '0.02 0.033' "$(widths 'effect row widths.csv; row > again.csv; effect row again.csv')"
    same changed '0.024 0.036 0.054' "$(widths 'effect row 3; change 2 height 80 mm')"
    same 'width changed' '0.024 0.04 0.0594' "$(widths 'effect row 3; change 2 width 4 cm; change 3 width +10 %')"
    same 'width changed, saved as a script' '0.024 0.04 0.0594' "$(widths 'effect row 3; change 2 width 4 cm; change 3 width +10 %; save s.dom; effect row off; source s.dom')"
    same 'mass of a wider domino' 'relative,1,1,2' "$("$DOMINO" -e 'set r 1; effect row 3; set output csv; change 3 width 48 mm; row' | cut -d, -f5 | paste -sd,)"
}

@test "plan: 'improve sizes' keeps the proportions of each domino, including its width" {
    proportions() { "$DOMINO" -e "$1; effect placement 5 mm; improve sizes; plan > p.csv" > /dev/null; awk -F, 'NR > 1 { printf "%.6g ", $13 / $7 }' p.csv; }
    same 'from the parameters' '0.5 0.5 0.5 0.5 ' "$(proportions 'effect row 4')"
    same 'a changed width' '0.5 0.416667 0.5 0.5 ' "$(proportions 'effect row 4; change 2 width 30 mm')"
}

# bats test_tags=chance
@test "plan: the guide gives the errors in leans in degrees" {
    run -0 "$DOMINO" -e 'set r 1.2; set row 3; set error_lean 0.3 deg; set error_slope 0.5 deg; plan > errors.txt'
    [[ $(paste -sd ' ' errors.txt) == *'(lean 0.3 deg, slope 0.5 deg)'* ]]
}

@test "plan: a guide for dominoes that lean says how far their tops are off plumb" {
    leans='set r 1.2; effect row 3; change 2 lean -2 mm; change 3 lean 1 mm'
    same csv 'lean 0 -0.002 0.001' "$("$DOMINO" -e "set output csv; $leans; plan" | tail -n 4 | cut -d, -f14 | paste -sd ' ' -)"
    "$DOMINO" -e "$leans; plan > lean.txt; plan > lean.svg"
    same text 'lean 0.0 -2.0 1.0' "$(sed -n '/^domino.*lean/,/^$/p' lean.txt | awk 'NF { print $NF }' | paste -sd ' ' -)"
    grep -q ' -2\.0 *<' lean.svg
    run ! grep -q lean <<<"$("$DOMINO" -e 'effect row 3; plan details')"
}

@test "plan: a table that fits on a page is not broken" {
    "$DOMINO" -e 'effect row 10; effect placement 2 mm; plan title "The hall" > p.gp; plan > p.txt'
    # Page 2 begins with the table of boards. Pages end with 'reset'.
    sed '/^reset/,$d' p.gp >first
    for words in "'For the hall" "'For the workshop: the sizes" "'  *10  *[0-9.]*  *1845.3" '(! in'; do
        grep -q -- "$words" first || same 'page 1' "$words" "$(cat first)"
    done
    same 'page 2' 1 "$(sed '1,/^reset/d' p.gp | grep -c "'For the workshop: boards")"
    tr -s ' \n' ' ' <p.txt | grep -qF 'What matters most (! in the tables): the place of domino 2'
}
