/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions that examine the values of the effects listed in DOM_DYNAMICS. struct request and struct
 * row_request hold these values in an array indexed by enum dom_effect_name. */
#ifndef DOM_EFFECTS_H
#define DOM_EFFECTS_H

#include "numerics/api.h"

static inline bool dynamics_on(dom_real value)
{
    return value != 0;
}

/* Returns the number of the first effect that is on and changes anything besides tau (see `cancels` in struct
 * dom_effect), or DOM_DYNAMICS_COUNT if there is none. */
int dynamics_first(const dom_real effect[DOM_DYNAMICS_COUNT]);

/* Returns DOM_OK, or the status for the first effect whose value is outside the range given in dom_effects.
 * The value 0, which turns an effect off, is always allowed. */
enum dom_status dynamics_check(const dom_real effect[DOM_DYNAMICS_COUNT]);

#endif
