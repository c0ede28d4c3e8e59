/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions for the values of the effects in DOM_DYNAMICS. struct request and struct row_request hold the
 * values in an array indexed by enum dom_effect_name. */
#ifndef DOM_EFFECTS_H
#define DOM_EFFECTS_H

#include "numerics/api.h"

/* Returns true if an effect with this value is on. Every effect is off if its value is 0. */
static inline bool dynamics_on(dom_real value)
{
    return value != 0;
}

/* Returns the number of the first effect that is on and does not cancel (struct dom_effect), or
 * DOM_DYNAMICS_COUNT if there is none. */
int dynamics_first(const dom_real effect[DOM_DYNAMICS_COUNT]);

/* Returns DOM_OK, or the status of the first effect whose value is outside the range that dom_effects states.
 * 0, which means off, is always allowed. */
enum dom_status dynamics_check(const dom_real effect[DOM_DYNAMICS_COUNT]);

#endif
