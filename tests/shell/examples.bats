#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Every example against its golden transcript; 'GOLDEN=write make sessions' writes them anew.

root=$BATS_TEST_DIRNAME/../..

digits() {
    sed -E -e 's/([0-9]\.[0-9]{12})[0-9]+/\1/g' -e '${/^$/d}'
}

golden() {
    "$DOMINO" -f "$root/examples/$1.dom" >"$BATS_TEST_TMPDIR/out"
    if [ "${GOLDEN:-}" = write ]; then cp "$BATS_TEST_TMPDIR/out" "$BATS_TEST_DIRNAME/golden/$1.out"; fi
    diff -u "$BATS_TEST_DIRNAME/golden/$1.out" "$BATS_TEST_TMPDIR/out"
}

@test "accuracy.dom" { golden accuracy; }
@test "quiz.dom" { golden quiz; }
@test "one-cycle.dom" { golden one-cycle; }
@test "growth-curve.dom" { golden growth-curve; }
@test "marginal-curve.dom" { golden marginal-curve; }
@test "domtoren.dom" { golden domtoren; }
@test "whitehead.dom" { golden whitehead; }
@test "quiz-hollow.dom" { golden quiz-hollow; }
@test "equal.dom" { golden equal; }
@test "record.dom" { golden record; }
@test "tutorial.dom" { golden tutorial; }
@test "sweep.dom" { golden sweep; }

@test "no example is without a golden transcript" {
    for example in "$root"/examples/*.dom; do
        [ -s "$BATS_TEST_DIRNAME/golden/$(basename "$example" .dom).out" ]
    done
}

# "The largest growth.": a line of the page from a line of help.
sentence() {
    sed -E 's/^(.)(.*)$/\U\1\E\2./'
}

@test "the man page says of every command what help says" {
    page=$root/man/domino.1
    "$DOMINO" -e help | sed -n '/^Parameters/q;s/^  //p' >"$BATS_TEST_TMPDIR/commands"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/commands")" -ge 25 ]
    while IFS= read -r line; do
        usage=$(sed -E 's/  +.*//' <<<"$line")
        summary=$(sed -E 's/^.{21}//' <<<"$line" | sentence)
        # "rmax [S]" is ".It Ic rmax Op Ar S" in the page.
        macro=${usage%% *}
        for word in $(cut -s -d ' ' -f 2- <<<"$usage"); do
            case $word in
            ":") macro="$macro :" ;;
            "["*) word=${word#?} macro="$macro Op Ar ${word%?}" ;;
            *) macro="$macro Ar $word" ;;
            esac
        done
        grep -A 1 -Fx ".It Ic $macro" "$page" | grep -qFx -- "$summary" || { echo "$macro: $summary"; false; }
        for key in $("$DOMINO" -e "help ${usage%% *}" | sed -n '/^It answers/,/^$/s/^  \([^ ]*\).*/\1/p'); do
            awk -v item=".It Ic $macro" '$0 == item { on = 1; next } /^\.It|^\.El/ { on = 0 } on' "$page" |
                grep -qE "\b$key\b" || { echo "$usage: key $key"; false; }
        done
    done <"$BATS_TEST_TMPDIR/commands"
}

@test "the man page has every parameter, option and environment variable" {
    page=$root/man/domino.1
    "$DOMINO" -e 'set output json; show' | while IFS= read -r row; do
        name=$(sed -E 's/.*"name":"([^"]*)".*/\1/' <<<"$row")
        meaning=$(sed -E 's/.*"meaning":"([^"]*)".*/\1/' <<<"$row" | sentence)
        grep -A 1 -Fx ".It Va $name" "$page" | grep -qFx -- "$meaning" || { echo "$name: $meaning"; false; }
    done
    "$DOMINO" --help | grep -o -- '--[a-z-]*' | sort -u | while read -r option; do
        grep -qE -- "(Fl Fl|Fl) ${option#--}( |$)" "$page" || { echo "option $option"; false; }
    done
    grep -rho 'getenv("[A-Z_]*")\|line_path("[A-Z_]*"' "$root"/src/shell | sed 's/.*"\(.*\)".*/\1/' | sort -u |
        while read -r name; do
            grep -q "^\.It Ev $name\$" "$page" || { echo "environment $name"; false; }
        done
}

@test "help NAME shows an example whose output is what the command line gives" {
    "$DOMINO" -e 'complete help ' | while read -r name; do
        "$DOMINO" -e "help $name" >"$BATS_TEST_TMPDIR/help"
        example=$(sed -n 's/^Example: //p' "$BATS_TEST_TMPDIR/help")
        if [ -n "$example" ]; then
            sed '1,/^Example: /d' "$BATS_TEST_TMPDIR/help" | sed -e 1d -e '/^See also/,$d' -e '/^The parameter/,$d' |
                sed -e '${/^$/d}' >"$BATS_TEST_TMPDIR/shown"
            "$DOMINO" -e "$example" >"$BATS_TEST_TMPDIR/true"
            diff -u "$BATS_TEST_TMPDIR/true" "$BATS_TEST_TMPDIR/shown"
        fi
    done
}

@test "the README's sessions are what the program prints" {
    # Blocks that begin with '$ domino' or '$ for' are commands with their output; the last digits of the 17 may
    # differ with the C library's sine.
    awk '/^```/ { inside = !inside; next } inside' "$root/README.md" >"$BATS_TEST_TMPDIR/blocks"
    PATH=$(dirname "$DOMINO"):$PATH
    cd "$root" || false
    grep '^\$ \(domino\|for\) ' "$BATS_TEST_TMPDIR/blocks" >"$BATS_TEST_TMPDIR/commands"
    [ -s "$BATS_TEST_TMPDIR/commands" ]
    while IFS= read -r command; do
        awk -v command="$command" '$0 == command { on = 1; next } /^\$ / { on = 0 } on' \
            "$BATS_TEST_TMPDIR/blocks" | digits >"$BATS_TEST_TMPDIR/said"
        sh -c "${command#\$ }" 2>&1 | digits >"$BATS_TEST_TMPDIR/says"
        diff -u "$BATS_TEST_TMPDIR/said" "$BATS_TEST_TMPDIR/says"
    done <"$BATS_TEST_TMPDIR/commands"
}
