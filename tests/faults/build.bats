#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The build is hardened, and gives the same bytes in every folder.

load faults

build=$(dirname "$DOMINO")
root=$BATS_TEST_DIRNAME/../..

@test "a build in another folder gives the same program and library, and both are hardened" {
    local other='the other folder/below'
    cd "$BATS_TEST_TMPDIR"
    mkdir -p "$other"
    cp -r "$root/Makefile" "$root/src" "$root/include" "$root/man" "$root/examples" "$other"
    (cd "$other" && env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u MAKEOVERRIDES -u B timeout -k 1 300 make -s "-j$(nproc)" all)
    for file in domino libdomino.a; do cmp "$build/$file" "$other/.build/$file"; done
    if grep -aqF "$BATS_TEST_TMPDIR" "$other/.build/domino"; then same 'the folder' 'not in the program' 'in there'; fi
    # Tables of addresses are read-only once they are filled, and there is a stack protector.
    readelf -lW "$build/domino" | grep -q GNU_RELRO
    for name in __stack_chk_fail __printf_chk; do nm -D "$build/domino" | grep -qw "$name"; done
    nm "$build/libdomino.a" | grep -qw __stack_chk_fail
}
