/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The effects, and the choice of the law of motion and of the potential energy for those that are on. The
 * values of the effects of DOM_DYNAMICS are in an array indexed by enum dom_effect_name.
 *
 * An effect of DOM_DYNAMICS has a file in this folder, which fills two tables, struct dom_effect and struct
 * terms; drag, the coefficient of the air, is in air.c. The other effects have a struct dom_effect in rows.c.
 */
#pragma once

#include "dynamics/dynamics.h"

/* What an effect adds to the law of motion. Each effect of DOM_DYNAMICS has such a table in its file. */
struct terms {
    /* Switches the effect on, with this value, for a train or for one domino of a row. The geometry has its
     * d, and the effects before this one. */
    enum dom_status (*apply)(struct geometry *geometry, real value);
    /* Returns the value for domino k of a row, counted from 0, if the effect is on. NULL if all dominoes have
     * the value of the row. */
    dom_real (*of_domino)(const struct dom_row *row, size_t k);
};

#define TERMS_DECLARE(effect, member, status) static const struct terms effect##_terms;
DOM_DYNAMICS(TERMS_DECLARE)
#undef TERMS_DECLARE

/* The values of walls and edges, divided by the height, for domino k of a row. */
KERNEL dom_real walls_of_domino(const struct dom_row *row, size_t k);
KERNEL dom_real edges_of_domino(const struct dom_row *row, size_t k);

/* Chooses the law of motion and the potential energy for the effects that are on. geometry->d must be set. */
KERNEL enum dom_status dynamics_choose(const dom_real effect[DOM_DYNAMICS_COUNT], struct geometry *geometry);

/* Finds the values of all effects for domino k of a row, counted from 0. */
KERNEL void dynamics_of_domino(const struct dom_row *row, size_t k, dom_real effect[DOM_DYNAMICS_COUNT]);

/* Prepares the geometry and the law of motion. geometry_set must then set the separation and the growth. */
KERNEL enum dom_status dynamics_read(const struct dom_train *train, const struct dom_compute *compute,
                                     struct geometry *geometry);

/* Prepare the geometry and the law of motion, and set the separation and the growth. train_make also checks
 * the train. Call dynamics_begin before the law is used. */
KERNEL enum dom_status dynamics_make(const struct dom_train *train, const struct dom_compute *compute,
                                     struct geometry *geometry);
KERNEL enum dom_status train_make(const struct dom_train *train, const struct dom_compute *compute,
                                  struct geometry *geometry);

/* Returns DOM_OK, or the status of the first effect whose value is outside its range. 0 (off) is always
 * allowed. */
KERNEL enum dom_status dynamics_check(const dom_real effect[DOM_DYNAMICS_COUNT]);

/* Returns true if one of the effects that are on takes energy from moving dominoes. */
KERNEL_SHARED bool dynamics_dissipate(const dom_real effect[DOM_DYNAMICS_COUNT]);

/* ---- Moments of inertia ---- */

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

/* Returns the moment of inertia of the air that moves along (air.c), relative to that of a solid block. The
 * density of the air is `air` times that of the domino. */
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
