#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Full disks and file size limits: there is an error message, and every file is complete, either the old file or the new
# one.

load faults

teardown() { rm -rf "${away:-}"; }

# Runs a command whose output cannot be written. The command must report the failure, and the session must go on.
refused() { # COMMAND FILE
    local said
    said=$(soon "$DOMINO" -n -e "set output csv; $1; print 42" 2>&1) && same "$1: the status" 1 0
    said=${said//$'\n'/|}
    [[ $said == "-e:1: ${1%% *}: cannot write '$2': $full|value,unit|42," ]] ||
        same "$1: what is said" "-e:1: ${1%% *}: cannot write '$2': $full" "$said"
}
export -f refused

replaced() {
    echo old >file
    fill
    refused 'curve 0.1 0.9 900 > file' file
    refused 'save file' file
    refused 'curve 0.1 0.9 900 > new' new
    refused 'curve 0.1 0.9 900 >> new' new
    same 'the file' old "$(cat file)"
    rm -f new # an empty file
    same 'no draft' 'file filler' "$(echo *)"
}
export -f replaced
@test "full disk: '>' and save leave the old file, and no temporary file" { disk replaced; }

appended() {
    # The last block of the file has some room left.
    "$DOMINO" -n -e 'set output csv; curve 0.1 0.9 20 > file'
    cp file before
    fill
    refused 'curve 0.1 0.9 900 >> file' file
    cmp file before
    empty
    "$DOMINO" -n -e 'set output csv; curve 0.1 0.9 20 >> file'
    { cat before && sed 1d before; } | cmp - file # a file has a single header
}
export -f appended
@test "full disk: '>>' leaves the old file" { disk appended; }

@test "full disk: a line that does not fit into the history is reported" {
    full_history() {
        printf 'show s\n' >history
        fill
        BATS_TEST_TMPDIR=$home expect -f "$faults/faults.exp" history_full "$PWD" </dev/null
    }
    export -f full_history
    home=$BATS_TEST_TMPDIR faults=$BATS_TEST_DIRNAME
    export home faults
    disk full_history
}

@test "exceeding the file size limit is an error like any other" {
    enter
    export full='File too large'
    "$DOMINO" -n -e 'set output csv; curve 0.1 0.9 20 > file'
    echo old >old && ln old other
    cp file before
    ulimit -f 3
    refused 'curve 0.1 0.9 900 > new' new
    refused 'curve 0.1 0.9 900 > old' old
    refused 'curve 0.1 0.9 900 >> file' file
    cmp file before
    same 'the file of two names' old "$(cat other)"
    same 'nothing else' 'before file old other' "$(inside)"
    run -1 --separate-stderr soon "$DOMINO" -n -e 'plot energy > x.svg'
    [[ $stderr =~ (gnuplot did not draw it|cannot draw: File too large) ]] || same 'plot' 'an error' "$stderr"
    same 'no picture' 'before file old other' "$(inside)"
    # Standard output has the same limit.
    run -1 --separate-stderr bash -c '"$DOMINO" -n -e "set output csv; curve 0.1 0.9 900" >out'
    same 'standard output' 'domino: cannot write the output: File too large' "$stderr"
}
