/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The choice of the law of motion and of the potential energy, for a train or a row. */
#ifndef DOM_CHOOSE_H
#define DOM_CHOOSE_H

#include "dynamics/energy_balance.h"
#include "effects/effects.h"

/* Chooses the law of motion and the potential energy for the effects that are on. geometry->d must be set. */
KERNEL enum dom_status dynamics_choose(const dom_real effect[DOM_DYNAMICS_COUNT], struct geometry *geometry);

/* Prepares the geometry and the law of motion. geometry_set must then set the separation and the growth. */
KERNEL enum dom_status dynamics_read(const struct request *train, struct geometry *geometry);

/* Checks a train and prepares its geometry and its law of motion. Call dynamics_begin before the law is
 * used. */
KERNEL enum dom_status dynamics_make(const struct request *train, struct geometry *geometry);

/* Allocate and free the memory of the law of motion. dynamics_end may follow a failed dynamics_begin. */
KERNEL enum dom_status dynamics_begin(struct geometry *geometry);
KERNEL void dynamics_end(struct geometry *geometry);

#endif
