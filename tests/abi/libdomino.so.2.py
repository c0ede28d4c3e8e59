"""The structures and functions of libdomino, generated from its headers by header.py."""

from ctypes import (CFUNCTYPE, POINTER, Structure, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint,
                    c_ulong, c_void_p)
from enum import IntEnum

SONAME = "libdomino.so.2"


class dom_proof_gap(IntEnum):
    DOM_PROOF_NONE = 0
    DOM_PROOF_EFFECT = 1
    DOM_PROOF_ROUNDING = 2
    DOM_PROOF_BOXES = 3
    DOM_PROOF_INTERRUPTED = 4
    DOM_PROOF_MODE = 5


class dom_proof_end(IntEnum):
    DOM_PROVED_BARRIER = 0
    DOM_PROVED_REACH = 1
    DOM_PROVED_NONE = 2
    DOM_PROVED_PARTLY = 3


class dom_proof_verdict(IntEnum):
    DOM_PROVED_GOES_ON = 0
    DOM_PROVED_STOPS = 1
    DOM_PROVED_NO_FUEL = 2
    DOM_PROVED_OUT_OF_REACH = 3
    DOM_PROVED_NOTHING = 4


class dom_proof_work(Structure):
    pass


class dom_proof(Structure):
    pass


class dom_interval(Structure):
    pass


class dom_proof_cycle(Structure):
    pass


dom_proof_work._fields_ = [
    ("boxes", c_size_t),
    ("chains", c_size_t),
]
dom_proof._fields_ = [
    ("ends", c_int),
    ("from", c_double),
    ("low", c_double),
    ("high", c_double),
    ("decimals", c_int),
    ("gap", c_int),
    ("work", dom_proof_work),
]
dom_interval._fields_ = [
    ("low", c_double),
    ("high", c_double),
]
dom_proof_cycle._fields_ = [
    ("verdict", c_int),
    ("kinetic", dom_interval),
    ("barrier", dom_interval),
    ("margin", dom_interval),
    ("gap", c_int),
    ("work", dom_proof_work),
]

# For each function the type of its result, and those of its parameters.
FUNCTIONS = {
    "dom_proof_gap_text": (c_char_p, [c_int]),
    "dom_prove_rmax": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_proof)]),
    "dom_prove_pair": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_proof)]),
    "dom_prove_cycle": (c_int, [POINTER(dom_train), POINTER(dom_compute), POINTER(dom_proof_cycle)]),
    "dom_prove_count": (c_int, [c_double, c_double, c_double, POINTER(c_double), POINTER(c_double)]),
}
