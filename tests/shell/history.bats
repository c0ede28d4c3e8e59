#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The history of the prompt: where it is stored, and what it contains.

load common

@test "history: no history in a device or a FIFO" { prompt history_other; }
@test "history: a long file, and a link" { prompt history_long; }
@test "history: four sessions that end at once" { prompt history_many 4 5; }

@test "history: it is kept from session to session, with mode 0600, and without immediate repetitions" { prompt history_sessions; }
@test "history: DOMINO_HISTORY names the file; without it and XDG_STATE_HOME it is in the home folder" { prompt history_override; }
@test "history: it survives a signal and a lost terminal" { prompt history_signal; }
@test "history: not used in pipes" {
    export XDG_STATE_HOME=$BATS_TEST_TMPDIR/state
    export HOME=$BATS_TEST_TMPDIR DOMINO_HISTORY=$BATS_TEST_TMPDIR/own
    for way in -e stdin -f; do
        run --separate-stderr session "$way" 'print s'
        [ "$status" -eq 0 ]
        same "$way" 0.4 "$output"
    done
    [ ! -e "$XDG_STATE_HOME" ]
    [ ! -e "$DOMINO_HISTORY" ]
}
