#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The calculator in a terminal emulator: the tests run it in tmux, and check the screen.
# bats file_tags=whole

load common

setup() {
    answers_at_all
    socket=$BATS_TEST_TMPDIR/tmux
    prompt='domino❯'
    export HOME=$BATS_TEST_TMPDIR XDG_STATE_HOME=$BATS_TEST_TMPDIR/state XDG_CONFIG_HOME=$BATS_TEST_TMPDIR/config
    export INPUTRC=/dev/null DOMINO_HISTORY='' LC_ALL=C.UTF-8 NO_COLOR=1
    unset TMUX TMUX_TMPDIR BASH_ENV ENV PROMPT_COMMAND
}
teardown() {
    terminal kill-server 2>/dev/null || true
}

terminal() { tmux -u -S "$socket" -f /dev/null "$@"; }

# A tmux server that ends still answers on its socket for a moment, so the next server gets a new socket.
close_terminal() {
    terminal kill-server
    socket+=x
}
open_terminal() { # WIDTH HEIGHT COMMAND...
    terminal start-server \; set -g history-limit 50000 \; new-session -d -x "$1" -y "$2" -- "${@:3}"
    terminal set -g window-size manual
}
open_session() { # WIDTH HEIGHT
    open_terminal "$1" "$2" "$DOMINO"
    see "or 'help'\."
    see_last "$prompt"
}

# Prints the screen without blanks at the end. With -J, wrapped lines are joined.
screen() {
    local text
    text=$(terminal capture-pane -p "$@" | sed 's/ *$//')
    printf '%s\n' "$text"
}
cursor() { terminal display-message -p '#{cursor_x}'; }

tty_is() { [ "$(stty -F "$(terminal display-message -p '#{pane_tty}')" size | cut -d ' ' -f 2)" = "$1" ]; }

# Repeats a command until it succeeds. The time limit matters only in a failure.
until_true() { # COMMAND...
    local end=$((SECONDS + 60))
    until "$@"; do
        if ((SECONDS > end)); then
            printf 'in vain: %s\nscreen:\n' "$*"
            screen
            return 1
        fi
        sleep 0.02
    done
}
shows() { screen -J | grep -Eq -- "$1"; }
hides() { ! shows "$1"; }
last_is() { [ "$(screen -J | tail -n 1)" = "$1" ]; }
see() { until_true shows "$1"; }
see_last() { until_true last_is "$1"; }

press() { terminal send-keys "$@"; }
type_in() { # TEXT: waits for its echo
    local before
    before=$(screen -J | tail -n 1)
    case $before in *[!\ ]) [ "$before" = "$prompt" ] && before+=' ' ;; esac
    press -l -- "$1"
    see_last "$before$1"
}
# Runs a command and waits for the next prompt.
ask() {
    type_in "$1"
    press Enter
    see_last "$prompt"
}
clear_screen() {
    press C-l
    until_true only "$prompt"
}
only() { [ "$(screen)" = "$1" ]; }

# Checks that every line of the answers to these commands fits into the width.
fits() { # WIDTH COMMAND...
    local width=$1 command wide=''
    open_session "$width" 180
    for command in "${@:2}"; do
        clear_screen
        ask "$command"
        screen -J >"$BATS_TEST_TMPDIR/joined"
        screen | diff - "$BATS_TEST_TMPDIR/joined" >"$BATS_TEST_TMPDIR/wrapped" ||
            wide+="$command:"$'\n'"$(grep '^>' "$BATS_TEST_TMPDIR/wrapped")"$'\n'
    done
    same "wider than $width columns" '(nothing)' "$wide"
}

answers=('chain 0.1' show 'show s' thetac rmax 'count 112' 'count 112 2' 'curve 0.1 0.9 3' barrier duration 'effect row 3; plan')
helps=(help 'apropos barrier' 'help count' 'help curve' 'help set' 'help sweep' 'help s' 'help tol' 'help output' 'help friction')
errors=(foo barier 'set s 9' 'theta1 9' theta1 'set q holow' 'chain 0.1 2' 'print sqrt(2' 'set d 0.7/' 'set s 0.9; thetac')

