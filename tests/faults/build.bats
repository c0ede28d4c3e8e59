#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The build is hardened, and gives the same bytes in every folder.
# shellcheck disable=SC2154

load faults

root=$BATS_TEST_DIRNAME/../..

@test "builds in two folders give the same hardened program and library" {
    local folder
    for folder in one 'the other folder/below'; do
        mkdir -p "$BATS_TEST_TMPDIR/$folder"
        cp -r "$root/Makefile" "$root/src" "$root/include" "$root/man" "$root/examples" "$BATS_TEST_TMPDIR/$folder"
        (cd "$BATS_TEST_TMPDIR/$folder" &&
            env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u MAKEOVERRIDES -u B -u CFLAGS -u LDFLAGS -u CC \
                timeout -k 1 300 make -s "-j$(nproc)" all)
    done
    cd "$BATS_TEST_TMPDIR"
    for file in domino libdomino.a; do
        cmp "one/.build/$file" "the other folder/below/.build/$file"
    done
    if grep -aqF "$BATS_TEST_TMPDIR" one/.build/domino; then same 'the folder' 'not in the program' 'in there'; fi
    # All addresses are bound before main, in memory that is then read-only, and there is a stack protector.
    readelf -d one/.build/domino | grep -q BIND_NOW
    readelf -lW one/.build/domino | grep -q GNU_RELRO
    for name in __stack_chk_fail __printf_chk; do nm -D one/.build/domino | grep -qw "$name"; done
    nm one/.build/libdomino.a | grep -qw __stack_chk_fail
}
