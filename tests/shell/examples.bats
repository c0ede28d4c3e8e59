#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The examples. Three of them are compared with golden transcripts, which 'GOLDEN=write make sessions' writes again.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell
# bats file_tags=whole

load common

golden() {
    cd "$BATS_TEST_TMPDIR" || return # for the files that an example writes
    "$DOMINO" "$root/examples/$1.dom" >"$BATS_TEST_TMPDIR/out"
    if [ "${GOLDEN:-}" = write ]; then cp "$BATS_TEST_TMPDIR/out" "$BATS_TEST_DIRNAME/golden/$1.out"; fi
    same_file "$BATS_TEST_DIRNAME/golden/$1.out" "$BATS_TEST_TMPDIR/out"
}

@test "quiz.dom" { golden quiz; }

@test "one-cycle.dom" { golden one-cycle; }

@test "record.dom" { golden record; }

@test "every other example runs to its end, without a message" {
    local example
    cd "$BATS_TEST_TMPDIR" || return
    # The atlas takes a quarter of a minute, so prove.bats compares a part of it with its table, and the pictures are
    # compared in animate.bats. The tutorial is in help.bats.
    for example in "$root"/examples/*.dom; do
        case ${example##*/} in atlas.dom | pictures.dom | quiz.dom | one-cycle.dom | record.dom | tutorial.dom) continue ;; esac
        run -0 --separate-stderr "$DOMINO" --bail "$example"
        same "$example" '(nothing)' "$stderr"
        [ "${#lines[@]}" -gt 5 ] || same "$example" answers "$output"
    done
}
