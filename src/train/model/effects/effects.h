/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Functions for the values of the effects of DOM_DYNAMICS. The values are in an array indexed by enum
 * dom_effect_name.
 *
 * Each effect has a file in this folder, which fills one table; drag, the coefficient of the air, is in
 * air.c. An effect of DOM_DYNAMICS fills a second one, struct terms (choose.h).
 */
#ifndef DOM_EFFECTS_H
#define DOM_EFFECTS_H

#include "numerics/real.h"

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
KERNEL bool dynamics_dissipate(const dom_real effect[DOM_DYNAMICS_COUNT]);

#endif
