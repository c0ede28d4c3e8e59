#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Rows that the rigid-body engine runs: feet that slip, dominoes that bounce, and a second opinion on any row.

load ../shell/common

scene='set q hollow; set s 0.3; set r 1.3; effect row 5; effect push 5'

# The model and the engine give values of a key that agree to within this fraction.
agree() { # KEY FRACTION COMMANDS
    paste <(json "$3" | values "$1") <(json "set method engine; $3" | values "$1") |
        awk -v what="$3: $1" -v most="$2" '{ off = $2 - $1; if (!(NF == 2 && off <= most * $1 && -off <= most * $1)) { print what, $0; bad = 1 } }
            END { exit bad || !NR }'
}

# The first 12 tilts of the engine agree with the model to within 0.02 rad.
poses_agree() { # SCENE
    paste <(json "$1; animate" | values theta) <(json "$1; set method engine; animate" | values theta) |
        head -n 12 | awk '{ off = $2 - $1; if (off > 0.02 || off < -0.02) { print; bad = 1 } } END { exit bad || NR != 12 }'
}

@test "the engine and the model give the same verdict, and times that agree to 1 %" {
    differ 'another way to compute' "$(json "$scene; fall" | values hit)" "$(json "$scene; set method engine; fall" | values hit)"
    agree hit 0.01 "$scene; fall"
    # With friction, a slope, rounded edges or walls, the times until the last domino lies also agree to 1 %.
    for effect in 'friction 0.2' 'slope 1 deg' 'edges 0.01' 'walls 1 mm'; do
        agree seconds 0.01 "$scene; effect $effect; verdict"
    done
}

# bats test_tags=chance
@test "the output is the same each time, with any number of threads" {
    study="$scene; effect placement 3 mm; effect feet 0.4; placement 20"
    first=$(json "set threads 1; $study")
    same 'two threads' "$first" "$(json "set threads 2; $study")"
    study="$scene; effect row 3; effect feet 0.4; tolerance details"
    first=$(json "set threads 1; $study")
    same 'windows with two threads' "$first" "$(json "set threads 2; $study")"
    first=$(json "$scene; effect feet 0.3; effect bounce 0.4; fall")
    same again "$first" "$(json "$scene; effect feet 0.3; effect bounce 0.4; fall")"
    # The unit of lengths does not matter.
    same scaled "$(json "$scene; effect feet 0.3; verdict" | values verdict)" \
        "$(json "$scene; effect push 0.5; set h 4.8 m; effect feet 0.3; verdict" | values verdict)"
}

@test "a domino that hardly moves has an angular velocity of exactly 0, without rounding errors" {
    for scene in 's 0.5; set r 1.932; effect row 3; effect friction 1; effect push 10' \
        's 0.8; set r 1.24; effect row 2; effect friction 1; effect push 6'; do
        same "$scene" 0 "$(json "set $scene; set method engine; fall" | values omega | tail -n 1)"
    done
}

# bats test_tags=errors
@test "feet slide: the table says how far, and the details how accurate this is" {
    run -0 "$DOMINO" -n -e "$scene; effect feet 0.2; fall details"
    [[ $output == *' slid'* ]]
    [[ $output == *'Chipmunk 7'*'With half as many steps the verdict is the same, and times agree within '*' %.'* ]]
    # Without feet that slip, there is no column 'slid'. Times have error bounds.
    run -0 "$DOMINO" -n -e "$scene; effect bounce 0.2; fall details"
    [[ $output != *slid* && $output == *'Chipmunk 7'* ]]
    json "$scene; effect feet 0.5; set errors on; verdict" | values seconds_error | awk '{ exit !($1 > 0 && $1 < 0.01) }'
}

# bats test_tags=explain
@test "'effects' says that the engine runs the row; trains are still computed by the model" {
    says "$scene; effect feet 0.4; effects" 'computed by the rigid-body engine'
    same train "$(json 'rmax' | sed 's/"r_start.*//')" "$(json 'set method engine; rmax' | sed 's/"r_start.*//')"
    # The engine takes too long to find the growth at which a row starts, and rmax says so.
    [[ $(json 'set method engine; rmax' | values reason) == *'engine'*'rowmax'* ]]
    [[ $("$DOMINO" -e 'set feet 0.3; set row off; rmax' | tail -n 1) == '(This answer is about dominoes that turn about a hinge.'* ]]
    same 'without feet' 0 "$("$DOMINO" -e 'rmax' | grep -c hinge)"
}

# bats test_tags=pictures
@test "animate and draw show the poses of the engine" {
    poses_agree "$scene"
    says "$scene; effect feet 0.3; draw at 0.1 s" 'after the push'
}

# bats test_tags=pictures
@test "rounded edges in the engine: times, a rough floor, bounce, growth and poses agree with the model" {
    edges="$scene; effect edges 0.02"
    model=$(json "$edges; verdict" | values seconds)
    for more in 'set method engine' 'effect feet 2' 'effect feet 2; effect bounce 0.01' 'effect bounce 0.01'; do
        close "$more" "$model" "$(json "$edges; $more; verdict" | values seconds)" 0.005
    done
    differ 'a slippery floor' "$model" "$(json "$edges; effect feet 0.2; verdict" | values seconds)"
    differ 'much bounce' "$(json "$edges; effect feet 0.5; verdict" | values seconds)" "$(json "$edges; effect feet 0.5; effect bounce 0.5; verdict" | values seconds)"
    close 'a rough floor' "$(json "$edges; rowmax" | values r_max)" "$(json "$edges; effect feet 2; rowmax" | values r_max)" 0.01
    poses_agree "$edges"
    differ 'drawn with edges' "$("$DOMINO" -n -e "$edges; set method engine; draw at 0.2 s")" "$("$DOMINO" -n -e "$scene; set method engine; draw at 0.2 s")"
}

