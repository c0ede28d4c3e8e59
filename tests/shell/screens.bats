#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Plots on a terminal of 80 x 24: a golden screen, colours, and bitmap pictures.
# GOLDEN=write writes the golden screen again; check the new one by eye.

load common

setup() {
    answers_at_all
    golden=$BATS_TEST_DIRNAME/golden
    unset NO_COLOR COLORTERM KITTY_WINDOW_ID DOMINO_GRAPHICS
    export LC_ALL=C.UTF-8 TERM=xterm-256color
}

on_terminal() { # COLUMNS ROWS ATTRIBUTES COMMANDS
    python3 "$BATS_TEST_DIRNAME/terminal.py" "$1" "$2" "$3" env PATH="${programs:-$PATH}" "$DOMINO" -n -e "$4"
}
scenes=('plot growth' 'effect row 6; effect friction 0.1; plot fall' 'effect row 6; effect friction 0.1; plot gaps'
    'effect row 8; plot speed' 'plot sweep q 3, 4 s 0.2 0.8 13 : rmax' 'plot sweep s 0.1 0.9 9 d 0.05 0.4 8 : rmax')

screens() {
    local scene
    for scene in "${scenes[@]}"; do
        printf '%s\n' "$scene"
        on_terminal 80 24 '' "$scene"
    done
}


@test "golden screen: plots in braille, boxes and blocks" {
    NO_COLOR=1 screens >"$BATS_TEST_TMPDIR/screens"
    [ "${GOLDEN:-}" != write ] || cp "$BATS_TEST_TMPDIR/screens" "$golden/plots-utf8.screen"
    same_file "$golden/plots-utf8.screen" "$BATS_TEST_TMPDIR/screens"
}

@test "pictures fit the terminal, whatever its size" {
    export NO_COLOR=1
    for size in '34 14' '60 20' '80 24' '132 43' '200 60'; do
        read -r columns rows <<<"$size"
        for scene in "${scenes[@]}"; do
            on_terminal "$columns" "$rows" '' "$scene" >"$BATS_TEST_TMPDIR/screen"
            [ "$(wc -l <"$BATS_TEST_TMPDIR/screen")" -lt "$rows" ] || same "$size: $scene" "$rows rows" "$(cat "$BATS_TEST_TMPDIR/screen")"
            [ "$(wc -L <"$BATS_TEST_TMPDIR/screen")" -lt "$columns" ] || same "$size: $scene" "$columns columns" "$(cat "$BATS_TEST_TMPDIR/screen")"
        done
    done
}

@test "a derivation fits the terminal, with line breaks at blanks" {
    on_terminal 60 24 '' 'explain rmax deep' >"$BATS_TEST_TMPDIR/screen"
    grep -q 'tilt of domino i when the head is hit' "$BATS_TEST_TMPDIR/screen"
    [ "$(wc -L <"$BATS_TEST_TMPDIR/screen")" -le 60 ] || same width "60 columns" "$(cat "$BATS_TEST_TMPDIR/screen")"
}

@test "a terminal that is too small for a picture gets one line that says so, and a file has the picture" {
    for size in '20 6' '30 24' '80 12'; do
        read -r columns rows <<<"$size"
        for scene in draw 'plot growth' 'effect row 6; draw'; do
            NO_COLOR=1 on_terminal "$columns" "$rows" '' "$scene" >"$BATS_TEST_TMPDIR/screen" && false
            grep -q "the terminal has $columns x $rows characters, but a picture needs 31 x 13;" "$BATS_TEST_TMPDIR/screen"
            same "$scene" 1 "$(wc -l <"$BATS_TEST_TMPDIR/screen")"
        done
    done
    on_terminal 20 6 '' "draw > $BATS_TEST_TMPDIR/draw.txt"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/draw.txt")" -gt 13 ]
    on_terminal 20 6 '' 'set output csv; draw' | grep -q ,
}

@test "colours change no characters, and a terminal gets only colours that it has" {
    local scene='effect row 6; effect friction 0.1; plot fall'
    plain() { sed 's/\x1b\[[0-9;]*m//g; s/<asked>//'; }
    expected=$(NO_COLOR=1 on_terminal 80 24 '' "$scene")
    for term in 'xterm-256color 38;5;' 'xterm \[3' 'linux \[3'; do
        TERM=${term% *} on_terminal 80 24 '62;22' "$scene" >"$BATS_TEST_TMPDIR/screen"
        grep -q "${term#* }" "$BATS_TEST_TMPDIR/screen"
        [ "${term% *}" = linux ] || same "${term% *}" "$expected" "$(plain <"$BATS_TEST_TMPDIR/screen")"
    done
    grep -q '#' "$BATS_TEST_TMPDIR/screen" # a console has no braille
    COLORTERM=truecolor on_terminal 80 24 '62;22' "$scene" | grep -q '38;2;213;94;0m'
    same 'no colour on a dumb terminal' '(nothing)' "$(TERM=dumb on_terminal 80 24 '' "$scene" | grep -o $'\x1b' | head -1)"
    differ 'a map in colour' "$(on_terminal 80 24 '62;22' "${scenes[5]}" | grep -c '▀')" 0
}

