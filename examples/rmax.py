#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest growth at a separation. Does the same as rmax.c, through ctypes and the shared library.

usage: rmax.py SEPARATION
"""
import ctypes
import ctypes.util
import os
import sys

# The structures of domino.h; enumerations are C's int.
REAL = ctypes.c_double


class Train(ctypes.Structure):
    """struct dom_train, with room for the members of effects that are not used here"""
    _fields_ = [(name, REAL) for name in "srdq"] + [("fuel", ctypes.c_int), ("effects", REAL * 16)]


class Limit(ctypes.Structure):
    """struct dom_limit, with struct dom_limit_error at its end"""
    _fields_ = [("r_max", REAL), ("ends", ctypes.c_int), ("why", ctypes.c_int), ("error_r_max", REAL)]


def library():
    """Loads libdomino: the file that $LIBDOMINO names, the library installed with this example, or any other."""
    installed = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../../../lib/libdomino.so")
    domino = ctypes.CDLL(os.environ.get("LIBDOMINO")
                         or (installed if os.path.exists(installed) else None)
                         or ctypes.util.find_library("domino") or "libdomino.so")
    domino.dom_train_default.restype = Train
    domino.dom_limit_rmax.argtypes = [ctypes.POINTER(Train), ctypes.c_void_p, ctypes.POINTER(Limit)]
    for text in domino.dom_status_text, domino.dom_end_text:
        text.restype = ctypes.c_char_p
    return domino


def main(arguments):
    try:
        (separation,) = map(float, arguments)
    except ValueError:
        print("usage: rmax.py SEPARATION", file=sys.stderr)
        return 2
    domino = library()
    train = domino.dom_train_default()
    train.s = separation
    limit = Limit()
    status = domino.dom_limit_rmax(train, None, limit) or limit.why
    if status:
        print(f"rmax: s = {separation:g}: {domino.dom_status_text(status).decode()}", file=sys.stderr)
        return 1
    print(f"{limit.r_max:.12g}, ends by {domino.dom_end_text(limit.ends).decode()}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
