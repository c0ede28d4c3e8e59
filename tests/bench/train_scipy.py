# SPDX-License-Identifier: GPL-3.0-or-later
"""The questions of the benchmark, as a user of SciPy would solve them: energies in plain Python, maxima, roots and
integrals from scipy.optimize and scipy.integrate.

Reads one question per line (see ask() at the end). Answers with the seconds that the question took, and a number.
"""

import math
import sys
import time

from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar

SAMPLES = 16  # number of samples of a cycle in the search for the barrier
FLAT = 1e-6  # any barrier has begun to rise within this fraction of the cycle
ROUNDING = 1e-15  # rounding error of a difference of two heights


def highest(f, end, tol):
    """Returns the maximum of f over [0, end], where f(0) = 0: the best of a few samples, refined by Brent's method."""
    step = end / SAMPLES
    heights = [0.0] + [f(k * step) for k in range(1, SAMPLES)] + [f(end)]
    top = max(range(SAMPLES + 1), key=heights.__getitem__)
    if top == SAMPLES or (top == 0 and f(FLAT * end) <= 0):
        return heights[top]
    around = (max(top - 1, 0) * step, (top + 1) * step)
    # The error of the height is of second order in the error of the tilt.
    found = minimize_scalar(
        lambda theta: -f(theta), bounds=around, method="bounded", options={"xatol": math.sqrt(tol) * step}
    )
    return max(heights[top], -found.fun)


def unit(x, y):
    """Makes a Newton step towards x^2 + y^2 = 1, to remove the drift by rounding errors along a long train."""
    norm = (3 - x * x - y * y) / 2
    return norm * x, norm * y


class Train:
    """An endless train with one growth r, and the values that all tilts share."""

    def __init__(self, s, r, d, q, tol):
        self.r, self.d, self.L = r, d, s + d
        self.weight, self.inertia = r**-q, r ** -(q + 1)
        self.enough = tol / 100
        self.theta_c = math.asin(min(r * s, 1))
        self.y_leave = -1.0
        L = self.L
        if 1 / (r * r) < L * L - d * d:
            self.y_leave = (L * L + d * d - 1 / (r * r)) / (2 * d * L)
            x_f = min((1 + r * r * (L * L - d * d)) / (2 * r * L), 1)
            self.h_f = math.sqrt(1 - x_f * x_f) + d * x_f
        # Heights of the dominoes while the head is upright, for all energy differences. The list grows as needed.
        self.upright = [(0.0, 1.0, 1.0)]
        fall, J = self.rise(self.theta_c)
        T, rq = self.inertia * J, r**q
        self.fuel = -fall
        self.kinetic = self.fuel * T / (rq * (1 + T) - T)

    def follower(self, x, y):
        X = self.r * (self.L * y - self.d)
        Y = math.sqrt(max(1 - X * X, 0))
        return unit(Y * x + X * y, Y * y - X * x)

    def rise(self, theta):
        """Returns H(theta) - H(0) and J(theta), summed term by term until the remainder is negligible."""
        x, y = math.sin(theta), math.cos(theta)
        r, d, L, y_leave, upright, enough = self.r, self.d, self.L, self.y_leave, self.upright, self.enough
        H = J = size = 0.0
        weight = inertia = slope = 1.0
        i = 0
        while True:
            _, y_0, h_0 = upright[i]
            term = weight * (y + d * x - h_0)
            H += term
            size += abs(term)
            J += inertia * slope * slope
            weight *= self.weight
            inertia *= self.inertia
            if y_0 <= y_leave:
                return H, J
            i += 1
            if i == len(upright):
                x_1, y_1 = self.follower(upright[-1][0], y_0)
                upright.append((x_1, y_1, y_1 + d * x_1))
            if y <= y_leave:  # this follower detaches during the cycle and keeps its energy
                return H + weight * (self.h_f - upright[i][2]), J
            X = r * (L * y - d)
            Y = math.sqrt(1 - X * X) if abs(X) < 1 else 0.0
            if x > 0:
                slope *= 1 - r * L * x / Y
            x, y = Y * x + X * y, Y * y - X * x
            norm = (3 - x * x - y * y) / 2  # same as unit(), inlined for speed
            x, y = norm * x, norm * y
            differs = abs(y + d * x - upright[i][2]) - ROUNDING
            if weight * differs + inertia * slope * slope < enough * size:
                return H, J

    def margin(self, tol):
        return self.kinetic - highest(lambda theta: self.rise(theta)[0], self.theta_c, tol)


def rmax(tol, s, _, d, q):
    def margin(r):
        return Train(s, r, d, q, tol).margin(tol)

    if margin(1) < 0:
        return math.nan
    if margin(1 / s) >= 0:
        return 1 / s
    return brentq(margin, 1, 1 / s, xtol=tol, rtol=max(tol, 1e-15))


def duration(tol, s, r, d, q):
    train = Train(s, r, d, q, tol)
    if train.margin(tol) < 0:
        return math.nan

    def slowness(theta):
        fall, J = train.rise(theta)
        return math.sqrt(J / (train.kinetic - fall))

    return quad(slowness, 0, train.theta_c, epsabs=0, epsrel=max(tol, 1e-14), limit=200)[0]


def row(tol, n, growth, s, d, h, g, push):
    """Returns the seconds until the last domino of a row of any dominoes lies."""
    n = int(n)
    height = [h * growth**i for i in range(n)]
    thick = [d * a for a in height]
    gap = [s * a for a in height]
    mass = [growth ** (3 * i) for i in range(n)]
    inertia = [m * (a * a + t * t) / 3 for m, a, t in zip(mass, height, thick)]

    def moving(k, theta):
        """Returns the energy and the inertia of domino k, at this tilt, and of all dominoes that lean on it."""
        x, y, slope, E, J = math.sin(theta), math.cos(theta), 1.0, 0.0, 0.0
        for j in range(k, -1, -1):
            E += mass[j] * g * (height[j] * y + thick[j] * x) / 2
            J += inertia[j] * slope * slope
            if j > 0:
                pitch = gap[j] + thick[j]
                X = (pitch * y - thick[j]) / height[j - 1]
                Y = math.sqrt(1 - X * X)
                slope *= 1 - pitch * x / (height[j - 1] * Y)
                x, y = Y * x + X * y, Y * y - X * x
        return E, J

    clock, momentum = 0.0, inertia[0] * push
    for k in range(n):
        E_0, J_0 = moving(k, 0.0)
        kinetic = momentum * momentum / J_0  # twice the kinetic energy
        end = math.asin(gap[k + 1] / height[k]) if k + 1 < n else math.pi / 2
        if kinetic < 2 * highest(lambda theta: moving(k, theta)[0] - E_0, end, tol):
            return math.nan

        def slowness(theta):
            E, J = moving(k, theta)
            return math.sqrt(J / (kinetic - 2 * (E - E_0)))

        clock += quad(slowness, 0, end, epsabs=0, epsrel=max(tol, 1e-14), limit=200)[0]
        E, J = moving(k, end)
        momentum = math.sqrt(J * (kinetic - 2 * (E - E_0)))
    return clock


QUESTIONS = {"rmax": rmax, "duration": duration, "row": row}


def ask(line):
    """NAME NUMBER...: the name of a question and its arguments."""
    name, *numbers = line.split()
    numbers = [float(number) for number in numbers]
    begun = time.perf_counter()
    answer = QUESTIONS[name](*numbers)
    seconds = time.perf_counter() - begun
    print(seconds, answer, flush=True)


for request in sys.stdin:
    ask(request)
