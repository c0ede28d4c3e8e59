# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of dominoes of any sizes, in metres, kilograms and seconds."""

from __future__ import annotations

import ctypes
import math
from typing import Any, Iterable

from . import _api as api
from ._library import (DominoError, computing, effect_members, interruptible, lib, number_of, parallel, raise_status,
                       record, run, status_name)  # fmt: skip
from .trains import Train

STATUS = api.dom_status


Domino = record("Domino", "height thickness gap mass lean radius width",
                """A block: height, thickness and the gap before it in m, mass in kg, lean in rad, radius of edges and width in m.

    A width of 0 stands for half of the height.""", defaults=(0.0,) * 5)  # fmt: skip
Fall = record("Fall", "domino time duration omega kinetic barrier margin lost",
              "The state of a domino when it is hit: times in s, omega in rad/s, energies in J.")  # fmt: skip
Verdict = record("Verdict", "falls end domino short_by seconds weakest spare",
                 "How the row ends, and at which domino. `spare` is margin / barrier of the weakest domino that falls.")  # fmt: skip
Window = record("Window", "domino now low high",
                "The range of one gap, place, height, lean or friction in which all dominoes fall; NaN if there is none.")  # fmt: skip
Mend = record("Mend", "domino gap to until", "A change of one gap in m. All dominoes fall with every gap from `to` to `until`.")
Placement = record("Placement", "rows fall unknown low high stops",
                   "How many of the rows with random errors fall, and a 95 % interval of the probability.")  # fmt: skip
Budget = record("Budget", "sigma low high",
                "The size of an error that the probability allows, or the factor of all errors, with its 95 % interval.")  # fmt: skip
Design = record("Design", "s r steps feet length seconds safety row",
                "A row that was designed for a wish. The attribute `row` holds its dominoes.")  # fmt: skip

# Names of columns, and their units in metres or kilograms.
COLUMNS = {"height": "m", "thickness": "m", "gap": "m", "mass": "kg", "lean": "m", "radius": "m", "width": "m"}
UNITS = {"m": {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}, "kg": {"kg": 1.0, "g": 0.001, "t": 1000.0}}
WINDOWS = {of.name.removeprefix("DOM_WINDOW_").lower(): of for of in api.dom_window_of}
ERRORS = {kind.name.removeprefix("DOM_ERROR_"): kind for kind in api.dom_error_of if kind.name != "DOM_ERROR_COUNT"}