@test "tolerance: windows of the engine agree with the model to 2 %" {
    two="$scene; effect row 2"
    model=$(json "$two; tolerance") engine=$(json "$two; set method engine; tolerance")
    for column in to from gap_low gap_high friction_high; do
        paste <(values "$column" <<<"$model" | tail -n 1) <(values "$column" <<<"$engine" | tail -n 1) |
            awk -v column="$column" '{ off = $2 / $1 - 1; if (!($1 > 0) || off > 0.02 || off < -0.02) { print column, $0; exit 1 } }'
    done
    # Windows of heights agree unless the model ends a window because a tip would pass above the next
    # domino.
    three="$scene; effect row 3"
    model=$(json "$three; tolerance") engine=$(json "$three; set method engine; tolerance")
    close 'lowest first' "$(values height_low <<<"$model" | head -n 1)" "$(values height_low <<<"$engine" | head -n 1)" 0.02
    close 'highest last' "$(values height_high <<<"$model" | tail -n 1)" "$(values height_high <<<"$engine" | tail -n 1)" 0.02
    paste <(values height_low <<<"$model") <(values height_high <<<"$model") <(values height_low <<<"$engine") <(values height_high <<<"$engine") |
        awk '{ if (!($3 < 1.02 * $1 && $4 > 0.98 * $2)) { print; bad = 1 } } END { exit bad || NR != 3 }'
    says "$two; effect feet 0.4; tolerance; details" 'accurate to about 1 %'
    run -130 timeout --preserve-status --foreground -s INT 1 "$DOMINO" -n -e 'effect row 60; effect feet 0.4; tolerance'
}

@test "^C ends a search of the engine" {
    run -130 timeout --preserve-status --foreground -s INT 1 "$DOMINO" -n -e 'effect row 60; effect feet 0.4; rowmax'
}

@test "without the library, a row that needs it gives a one-line error, and everything else works" {
    cat >"$PWD/none.c" <<'C'
#include <string.h>
void *dlopen(const char *name, int flags);
void *dlopen(const char *name, int flags)
{
    (void)name, (void)flags;
    return 0;
}
C
    [ -z "$(checked "$DOMINO")" ] || skip 'the sanitizers bring a loader of their own'
    cc -shared -fPIC "$PWD/none.c" -o "$PWD/none.so"
    run env LD_PRELOAD="$PWD/none.so" "$DOMINO" -n -e "$scene; effect feet 0.4; rmax > /dev/null; fall"
    same missing "-e:1: fall: feet is on, but the rigid-body engine Chipmunk 7 is not installed; on Debian, run 'apt-get install libchipmunk7'" "$output"
    run -0 env LD_PRELOAD="$PWD/none.so" "$DOMINO" -n -e "$scene; effect feet 0.4; effect feet off; verdict"
}

@test "what the engine cannot do gives a one-line error that says what to do" {
    while IFS='|' read -r commands message; do
        run "$DOMINO" -n -e "$commands"
        same "$commands" "$message" "$(sed -E 's/^-e:1:([0-9]+:)? //' <<<"$output")"
    done <<'END'
effect row 3; effect bounce 1.5|effect: E = 1.5 is out of range; E, the restitution between dominoes, must be in the range 0 .. 1
effect row 3; effect feet -0.1|effect: MU = -0.1 is out of range; MU, the friction coefficient of the floor, must be in the range 0 .. 100
effect row 201; effect feet 0.4; verdict|verdict: a row of 201 dominoes is too long for the rigid-body engine, which runs this row because feet is on; the maximum is 200; enter, for example, 'set row 20'
effect row 3; effect floor 1; set method engine; fall|fall: the rigid-body engine runs this row because method is engine, but does not include floor; first enter 'set floor off'
set method box|set: unknown value of method 'box'; use one of: model, engine
END
}

# bats test_tags=save
@test "effects are saved and read back, and reset turns them off" {
    saved=$("$DOMINO" -n -e "$scene; effect feet 0.4; effect bounce 0.1; set method engine; save \"saved.dom\"; verdict")
    same saved "$saved" "$("$DOMINO" -n -e "source \"saved.dom\"; verdict")"
    same reset "$(json "$scene; verdict")" "$(json "set method engine; effect row 3; effect feet 0.1; reset; $scene; verdict")"
}

@test "the library prints nothing of its own, into a file, a pipe or a terminal" {
    local ask='set row 2; set feet 0.5; verdict' said
    "$DOMINO" -n -e "$ask" >file
    said=$("$DOMINO" -n -e "$ask")
    [[ $said == *'Both fall'* ]] || same 'the engine' 'Both fall' "$said"
    same 'a pipe' "$(cat file)" "$said"
    for text in "$said" "$(python3 "$root/tests/shell/terminal.py" 500 50 "$DOMINO" -n -e "$ask")"; do
        [[ $text != *Initializing* && $text != *DNDEBUG* ]] || same 'nothing else' "$said" "$text"
        same 'the answer begins' "$(head -c 20 file)" "${text:0:20}"
    done
    # At the prompt, Readline has written to the standard output before the library does.
    said=$(printf '%s\nquit\n' "$ask" | soon python3 -c 'import pty, sys; pty.spawn(sys.argv[1:])' "$DOMINO" -n)
    [[ $said == *'Both fall'* && $said != *Initializing* ]] || same 'at the prompt' 'Both fall' "$said"
}
