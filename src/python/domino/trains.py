# SPDX-License-Identifier: GPL-3.0-or-later
"""Questions about trains: endless rows, each domino r times as large as the one before."""

from __future__ import annotations

import ctypes
import functools
import math
from typing import Any, NamedTuple, Union

from . import _api as api
from ._library import (DominoError, OutOfRange, computing, CORES, interruptible, lib, raise_status, run, run_all)

Number = Union[float, Any]  # a number, or anything that NumPy turns into an array of numbers

MASSES = {"hollow": 3.0, "solid": 4.0, "massive": 4.0}
FUELS = {"exact": api.dom_fuel.DOM_FUEL_EXACT, "paper": api.dom_fuel.DOM_FUEL_PAPER}


class Angles(NamedTuple):
    """The angles of a cycle in rad."""

    theta_c: Number
    theta_u: Number
    theta_inf: Number
    theta_f: Number
    theta_leave: Number
    detaches: Any


class Contact(NamedTuple):
    """A domino at a tilt, and its follower: theta_1 in rad, d theta_1 / d theta, and the arms of the force."""

    theta_1: Number
    slope: Number
    arm_a: Number
    arm_b: Number


class Energy(NamedTuple):
    """H(theta) - H(0), J(theta) and J(0), in m g h / 2 of the head."""

    dH: Number
    J: Number
    J0: Number


class Fuel(NamedTuple):
    """The energy that a cycle releases, from the energy balance and by the paper's formula."""

    exact: Number
    paper: Number


class Launch(NamedTuple):
    """The motion right after a collision."""

    fuel: Number
    J0: Number
    velocity_ratio: Number
    omegasq: Number
    kinetic: Number


class Barrier(NamedTuple):
    """The barrier of a cycle. The train keeps falling if margin = kinetic - barrier is not negative.

    stop is the tilt in rad at which a train that stops comes to rest.
    """

    theta_m: Number
    barrier: Number
    kinetic: Number
    margin: Number
    stop: Number


class Limit(NamedTuple):
    """The largest growth, and its limit: "barrier", "reach", or "none" if even equal dominoes stop."""

    r_max: Number
    ends: Any


class Best(NamedTuple):
    """The separation that allows the largest growth, and the growth."""

    s: Number
    r_max: Number


class Count(NamedTuple):
    """The number of dominoes that topple a height, ln(height/first) / ln r, and the height of the last domino in m."""

    dominoes: int | float
    exact: float
    last: float


class Proof(NamedTuple):
    """What is proved: low <= r_max <= high, what limits r_max, and why a proof is incomplete ("" if complete)."""

    low: float
    high: float
    ends: str
    gap: str


def _named(values: dict[str, Any], given: Any, what: str) -> Any:
    """Returns the number of a word such as "hollow"; other values are returned as they are."""
    if isinstance(given, str):
        if given not in values:
            raise OutOfRange(f"{what}: {given!r} is not one of {', '.join(values)}", f"BAD_{what.upper()}", what)
        return values[given]
    return given


class Train:
    """The parameters of a train, which are checked by every question. A notebook shows a picture of the train.

    air is the density of the air over that of the dominoes, and drag the drag coefficient, if it is not 1.2.
    """

    def __init__(self, s: Number = 0.4, r: Number = 1.5, d: Number = 7 / 48, q: Number | str = 4.0, *,
                 friction: Number = 0.0, slope: Number = 0.0, edges: Number = 0.0, walls: Number = 0.0,
                 air: Number = 0.0, drag: Number = 0.0, width: Number = 0.5, fuel: str = "exact"):  # fmt: skip
        self.values = {"s": s, "r": r, "d": d, "q": _named(MASSES, q, "q"), "mu": friction, "alpha": slope, "rho": edges,
                       "walls": walls, "air": air, "drag": drag, "width": width}  # fmt: skip
        self.fuel = int(_named(FUELS, fuel, "fuel"))

    def structure(self) -> ctypes.Structure:
        """Returns the struct dom_train for a train whose parameters are numbers."""
        return api.dom_train(fuel=self.fuel, **{name: float(value) for name, value in self.values.items()})

    def __repr__(self) -> str:
        v = self.values
        return f"Train(s={v['s']!r}, r={v['r']!r}, d={v['d']!r}, q={v['q']!r})"

    def _repr_svg_(self) -> str:
        from .drawing import train_svg

        return train_svg(self)


def _is_array(value: Any) -> bool:
    return not isinstance(value, (int, float, str)) and hasattr(value, "__len__") and getattr(value, "ndim", 1) > 0


