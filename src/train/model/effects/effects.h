/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The effects. An effect of DOM_DYNAMICS has a file in this folder, with a struct dom_effect and the function
 * NAME_apply; drag, the coefficient of the air, is in air.c. The other effects have a struct dom_effect in
 * rows.c.
 */
#pragma once

#include "dynamics/dynamics.h"

/* friction_apply and so on switch an effect on, with this value, for a train or for one domino of a row. The
 * geometry has its d, and the effects before this one. */
#define APPLY_DECLARE(effect, member, status)                                                                \
    KERNEL enum dom_status effect##_apply(struct geometry *geometry, real value);
DOM_DYNAMICS(APPLY_DECLARE)
#undef APPLY_DECLARE

/* Returns domino k of a row, counted from 0, as one of a train: its d and its width, and its values of the
 * effects, which are relative as in struct dom_train. */
KERNEL_SHARED struct dom_train dynamics_of_domino(const struct dom_row *row, size_t k);

/* Prepares the geometry and the law of motion. geometry_set must then set the separation and the growth. */
KERNEL enum dom_status dynamics_read(const struct dom_train *train, const struct dom_compute *compute,
                                     struct geometry *geometry);

/* Checks a train, prepares its geometry and the law of motion, and sets the separation and the growth. If
 * `energies` is true, also prepares the far tail. The caller sets geometry->flow before the law is used. */
KERNEL enum dom_status train_make(const struct dom_train *train, const struct dom_compute *compute,
                                  bool energies, struct geometry *geometry);

/* Returns DOM_OK, or the status of the first effect whose value is outside its range. 0 (off) is always
 * allowed. */
KERNEL enum dom_status dynamics_check(const struct dom_train *train);

/* The usual drag coefficient of a domino. */
#define AIR_COEFFICIENT ((real)12 / 10)

/* Returns the moment of inertia of the air that moves along (air.c), relative to that of a solid block. The
 * density of the air is `air` times that of the domino. */
KERNEL inline real air_entrained(real d, real width, real air)
{
    return PI * air * width / (4 * d * (1 + d * d));
}
