#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The sweep and the study of placement in parts, under GNU parallel: on the processors of this machine, or
# with its option --sshlogin on those of others.
#
#   parallel.sh [PARTS] [FOLDER]     FOLDER/sweep.csv and, of the study, blocks.csv and its answer, placement.csv
set -eu
here=$(cd "$(dirname "$0")" && pwd)
parts=${1:-8}
folder=${2:-.}
domino=${DOMINO:-domino}

# Each part computes on one thread, since as many parts run together as there are processors. --keep-order
# concatenates their outputs in order: the same bytes as without --shard.
in_parts() { # FILE.dom
    seq "$parts" | parallel --quote --keep-order --halt now,fail=1 \
        "$domino" --shard "{}/$parts" -e 'set threads 1' -f "$1"
}

in_parts "$here/sweep.dom" >"$folder/sweep.csv"

# A part of a study is counts of rows, and their sum is the answer.
in_parts "$here/placement.dom" >"$folder/blocks.csv"
"$domino" -e 'set output csv' -e 'pool -' <"$folder/blocks.csv" >"$folder/placement.csv"
