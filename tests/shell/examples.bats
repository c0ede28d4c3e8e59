#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Compares every example with its golden transcript. 'GOLDEN=write make sessions' writes the
# transcripts again.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

golden() {
    cd "$BATS_TEST_TMPDIR" || return # for the files that an example writes
    "$DOMINO" "$root/examples/$1.dom" >"$BATS_TEST_TMPDIR/out"
    if [ "${GOLDEN:-}" = write ]; then cp "$BATS_TEST_TMPDIR/out" "$BATS_TEST_DIRNAME/golden/$1.out"; fi
    same_file "$BATS_TEST_DIRNAME/golden/$1.out" "$BATS_TEST_TMPDIR/out"
}

@test "accuracy.dom" { golden accuracy; }

@test "quiz.dom" { golden quiz; }

@test "one-cycle.dom" { golden one-cycle; }

@test "growth-curve.dom" { golden growth-curve; }

@test "marginal-curve.dom" { golden marginal-curve; }

@test "domtoren.dom" { golden domtoren; }

@test "morris.dom" { golden morris; }

@test "quiz-hollow.dom" { golden quiz-hollow; }

@test "equal.dom" { golden equal; }

@test "record.dom" { golden record; }

@test "tutorial.dom" { golden tutorial; }

@test "sweep.dom" { golden sweep; }

@test "measured.dom" { golden measured; }

@test "pictures.dom" { golden pictures; }

@test "every example has a golden transcript and a test, and no transcript is left over" {
    # The atlas takes a quarter of a minute, so prove.bats compares only a part of it with its
    # table.
    examples=$(cd "$root/examples" && printf '%s\n' *.dom | sed 's/\.dom$//' | grep -vx atlas | sort)
    [ "$(wc -l <<<"$examples")" -ge 12 ]
    same transcripts "$examples" "$(cd "$BATS_TEST_DIRNAME/golden" && find . -name '*.out' -size +0 | sed 's,^\./,,; s/\.out$//' | sort)"
    same tests "$examples" "$(sed -nE 's/^@test "(.*)\.dom" \{ golden \1; \}$/\1/p' "$BATS_TEST_FILENAME" | sort)"
}
