#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Computes scenes in parts with GNU parallel, on the processors of this machine. With PARALLEL='--sshlogin ...' in the
# environment, the parts run on other machines that share FOLDER.
#
#   parallel.sh [PARTS] [FOLDER] [SCENE...]     writes FOLDER/SCENE.csv for each scene; by default for sweep.dom
#
# A part whose program is killed is computed again, at most twice. If the script itself was stopped, run it again: it
# computes only the parts that are missing. The parts are in FOLDER/SCENE.parts.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
parts=${1:-8}
folder=${2:-.}
shift $(($# < 2 ? $# : 2))
[ $# -gt 0 ] || set -- "$here/sweep.dom"

# GNU parallel computes one part per processor at a time, so each part uses one thread.
for scene; do
    name=$(basename "$scene" .dom)
    mkdir -p "$folder/$name.parts"
    seq -w "$parts" | parallel --quote --retries 3 --halt now,fail=1 \
        "$here/part.sh" "$scene" {} "$parts" "$folder/$name.parts/{}.csv"
    cat "$folder/$name.parts"/*.csv >"$folder/$name.csv"
done
