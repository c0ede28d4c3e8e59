#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The history of the prompt: where it is, and what it keeps.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

@test "history: a device keeps its mode, and nothing is said" {
    prompt history_device /dev/null
    ln -s /dev/null "$BATS_TEST_TMPDIR/link"
    prompt history_device "$BATS_TEST_TMPDIR/link"
}

@test "history: a link's target keeps its mode" { prompt history_link; }

@test "history: a FIFO is reported, and is none" { prompt history_fifo; }

@test "history: SIGKILL loses nothing" { prompt history_crash; }

@test "history: half a line and a long file" { prompt history_long; }

@test "history: four sessions that end at once" { prompt history_many 4 5; }

@test "history: from session to session, 0600, nothing twice in a row" { prompt history_sessions; }
@test "history: DOMINO_HISTORY says where" { prompt history_override; }
@test "history: an empty DOMINO_HISTORY means none" { prompt history_none; }
@test "history: without XDG_STATE_HOME it is in the home folder" { prompt history_home; }
@test "history: a signal and a lost terminal keep it" { prompt history_signal; }
@test "history: two sessions at once" { prompt history_two; }
@test "history: where it cannot be written, that is said" { prompt history_cannot; }
@test "history and start-up file: neither in pipes" {
    export XDG_STATE_HOME=$BATS_TEST_TMPDIR/state XDG_CONFIG_HOME=$BATS_TEST_TMPDIR/config
    export HOME=$BATS_TEST_TMPDIR DOMINO_HISTORY=$BATS_TEST_TMPDIR/own
    mkdir -p "$XDG_CONFIG_HOME/domino"
    echo 'set s 0.3' >"$XDG_CONFIG_HOME/domino/init.dom"
    for way in -e stdin -f; do
        run --separate-stderr session "$way" 'print s'
        [ "$status" -eq 0 ]
        same "$way" 0.4 "$output"
    done
    [ ! -e "$XDG_STATE_HOME" ]
    [ ! -e "$DOMINO_HISTORY" ]
}
