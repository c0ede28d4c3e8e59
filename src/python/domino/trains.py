# SPDX-License-Identifier: GPL-3.0-or-later
"""Questions about trains: endless rows, each domino r times as large as the one before."""

from __future__ import annotations

import ctypes
import functools
import math
from typing import Any, Callable, Union

from . import _api as api
from ._library import (CORES, DominoError, OutOfRange, computing, effect_members, interruptible, lib, number_of,
                       raise_status, record, run, run_all, status_name)  # fmt: skip

Number = Union[float, Any]  # a number, or anything that NumPy turns into an array of numbers

MASSES = {"hollow": 3.0, "solid": 4.0, "massive": 4.0}
FUELS = {"exact": api.dom_fuel.DOM_FUEL_EXACT, "paper": api.dom_fuel.DOM_FUEL_PAPER}

# The names of the fields are those of the structures of the library.
Angles = record("Angles", "theta_c theta_u theta_inf theta_f theta_leave detaches", "The angles of a cycle in rad.")
Contact = record("Contact", "theta_1 slope arm_a arm_b",
                 "A domino at a tilt, and its follower: theta_1 in rad, d theta_1 / d theta, and the arms of the force.")  # fmt: skip
Energy = record("Energy", "dH J J0", "H(theta) - H(0), J(theta) and J(0), in m g h / 2 of the head.")
Fuel = record("Fuel", "exact paper", "The energy that a cycle releases, from the energy balance and by the paper's formula.")
Launch = record("Launch", "fuel J0 velocity_ratio omegasq kinetic", "The motion right after a collision.")
Barrier = record("Barrier", "theta_m barrier kinetic margin stop", """The barrier of a cycle.

    The train keeps falling if margin = kinetic - barrier is not negative. stop is the tilt in rad at which a train that
    stops comes to rest.""")
Limit = record("Limit", "r_max ends", 'The largest growth, and its limit: "barrier", "reach", or "none" if even equal dominoes stop.')
Best = record("Best", "s r_max", "The separation that allows the largest growth, and the growth.")
Count = record("Count", "dominoes exact last",
               "The number of dominoes that topple a height, ln(height/first) / ln r, and the height of the last domino in m.")  # fmt: skip
Proof = record("Proof", "low high ends gap",
               'What is proved: low <= r_max <= high, what limits r_max, and why a proof is incomplete ("" if complete).')  # fmt: skip


class Train:
    """The parameters of a train, which are checked by every question.

    The effects are those of domino-effects(7), which are off at 0: friction, slope (rad), edges (radius over height),
    walls (over the height), air (its density over that of the dominoes), and drag, its coefficient if it is not 1.2.
    """

    def __init__(self, s: Number = 0.4, r: Number = 1.5, d: Number = 7 / 48, q: Number | str = 4.0, *,
                 width: Number = 0.5, fuel: str = "exact", **effects: Number):  # fmt: skip
        q = number_of(q, MASSES, "q") if isinstance(q, str) else q
        self.values = {"s": s, "r": r, "d": d, "q": q, "width": width, **effect_members(effects)}
        self.fuel = int(number_of(fuel, FUELS, "fuel"))

    def structure(self) -> ctypes.Structure:
        """Returns the struct dom_train for a train whose parameters are numbers."""
        return api.dom_train(fuel=self.fuel, **{name: float(value) for name, value in self.values.items()})

    def __repr__(self) -> str:
        return "Train({})".format(", ".join(f"{name}={self.values[name]!r}" for name in "srdq"))


def _is_array(value: Any) -> bool:
    return not isinstance(value, (int, float, str)) and hasattr(value, "__len__") and getattr(value, "ndim", 1) > 0


