#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The examples. One of them is compared with a golden transcript, which 'GOLDEN=write make sessions' writes again.
# bats file_tags=whole

load common

@test "quiz.dom" {
    "$DOMINO" "$root/examples/quiz.dom" >out
    if [ "${GOLDEN:-}" = write ]; then cp out "$BATS_TEST_DIRNAME/golden/quiz.out"; fi
    same_file "$BATS_TEST_DIRNAME/golden/quiz.out" out
}

@test "every other example runs to its end, without a message" {
    local example
    cd "$BATS_TEST_TMPDIR" || return
    # The atlas takes a quarter of a minute, so prove.bats compares a part of it with its table, and the pictures are
    # compared in animate.bats. The tutorial is in help.bats.
    for example in "$root"/examples/*.dom; do
        case ${example##*/} in atlas.dom | pictures.dom | quiz.dom | tutorial.dom) continue ;; esac
        run -0 --separate-stderr "$DOMINO" --bail "$example"
        same "$example" '(nothing)' "$stderr"
        [ "${#lines[@]}" -gt 5 ] || same "$example" answers "$output"
    done
}
