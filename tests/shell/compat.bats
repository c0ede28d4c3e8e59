#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Compatibility for programs: 100 commands answer as version 2.0 did.
# bats file_tags=whole

load common

@test "100 commands answer in json as version 2.0 did: each key, each value, each failure" {
    same commands 100 "$(grep -vc '^#' "$root/tests/compat/session.dom")"
    # Some of these commands are wrong. Messages contain the file name as it was given.
    ! (cd "$root/tests/compat" && "$DOMINO" -n --keep-going -f session.dom) >answers.json 2>errors
    run -0 "$root/tests/compat/compare" "$root/tests/compat/answers.json" answers.json
}