def _ask(question: int, kind: type, train: Train, tilt: Any, how: dict[str, Any], accepted: tuple[str, ...] = ()) -> Any:
    """Returns the structure with the result for one train, or the array of results for many trains, and the statuses.

    Statuses of `accepted` come with an answer. Other statuses raise an error for one train, and for the parameters of
    many; a train among many that has no answer gets NaN.
    """
    compute = computing(**how)
    values = dict(train.values)
    if tilt is not None:
        values["tilt"] = tilt
    if any(map(_is_array, values.values())):
        return _ask_many(question, kind, train.fuel, values, compute, accepted)
    one, answer, status = train.structure(), kind(), ctypes.c_int()
    angle = ctypes.c_double(math.nan if tilt is None else float(tilt))
    with interruptible(compute):
        run(lib.dom_trains_ask, question, ctypes.byref(one), ctypes.byref(angle), 1, ctypes.byref(compute),
            ctypes.byref(answer), ctypes.byref(status))  # fmt: skip
    if not status.value or api.dom_status(status.value).name.removeprefix("DOM_") not in accepted:
        raise_status(status.value)
    return answer


def _ask_many(question: int, kind: type, fuel: int, values: dict[str, Any], compute: Any,
              accepted: tuple[str, ...]) -> Any:  # fmt: skip
    import numpy as np

    arrays = {name: np.asarray(value, float) for name, value in values.items()}
    shape = np.broadcast_shapes(*[array.shape for array in arrays.values()])
    trains = np.zeros(shape, _dtype(api.dom_train))
    trains["fuel"] = fuel
    tilts = np.zeros(shape)
    for name, array in arrays.items():
        (tilts if name == "tilt" else trains[name])[...] = array
    count = trains.size
    answers = np.zeros(count, _dtype(kind))
    statuses = np.zeros(count, np.intc)
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
    without = np.zeros(count, bool)
    for status in np.unique(statuses) if statuses.any() else ():
        name = api.dom_status(int(status)).name.removeprefix("DOM_")
        if name.startswith("BAD_") or name in ("INTERRUPTED", "NO_MEMORY", "NO_METHOD", "NO_PRECISION"):
            first = int(np.flatnonzero(statuses == status)[0])
            raise_status(int(status), f", at the index {tuple(map(int, np.unravel_index(first, shape)))}")
        if name != "OK" and name not in accepted:
            without |= statuses == status
    if without.any():
        _set_nan(answers, without)
    return answers.reshape(shape)


@functools.cache
def _dtype(structure: type) -> Any:
    """Returns the NumPy dtype of a structure. Creating a dtype takes as long as computing a hundred results."""
    import numpy as np

    return np.dtype(structure)


def _set_nan(answers: Any, where: Any) -> None:
    """Sets all numbers of these results to NaN, including those in nested structures."""
    import numpy as np

    if not answers.dtype.names:
        answers[where] = math.nan
    for name in answers.dtype.names or ():
        if answers.dtype[name].names:
            _set_nan(answers[name], where)
        elif answers.dtype[name] == np.float64:
            answers[name][where] = math.nan


def _tuple(kind: type, answer: Any, fields: list[str]) -> Any:
    """Converts a result to a named tuple."""
    get = (lambda a, name: a[name]) if hasattr(answer, "dtype") else getattr
    return kind(*[get(answer, name) for name in fields])


ASK = api.dom_question


def angles(s: Number = 0.4, *, tol: float | None = None,
           **train: Any) -> Angles:  # fmt: skip
    """The angles that bound a cycle (2; a2), (4; b1), (40; A16), (42; A18)."""
    a = _ask(ASK.DOM_ASK_ANGLES, api.dom_angles, Train(s, **train), None, {"tol": tol})
    return _tuple(Angles, a, ["theta_c", "theta_u", "theta_inf", "theta_f", "theta_leave", "detaches"])


def theta1(theta: Number, s: Number = 0.4, *, tol: float | None = None, **train: Any) -> Contact:  # fmt: skip
    """The tilt of the follower of a domino that leans at theta, in rad (12; b8)."""
    a = _ask(ASK.DOM_ASK_CONTACT, api.dom_contact, Train(s, **train), theta, {"tol": tol})
    return _tuple(Contact, a, ["theta_1", "slope", "arm_a", "arm_b"])


def energy(theta: Number, s: Number = 0.4, *, tol: float | None = None, **train: Any) -> Energy:  # fmt: skip
    """The energy and the inertia of the train whose head leans at theta, in rad (19; c1) (20; c2)."""
    a = _ask(ASK.DOM_ASK_ENERGY, api.dom_energy, Train(s, **train), theta, {"tol": tol})
    return _tuple(Energy, a, ["dH", "J", "J0"])


