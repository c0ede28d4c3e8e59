/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which effects of DOM_DYNAMICS a train or a row has. */
#ifndef DOM_LIST_H
#define DOM_LIST_H

#include "domino.h"

/* The value of each effect, in the order of the list. */
struct dynamics_values {
    dom_real of[DOM_DYNAMICS_COUNT];
};

#define DYNAMICS_VALUE(effect, member) from->member,

static inline struct dynamics_values dynamics_of_train(const struct dom_train *from)
{
    return (struct dynamics_values){{DOM_DYNAMICS(DYNAMICS_VALUE)}};
}

static inline struct dynamics_values dynamics_of_row(const struct dom_row *from)
{
    return (struct dynamics_values){{DOM_DYNAMICS(DYNAMICS_VALUE)}};
}

#undef DYNAMICS_VALUE

/* Returns whether an effect of this value is on; every effect is off at 0. */
static inline bool dynamics_on(dom_real value)
{
    return value != 0;
}

/* Returns whether all values are inside the ranges that the effects state. */
static inline bool dynamics_allowed(const struct dynamics_values *values)
{
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++) {
        const struct dom_effect_argument *argument = dom_effect((enum dom_effect_name)k)->argument;
        if (!(values->of[k] >= argument->lowest && values->of[k] <= argument->highest))
            return false;
    }
    return true;
}

#endif
