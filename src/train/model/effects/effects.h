/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The effects, and the choice of the law of motion and of the potential energy for those that are on. The
 * values of the effects of DOM_DYNAMICS are in an array indexed by enum dom_effect_name.
 *
 * Each effect has a file in this folder, which fills one table; drag, the coefficient of the air, is in
 * air.c. An effect of DOM_DYNAMICS fills a second one, struct terms.
 */
#ifndef DOM_EFFECTS_H
#define DOM_EFFECTS_H

#include "dynamics/dynamics.h"

/* What an effect adds to the law of motion. Each effect of DOM_DYNAMICS has such a table in its file. */
struct terms {
    /* Switches the effect on, with this value, for a train or for one domino of a row. The geometry has its
     * d, and the effects before this one. */
    enum dom_status (*apply)(struct geometry *geometry, real value);
    /* Returns the value for domino k of a row, counted from 0, if the effect is on. NULL if all dominoes have
     * the value of the row. */
    dom_real (*of_domino)(const struct row_request *row, size_t k);
};

#define TERMS_DECLARE(effect, member, status) static const struct terms effect##_terms;
DOM_DYNAMICS(TERMS_DECLARE)
#undef TERMS_DECLARE

/* The values of walls and edges, divided by the height, for domino k of a row. */
KERNEL dom_real walls_of_domino(const struct row_request *row, size_t k);
KERNEL dom_real edges_of_domino(const struct row_request *row, size_t k);

/* Chooses the law of motion and the potential energy for the effects that are on. geometry->d must be set. */
KERNEL enum dom_status dynamics_choose(const dom_real effect[DOM_DYNAMICS_COUNT], struct geometry *geometry);

/* Finds the values of all effects for domino k of a row, counted from 0. */
KERNEL void dynamics_of_domino(const struct row_request *row, size_t k, dom_real effect[DOM_DYNAMICS_COUNT]);

/* Prepares the geometry and the law of motion. geometry_set must then set the separation and the growth. */
KERNEL enum dom_status dynamics_read(const struct request *train, struct geometry *geometry);

/* Checks a train and prepares its geometry and its law of motion. Call dynamics_begin before the law is
 * used. */
KERNEL enum dom_status dynamics_make(const struct request *train, struct geometry *geometry);

static inline bool dynamics_on(dom_real value)
{
    return value != 0;
}

/* Some effects only change the time scale tau. Returns the number of the first effect that is on and changes
 * anything else, or DOM_DYNAMICS_COUNT if there is none. */
KERNEL int dynamics_first(const dom_real effect[DOM_DYNAMICS_COUNT]);

/* Returns DOM_OK, or the status of the first effect whose value is outside its range. 0 (off) is always
 * allowed. */
KERNEL enum dom_status dynamics_check(const dom_real effect[DOM_DYNAMICS_COUNT]);

/* Returns true if one of the effects that are on takes energy from moving dominoes. */
KERNEL_SHARED bool dynamics_dissipate(const dom_real effect[DOM_DYNAMICS_COUNT]);

#endif
