# SPDX-License-Identifier: GPL-3.0-or-later
"""How far can a row of dominoes grow?

A train is an endless row of dominoes, each r times as large as the one before (J. M. J. van Leeuwen, "Domino
Magnification"). This module asks libdomino about trains and about rows of any dominoes:

    >>> import domino
    >>> domino.rmax(0.4).r_max
    1.644229039535149
    >>> domino.count(112).dominoes
    20

Questions about a train take s (separation), r (growth), d (thickness) and q (mass: 3 or "hollow", 4 or "solid"), the
effects friction, slope, edges, walls and air, and tol, the relative tolerance. All
numbers are doubles. Lengths are in heights of the head, angles in radians, energies in m g h / 2, times in tau.
Each of these may be a NumPy array. Arrays broadcast, and are computed on all cores:

    >>> import numpy as np
    >>> domino.rmax(np.linspace(0.1, 0.9, 1000)).r_max.shape
    (1000,)

Rows are in metres, kilograms and seconds: see Row. Answers are named tuples. A question without an answer raises
DominoError.
"""

from ._library import DominoError, OutOfRange, version
from .rows import Budget, Design, Domino, Fall, Mend, Placement, Row, Verdict, Window, design
from .trains import (Angles, Barrier, Best, Contact, Count, Energy, Fuel, Launch, Limit, Proof, Train, angles,
                     barrier, best, count, duration, energy, fuel, launch, omegasq, pair, prove, rmax, theta1)

__version__ = version
__all__ = [
    "Angles", "Barrier", "Best", "Budget", "Contact", "Count", "Design", "Domino", "DominoError", "Energy",
    "Fall", "Fuel", "Launch", "Limit", "Mend", "OutOfRange", "Placement", "Proof", "Row", "Train", "Verdict", "Window",
    "angles", "barrier", "best", "count", "design", "duration", "energy", "fuel", "launch", "omegasq", "pair", "prove",
    "rmax", "theta1",
]  # fmt: skip
