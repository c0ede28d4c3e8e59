/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of the effects in DOM_DYNAMICS, by number: struct request and struct row_request hold them in
 * this order. */
#ifndef DOM_EFFECTS_H
#define DOM_EFFECTS_H

#include "numerics/api.h"

/* Returns true if an effect with this value is on; 0 turns every effect off. */
static inline bool dynamics_on(dom_real value)
{
    return value != 0;
}

/* Returns the number of the first effect that is on and does not cancel, or DOM_DYNAMICS_COUNT. */
int dynamics_first(const dom_real effect[DOM_DYNAMICS_COUNT]);

/* Returns DOM_OK, or the status that names the first value outside the range that its effect states. */
enum dom_status dynamics_check(const dom_real effect[DOM_DYNAMICS_COUNT]);

#endif
