/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The choice of the law of motion and of the potential energy, for a train or a row. */
#ifndef DOM_CHOOSE_H
#define DOM_CHOOSE_H

#include "dynamics/energy_balance.h"
#include "effects/effects.h"

/* Chooses the law of motion and the potential energy for the effects that are on. Needs geometry->d. */
KERNEL enum dom_status dynamics_choose(const dom_real effect[DOM_DYNAMICS_COUNT], struct geometry *geometry);

/* Reads a train, except its separation and growth, which geometry_set adds. */
KERNEL enum dom_status dynamics_read(const struct request *train, struct geometry *geometry);

/* Checks a train and fills its geometry, with its law of motion. Call dynamics_begin before its first use. */
KERNEL enum dom_status dynamics_make(const struct request *train, struct geometry *geometry);

/* Takes the memory that the law of motion needs. dynamics_end frees the memory, also after a failure. */
KERNEL enum dom_status dynamics_begin(struct geometry *geometry);
KERNEL void dynamics_end(struct geometry *geometry);

#endif
