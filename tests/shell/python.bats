#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# The Python module: its tests and its installation.
# bats file_tags=whole

load common

build=$(dirname "$DOMINO")

setup() {
    cd "$BATS_TEST_TMPDIR" || return
    if [ -n "$(checked "$build/libdomino.a")" ]; then skip 'Python does not load a library with sanitizers'; fi
}

@test "the module gives the same answers as the program, also for arrays, and errors name the parameter" {
    export DOMINO_LIBRARY=$build/libdomino.so PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1
    run python "$root/tests/python/test_domino.py"
    [ "$status" -eq 0 ] || { echo "$output" && false; }
    [[ $output =~ 'Ran '[0-9]+' tests' ]]
}

@test "an installed module finds its library without an environment variable, even without NumPy" {
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u MAKEOVERRIDES make -s -C "$root" B="$build" install PREFIX="$PWD/my prefix" \
        PYTHONDIR=lib/python3/dist-packages >install.log
    cat >quiz.py <<'END'
import sys
sys.modules["numpy"] = None
import domino
print(domino.count(112).dominoes, domino.rmax(0.4).ends, domino.Row.of_train(5).verdict().falls)
END
    run env -u DOMINO_LIBRARY PYTHONPATH="$PWD/my prefix/lib/python3/dist-packages" PYTHONDONTWRITEBYTECODE=1 \
        "$(python -c 'import sys; print(sys.executable)')" quiz.py
    same quiz '20 barrier True' "$output"
}
