#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the time of a NumPy array in the Python module with the time of the library's own loop over the same trains.
Both run on one core.

usage: numpy_loop.py BUILD
"""
import ctypes
import os
import sys
import time

build = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else ".build")
os.environ["DOMINO_LIBRARY"] = build + "/libdomino.so"
sys.path.insert(0, build + "/python")
sys.dont_write_bytecode = True
if hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
try:
    import numpy
except ImportError:
    print("\nThe Python module on arrays: not measured, since this Python has no NumPy")
    sys.exit(0)
import domino  # noqa: E402
from domino import _api as api  # noqa: E402
from domino._library import computing, lib  # noqa: E402

GOAL, REPEATS = 1.2, 25
separations = numpy.linspace(0.1, 0.9, 1000)
count = len(separations)
trains = (api.dom_train * count)()
for train, s in zip(trains, separations):
    ctypes.pointer(train)[0] = lib.dom_train_default()
    train.s = s
answers, statuses = (api.dom_limit * count)(), (ctypes.c_int * count)()
compute = computing(None)


def loop():
    lib.dom_trains_ask(api.dom_question.DOM_ASK_RMAX, trains, None, count, ctypes.byref(compute), answers, statuses)
    return numpy.array([answer.r_max for answer in answers])


def seconds(function):
    """Returns the processor time of all threads, which other programs hardly affect."""
    begun = time.process_time()
    function()
    return time.process_time() - begun


if not numpy.array_equal(loop(), domino.rmax(separations).r_max):
    sys.exit("numpy_loop.py: the module and the loop differ")
in_c = in_numpy = float("inf")
for _ in range(REPEATS):  # the two take turns
    in_c = min(in_c, seconds(lambda: lib.dom_trains_ask(api.dom_question.DOM_ASK_RMAX, trains, None, count,
                                                        ctypes.byref(compute), answers, statuses)))
    in_numpy = min(in_numpy, seconds(lambda: domino.rmax(separations)))
print(f"\nThe Python module: domino.rmax of an array of {count}, on one core: {1e3 * in_numpy:.2f} ms; the library's own "
      f"loop: {1e3 * in_c:.2f} ms")
print(f"  times as long: {in_numpy / in_c:.3f}; at most {GOAL}: {'met' if in_numpy <= GOAL * in_c else 'NOT MET'}")
