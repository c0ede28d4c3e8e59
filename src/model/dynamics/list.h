/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects of DOM_DYNAMICS by number. struct request and struct row_request hold their values in this
 * order. */
#ifndef DOM_LIST_H
#define DOM_LIST_H

#include "geometry/request.h"

/* Returns true if an effect with this value is on; 0 turns every effect off. */
static inline bool dynamics_on(dom_real value)
{
    return value != 0;
}

/* Returns the number of the first effect that is on and does not cancel, or DOM_DYNAMICS_COUNT. */
static inline int dynamics_first(const dom_real effect[DOM_DYNAMICS_COUNT])
{
    int k = 0;
    while (k < DOM_DYNAMICS_COUNT &&
           (!dynamics_on(effect[k]) || dom_effect((enum dom_effect_name)k)->cancels))
        k++;
    return k;
}

/* Returns DOM_OK, or the status that names the first value outside the range that its effect states. */
static inline enum dom_status dynamics_check(const dom_real effect[DOM_DYNAMICS_COUNT])
{
#define STATUS(effect, member, status) status,
    static const enum dom_status bad[] = {DOM_DYNAMICS(STATUS)};
#undef STATUS
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++) {
        const struct dom_effect_argument *argument = dom_effect((enum dom_effect_name)k)->argument;
        if (dynamics_on(effect[k]) && !(effect[k] >= argument->lowest && effect[k] <= argument->highest))
            return bad[k];
    }
    return DOM_OK;
}

#endif