def _ask(question: int, kind: type, train: Train, tilt: Any, tol: float | None, accepted: tuple[str, ...]) -> Any:
    """Returns the structure with the result for one train, or the array of results for many trains.

    Statuses of `accepted` come with an answer. Other statuses raise an error for one train, and for the parameters of
    many; a train among many that has no answer gets NaN.
    """
    compute = computing(tol)
    values = train.values if tilt is None else {**train.values, "tilt": tilt}
    if any(map(_is_array, values.values())):
        return _ask_many(question, kind, train.fuel, values, compute, accepted)
    one, answer, status = train.structure(), kind(), ctypes.c_int()
    angle = ctypes.c_double(math.nan if tilt is None else float(tilt))
    with interruptible(compute):
        run(lib.dom_trains_ask, question, ctypes.byref(one), ctypes.byref(angle), 1, ctypes.byref(compute),
            ctypes.byref(answer), ctypes.byref(status))  # fmt: skip
    if status_name(status.value) not in accepted:
        raise_status(status.value)
    return answer


def _ask_many(question: int, kind: type, fuel: int, values: dict[str, Any], compute: Any,
              accepted: tuple[str, ...]) -> Any:  # fmt: skip
    import numpy as np

    arrays = {name: np.asarray(value, float) for name, value in values.items()}
    shape = np.broadcast_shapes(*[array.shape for array in arrays.values()])
    trains, tilts = np.zeros(shape, _dtype(api.dom_train)), np.zeros(shape)
    trains["fuel"] = fuel
    for name, array in arrays.items():
        (tilts if name == "tilt" else trains[name])[...] = array
    count = trains.size
    answers, statuses = np.zeros(count, _dtype(kind)), np.zeros(count, np.intc)
    # There are more parts than cores, since some parts take longer than others.
    ends = np.linspace(0, count, (min(8 * CORES, max(count // 4, 1)) if CORES > 1 else 1) + 1).astype(int)

    def part(low: int, high: int) -> Any:
        def at(array: Any, type: type) -> Any:
            return ctypes.cast(array.ctypes.data + int(low) * array.itemsize, type)

        return lambda: lib.dom_trains_ask(
            question, at(trains, ctypes.POINTER(api.dom_train)), at(tilts, ctypes.POINTER(ctypes.c_double)),
            int(high - low), ctypes.byref(compute), at(answers, ctypes.c_void_p),
            at(statuses, ctypes.POINTER(ctypes.c_int)))  # fmt: skip

    with interruptible(compute):
        run_all([part(low, high) for low, high in zip(ends, ends[1:])])
    for status in np.unique(statuses):
        name = status_name(status)
        if name.startswith("BAD_") or name in ("INTERRUPTED", "NO_MEMORY", "NO_METHOD", "NO_PRECISION"):
            first = int(np.flatnonzero(statuses == status)[0])
            raise_status(int(status), f", at the index {tuple(map(int, np.unravel_index(first, shape)))}")
        if name != "OK" and name not in accepted:
            _set_nan(answers, statuses == status)
    return answers.reshape(shape)


@functools.cache
def _dtype(structure: type) -> Any:
    """Returns the NumPy dtype of a structure. Creating a dtype takes as long as computing a hundred results."""
    import numpy as np

    return np.dtype(structure)


def _set_nan(answers: Any, where: Any) -> None:
    """Sets all numbers of these results to NaN, including those in nested structures."""
    for name in answers.dtype.names or ():
        _set_nan(answers[name], where)
    if answers.dtype.kind == "f":
        answers[where] = math.nan


def _limit_text(ends: Any) -> Any:
    if not hasattr(ends, "dtype"):
        return lib.dom_end_text(ends).decode()
    import numpy as np

    return np.array([lib.dom_end_text(end).decode() for end in api.dom_end])[ends]


def _question(name: str, asked: str, kind: type, result: type | None, doc: str, *, has_tilt: bool = False,
              accepted: tuple[str, ...] = ()) -> Callable[..., Any]:  # fmt: skip
    """Returns the function that asks the library a question about a train; with `has_tilt`, also about a tilt."""
    question = api.dom_question["DOM_ASK_" + asked]

    def ask(tilt: Any, s: Number, tol: float | None, train: dict[str, Any]) -> Any:
        answer = _ask(question, kind, Train(s, **train), tilt, tol, accepted)
        get = (lambda field: answer[field]) if hasattr(answer, "dtype") else functools.partial(getattr, answer)
        if result is None:
            return answer if hasattr(answer, "dtype") else answer.value
        found = result(*map(get, result._fields))
        return found._replace(ends=_limit_text(found.ends)) if result is Limit else found

    def at_tilt(theta: Number, s: Number = 0.4, *, tol: float | None = None, **train: Any) -> Any:
        return ask(theta, s, tol, train)

    def of_train(s: Number = 0.4, *, tol: float | None = None, **train: Any) -> Any:
        return ask(None, s, tol, train)

    function = at_tilt if has_tilt else of_train
    function.__name__ = function.__qualname__ = name
    function.__doc__ = doc
    return function


angles = _question("angles", "ANGLES", api.dom_angles, Angles,
                   "The angles that bound a cycle (2; a2), (4; b1), (40; A16), (42; A18).")  # fmt: skip
theta1 = _question("theta1", "CONTACT", api.dom_contact, Contact,
                   "The tilt of the follower of a domino that leans at theta, in rad (12; b8).", has_tilt=True)  # fmt: skip
energy = _question("energy", "ENERGY", api.dom_energy, Energy,
                   "The energy and the inertia of the train whose head leans at theta, in rad (19; c1) (20; c2).", has_tilt=True)  # fmt: skip
fuel = _question("fuel", "FUEL", api.dom_fuels, Fuel, "The energy that one cycle releases (25; c7).")
launch = _question("launch", "LAUNCH", api.dom_launch, Launch, "The motion right after a collision (24; c6).")
barrier = _question("barrier", "BARRIER", api.dom_barrier, Barrier, """The barrier of a cycle, and the energy left at its top (26; c8).

    The train keeps falling if margin >= 0.""", accepted=("STOPS", "NO_FUEL"))
omegasq = _question("omegasq", "OMEGASQ", ctypes.c_double, None,
                    "tau^2 omega(theta)^2 of the head between one collision and the next (21; c3).", has_tilt=True)  # fmt: skip
duration = _question("duration", "DURATION", ctypes.c_double, None, "The duration of a cycle, from one collision to the next, in tau.")
rmax = _question("rmax", "RMAX", api.dom_limit, Limit, "The largest growth of a train at the separation s; r is not used.")
pair = _question("pair", "PAIR", api.dom_limit, Limit,
                 "The largest growth of two dominoes, the first of which tips over its edge from rest; r is not used.")  # fmt: skip
best = _question("best", "BEST", api.dom_best, Best,
                 "The separation that allows the largest growth, and the growth; s and r are not used.")  # fmt: skip


def count(height: float, r: float = 1.5, *, first: float = 0.048) -> Count:
    """How many dominoes topple one of this height in m, each r times as tall as the one before."""
    c = api.dom_count()
    raise_status(lib.dom_count_find(first, height, r, ctypes.byref(c)))
    return Count(int(c.dominoes) if math.isfinite(c.dominoes) else c.dominoes, c.exact, c.last)


def prove(what: str = "rmax", s: float = 0.4, *, tol: float = 1e-12, **train: Any) -> Proof:
    """Proves bounds on the largest growth of a train ("rmax") or of two dominoes ("pair") by interval arithmetic."""
    function = number_of(what, {"rmax": lib.dom_prove_rmax, "pair": lib.dom_prove_pair}, "what")
    t, compute, proof = Train(s, **train), computing(tol), api.dom_proof()
    with interruptible(compute):
        status = run(function, ctypes.byref(t.structure()), ctypes.byref(compute), ctypes.byref(proof))
    raise_status(status)
    ends = ["barrier", "reach", "none", "partly"][proof.ends]
    gap = lib.dom_proof_gap_text(proof.gap).decode() if proof.gap else ""
    if proof.gap == api.dom_proof_gap.DOM_PROOF_EFFECT:
        raise DominoError(gap, "NO_METHOD")
    return Proof(proof.low, proof.high, ends, gap)
