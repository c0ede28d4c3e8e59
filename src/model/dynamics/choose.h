/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which law of motion and which potential a train or a row has. */
#ifndef DOM_CHOOSE_H
#define DOM_CHOOSE_H

#include "dynamics/energy_balance.h"
#include "dynamics/list.h"

/* Chooses the law of motion and the potential for the effects that are on; the geometry has its d. */
KERNEL enum dom_status dynamics_choose(const dom_real effect[DOM_DYNAMICS_COUNT], struct geometry *geometry);

/* Reads a train as it is; geometry_set then gives it its separation and growth. */
KERNEL enum dom_status dynamics_read(const struct request *train, struct geometry *geometry);

/* Checks a train, and fills its geometry with its law of motion; dynamics_begin goes before it is used. */
KERNEL enum dom_status dynamics_make(const struct request *train, struct geometry *geometry);

/* Takes the memory that the law of motion needs; dynamics_end gives it back, also after a failure. */
KERNEL enum dom_status dynamics_begin(struct geometry *geometry);
KERNEL void dynamics_end(struct geometry *geometry);

#endif