@test "a terminal that announces sixel gets sixel, and any other gets characters" {
    local scene
    for scene in 'effect row 6; draw' 'draw train' 'plot growth'; do
        on_terminal 80 24 '62;4;22' "$scene" >"$BATS_TEST_TMPDIR/screen"
        grep -q '^<asked>' "$BATS_TEST_TMPDIR/screen"
        grep -qa $'\x1bP' "$BATS_TEST_TMPDIR/screen"
    done
    for attributes in '62;22' '64;14' ''; do
        on_terminal 80 24 "$attributes" "$scene" >"$BATS_TEST_TMPDIR/screen"
        same "$attributes" 0 "$(grep -ca $'\x1bP' "$BATS_TEST_TMPDIR/screen")"
        grep -q '⠤' "$BATS_TEST_TMPDIR/screen"
    done
    same 'asked once a session' 1 "$(on_terminal 80 24 '62;22' 'plot growth; plot growth' | grep -o '<asked>' | wc -l)"
    same 'not with NO_COLOR' 0 "$(NO_COLOR=1 on_terminal 80 24 '62;4' "$scene" | grep -c '<asked>')"
    same 'not a dumb one' 0 "$(TERM=dumb on_terminal 80 24 '62;4' "$scene" | grep -c '<asked>')"
    programs=/nowhere on_terminal 80 24 '62;4' "$scene" | grep -q '⠤' # without gnuplot
}

@test "kitty gets a png with the size of the window" {
    for scene in 'effect row 6; draw' 'plot growth'; do
        TERM=xterm-kitty on_terminal 80 24 '' "$scene" >"$BATS_TEST_TMPDIR/screen"
        python3 - "$BATS_TEST_TMPDIR/screen" <<'END'
import base64, re, struct, sys
written = open(sys.argv[1], "rb").read()
pieces = re.findall(rb"\x1b_G([^;]*);([A-Za-z0-9+/=]*)\x1b\\", written)
png = b"".join(base64.b64decode(data) for _, data in pieces)
assert pieces[0][0].startswith(b"f=100,a=T") and pieces[0][0].endswith(b"m=1") and pieces[-1][0] == b"m=0", pieces[0][0]
assert all(len(data) <= 4096 for _, data in pieces)
assert png[:8] == b"\x89PNG\r\n\x1a\n" and png[-8:-4] == b"IEND", png[:8]
width, height = struct.unpack(">II", png[16:24])
assert width == 800 and 300 <= height <= 480, (width, height)
assert b"<asked>" not in written
END
    done
    KITTY_WINDOW_ID=1 on_terminal 80 24 '' 'plot growth' | grep -qa $'\x1b_G'
    same 'not through tmux' 0 "$(KITTY_WINDOW_ID=1 TERM=tmux-256color on_terminal 80 24 '62;22' 'plot growth' | grep -ca $'\x1b_G')"
    same 'not into a file' "$("$DOMINO" -e 'plot growth')" \
        "$(TERM=xterm-kitty on_terminal 80 24 '' "plot growth > $BATS_TEST_TMPDIR/a.txt" && cat "$BATS_TEST_TMPDIR/a.txt")"
}

@test "letters of a chart on a terminal are smaller where the window has less room" {
    mkdir "$BATS_TEST_TMPDIR/bin"
    printf '#!/bin/sh\nsed -n "s/.*fontscale //p"\n' >"$BATS_TEST_TMPDIR/bin/gnuplot"
    chmod +x "$BATS_TEST_TMPDIR/bin/gnuplot"
    scale() { DOMINO_GRAPHICS=sixel programs=$BATS_TEST_TMPDIR/bin:$PATH on_terminal "$1" "$2" '' 'plot growth' | head -n 1; }
    same 'large' 1 "$(scale 100 40)"
    same 'narrow' 0.484 "$(scale 32 40)"
    same 'low' 0.5 "$(scale 100 14)"
}
