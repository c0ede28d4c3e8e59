/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "effects/choose.h"
#include "geometry/far.h"

static const struct terms *const terms[] = {
#define DYNAMICS_TERMS(effect, member, status) &effect##_terms,
    DOM_DYNAMICS(DYNAMICS_TERMS)
#undef DYNAMICS_TERMS
};

KERNEL enum dom_status dynamics_choose(const dom_real effect[DOM_DYNAMICS_COUNT], struct geometry *geometry)
{
    enum dom_status status = DOM_OK;
    geometry->conservative = true;
    for (int i = 0; i < DOM_DYNAMICS_COUNT && status == DOM_OK; i++)
        if (dynamics_on(effect[i]))
            status = terms[i]->apply(geometry, (real)effect[i]);
    return status;
}

KERNEL void dynamics_of_domino(const struct row_request *row, size_t k, dom_real effect[DOM_DYNAMICS_COUNT])
{
/* without a loop, so that effects of which all dominoes have the same value cost nothing */
#define DYNAMICS_VALUE(name, member, status)                                                                 \
    effect[DOM_EFFECT_##name] = row->effect[DOM_EFFECT_##name];                                              \
    if (name##_terms.of_domino && dynamics_on(effect[DOM_EFFECT_##name]))                                    \
        effect[DOM_EFFECT_##name] = name##_terms.of_domino(row, k);
    DOM_DYNAMICS(DYNAMICS_VALUE)
#undef DYNAMICS_VALUE
}

KERNEL enum dom_status dynamics_read(const struct request *train, struct geometry *geometry)
{
    *geometry = geometry_read(train);
    return dynamics_choose(train->effect, geometry);
}

KERNEL enum dom_status dynamics_make(const struct request *train, struct geometry *geometry)
{
    enum dom_status status = dynamics_read(train, geometry);
    if (status == DOM_OK)
        status = geometry_set(geometry, geometry->s, geometry->r);
    if (status == DOM_OK)
        far_make(geometry, 16); /* 16 is about the number of passes that a train needs */
    return status;
}
