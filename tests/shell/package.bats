#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# What a stranger gets: the installed library, its manual page, the archive.
load common

root=$BATS_TEST_DIRNAME/../..
build=$(dirname "$DOMINO")

# As from a shell of its own: nothing of the 'make' that runs the tests.
plain_make() {
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u MAKEOVERRIDES -u B -u CFLAGS -u CC make -s "$@"
}

# What a library that was built to be checked needs of its users.
checked() {
    if nm "$1" 2>/dev/null | grep -q __asan_init; then echo -fsanitize=address,undefined; fi
    if nm "$1" 2>/dev/null | grep -q __gcov_init; then echo --coverage; fi
}

@test "a stranger builds the example with pkg-config from what make install put there, and uninstall leaves nothing" {
    dest=$BATS_TEST_TMPDIR/dest
    mkdir -p "$dest/usr/lib" "$dest/usr/share/man/man3" # there before, and one of them not empty
    echo before >"$dest/usr/lib/other"
    find "$dest" | sort >"$BATS_TEST_TMPDIR/before"
    plain_make -C "$root" B="$build" install DESTDIR="$dest" PREFIX=/usr
    [ -x "$dest/usr/bin/domino" ]
    [ -x "$dest/usr/share/doc/domino/examples/quiz.dom" ]
    for page in man1/domino.1 man3/libdomino.3 man7/domino-{effects,model,rows}.7; do [ -s "$dest/usr/share/man/$page" ]; done

    export PKG_CONFIG_SYSROOT_DIR=$dest PKG_CONFIG_PATH=$dest/usr/lib/pkgconfig
    cd "$BATS_TEST_TMPDIR" || false
    cp "$dest/usr/share/doc/domino/examples/rmax.c" .
    # As its first lines say; and as for a link without shared libraries.
    for static in '' --static; do
        # shellcheck disable=SC2046
        cc rmax.c -o rmax $(checked "$dest/usr/lib/libdomino.a") $(pkg-config $static --cflags --libs domino)
        for s in 0.4 0.05 0.7; do
            run -0 ./rmax $s
            says=$("$dest/usr/bin/domino" -n -e "set digits 12; print rmax($s)" | head -n 1)
            same "r_max at $s" "$says" "${output%%,*}"
        done
    done
    run -0 ./rmax 0.7
    [[ $output = *", ends by reach" ]]
    run -1 ./rmax 0.001
    [[ $output = "rmax: s = 0.001: the fuel P is not positive"* ]]
    run -1 ./rmax 7
    [[ $output = *"a parameter is outside its range" ]]
    run -2 ./rmax 0.4x
    same version "$(pkg-config --modversion domino)" "$("$DOMINO" --version | grep -o '[0-9.]*[0-9]')"

    plain_make -C "$root" B="$build" install DESTDIR="$dest" PREFIX=/usr # an upgrade
    plain_make -C "$root" B="$build" uninstall DESTDIR="$dest" PREFIX=/usr
    find "$dest" | sort | diff -u "$BATS_TEST_TMPDIR/before" -
}

@test "uninstall leaves an empty DESTDIR, and what others put there" {
    for other in '' usr/share/doc/domino/notes; do
        dest="$BATS_TEST_TMPDIR/a dest$other"
        mkdir -p "$dest"
        plain_make -C "$root" B="$build" install DESTDIR="$dest" PREFIX=/usr
        if [ -n "$other" ]; then echo mine >"$dest/$other"; fi
        plain_make -C "$root" B="$build" uninstall DESTDIR="$dest" PREFIX=/usr
        same "files left" "${other:+$dest/}${other:-(nothing)}" "$(find "$dest" -type f)"
        if [ -z "$other" ]; then same "left" "$dest" "$(find "$dest")"; fi
        run ! plain_make -C "$root" B="$build" uninstall DESTDIR="$dest" PREFIX=/usr
    done
}

@test "pkg-config says that the library has no __float128, where it was built so" {
    for flags in '' -DDOM_NO_FLOAT128; do
        pc=$BATS_TEST_TMPDIR/pc$flags
        plain_make -C "$root" B="$pc" CFLAGS="-O2 $flags" "$pc/domino.pc"
        same "Cflags" "Cflags: -I\${includedir}${flags:+ $flags}" "$(grep '^Cflags' "$pc/domino.pc")"
    done
}

