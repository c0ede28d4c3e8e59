#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Compatibility for programs: 300 commands answer as version 1.0 did.

load common

@test "300 commands answer in json as version 1.0 did: each key, each value, each failure" {
    same commands 300 "$(grep -vc '^#' "$root/tests/compat/session.dom")"
    # Some of these commands are wrong. Messages contain the file name as it was given.
    ! (cd "$root/tests/compat" && "$DOMINO" -n --keep-going -f session.dom) >answers.json 2>errors
    run -0 "$root/tests/compat/compare" "$root/tests/compat/answers.json" answers.json
}

@test "the comparison reports a missing key, value or answer, and accepts new ones" {
    kept=$root/tests/compat/answers.json
    while IFS='|' read -r status edit; do
        sed -E "$edit" "$kept" >edited.json
        run -"$status" "$root/tests/compat/compare" "$kept" edited.json
    done <<'END'
1|s/,"r_max_paper":[^,}]*//
1|s/"ends_by":"barrier"/"ends_by":"fuel"/
1|/"rmax"/s/(\.[0-9]{6})[0-9]/\15/
1|/"best"/d
1|$d
0|s/\}$/,"new":1}/
0|s/(\.[0-9]{14})[0-9]/\10/
END
}
