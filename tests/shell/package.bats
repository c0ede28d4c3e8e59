#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The installed library, its headers, and the archive.
# bats file_tags=whole

load common

build=$(dirname "$DOMINO")

soname=libdomino.so.$(sed -n 's/^#define DOM_VERSION "\([0-9]*\).*"/\1/p' "$root/include/domino.h")

# These functions run the compiler on domino.h, and on domino_float.h or domino_quad.h.
header() { cc -std=c17 -I"$root/include" "$@" "$root/include/domino.h"; }

header_of() { cc -std=c17 -I"$root/include" -I"$build/include" -include "domino_$1.h" -x c /dev/null -E -P; }

# Runs make without the environment of the 'make' that runs the tests.
plain_make() {
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u MAKEOVERRIDES -u B -u CFLAGS -u CC make -s "$@"
}

# Installs into $dest, and makes pkg-config and the dynamic linker find the library there.
install_there() {
    dest=$PWD/dest
    plain_make -C "$root" B="$build" install DESTDIR="$dest" PREFIX=/usr
    export PKG_CONFIG_SYSROOT_DIR=$dest PKG_CONFIG_PATH=$dest/usr/lib/pkgconfig LD_LIBRARY_PATH=$dest/usr/lib
}

# Compiles and links with the installed shared library or, with --static, with the static one.
build_with() { # shared|--static FLAGS...
    local how=(-L"$dest/usr/lib")
    if [ "$1" = --static ]; then
        # There are no static sanitizer libraries, so with sanitizers only libdomino is linked
        # statically.
        if [ -z "$(checked "$build/libdomino.a")" ]; then how=(-static); else how=(-Lstatic); fi
        mkdir -p static && cp "$dest/usr/lib/libdomino.a" static
    fi
    cc "${@:2}" "${how[@]}" $(checked "$build/libdomino.a") $(pkg-config ${1#shared} --cflags --libs domino)
}

needed() { readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(libdomino.*\)\]/\1/p'; }

@test "a user builds the example with pkg-config from the installed files, and uninstall leaves nothing" {
    dest=$PWD/dest
    mkdir -p "$dest/usr/lib" "$dest/usr/share/man/man3" # these folders exist already, and one is not empty
    echo before >"$dest/usr/lib/other"
    find "$dest" | sort >before
    install_there
    [ -x "$dest/usr/bin/domino" ]
    [ -x "$dest/usr/share/doc/domino/examples/quiz.dom" ]
    for page in man1/domino.1 man3/libdomino.3 man7/domino-{effects,model,rows}.7; do [ -s "$dest/usr/share/man/$page" ]; done

    cp "$dest/usr/share/doc/domino/examples/rmax.c" .
    # Build as the first lines of the file say, and also without a shared library.
    for way in shared --static; do
        build_with $way rmax.c -o rmax
        libraries=$(needed rmax)
        if [ $way = shared ]; then same needed "$soname" "$libraries"; else same needed '(nothing)' "$libraries"; fi
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
    [[ $output = "rmax: s = 7: the separation s is outside its range" ]]
    run -2 ./rmax 0.4x
    same version "$(pkg-config --modversion domino)" "$("$DOMINO" --version | sed -n '1s/^domino //p')"

    plain_make -C "$root" B="$build" install DESTDIR="$dest" PREFIX=/usr # install over the existing files, as an upgrade does
    plain_make -C "$root" B="$build" uninstall DESTDIR="$dest" PREFIX=/usr
    find "$dest" | sort | diff -u before -
}

@test "with any PREFIX, even with blanks, programs and the Python example find the shared library there" {
    local prefix="$PWD/my app"
    plain_make -C "$root" B="$build" install PREFIX="$prefix"
    export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
    eval cc "'$prefix/share/doc/domino/examples/rmax.c'" -o rmax $(checked "$build/libdomino.a") "$(pkg-config --cflags --libs domino)"
    same rmax.c '1.64422903954, ends by barrier' "$(./rmax 0.4)"
    if [[ "$(checked "$build/libdomino.a")" != *sanitize* ]]; then
        same rmax.py '1.64422903954, ends by barrier' "$("$prefix/share/doc/domino/examples/rmax.py" 0.4)"
    fi
    plain_make -C "$root" B="$build" uninstall PREFIX="$prefix"
    [ ! -e "$prefix" ]
}

@test "the Python example gives the same output and status as the C example" {
    [[ "$(checked "$build/libdomino.a")" != *sanitize* ]] || skip "Python has no runtime of the sanitizers"
    install_there
    examples=$dest/usr/share/doc/domino/examples
    build_with shared "$examples/rmax.c" -o rmax
    run -0 env -u LD_LIBRARY_PATH LIBDOMINO="$dest/usr/lib/libdomino.so" "$examples/rmax.py" 0.4
    same "LIBDOMINO" "1.64422903954, ends by barrier" "$output"
    for arguments in 0.4 0.05 0.7 1 1e-6 0.001 0 7 -1 nan inf 0.4x '' '0.4 0.4' no; do
        run ./rmax $arguments
        in_c="$status: $output"
        run "$examples/rmax.py" $arguments
        same "rmax $arguments" "$in_c" "$status: ${output/rmax.py/rmax}"
    done
    run -2 "$examples/rmax.py" ''
}

@test "pkg-config passes -DDOM_NO_FLOAT128 if the library was built without __float128" {
    for flags in '' -DDOM_NO_FLOAT128; do
        pc=$PWD/pc$flags
        plain_make -C "$root" B="$pc" CFLAGS="-O2 $flags" "$pc/domino.pc" "$pc/include/domino_quad.h"
        same "Cflags" "Cflags: -I\${includedir}${flags:+ $flags}" "$(grep '^Cflags' "$pc/domino.pc")"
        cc -std=c17 $flags -I"$pc/include" -I"$root/include" -include domino_quad.h -x c /dev/null -E -P >"$pc/quad"
        grep -q 'domq_limit_rmax' "$pc/quad"
    done
    grep -q 'typedef long double domq_real;' "$pc/quad"
    same "__float128" '(nothing)' "$(grep __float128 "$pc/quad")"
}

@test "both libraries export the same names, which all begin with dom_ or domq_" {
    # In the archive, functions that its objects share are global too, but hidden.
    names=$(nm -g --defined-only "$build/libdomino.a" | awk 'NF == 3 { print $3 }')
    same "global names" '(nothing)' "$(grep -vE '^(dom[fq]?_|__asan|__odr_asan|__gcov)' <<<"$names")"
    readelf -sW "$build/libdomino.a" | awk '$5 == "GLOBAL" && $6 != "HIDDEN" && $7 ~ /^[0-9]+$/ { print $8 }' |
        sort >static
    # Each symbol of the shared library has the version of the soname.
    nm -D --defined-only "$build/libdomino.so" | awk -v v="@@DOMINO_${soname##*.}" '
        NF == 3 && $2 != "A" { if (sub(v "$", "", $3)) print $3; else print $3, "has no version" }' | sort >shared
    for way in static shared; do
        names=$way
        [ "$(grep -c '^dom_' "$names")" -gt 35 ]
        [ "$(grep -c '^domq_' "$names")" -gt 30 ]
        same "other names, $way" '(nothing)' "$(grep -vE '^(dom[fq]?_|__asan|__odr_asan|__gcov)' "$names")"
        grep -E '^dom[fq]?_' "$names" >"$names.api"
    done
    same_file static.api shared.api
    # The symbols are the functions and objects of the headers. dom_raised is an inline function.
    { header -E -P && header_of float && header_of quad && header -include "$root/include/domino_study.h" -include "$root/include/domino_proof.h" -E -P; } | tr '\n;' ' \n' | grep -vE '\btypedef |\bstatic ' >declarations
    {
        grep -oE '\bdom[fq]?_\w+ *\(' declarations | tr -d ' ('
        grep -oE '\bextern const struct dom[fq]?_effect [^[]*' declarations | grep -oE '\bdom[fq]?_\w+' | grep -vxE 'dom[fq]?_effect'
    } | sort -u >declared
    same_file declared static.api
}

@test "the interface is compatible with the first library of this soname, and the check reports incompatible changes" {
    kept=$root/tests/abi/$soname.txt
    now=$PWD/now.py
    python3 "$root/src/python/header.py" "$soname" cc "$root"/include/domino_{study,proof}.h >"$now"
    run -0 "$root/tests/abi/check" "$kept" "$now"
    while read -r status edit; do
        sed -E "$edit" "$now" >edited.py
        ! cmp -s "$now" edited.py || same "$edit" 'a change' 'none'
        run -"$status" "$root/tests/abi/check" "$kept" edited.py
    done <<'END'
1 s/DOM_BAD_R = 2/DOM_BAD_R = 3/
1 s/\("mu", c_double\)/("mu", c_int)/
1 /^ *"dom_limit_rmax":/d
1 s/(dom_rmax": \(c_double, \[)c_double, /\1/
0 s/^( *)DOM_EVENT_HIT = 4/&\n\1DOM_EVENT_NEW = 5/
0 s/^FUNCTIONS = \{/class dom_new(Structure):\n    pass\nFUNCTIONS = {/
END
    # Another effect adds a member, and the check says what to do.
    sed -E 's/\("mu", c_double\),/& ("drag", c_double),/' "$now" >effect.py
    run -1 "$root/tests/abi/check" "$kept" effect.py
    for words in 'dom_train: has changed' 'dom_row: has changed' "needs a new major version in domino.h; before the release of a version, 'make abi KEEP=1' accepts it"; do
        grep -qE "$words" <<<"$output" || same 'a new effect' "$words" "$output"
    done
    "$root/tests/abi/check" effect.py >kept
    run -0 "$root/tests/abi/check" kept effect.py
}

@test "the headers compile as C and as C++, in any order, and domino.h has no type wider than double" {
    languages='cc:-std=c99 cc:-std=c17'
    if command -v g++ >/dev/null; then languages+=' g++:-std=c++11 g++:-std=c++17'; fi
    for language in $languages; do
        for order in 'domino domino_quad domino_float' 'domino_float domino_quad domino' domino domino_quad domino_float; do
            printf '#include <%s.h>\n' $order >both.cpp
            echo 'int main(void) { return dom_rmax(0.4, 0.1, 4) > 1 && !dom_raised(NULL) ? DOM_OK : DOM_STOPS; }' \
                >>both.cpp
            cp both.cpp both.c
            file=both.c
            [[ $language = cc:* ]] || file+=pp
            "${language%:*}" "${language#*:}" -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I"$root/include" \
                -I"$build/include" "$file"
        done
    done
    for flags in -std=c17 -DDOM_NO_FLOAT128 -DDOMQ; do
        header -E -P $flags >header
        grep -q dom_limit_rmax header
        same "wider than double, $flags" '(nothing)' "$(grep dom header | grep -E '__float128|_Float128|\bdomq_')"
    done
    header_of quad >header
    grep -q domq_limit_rmax header && grep -q '\bdom_limit_rmax' header
}

@test "make dist packs the tracked files, and the unpacked archive builds without git and with -flto, and packs the same bytes" {
    [ -z "$(checked "$build/libdomino.a")" ] || skip "the same archive in every build"
    dist=$PWD/dist
    plain_make -C "$root" B="$dist" dist
    archive=$(echo "$dist"/domino-*.tar.gz)
    name=$(basename "$archive" .tar.gz)
    if [ -e "$root/.git" ] && git -C "$root" rev-parse HEAD >/dev/null 2>&1; then
        tar -tzf "$archive" | sed "s|^$name/||" | sort | diff -u <({ git -C "$root" ls-files && echo COPYING; } | sort) -
    fi
    tar -xzf "$archive"
    [ ! -e /usr/share/common-licenses/GPL-3 ] || cmp /usr/share/common-licenses/GPL-3 "$name/COPYING"
    tree=$PWD/$name
    [ ! -e "$tree/.git" ]
    plain_make -C "$tree" -j2 CFLAGS='-O0 -flto=auto' all dist
    same "the quiz" "$("$DOMINO" -e 'count 112')" "$("$tree/.build/domino" -n -e 'count 112')"
    "$tree/.build/domino" -n -f "$tree/examples/quiz.dom" | diff -u "$tree/tests/shell/golden/quiz.out" -
    cmp "$archive" "$tree/.build/$name.tar.gz"
}

@test "a C++ program gets the same answers" {
    command -v g++ >/dev/null || skip "no compiler of C++"
    cat >both.cc <<'END'
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
    std::printf("%.9g %.9g\n", limit.r_max, static_cast<double>(wide_limit.r_max));
}
END
    g++ -std=c++11 -Wall -Wextra -Werror -I"$root/include" -I"$build/include" both.cc "$build/libdomino.a" $(checked "$build/libdomino.a") -lgsl -lgslcblas -lm -pthread \
        -o both
    local expected
    expected=$("$DOMINO" -e 'set output csv; rmax' | sed -n '2s/^[^,]*,\([^,]*\),.*/\1/p')
    [ -n "$expected" ]
    [ "$(./both)" = "$(printf '%.9g %.9g' "$expected" "$expected")" ]
}

@test "Debian packages: they work when installed into a separate root, and lintian finds no error" {
    command -v dpkg-shlibdeps >/dev/null || skip 'dpkg-dev is not installed'
    if [ -n "$(checked "$build/libdomino.a")" ]; then skip 'packages are not made of a build with sanitizers'; fi
    plain_make -C "$root" B="$build" deb >deb.log
    local fresh=$PWD/root
    mkdir -p "$fresh"/var/lib/dpkg/{info,updates,triggers}
    touch "$fresh/var/lib/dpkg/status"
    # The dependencies are not installed in this root, so dpkg must not insist on them.
    if [ "$(id -u)" -eq 0 ]; then
        dpkg --root="$fresh" --force-depends --force-script-chrootless -i "$build"/deb/*.deb >dpkg.log 2>&1
    else
        for package in "$build"/deb/*.deb; do dpkg-deb -x "$package" "$fresh"; done
    fi
    same packages 'domino libdomino libdomino-dev python3-domino' \
        "$(basename -a "$build"/deb/*.deb | sed -E 's/_.*//; s/^(libdomino)[0-9].*/\1/' | LC_ALL=C sort | tr '\n' ' ' | sed 's/ $//')"

    local lib
    lib=$(dirname "$fresh"/usr/lib/*/libdomino.a)
    same quiz '20' "$("$fresh/usr/bin/domino" -n -e 'set output json; count 112 m' | values dominoes)"
    PKG_CONFIG_SYSROOT_DIR=$fresh PKG_CONFIG_PATH=$lib/pkgconfig
    export PKG_CONFIG_SYSROOT_DIR PKG_CONFIG_PATH
    cc "$fresh/usr/share/doc/domino/examples/rmax.c" -o rmax $(pkg-config --cflags --libs domino)
    same C '1.64422903954, ends by barrier' "$(LD_LIBRARY_PATH=$lib ./rmax 0.4)"
    same Python 20 "$(LD_LIBRARY_PATH=$lib PYTHONPATH=$fresh/usr/lib/python3/dist-packages python3 -B -c \
        'import domino; print(domino.count(112).dominoes)')"
    for package in "$build"/deb/*.deb; do
        [[ $package = *python3* || $(dpkg-deb -f "$package" Depends) =~ libc6|libdomino ]]
    done
    if command -v lintian >/dev/null; then run -0 lintian --fail-on error "$build"/deb/*.deb; fi
}

@test "a part of the library is installed without a shared library, a pkg-config file and a Python module" {
    plain_make -n -C "$root" B="$build" P="$PWD/part" install FEATURES= >commands
    grep -q "'$PWD/part/libdomino.a'" commands
    [ "$(grep -cE "$soname'|domino\.pc'|python/domino" commands)" = 0 ]
}
