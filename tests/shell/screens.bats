#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Plots on a terminal of 80 x 24: a golden screen, and colours.
# GOLDEN=write writes the golden screen again; check the new one by eye.
# bats file_tags=whole

load common

setup() {
    answers_at_all
    golden=$BATS_TEST_DIRNAME/golden
    unset NO_COLOR COLORTERM
    export LC_ALL=C.UTF-8 TERM=xterm-256color
}

on_terminal() { # COLUMNS ROWS COMMANDS
    python3 "$BATS_TEST_DIRNAME/terminal.py" "$1" "$2" env PATH="${programs:-$PATH}" "$DOMINO" -n -e "$3"
}
scenes=('plot growth' 'effect row 6; effect friction 0.1; plot fall' 'plot sweep s 0.1 0.9 9 d 0.05 0.4 8 : rmax'
    'effect row 8; plot speed' 'plot sweep q 3, 4 s 0.2 0.8 13 : rmax')

screens() {
    local scene
    for scene in "${scenes[@]:0:2}"; do
        printf '%s\n' "$scene"
        on_terminal 80 24 "$scene"
    done
}

@test "golden screen: plots in braille and boxes" {
    NO_COLOR=1 screens >"$BATS_TEST_TMPDIR/screens"
    [ "${GOLDEN:-}" != write ] || cp "$BATS_TEST_TMPDIR/screens" "$golden/plots-utf8.screen"
    same_file "$golden/plots-utf8.screen" "$BATS_TEST_TMPDIR/screens"
}

@test "pictures fit the terminal, whatever its size" {
    export NO_COLOR=1
    for size in '34 14' '60 20' '80 24' '132 43' '200 60'; do
        read -r columns rows <<<"$size"
        for scene in "${scenes[@]}"; do
            on_terminal "$columns" "$rows" "$scene" >"$BATS_TEST_TMPDIR/screen"
            [ "$(wc -l <"$BATS_TEST_TMPDIR/screen")" -lt "$rows" ] || same "$size: $scene" "$rows rows" "$(cat "$BATS_TEST_TMPDIR/screen")"
            [ "$(wc -L <"$BATS_TEST_TMPDIR/screen")" -lt "$columns" ] || same "$size: $scene" "$columns columns" "$(cat "$BATS_TEST_TMPDIR/screen")"
        done
    done
}

@test "a derivation fits the terminal, with line breaks at blanks" {
    on_terminal 60 24 'explain rmax deep' >"$BATS_TEST_TMPDIR/screen"
    grep -q 'tilt of domino i when the head is hit' "$BATS_TEST_TMPDIR/screen"
    [ "$(wc -L <"$BATS_TEST_TMPDIR/screen")" -le 60 ] || same width "60 columns" "$(cat "$BATS_TEST_TMPDIR/screen")"
}

@test "colours change no characters" {
    local scene='effect row 6; effect friction 0.1; plot fall'
    plain() { sed 's/\x1b\[[0-9;]*m//g'; }
    expected=$(NO_COLOR=1 on_terminal 80 24 "$scene")
    for term in xterm-256color xterm linux; do
        TERM=$term on_terminal 80 24 "$scene" >"$BATS_TEST_TMPDIR/screen"
        grep -q '\[3' "$BATS_TEST_TMPDIR/screen"
        [ $term = linux ] || same $term "$expected" "$(plain <"$BATS_TEST_TMPDIR/screen")"
    done
    grep -q '#' "$BATS_TEST_TMPDIR/screen" # a console has no braille
    same 'no colour on a dumb terminal' '(nothing)' "$(TERM=dumb on_terminal 80 24 "$scene" | grep -o $'\x1b' | head -1)"
}