@test "the library shows no names but dom_*" {
    nm -g --defined-only "$build/libdomino.a" | awk 'NF == 3 { print $3 }' >"$BATS_TEST_TMPDIR/names"
    [ "$(grep -c '^dom_' "$BATS_TEST_TMPDIR/names")" -gt 30 ]
    same "other names" '(nothing)' "$(grep -vE '^(dom_|__asan|__odr_asan|__gcov)' "$BATS_TEST_TMPDIR/names")"
}

@test "make dist packs the tracked files, and what is unpacked builds without git and packs the same bytes" {
    [ -z "$(checked "$build/libdomino.a")" ] || skip "the same archive in every build"
    dist=$BATS_TEST_TMPDIR/dist
    plain_make -C "$root" B="$dist" dist
    archive=$(echo "$dist"/domino-*.tar.gz)
    name=$(basename "$archive" .tar.gz)
    if [ -e "$root/.git" ] && git -C "$root" rev-parse HEAD >/dev/null 2>&1; then
        tar -tzf "$archive" | sed "s|^$name/||" | sort | diff -u <(git -C "$root" ls-files | sort) -
    fi
    tar -xzf "$archive" -C "$BATS_TEST_TMPDIR"
    tree=$BATS_TEST_TMPDIR/$name
    [ ! -e "$tree/.git" ]
    plain_make -C "$tree" -j2 CFLAGS=-O0 all dist
    same "the quiz" "$("$DOMINO" -e 'count 112')" "$("$tree/.build/domino" -n -e 'count 112')"
    "$tree/.build/domino" -n -f "$tree/examples/quiz.dom" | diff -u "$tree/tests/shell/golden/quiz.out" -
    cmp "$archive" "$tree/.build/$name.tar.gz"
}

# ---- libdomino(3) against the header ----

header() { cc -std=c17 -I"$root/include" "$@" "$root/include/domino.h"; }

# The function types of C, with their arguments, from the page's synopsis.
synopsis() {
    awk '/^\.Sh DESCRIPTION/ { exit }
         /^\.Ft / { sub(/^\.Ft /, ""); type = $0 }
         /^\.Fn / { name = $2; sub(/^\.Fn [^ ]* /, ""); gsub(/"/, ""); print type " " name "(" $0 ");" }
         /^\.Fo / { name = $2; arguments = "" }
         /^\.Fa / { sub(/^\.Fa "/, ""); sub(/"$/, ""); arguments = arguments (arguments ? ", " : "") $0 }
         /^\.Fc/ { print type " " name "(" arguments ");" }' "$root/man/libdomino.3"
}

# The names of structures' members in C that is one statement a ';'.
members() {
    tr '\n' ' ' | grep -o 'struct dom_[a-z_]* *{[^}]*}' | sed 's/^[^{]*{//; s/}//' | tr ';' '\n' |
        sed -E 's/.*\(\*(\w+)\).*/\1/; s/\[\w*\]//g' | tr ',' '\n' | grep -oE '\w+ *$' | tr -d ' ' | sort -u
}

@test "libdomino(3) has every function of the header, as it is declared" {
    synopsis >"$BATS_TEST_TMPDIR/synopsis.h"
    header -E -P | grep -oE '\bdom_\w+ *\(' | sort -u >"$BATS_TEST_TMPDIR/functions"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/functions")" -gt 30 ]
    grep -oE '\bdom_\w+ *\(' "$BATS_TEST_TMPDIR/synopsis.h" | sort -u | diff -u "$BATS_TEST_TMPDIR/functions" -
    # What is declared again must be the same.
    header -Werror -fsyntax-only -include "$root/include/domino.h" -x c "$BATS_TEST_TMPDIR/synopsis.h"
    sed '0,/dom_real theta/s//double theta/' "$BATS_TEST_TMPDIR/synopsis.h" >"$BATS_TEST_TMPDIR/other.h"
    run ! header -Werror -fsyntax-only -include "$root/include/domino.h" -x c "$BATS_TEST_TMPDIR/other.h"
    # And each function is explained.
    for name in $(tr -d '(' <"$BATS_TEST_TMPDIR/functions"); do
        sed '1,/^\.Sh DESCRIPTION/d' "$root/man/libdomino.3" | grep -qE "^\.(It |)(Fn|Vt) $name\b" || { echo "$name"; false; }
    done
}

@test "libdomino(3) has every type, constant and member of the header, and no other" {
    header -E -P >"$BATS_TEST_TMPDIR/header"
    { grep -oE '\b(dom|DOM)_\w+' "$BATS_TEST_TMPDIR/header" && header -E -dM | grep -oE '\bDOM_\w+'; } | sort -u \
        >"$BATS_TEST_TMPDIR/names"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/names")" -gt 130 ]
    # DOM_NO_FLOAT128 is for users to define, and DOM_REAL_FLOAT128 not everywhere.
    grep -oE '\b(dom|DOM)_\w+' "$root/man/libdomino.3" | grep -vE '^DOM_(NO|REAL)_FLOAT128' | sort -u |
        diff -u <(grep -vE '^DOM_(NO|REAL)_FLOAT128' "$BATS_TEST_TMPDIR/names") -
    members <"$BATS_TEST_TMPDIR/header" >"$BATS_TEST_TMPDIR/members"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/members")" -gt 90 ]
    sed '1,/^\.Sh DESCRIPTION/d' "$root/man/libdomino.3" | grep -E '^\.(It |Po |)Fa ' | grep -oE '\w+' | sort -u |
        comm -23 "$BATS_TEST_TMPDIR/members" - >"$BATS_TEST_TMPDIR/missing"
    same "members that are missing" '(nothing)' "$(cat "$BATS_TEST_TMPDIR/missing")"
}