class Row:
    """An immutable row of dominoes.

    Row([(0.05, 0.008), (0.06, 0.009, 0.02)]) takes height, thickness and gap in m; see Domino. A row can also be made
    of a train, or of a pandas DataFrame with the columns height, thickness, gap and, if known, mass, lean, radius and
    width. Without masses, all dominoes have the same density.

    friction, slope (rad), edges (radius over height), walls (m) and air (kg/m^3) are effects; drag is the drag
    coefficient in air, if it is not 1.2. In air, masses count: in kg. push is the angular velocity of the
    first domino in rad/s; without it, this domino tips over its edge from rest. `precision` is that of falls; windows,
    placements and budgets are computed in double.
    """

    def __init__(self, dominoes: Iterable[Any], *, push: float | None = None, g: float = 9.81,
                 tol: float | None = None, **effects: float):  # fmt: skip
        self.dominoes = tuple(Domino(*map(float, domino)) for domino in dominoes)
        if any(domino.mass == 0 for domino in self.dominoes):
            self.dominoes = tuple(
                domino if domino.mass else domino._replace(mass=500 * domino.height * (domino.width or domino.height / 2) * domino.thickness)
                for domino in self.dominoes
            )
        self._effects = {"push": math.nan if push is None else push, "g": g, **effect_members(effects)}
        self._how = {"tol": tol}

    # ---- Where rows come from ----

    @classmethod
    def of_train(cls, count: int, *, h: float = 0.048, s: float = 0.4, r: float = 1.5, d: float = 7 / 48,
                 q: float | str = 4.0, width: float = 0.5, mass: float = 1.0, **effects: Any) -> Row:  # fmt: skip
        """The first dominoes of a train, the first of them h tall, in m."""
        one = Train(s, r, d, q, width=width).structure()
        dominoes = (api.dom_domino * count)()
        lib.dom_row_of_train(ctypes.byref(one), ctypes.byref(api.dom_scale(h=h, g=9.81)), mass, dominoes, count)
        return cls([(c.height, c.thickness, c.gap, c.mass, 0, 0, c.width) for c in dominoes], **effects)

    @classmethod
    def from_pandas(cls, frame: Any, **effects: Any) -> Row:
        """Takes a row from a DataFrame whose columns name their units: "height (mm)". Other columns are not used.

        pandas.read_csv(path, comment="#", na_values="-", skipinitialspace=True) reads a csv file of the program.
        """
        columns: dict[str, list[float]] = {}
        for head in frame.columns:
            name, _, unit = str(head).lower().rstrip(" )]").replace("[", "(").partition("(")
            name = name.strip()
            if name in COLUMNS:
                units = UNITS[COLUMNS[name]]
                if unit not in units:
                    raise ValueError(f"the column {head!r} needs its unit, one of {', '.join(units)}: '{name} ({next(iter(units))})'")
                columns[name] = [cell * units[unit] for cell in map(float, frame[head])]
        for name in ("height", "thickness", "gap"):
            if name not in columns:
                raise ValueError(f"there is no column '{name} (mm)'")
        first, *others = columns["gap"] or [0.0]
        if abs(first) > 0 and any(gap != first for gap in others):
            raise ValueError("domino 1 has no gap, because a gap is measured from the domino before; leave this cell empty, "
                             "or if your numbers are measured to the next domino, move all one line down")  # fmt: skip
        columns["gap"][:1] = [0.0]
        rows = [dict(zip(columns, values)) for values in zip(*columns.values())]
        for row in rows:
            if "lean" in row:  # in a table a lean is how far the top is off, as a plumb line shows it
                row["lean"] = math.asin(row["lean"] / row["height"])
        return cls([Domino(**row) for row in rows], **effects)

    # ---- Questions ----

    def __len__(self) -> int:
        return len(self.dominoes)

    def __iter__(self) -> Any:
        return iter(self.dominoes)

    def __repr__(self) -> str:
        return f"Row of {len(self)} dominoes, {self.dominoes[0].height:.6g} m to {self.dominoes[-1].height:.6g} m"

    def _row(self) -> api.dom_row:
        dominoes = (api.dom_domino * max(len(self), 1))()
        for one, domino in zip(dominoes, self.dominoes):
            for name, value in domino._asdict().items():
                setattr(one, name, value)
        row = api.dom_row(domino=dominoes, count=len(self), **self._effects)
        row.keep = dominoes  # keeps the dominoes alive as long as the row
        return row

    def _call(self, function: Any, *arguments: Any, wrong: Any = None) -> None:
        """Calls a function about rows, and raises an error if it fails. The verdict `wrong` names the bad domino."""
        row, compute = self._row(), computing(**self._how)
        with interruptible(compute):
            status = run(function, ctypes.byref(row), ctypes.byref(compute), *arguments)
        if status != STATUS.DOM_OK and wrong is None:  # only a run tells which domino is bad
            wrong = api.dom_verdict()
            lib.dom_row_run(ctypes.byref(row), ctypes.byref(compute), False, api.dom_fall_visit(), None,
                            ctypes.byref(wrong))  # fmt: skip
        is_wrong = STATUS(status).name.startswith("DOM_BAD") and wrong is not None and wrong.domino
        raise_status(status, f" (domino {wrong.domino})" if is_wrong else "")

    def fall(self) -> list[Fall]:
        """The falls of all dominoes that are hit, in order."""
        falls: list[Fall] = []

        @api.dom_fall_visit
        def visit(fall: Any, context: Any) -> bool:
            falls.append(Fall(*[getattr(fall.contents, name) for name in Fall._fields]))
            return True

        verdict = api.dom_verdict()
        self._call(lib.dom_row_run, True, visit, None, ctypes.byref(verdict), wrong=verdict)
        return falls

    def verdict(self) -> Verdict:
        """Finds whether all dominoes fall. If not, finds where the row ends, and why."""
        v = api.dom_verdict()
        self._call(lib.dom_row_run, True, api.dom_fall_visit(), None, ctypes.byref(v), wrong=v)
        end = api.dom_row_end(v.end)
        return Verdict(end == api.dom_row_end.DOM_ROW_FALLS, lib.dom_row_end_text(end).decode(), v.domino, v.short_by,
                       v.seconds, v.weakest, v.spare)  # fmt: skip

    def tolerance(self, of: str = "gap") -> list[Window]:
        """The windows of each "gap", "place", "height" or "lean", or of the "friction", in which all fall."""
        window = number_of(of, WINDOWS, "of", "BAD_METHOD")
        count = {"friction": 1, "gap": len(self) - 1, "place": len(self) - 1}.get(of, len(self))
        windows = (api.dom_window * max(count, 1))()
        self._call(lib.dom_row_windows, window, api.dom_progress(), None, windows)
        return [Window(w.domino, w.now, w.low, w.high) for w in windows[:count]]

    def mend(self) -> list[Mend]:
        """The changes of single gaps that make the row fall, the smallest first; empty if the row falls already."""
        if self.verdict().falls:
            return []
        mends = [Mend(w.domino, w.now, *((w.low, w.high) if w.now < w.low else (w.high, w.low)))
                 for w in self.tolerance() if not math.isnan(w.low)]  # fmt: skip
        return sorted(mends, key=lambda m: abs(m.to - m.gap))

    def weakest_push(self, strongest: float = 100.0) -> float:
        """The weakest push in rad/s with which all dominoes fall, or the push of the row if all fall already."""
        push = ctypes.c_double()
        self._call(lib.dom_row_weakest_push, strongest, ctypes.byref(push))
        if math.isnan(push.value) and not self.verdict().falls:
            raise DominoError(f"no push up to {strongest:.6g} rad/s is enough", "STOPS")
        return push.value

    def _placement(self, errors: dict[str, float | tuple[float, str]], seed: int, rows: int) -> api.dom_placement:
        placement = api.dom_placement(seed=seed, first=0, rows=rows, parallel=parallel)
        for name, error in errors.items():
            size, limits = error if isinstance(error, tuple) else (error, "normal")
            if limits not in ("normal", "uniform"):
                raise ValueError(f"the error of {name} is 'normal' or 'uniform', not {limits!r}")
            placement.error[number_of(name, ERRORS, "error")] = api.dom_random_error(size, limits == "uniform")
        return placement

    def placement(self, sigma: float = 0.0, *, rows: int = 1000, seed: int = 1,
                  **errors: float | tuple[float, str]) -> Placement:  # fmt: skip
        """Sets the row up `rows` times with random errors, and counts how many rows fall.

        sigma is the standard deviation of the gaps in m. More errors are height, thickness, mass and radius (shares),
        place (m), lean and slope (rad), friction, floor, and push (rad/s): thickness=0.01, or (0.01, "uniform").
        """
        study, stops = api.dom_study(), (ctypes.c_size_t * max(len(self), 1))()
        placement = self._placement({"gap": sigma, **errors}, seed, rows)
        self._call(lib.dom_placement_study, ctypes.byref(placement), ctypes.byref(study), stops)
        return Placement(study.rows, study.fall, study.unknown, study.low, study.high, tuple(stops))

    def budget(self, probability: float, of: str = "gap", *, rows: int = 1000, seed: int = 1,
               **errors: float | tuple[float, str]) -> Budget:  # fmt: skip
        """The size of one kind of error at which the row falls with this probability. Other errors: as in `placement`.

        of="all" finds the factor by which all errors may be multiplied.
        """
        budget, placement = api.dom_budget(), self._placement(errors, seed, rows)
        kind = api.dom_error_of.DOM_ERROR_COUNT if of == "all" else number_of(of, ERRORS, "of")
        try:
            self._call(lib.dom_placement_budget, ctypes.byref(placement), kind, probability, ctypes.byref(budget))
        except DominoError as error:
            if error.status != "STOPS":
                raise
            raise DominoError("even with exact gaps, too few of these rows fall", "STOPS") from None
        return Budget(budget.sigma, budget.low, budget.high)


