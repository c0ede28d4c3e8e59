#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The README and the man pages.
# bats file_tags=whole

load common

digits() {
    sed -E -e 's/([0-9]\.[0-9]{12})[0-9]+/\1/g' -e '${/^$/d}'
}

build=$(dirname "$DOMINO")

@test "domino-effects(7) has a section for each effect, with an example that runs" {
    page=$root/man/domino-effects.7
    same effects "$(json help | grep '"kind":"effect"' | values name | sort)" "$(sed -n 's/^\.Ss //p' "$page" | sort)"
    sed -n 's/^\.Dl //p' "$page" >examples
    same examples "$(grep -c '^\.Ss ' "$page")" "$(wc -l <examples)"
    while IFS= read -r example; do
        run -0 --separate-stderr "$DOMINO" -n --bail -e "$example"
        expects "$example" "$output"
        same "$example: errors" '(nothing)' "$stderr"
    done <examples
}

@test "every name or beginning of a name in libdomino(3) exists in the headers" {
    cat "$root"/include/*.h "$build"/include/domino_{float,quad}.h >headers
    grep -oE '\b(dom|DOM)q?_\w+' "$root/man/libdomino.3" | sort -u >names
    [ "$(wc -l <names)" -gt 20 ]
    while read -r name; do
        grep -q "\b${name/domq_/dom_}" headers || { echo "$name"; false; }
    done <names
}

@test "the example in libdomino(3) is examples/rmax.c, and does what the page says" {
    # The first line of the file, which is the licence, is left out.
    sed -n '/^\.Bd -literal/,/^\.Ed/{/^\./d;s/\\e/\\/g;p}' "$root/man/libdomino.3" >"$BATS_TEST_TMPDIR/rmax.c"
    diff -u <(sed 1d "$root/examples/rmax.c") "$BATS_TEST_TMPDIR/rmax.c"
    cc -std=c99 -Wall -Wextra -Wpedantic -Werror -I"$root/include" "$BATS_TEST_TMPDIR/rmax.c" "$build/libdomino.a" \
        $(checked "$build/libdomino.a") -lgsl -lgslcblas -lm -pthread -o "$BATS_TEST_TMPDIR/rmax"
    command=$(sed -n 's/^\.Dl \$ //p' "$root/man/libdomino.3")
    output=$(cd "$BATS_TEST_TMPDIR" && sh -c "$command")
    same "$command" "$(sed '1,/^\.Dl \$ /d' "$root/man/libdomino.3" | sed -n 's/^\.Dl //p')" "$output"
}

@test "domino(1) has every option and environment variable" {
    page=$root/man/domino.1
    "$DOMINO" --help | grep -o -- '--[a-z-]*' | sort -u >options
    [ "$(wc -l <options)" -ge 7 ]
    while read -r option; do
        grep -qE -- "(Fl Fl|Fl) ${option#--}( |$)" "$page" || { echo "option $option"; false; }
    done <options
    grep -rho 'getenv("[A-Z_]*")\|line_path("[A-Z_]*"' "$root"/src | sed 's/.*"\(.*\)".*/\1/' | sort -u \
        >environment
    [ "$(wc -l <environment)" -ge 5 ]
    while read -r name; do
        grep -q "^\.It Ev $name\$" "$page" || { echo "environment $name"; false; }
    done <environment
}

@test "the sessions of the README and the man pages are what the program prints" {
    # The last of 17 digits may depend on the C library's sine.
    PATH=$(dirname "$DOMINO"):$PATH
    commands=0
    for text in "$root/README.md" "$root"/man/*.[0-9]; do
        "$root/tests/sessions" "$text" >now
        if [ "${GOLDEN:-}" = write ]; then cp now "$text"; fi
        digits <"$text" >said
        digits <now >says
        same_file said says
        commands=$((commands + $(grep -cE '^\$ (domino|for) ' "$text" || :)))
    done
    [ "$commands" -ge 5 ]
}

@test "links of the README lead to files, and its picture is small" {
    pictures=$(grep -oE '\(examples/pictures/[^)]*\)' "$root/README.md" | tr -d '()')
    expects pictures "$pictures"
    for picture in $pictures; do
        [ "$(wc -c <"$root/$picture")" -lt 300000 ]
        grep -qE '^(GIF89a|<\?xml)' "$root/$picture"
    done
    # Links lead to files.
    for link in $(grep -oE '\]\([a-z][^:)]*\)' "$root/README.md" | tr -d ']()'); do
        [ -e "$root/$link" ] || { echo "$link"; false; }
    done
}