def fuel(s: Number = 0.4, *, tol: float | None = None,
         **train: Any) -> Fuel:  # fmt: skip
    """The energy that one cycle releases (25; c7)."""
    a = _ask(ASK.DOM_ASK_FUEL, api.dom_fuels, Train(s, **train), None, {"tol": tol})
    return _tuple(Fuel, a, ["exact", "paper"])


def launch(s: Number = 0.4, *, tol: float | None = None,
           **train: Any) -> Launch:  # fmt: skip
    """The motion right after a collision (24; c6)."""
    a = _ask(ASK.DOM_ASK_LAUNCH, api.dom_launch, Train(s, **train), None, {"tol": tol})
    return _tuple(Launch, a, ["fuel", "J0", "velocity_ratio", "omegasq", "kinetic"])


def barrier(s: Number = 0.4, *, tol: float | None = None,
            **train: Any) -> Barrier:  # fmt: skip
    """The barrier of a cycle, and the energy left at its top (26; c8). The train keeps falling if margin >= 0."""
    a = _ask(ASK.DOM_ASK_BARRIER, api.dom_barrier, Train(s, **train), None, {"tol": tol},
             ("STOPS", "NO_FUEL"))  # fmt: skip
    return _tuple(Barrier, a, ["theta_m", "barrier", "kinetic", "margin", "stop"])


def omegasq(theta: Number, s: Number = 0.4, *, tol: float | None = None,
            **train: Any) -> Number:  # fmt: skip
    """tau^2 omega(theta)^2 of the head between one collision and the next (21; c3)."""
    a = _ask(ASK.DOM_ASK_OMEGASQ, ctypes.c_double, Train(s, **train), theta, {"tol": tol})
    return a if hasattr(a, "dtype") else a.value


def duration(s: Number = 0.4, *, tol: float | None = None,
             **train: Any) -> Number:  # fmt: skip
    """The duration of a cycle, from one collision to the next, in tau."""
    a = _ask(ASK.DOM_ASK_DURATION, ctypes.c_double, Train(s, **train), None, {"tol": tol})
    return a if hasattr(a, "dtype") else a.value


def _limit(question: int, s: Number, how: dict[str, Any], train: dict[str, Any]) -> Limit:
    a = _ask(question, api.dom_limit, Train(s, **train), None, how)
    limit = _tuple(Limit, a, ["r_max", "ends"])
    if hasattr(limit.ends, "dtype"):
        import numpy as np

        names = np.array([lib.dom_end_text(end).decode() for end in api.dom_end])
        return limit._replace(ends=names[limit.ends])
    return limit._replace(ends=lib.dom_end_text(limit.ends).decode())


def rmax(s: Number = 0.4, *, tol: float | None = None,
         **train: Any) -> Limit:  # fmt: skip
    """The largest growth of a train at the separation s; r is not used."""
    return _limit(ASK.DOM_ASK_RMAX, s, {"tol": tol}, train)


def pair(s: Number = 0.4, *, tol: float | None = None,
         **train: Any) -> Limit:  # fmt: skip
    """The largest growth of two dominoes, the first of which tips over its edge from rest; r is not used."""
    return _limit(ASK.DOM_ASK_PAIR, s, {"tol": tol}, train)


def best(*, tol: float | None = None, **train: Any) -> Best:
    """The separation that allows the largest growth, and the growth; s and r are not used."""
    a = _ask(ASK.DOM_ASK_BEST, api.dom_best, Train(**train), None, {"tol": tol})
    return _tuple(Best, a, ["s", "r_max"])


def count(height: float, r: float = 1.5, *, first: float = 0.048) -> Count:
    """How many dominoes topple one of this height in m, each r times as tall as the one before."""
    c = api.dom_count()
    raise_status(lib.dom_count_find(first, height, r, ctypes.byref(c)))
    return Count(int(c.dominoes) if math.isfinite(c.dominoes) else c.dominoes, c.exact, c.last)


def prove(what: str = "rmax", s: float = 0.4, *, tol: float = 1e-12, **train: Any) -> Proof:
    """Proves bounds on the largest growth of a train ("rmax") or of two dominoes ("pair") by interval arithmetic."""
    functions = {"rmax": lib.dom_prove_rmax, "pair": lib.dom_prove_pair}
    function = _named(functions, what, "what")
    t, compute, proof = Train(s, **train), computing(tol), api.dom_proof()
    with interruptible(compute):
        status = run(function, ctypes.byref(t.structure()), ctypes.byref(compute), ctypes.byref(proof))
    raise_status(status)
    ends = ["barrier", "reach", "none", "partly"][proof.ends]
    gap = lib.dom_proof_gap_text(proof.gap).decode() if proof.gap else ""
    if proof.gap == api.dom_proof_gap.DOM_PROOF_EFFECT:
        raise DominoError(gap, "NO_METHOD")
    return Proof(proof.low, proof.high, ends, gap)
