#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# bats file_tags=whole
# Air: which commands answer with it, and why the others do not. tests/unit/test_air.c has the numbers.

load ../shell/common

less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a > 0 && a < b) }'; }

@test "air: a parameter like the others, and a drag coefficient" {
    local airy='set density 650; set air 1.2 kg/m^3'
    same 'on' 1.2 "$(json 'set density 650; set air on; show air' | values value)"
    wrong 'set air 1 kg' 'density|kg/m'
    wrong 'set air -1' 'RHO = -1 is out of range'
    wrong 'set drag 2' "'set drag' needs the effect air"
    wrong 'set air 1.2; set drag 1; set air off' "needs the air"
    same 'usual coefficient' "$(json "$airy; rmax" | values r_max)" "$(json "$airy; set drag 1.2; rmax" | values r_max)"
    less "$(json "$airy; set drag 2; rmax" | values r_max)" "$(json "$airy; rmax" | values r_max)"
    same 'sweep' 3 "$(json 'set density 650; sweep air 0, 1, 2 : rmax' | values r_max | sort -r | uniq | wc -l)"
    same 'air of density 0' "$(json 'rmax; set row 20; fall; placement 20 with placement 1 mm')" \
        "$(json 'set air 0; rmax; set row 20; fall; placement 20 with placement 1 mm')"
}

@test "air: endless trains of solid dominoes, and why no others" {
    local airy='set density 650; set air 1.2'
    wrong 'set air 1.2; rmax' "needs the mass of the dominoes; first enter, for example, 'set density 650 kg/m"
    wrong 'set air 1.2; set row 5; fall' 'needs the mass of the dominoes'
    for ask in 'rmax 0.4' best duration pair barrier step cycle why 'explain launch' 'count 8'; do
        wrong "$airy; set q hollow; $ask" "self-similar; enter 'set q solid', or ask about a row, as in 'set row 12; fall'$"
        json "$airy; $ask" >out
        [ -s out ]
    done
    wrong "$airy; set q hollow; set row 5; slip" "self-similar; about the row: 'set floor 0.4; fall'$"
    wrong "$airy; set fuel paper" "'fuel paper' cannot be combined with air"
    same 'no proof' 'not proved: there is no proof for trains with effects that change their motion' "$(json "$airy; prove rmax" | values reason)"
    # The growth of a solid train is the same at any size, and smaller for lighter wood.
    close 'any size' 1 "$(json "$airy; rmax; set h 8 m; rmax" | values r_max | paste -sd ' ' | awk '{ print $2 / $1 }')"
    less "$(json "$airy; set density 50; rmax" | values r_max)" "$(json "$airy; rmax" | values r_max)"
    same 'a mass is as good' "$(json "$airy; rmax" | values r_max)" \
        "$(json "set density 650; set row 1; row" | values mass | { read -r m; json "set mass $m; set air 1.2; rmax" | values r_max; })"
    [[ $("$DOMINO" -e "$airy; set friction 0.2; why") == *'in spite of friction and the drag of the air'* ]]
    "$DOMINO" -e "$airy; explain launch" | grep -qxF '    k I = rho C w h^4/8, the torque of the drag over omega^2'
    "$DOMINO" -e 'help air' | grep -qF "B = sum r^(-(q+1) i) S_i (theta_i'' + k theta_i'^2)"
}

@test "air: rows, and giants that feel it" {
    # Boxes of 8 m, 20 mm boards, 1.17 m thick: about 1,200 kg each.
    local giants='set h 8 m; set d 1.17 m; set width 4 m; set walls 20 mm; set density 650; set r 1; set row 12; set push 1'
    same 'mass' 1 "$(json "$giants; row" | values mass | awk 'NR == 1 { print ($1 > 1100 && $1 < 1300) }')"
    less "$(json "$giants; fall" | values hit | tail -n 1)" "$(json "$giants; set air 1.2; fall" | values hit | tail -n 1)"
    less "$(json "$giants; set air 1.2; set q hollow; rowmax" | values r_max)" "$(json "$giants; set q hollow; rowmax" | values r_max)"
    same 'without a train' null "$(json "$giants; set air 1.2; set q hollow; rowmax" | values r_train)"
    # A row from a file has the masses and widths of the file.
    printf 'height (mm), thickness (mm), gap (mm), mass (g), width (mm)\n48, 7, -, 1, 24\n72, 10, 20, 2, 36\n100, 15, 30, 3, 50\n' >light.csv
    less "$(json 'set row light.csv; set push 6; fall' | values hit | tail -n 1)" \
        "$(json 'set row light.csv; set push 6; set air 1.2; fall' | values hit | tail -n 1)"
    same 'wider dominoes have more drag' 1 "$(json 'set row light.csv; set push 6; set air 1.2; fall; change 1-3 width +100 %; fall' |
        values hit | awk '{ t[NR] = $1 } END { print (t[6] > t[3]) }')"
    wrong 'set density 650; set air 1.2; set row 5; set method engine; fall' "does not include air; first enter 'set air off'"
    json 'set density 650; set air 1.2; design 2 m; verdict' >out
    same 'a design falls' 'all fall' "$(values verdict <out | tail -n 1)"
}
