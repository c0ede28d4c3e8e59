#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The public headers as a compiler of C and one of C++ see them.
# shellcheck disable=SC2030,SC2031,SC2154 # 'run' and 'load' set variables, each test is a subshell

load common

setup() {
    root=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    build=$(cd "$(dirname "$DOMINO")" && pwd)
    includes=(-I"$root/include" -I"$build/include")
}

# Prints what the compiler makes of a header: LANGUAGE HEADER [OPTION...]
preprocessed() {
    local language=$1 header=$2
    shift 2
    echo "#include <$header>" | cc -E -P "${includes[@]}" "$@" -x "$language" -
}

@test "domino.h shows no type wider than double" {
    local text
    for flags in '' -DDOM_NO_FLOAT128 -std=c17 -DDOMQ; do
        text=$(preprocessed c domino.h ${flags:+"$flags"})
        grep -q 'dom_limit_rmax' <<<"$text"
        run ! grep -nE '__float128|_Float128|\bdomq_' <<<"$(grep -E 'dom' <<<"$text")"
    done
}

@test "domino_quad.h names its own functions domq_, and has those of domino.h" {
    local text
    text=$(preprocessed c domino_quad.h)
    grep -q 'domq_limit_rmax' <<<"$text"
    grep -q 'dom_limit_rmax' <<<"$text"
}

@test "both headers compile in C and C++, and a program in C++ gets the answers" {
    local source=$BATS_TEST_TMPDIR/both.cc
    for header in domino.h domino_quad.h; do
        echo "#include <$header>" | cc -std=c17 -Wall -Wextra -Wpedantic -Werror -fsyntax-only "${includes[@]}" -x c -
    done
    command -v g++ >/dev/null || skip "no compiler of C++"
    cat >"$source" <<'END'
#include <domino_quad.h>
#include <cstdio>

int main()
{
    dom_train train = dom_train_default();
    dom_limit limit;
    domq_train wide = domq_train_default();
    domq_limit wide_limit;
    if (dom_limit_rmax(&train, nullptr, &limit) != DOM_OK || domq_limit_rmax(&wide, nullptr, &wide_limit) != DOM_OK)
        return 1;
    std::printf("%.9g %.9g %g\n", limit.r_max, static_cast<double>(wide_limit.r_max), dom_dominoes(0.048, 112, 1.5));
}
END
    # shellcheck disable=SC2046
    g++ -std=c++11 -Wall -Wextra -Werror "${includes[@]}" "$source" "$build/libdomino.a" $(checked "$build/libdomino.a") -lgsl -lgslcblas -lm -pthread \
        -o "$BATS_TEST_TMPDIR/both"
    local expected
    expected=$("$DOMINO" -e 'set output csv; rmax' | sed -n '2s/^[^,]*,\([^,]*\),.*/\1/p')
    [ -n "$expected" ]
    [ "$("$BATS_TEST_TMPDIR/both")" = "$(printf '%.9g %.9g 20' "$expected" "$expected")" ]
}
