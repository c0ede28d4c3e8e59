/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What effects add to the moment of inertia of a domino.
 *
 * A hollow box whose six walls have the same thickness. Let d be the thickness of the domino, w its width and
 * t the thickness of a wall, all relative to the height. The hollow is smaller than the box by these
 * fractions of the height, the thickness and the width:
 *
 *     a = 2 t,   b = 2 t / d,   c = 2 t / w.
 *
 * The hollow fills the fraction v = (1 - a) (1 - b) (1 - c) of the box. By the parallel axis theorem, the
 * moment of inertia about the lower edge, relative to a solid block of the same mass, is
 *
 *     1 + v (1 - u) / (4 (1 - v)),   u = [(1 - a)^2 + d^2 (1 - b)^2] / (1 + d^2).
 */
#ifndef DOM_INERTIA_H
#define DOM_INERTIA_H

#include "numerics/real.h"

struct box {
    real filled;  /* fraction of the volume that the walls fill */
    real inertia; /* moment of inertia relative to that of a solid block of the same mass */
};

/* Returns the properties of a box. All arguments are relative to the height. If walls meet, there is no
 * hollow. The formulas avoid cancellation. */
KERNEL inline struct box walls_box(real d, real width, real walls)
{
    real a = fmin(2 * walls, 1), b = fmin(2 * walls / d, 1), c = fmin(2 * walls / width, 1);
    real filled = a + (1 - a) * (b + (1 - b) * c), v = (1 - a) * (1 - b) * (1 - c);
    /* the term 1 - u of the formula at the top of this file */
    real smaller = (a * (2 - a) + d * d * b * (2 - b)) / (1 + d * d);
    return (struct box){filled, 1 + v * smaller / (4 * filled)};
}

/* Returns true if two walls together are at most as thick as the domino, apart from rounding errors. */
KERNEL inline bool walls_fit(real d, real walls)
{
    return walls > 0 && 2 * walls <= d * (1 + 8 * REAL_EPSILON);
}

/* The usual drag coefficient of a domino. */
#define AIR_COEFFICIENT ((real)12 / 10)

/* These two functions are for air (air.c) whose density is `air` times the density of the domino. Returns the
 * torque of the drag, divided by omega^2 and by the moment of inertia of a solid block of the same mass. */
KERNEL inline real air_drag(real d, real air, real coefficient)
{
    return 3 * coefficient * air / (8 * d * (1 + d * d));
}

/* Returns the moment of inertia of the air that moves along, relative to that of a solid block. */
KERNEL inline real air_entrained(real d, real width, real air)
{
    return PI * air * width / (4 * d * (1 + d * d));
}

/* Returns the moment of inertia of a domino relative to that of a solid block of the same size and mass. The
 * values of the effects are those of this domino. */
KERNEL inline real inertia_factor(real d, real width, const dom_real effect[DOM_DYNAMICS_COUNT])
{
    const real walls = (real)effect[DOM_EFFECT_walls], air = (real)effect[DOM_EFFECT_air];
    return (walls != 0 ? walls_box(d, width, walls).inertia : 1) +
           (air != 0 ? air_entrained(d, width, air) : 0);
}

#endif