@test "answers fit in 80 columns" { fits 80 "${answers[@]}"; }
@test "details fit in 100 columns, and no word is cut" {
    fits 100 'set q hollow; set row 8; set placement 5 mm; set error_place 5 mm' 'set error_lean 0.3 deg' \
        'placement 50' details plan details
    see 'all dominoes still fall'
}
@test "help fits in 80 columns" { fits 80 "${helps[@]}"; }
@test "errors fit in 80 columns" { fits 80 "${errors[@]}"; }

@test "tables follow the width of the terminal" {
    open_session 120 70
    ask 'chain 0.1'
    for width in 90 100 80; do
        terminal resize-window -x "$width"
        until_true tty_is "$width"
        clear_screen
        for command in 'chain 0.1' show thetac; do ask "$command"; done
        same "$width columns" "$(screen -J)" "$(screen)"
    done
}

@test "300 pasted lines are all run, with and without bracketed paste" {
    echo foo >"$BATS_TEST_TMPDIR/lines" # an error, after which the other lines are run
    for i in {1..299}; do echo "set s 0.0$((100 + i))"; done >>"$BATS_TEST_TMPDIR/lines"
    echo 'print s*10000' >>"$BATS_TEST_TMPDIR/lines"
    for option in -p -d; do # -p is bracketed paste, as in modern terminals
        open_session 80 24
        terminal load-buffer "$BATS_TEST_TMPDIR/lines"
        terminal paste-buffer "$option"
        [ "$option" = -d ] || press Enter
        see '^399$'
        see_last "$prompt"
        ask 'print 6*7'
        see '^42$'
        close_terminal
    done
}

@test "^C during a computation leaves one line, and a prompt below it" {
    open_session 80 24
    type_in 'curve 0.01 0.9 10000000 > /dev/null; set s 0.3'
    press Enter
    see '[0-9] %, .*left'
    press C-c
    see_last "$prompt"
    same 'the screen' "$prompt curve 0.01 0.9 10000000 > /dev/null; set s 0.3
curve: interrupted
$prompt" "$(screen | tail -n 3)"
    ask 'print s'
    see '^0.4$'
}

@test "progress is shown after a second, and wiped" {
    open_session 80 24
    ask 'set threads 1'
    mkfifo "$BATS_TEST_TMPDIR/fifo"
    exec 7<>"$BATS_TEST_TMPDIR/fifo"
    line="curve 0.1 0.9 20000 > $BATS_TEST_TMPDIR/fifo"
    type_in "$line"
    press Enter
    see '^ *[0-9]+ %, .*left' # the rest does not fit into the FIFO before somebody reads
    cat <&7 >/dev/null 7<&- 3>&- &
    see_last "$prompt"
    kill $!
    hides 'left'
    same 'nothing is left of it' "$prompt $line
$prompt" "$(screen -J | tail -n 2)"
}

@test "progress does not mix with rows" {
    open_session 80 24
    type_in 'curve 0.1 0.9 6000'
    press Enter
    see_last "$prompt"
    terminal capture-pane -p -S - | sed 's/ *$//' >"$BATS_TEST_TMPDIR/all"
    same 'rows' 6000 "$(grep -Ec '^ +0\.[0-9]+( +[0-9.-]+){4}$' "$BATS_TEST_TMPDIR/all")"
    same 'progress' '(nothing)' "$(grep -E 'left|\^C' "$BATS_TEST_TMPDIR/all")"
}

@test "the caret stands under the error in a line that wraps" {
    open_session 80 24
    line="print 1$(printf ' + %d' {2..30}) + fooo"
    clear_screen
    ask "$line"
    place=$(((8 + ${#line} - 4) % 80))
    # The caret must be directly below the screen line that has the word.
    same caret "$(printf '%*s^' "$place" '')" "$(screen | grep -A 1 'fooo$' | sed -n 2p)"
}

@test "an error in a file is broken between words" {
    echo 'rmax hollow' >"$BATS_TEST_TMPDIR/x.dom"
    cd "$BATS_TEST_TMPDIR"
    open_session 61 20
    ask 'source x.dom'
    same 'the message' 1 "$(screen | paste -sd ' ' - | grep -cF "x.dom:1:6: rmax: S at 'hollow': 'hollow' is a value of q; enter 'set q hollow', or write 'with q hollow' at the end")"
}
