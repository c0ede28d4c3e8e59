/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A box: six walls of one thickness around a hollow, half as wide as tall. With d the thickness of the domino
 * and t that of a wall, over the height, the hollow is smaller by the shares
 *
 *     a = 2 t,   b = 2 t / d,   c = 2 t / (1/2)
 *
 * of the height, the thickness and the width, and has the share v = (1 - a) (1 - b) (1 - c) of the volume.
 * The moments of inertia of the block and of the hollow about their common centre, and the parallel axis,
 * give the moment of inertia about the lower edge, over that of a solid block of the same mass:
 *
 *     1 + v (1 - u) / (4 (1 - v)),   u = [(1 - a)^2 + d^2 (1 - b)^2] / (1 + d^2).
 */
#ifndef DOM_WALLS_H
#define DOM_WALLS_H

#include "numerics/real.h"

struct box {
    real filled;  /* share of the volume that the walls fill */
    real inertia; /* over that of a solid block of the same mass */
};

/* Returns the box. A measure that the walls fill has no hollow. `width` is over the height. No terms cancel.
 */
KERNEL inline struct box walls_box(real d, real width, real walls)
{
    real a = fmin(2 * walls, 1), b = fmin(2 * walls / d, 1), c = fmin(2 * walls / width, 1);
    real filled = a + (1 - a) * (b + (1 - b) * c), v = (1 - a) * (1 - b) * (1 - c);
    real smaller = (a * (2 - a) + d * d * b * (2 - b)) / (1 + d * d); /* 1 - u */
    return (struct box){filled, 1 + v * smaller / (4 * filled)};
}

/* Returns true if two walls have room in the thickness; they may fill it, also after the rounding errors of
 * both. */
KERNEL inline bool walls_fit(real d, real walls)
{
    return walls > 0 && 2 * walls <= d * (1 + 8 * REAL_EPSILON);
}

/* The width of a domino over its height, where no other is known. */
#define WALLS_WIDTH ((real)1 / 2)

#endif
