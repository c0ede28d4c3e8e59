#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Every example against its golden transcript; 'GOLDEN=write make sessions' writes them again.

load common

root=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)

digits() {
    sed -E -e 's/([0-9]\.[0-9]{12})[0-9]+/\1/g' -e '${/^$/d}'
}

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
    # The atlas takes a quarter of a minute: prove.bats compares a part of it with its table.
    examples=$(cd "$root/examples" && printf '%s\n' *.dom | sed 's/\.dom$//' | grep -vx atlas | sort)
    [ "$(wc -l <<<"$examples")" -ge 12 ]
    same transcripts "$examples" "$(cd "$BATS_TEST_DIRNAME/golden" && find . -name '*.out' -size +0 | sed 's,^\./,,; s/\.out$//' | sort)"
    same tests "$examples" "$(sed -nE 's/^@test "(.*)\.dom" \{ golden \1; \}$/\1/p' "$BATS_TEST_FILENAME" | sort)"
}

@test "domino(1) has every option and environment variable" {
    page=$root/man/domino.1
    "$DOMINO" --help | grep -o -- '--[a-z-]*' | sort -u >"$BATS_TEST_TMPDIR/options"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/options")" -ge 7 ]
    while read -r option; do
        grep -qE -- "(Fl Fl|Fl) ${option#--}( |$)" "$page" || { echo "option $option"; false; }
    done <"$BATS_TEST_TMPDIR/options"
    grep -rho 'getenv("[A-Z_]*")\|line_path("[A-Z_]*"' "$root"/src/shell | sed 's/.*"\(.*\)".*/\1/' | sort -u \
        >"$BATS_TEST_TMPDIR/environment"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/environment")" -ge 5 ]
    while read -r name; do
        grep -q "^\.It Ev $name\$" "$page" || { echo "environment $name"; false; }
    done <"$BATS_TEST_TMPDIR/environment"
}

@test "the sessions of the README and the man pages are what the program prints" {
    # The last digits of the 17 may differ with the C library's sine.
    PATH=$(dirname "$DOMINO"):$PATH
    commands=0
    for text in "$root/README.md" "$root"/man/*.[0-9]; do
        "$root/tests/sessions" "$text" >"$BATS_TEST_TMPDIR/now"
        if [ "${GOLDEN:-}" = write ]; then cp "$BATS_TEST_TMPDIR/now" "$text"; fi
        digits <"$text" >"$BATS_TEST_TMPDIR/said"
        digits <"$BATS_TEST_TMPDIR/now" >"$BATS_TEST_TMPDIR/says"
        same_file "$BATS_TEST_TMPDIR/said" "$BATS_TEST_TMPDIR/says"
        commands=$((commands + $(grep -cE '^\$ (domino|for) ' "$text" || :)))
    done
    [ "$commands" -ge 5 ]
}