@test "libdomino(3) has the header's tables: parameters with range and default, statuses, ends of a row" {
    cat >"$BATS_TEST_TMPDIR/tables.c" <<'C'
#include <domino.h>
#include <stdio.h>
#define PARAMETER(name, default_, lowest, highest, unit, meaning) \
    printf("Fa %s|%s.|Range %g .. %g%s%s; default %g\n", #name, meaning, (double)(lowest), (double)(highest), \
           *unit ? " " : "", unit, (double)(default_));
#define STATUS(name, text) printf("Dv DOM_%s|%s.\n", #name, text);
#define END(name, text) printf("Dv DOM_ROW_%s|%s.\n", #name, text);
int main(void)
{
    DOM_TRAIN_PARAMETERS(PARAMETER)
    DOM_SCALE_PARAMETERS(PARAMETER)
    DOM_STATUSES(STATUS)
    DOM_ROW_ENDS(END)
    printf("Fa mu|Coefficient|Range 0 .. %d\n", DOM_MU_HIGHEST);
}
C
    cc -I"$root/include" "$BATS_TEST_TMPDIR/tables.c" -o "$BATS_TEST_TMPDIR/tables"
    "$BATS_TEST_TMPDIR/tables" >"$BATS_TEST_TMPDIR/rows"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/rows")" -gt 30 ]
    while IFS='|' read -r item text range; do
        entry=$(awk -v item=".It $item" '$0 == item { on = 1; next } /^\.It|^\.El/ { on = 0 } on' \
            "$root/man/libdomino.3" | grep -v '^\.Sh' | paste -sd ' ' -)
        [[ ${entry,,} == "${text,,}"* && $entry == *"$range"* ]] || { echo "$item: $text $range, not: $entry"; false; }
    done <"$BATS_TEST_TMPDIR/rows"
}

@test "the example in libdomino(3) is examples/rmax.c, and does what the page says" {
    # The first line of the file is its licence.
    sed -n '/^\.Bd -literal/,/^\.Ed/{/^\./d;s/\\e/\\/g;p}' "$root/man/libdomino.3" >"$BATS_TEST_TMPDIR/rmax.c"
    diff -u <(sed 1d "$root/examples/rmax.c") "$BATS_TEST_TMPDIR/rmax.c"
    # shellcheck disable=SC2046
    cc -std=c99 -Wall -Wextra -Wpedantic -Werror -I"$root/include" "$BATS_TEST_TMPDIR/rmax.c" "$build/libdomino.a" \
        $(checked "$build/libdomino.a") -lgsl -lgslcblas -lm -pthread -o "$BATS_TEST_TMPDIR/rmax"
    command=$(sed -n 's/^\.Dl \$ //p' "$root/man/libdomino.3")
    output=$(cd "$BATS_TEST_TMPDIR" && sh -c "$command")
    same "$command" "$(sed '1,/^\.Dl \$ /d' "$root/man/libdomino.3" | sed -n 's/^\.Dl //p')" "$output"
}
