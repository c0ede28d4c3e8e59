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

@test "quiz.dom" { golden quiz; }
@test "one-cycle.dom" { golden one-cycle; }
@test "growth-curve.dom" { golden growth-curve; }
@test "marginal-curve.dom" { golden marginal-curve; }

@test "no example is without a golden transcript" {
    for example in "$root"/examples/*.dom; do
        [ -s "$BATS_TEST_DIRNAME/golden/$(basename "$example" .dom).out" ]
    done
}

@test "the man page covers every command, parameter and option" {
    page=$root/man/domino.1
    "$DOMINO" -e help | sed -n 's/^  \([a-z0-9]*\) .*/\1/p' >"$BATS_TEST_TMPDIR/names"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/names")" -ge 19 ]
    while read -r name; do
        grep -q "^\.It Ic $name\b" "$page" || { echo "command $name"; false; }
    done <"$BATS_TEST_TMPDIR/names"
    "$DOMINO" -e 'set output csv; show' | tail -n +2 | cut -d, -f1 | while read -r name; do
        grep -q "^\.It Va $name\b" "$page" || { echo "parameter $name"; false; }
    done
    "$DOMINO" --help | grep -o -- '--[a-z]*' | sort -u | while read -r option; do
        grep -q -- "Fl Fl ${option#--}" "$page" || { echo "option $option"; false; }
    done
}

@test "the README's sessions are what the program prints" {
    # Blocks that begin with '$ domino' are commands with their output; the last digits of the 17 may
    # differ with the C library's sine.
    awk '/^```/ { inside = !inside; next } inside' "$root/README.md" >"$BATS_TEST_TMPDIR/blocks"
    PATH=$(dirname "$DOMINO"):$PATH
    cd "$root" || false
    grep '^\$ domino' "$BATS_TEST_TMPDIR/blocks" >"$BATS_TEST_TMPDIR/commands"
    [ -s "$BATS_TEST_TMPDIR/commands" ]
    while IFS= read -r command; do
        awk -v command="$command" '$0 == command { on = 1; next } /^\$ / { on = 0 } on' \
            "$BATS_TEST_TMPDIR/blocks" | digits >"$BATS_TEST_TMPDIR/said"
        sh -c "${command#\$ }" 2>&1 | digits >"$BATS_TEST_TMPDIR/says"
        diff -u "$BATS_TEST_TMPDIR/said" "$BATS_TEST_TMPDIR/says"
    done <"$BATS_TEST_TMPDIR/commands"
}

@test "make install puts everything where it belongs, and a stranger can link the library" {
    dest=$BATS_TEST_TMPDIR/dest
    make -s -C "$root" B="$(dirname "$DOMINO")" install DESTDIR="$dest" PREFIX=/usr
    [ -x "$dest/usr/bin/domino" ]
    [ -x "$dest/usr/share/doc/domino/examples/quiz.dom" ]
    [ -f "$dest/usr/share/man/man1/domino.1" ]
    grep -q '^prefix=/usr$' "$dest/usr/lib/pkgconfig/domino.pc"
    cat >"$BATS_TEST_TMPDIR/use.c" <<'C'
#include <domino.h>
#include <stdio.h>
int main(void)
{
    struct dom_train train = dom_train_default();
    struct dom_limit limit;
    enum dom_status status = dom_limit_rmax(&train, &limit, NULL);
    printf("%s %.6f\n", dom_status_text(status), limit.r_max);
}
C
    # A sanitized library needs its runtime.
    nm "$dest/usr/lib/libdomino.a" | grep -q __asan_init && sanitize=-fsanitize=address,undefined
    gcc ${sanitize:-} -I"$dest/usr/include" "$BATS_TEST_TMPDIR/use.c" -L"$dest/usr/lib" -ldomino -lgsl -lgslcblas -lm \
        -o "$BATS_TEST_TMPDIR/use"
    run "$BATS_TEST_TMPDIR/use"
    [ "$output" = "no error 1.644229" ]
}
