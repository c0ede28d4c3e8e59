#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Computes part I of N of a scene into a file, unless the file is there already. The file gets its name only when it is
# complete, so that only missing parts are computed again.
#
#   part.sh SCENE I N FILE
set -eu
[ -e "$4" ] && exit
"${DOMINO:-domino}" --shard "$2/$3" -e "set threads ${THREADS:-1}" -f "$1" >"$4.new.$$" || {
    rm -f "$4.new.$$"
    exit 1
}
mv "$4.new.$$" "$4"
