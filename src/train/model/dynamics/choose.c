/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dynamics/choose.h"
#include "geometry/far.h"

/* Each effect in DOM_DYNAMICS has a source file and a function that switches it on. */
#define DYNAMICS_DECLARE(effect, member, status)                                                             \
    KERNEL enum dom_status effect##_apply(struct geometry *geometry, real value);
DOM_DYNAMICS(DYNAMICS_DECLARE)
#undef DYNAMICS_DECLARE

KERNEL enum dom_status dynamics_choose(const dom_real effect[DOM_DYNAMICS_COUNT], struct geometry *geometry)
{
    static enum dom_status (*const apply[])(struct geometry *, real) = {
#define DYNAMICS_APPLY(effect, member, status) effect##_apply,
        DOM_DYNAMICS(DYNAMICS_APPLY)
#undef DYNAMICS_APPLY
    };
    enum dom_status status = DOM_OK;
    geometry->dynamics = &energy_balance;
    for (int i = 0; i < DOM_DYNAMICS_COUNT && status == DOM_OK; i++)
        if (dynamics_on(effect[i]))
            status = apply[i](geometry, (real)effect[i]);
    return status;
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

KERNEL enum dom_status dynamics_begin(struct geometry *geometry)
{
    return geometry->dynamics->begin ? geometry->dynamics->begin(geometry) : DOM_OK;
}

KERNEL void dynamics_end(struct geometry *geometry)
{
    if (geometry->dynamics->end)
        geometry->dynamics->end(geometry);
}
