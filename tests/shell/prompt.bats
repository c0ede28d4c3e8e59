#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The calculator at a terminal. The scenarios are in prompt.exp.
# bats file_tags=whole

load common

# Checks that the answers to all commands at the prompt are exactly those with -e.
same_at_the_prompt() { # FORMAT
    local ask=("set output $1") all="set output $1" call
    while IFS='|' read -r call _; do
        ask+=("$call")
        all+="; $call"
    done <<<"$commands"
    prompt answers "${ask[@]}" >"$BATS_TEST_TMPDIR/obtained"
    # In tables, the answers of a script are separated by a blank line.
    "$DOMINO" -e "$all" | grep . >"$BATS_TEST_TMPDIR/expected"
    grep . "$BATS_TEST_TMPDIR/obtained" | diff "$BATS_TEST_TMPDIR/expected" -
}

@test "tables at the prompt are the same as with -e, for every command" { same_at_the_prompt table; }
@test "json at the prompt is the same as with -e, for every command" { same_at_the_prompt json; }
@test "^D leaves with status 0, but only on an empty line" { prompt end_of_input; }
@test "an error is shown by a caret and one line, and the session goes on" { prompt error_goes_on; }
@test "TAB completes commands, parameters and words, and nothing else; TAB TAB lists them" { prompt complete; }
@test "TAB completes files where a file belongs, but not in a safe session" { prompt complete_files; }
@test "TAB quotes a file name with blanks, '#', ';' or '>'" { prompt complete_files_quoted; }
@test "^C clears a half-typed line, ends a history search, and on an empty line says how to leave" { prompt interrupt_line; }
@test "^C stops a long computation, and drops the rest of the line" { prompt interrupt_rest; }
@test "^C stops gnuplot while it draws an animation, and leaves no file" { prompt interrupt_animation; }
@test "animate at a terminal: space stops, the right arrow shows the next frame, q ends; a file says what it has" { prompt play; }
@test "^Z while an animation plays does nothing" { prompt suspend_animation; }
@test "^Z during a computation suspends the session at once, and fg goes on" { prompt suspend; }
@test "pasted lines run as those of a script: continued lines, comments, line ends of other systems" { prompt pasted; }
@test "watch: keys move the point, and every way out restores the terminal" { prompt watch; }
@test "lesson: it waits for each command, and q, ^C, ^D and quit leave it" {
    TUTORIAL=$BATS_TEST_DIRNAME/../../examples/tutorial.dom prompt lesson
}

# bats test_tags=rows,save
@test "the prompt opens with a row from a file, and after a file with -i" { prompt opened; }
@test "^C in a file before the prompt ends the file, and the prompt opens" { prompt interrupt_opened; }
@test "inputrc: \$if Domino" { prompt inputrc; }
@test "letters: ASCII in an ASCII locale" { prompt ascii; }
@test "watch works only at the prompt, and says so" {
    wrong 'watch s 0.1 0.9: rmax' 'works only at the prompt of a terminal .* lists the answers'
    wrong 'watch s 0.9 0.1: rmax' 'FROM must be less than TO'
    wrong 'watch s' "enter, for example, 'watch s 0.1 0.9 : rmax'"
    wrong 'watch s 0.1 0.9:' "the answer is missing after ':'"
}
@test "^Z while gnuplot draws: the picture is finished, then the program stops" { prompt suspend_drawing; }
@test "a signal that ends the program restores the terminal" {
    for signal in TERM ALRM QUIT HUP; do prompt end_signal "$signal"; done
}
