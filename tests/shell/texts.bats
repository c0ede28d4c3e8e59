#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The README, and the equations that texts cite.

load common

root=$BATS_TEST_DIRNAME/../..

@test "the README is read to its end: at most 180 lines, and its picture is there, and small" {
    [ "$(wc -l <"$root/README.md")" -le 180 ]
    pictures=$(grep -oE '\(examples/pictures/[^)]*\)' "$root/README.md" | tr -d '()')
    expects pictures "$pictures"
    for picture in $pictures; do
        [ "$(wc -c <"$root/$picture")" -lt 300000 ]
        same "$picture" GIF89a "$(head -c 6 "$root/$picture")"
    done
    # Links lead to files.
    for link in $(grep -oE '\]\([a-z][^:)]*\)' "$root/README.md" | tr -d ']()'); do
        [ -e "$root/$link" ] || { echo "$link"; false; }
    done
}

@test "each equation is cited with the number that the paper prints, and the table lists the files" {
    same equations '(nothing)' "$("$root/tests/equations")"
}
