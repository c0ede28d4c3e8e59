/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "domino.h"
#include <float.h>
#include <math.h>

const char *dom_status_text(enum dom_status status)
{
    switch (status) {
#define TEXT(name, text)                                                                                     \
    case DOM_##name:                                                                                         \
        return text;
        DOM_STATUSES(TEXT)
#undef TEXT
    }
    return "unknown status";
}

#define DEFAULT(name, default_, lowest, highest, unit, meaning) .name = default_,

struct dom_train dom_train_default(void)
{
    return (struct dom_train){DOM_TRAIN_PARAMETERS(DEFAULT).fuel = DOM_FUEL_EXACT, .interrupt = NULL};
}

struct dom_scale dom_scale_default(void)
{
    return (struct dom_scale){DOM_SCALE_PARAMETERS(DEFAULT)};
}

enum dom_status dom_train_check(const struct dom_train *train)
{
#define CHECK(name, default_, lowest, highest, unit, meaning)                                                \
    if (!(train->name >= (lowest) && train->name <= (highest)))                                              \
        return DOM_BAD_PARAMETER;
    DOM_TRAIN_PARAMETERS(CHECK)
#undef CHECK
    /* Half a unit in the last place of 1: no more than r = 1/s loses when it is rounded. */
    if (fma(-train->r, train->s, 1) < -DBL_EPSILON / 2)
        return DOM_OUT_OF_REACH;
    /* The kinetic energy (c6) is as small as r^-(2q+1); below this it would lose its digits. */
    if ((2 * train->q + 1) * log(train->r) > -log(DBL_MIN / DBL_EPSILON))
        return DOM_UNDERFLOW;
    return DOM_OK;
}
