# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Functions that the fault suites share: a folder for each test, time limits, and full disks.

load ../shell/common

# Enters a folder that is removed after the test.
enter() { mkdir -p "$BATS_TEST_TMPDIR/in" && cd "$BATS_TEST_TMPDIR/in" || exit; }

# Runs a program with a time limit. The status is 124 if the program did not end by itself.
soon() { timeout -k 1 60 "$@"; }
export -f soon

prompt() { soon expect -f "$BATS_TEST_DIRNAME/faults.exp" "$@" </dev/null; }

inside() { find . -mindepth 1 | LC_ALL=C sort | sed 's|^\./||' | paste -sd ' ' -; }

# Checks that the program ended by itself, and not by a signal or by the time limit.
no_crash() { # WHAT STATUS
    [ "$2" -le 1 ] || same "$1: it ends by itself" '0 or 1' "$2"
}

# Runs a bash script on a separate disk of 64 kB, which is unmounted when the script ends. In the script, 'fill' fills
# all blocks, and 'empty' frees them. If mounting is not allowed, 'fill' sets a limit of file size instead. $full is the
# error message that is expected then.
disk() { # SCRIPT
    local own=() mounts=$BATS_TEST_TMPDIR/disk
    mkdir -p "$mounts"
    if [ "$(id -u)" -ne 0 ]; then own=(--map-root-user); fi
    # shellcheck disable=SC2016 # the inner shell expands it
    if unshare --mount "${own[@]}" mount -t tmpfs tmpfs "$mounts" 2>/dev/null; then
        full='No space left on device' timeout -k 1 120 unshare --mount "${own[@]}" bash -eu -c '
            mount -t tmpfs -o size=64k,mode=700 tmpfs "$1" && cd "$1"
            fill() { head -c 1M /dev/zero >filler 2>/dev/null || :; }
            empty() { rm filler; }
            eval "$2"' bash "$mounts" "$1"
    else
        full='File too large' timeout -k 1 120 bash -eu -c '
            cd "$1"
            fill() { >filler; ulimit -Sf 0; }
            empty() { rm filler; ulimit -Sf unlimited; }
            eval "$2"' bash "$mounts" "$1"
    fi
}
export -f expects same same_file close