def design(height: float, *, first: float = 0.048, safety: float = 2.0, hall: float = math.inf, d: float = 7 / 48,
           q: float | str = 4.0, push: float | None = None, g: float = 9.81, width: float = 0.5, **effects: float) -> Design:  # fmt: skip
    """The row of a train from `first` to `height`, in m, in which each cycle has `safety` times the energy it needs.

    The effects are those of a train, without air.
    """
    if effects.get("air"):
        raise TypeError("a design has no air")
    train = Train(0.4, 1.5, d, q, width=width, **effects).structure()
    wish = api.dom_wish(first=first, height=height, safety=safety, hall=hall, g=g,
                        push=math.nan if push is None else push)  # fmt: skip
    found, compute = api.dom_design(), computing(None)
    with interruptible(compute):
        status = run(lib.dom_design_find, ctypes.byref(train), ctypes.byref(wish), None, ctypes.byref(compute), ctypes.byref(found), None)
    raise_status(status)
    limits = api.dom_design_limit
    refusals = {
        limits.DOM_DESIGN_SAFETY: f"no train has a safety of {safety:.6g}; the largest is just above {found.needs:.6g}",
        limits.DOM_DESIGN_START: f"the start is too weak; a push of {found.needs:.6g} rad/s is enough",
        limits.DOM_DESIGN_HALL: f"the hall is too short; the shortest row found needs {found.needs:.6g} m",
    }
    if found.limit != limits.DOM_DESIGN_FITS:
        raise DominoError(refusals.get(found.limit, "no such row falls"), limits(found.limit).name.removeprefix("DOM_"))
    effects["walls"] = effects.get("walls", 0.0) * first
    row = Row.of_train(found.steps + 1, h=first, s=found.s, r=found.r, d=d, q=q, width=width, push=push, g=g, **effects)
    return Design(found.s, found.r, found.steps, found.feet, found.length, found.seconds, found.row, row)
