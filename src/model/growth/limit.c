/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds r_max, the largest growth. r_max is the first root of the margin between r = 1 and the reach. The
 * reach is r = 1/s with sharp edges, and less with rounded edges. If there is no root, r_max is the reach.
 *
 * The margin need not be monotone. For thin dominoes it first decreases, then increases, and finally drops
 * near the reach. So it can have more than one root, and an ordinary root finder could miss the first one.
 * The methods of limit.h look for the first root.
 */
#include "growth/limit.h"

static struct dom_limit limit_public(const struct limit *limit)
{
    return (struct dom_limit){.r_max = limit->r_max, .ends = limit->ends, .why = limit->why};
}

static const struct limit no_limit = {.r_max = REAL_NAN, .ends = DOM_END_NONE};

/* Finds the first r > from->r at which the margin becomes negative, or the reach if there is none. The margin
 * at from->r is >= 0. */
static enum dom_status limit_to_negative(struct margin_context *c, const struct margin_sample *from,
                                         struct limit *limit)
{
    *limit = (struct limit){.r_max = c->geometry.span / c->s, .ends = DOM_END_REACH};
    if (dynamics_bounded(&c->geometry) && c->dominoes == CHAIN_ENDLESS)
        return scan_to_negative(c, from, &limit->r_max, &limit->ends);
    struct margin_sample root;
    bool found = false;
    enum dom_status status = probe_change(c, from, &root, &found);
    if (status == DOM_OK && found)
        *limit = (struct limit){.r_max = root.r, .ends = DOM_END_BARRIER};
    return status;
}

KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit)
{
    struct margin_sample first = {.r = 1};
    struct geometry geometry = c->geometry;
    bool known = false;
    *limit = (struct limit){.ends = DOM_END_BARRIER};
    /* A coarser kernel has already found c->near as the first root. */
    if (c->status == DOM_OK && c->near > 0)
        c->status = root_near(c, c->near, &limit->r_max, &known);
    if (known)
        return c->status;
    enum dom_status status = c->status != DOM_OK ? c->status : geometry_set(&geometry, c->s, 1);
    if (status == DOM_OUT_OF_REACH) { /* with rounded edges the reach may be less than 1 */
        *limit = no_limit;
        limit->why = status;
        return DOM_OK;
    }
    if (status != DOM_OK)
        return c->status = status;
    /* At r = 1 the kinetic energy K is P T. P has a closed form. T is a sum that is at least its first term,
     * `own`. With sharp edges, `own` is 1. */
    const real own = geometry_inertia(&geometry, geometry.c) / geometry.upright_inertia;
    first.margin = (struct margin){.kinetic = geometry.law->paper_fuel(&geometry) * own,
                                   .barrier = barrier_most(&geometry),
                                   .barrier_is_bound = true};
    if (!geometry.dynamics->conservative || !(first.margin.kinetic > 2 * first.margin.barrier))
        first.margin = margin_sign(c, 1);
    if (c->status == DOM_NO_FUEL || (c->status == DOM_OK && margin_value(&first.margin) < 0)) {
        *limit = no_limit;
        limit->why = c->status == DOM_NO_FUEL ? DOM_NO_FUEL : c->locked ? DOM_LOCKS : DOM_STOPS;
        return c->status = DOM_OK;
    }
    if (c->status == DOM_OK)
        c->status = limit_to_negative(c, &first, limit);
    return c->status;
}

/* The maximum number of visits to dominoes in a search that has to solve an equation of motion. Each of these
 * visits takes four times as long as a visit in other searches. */
#define WORK_MOST_FLOW ((size_t)15000000)

KERNEL void limit_begin(struct margin_context *c)
{
    const size_t most = c->geometry.law->work_most;
    c->geometry.effort = &c->effort;
    c->geometry.effort_most =
        c->geometry.dynamics->conservative || most < WORK_MOST_FLOW ? most : WORK_MOST_FLOW;
}

KERNEL enum dom_status limit_rmax(const struct request *train, struct dom_limit *limit)
{
    struct margin_context c = margin_of_train(train);
    struct limit found;
    limit_begin(&c);
    enum dom_status status = limit_find(&c, &found);
    if (status == DOM_OK)
        *limit = limit_public(&found);
    return status;
}

static enum dom_status pair_find(struct margin_context *c, struct limit *found)
{
    *found = no_limit;
    /* If the growth is less than first.r, domino 1 does not tip over by itself before it hits the next domino
     * (5; b0). */
    struct margin_sample first = {.r = fmax(c->geometry.law->tips_at(&c->geometry) / c->s, 1)}, sample;
    if (first.r > c->geometry.span / c->s)
        return DOM_OK;
    sample = first;
    sample.margin = first.margin = margin_sign(c, first.r);
    bool any = c->status == DOM_OK && margin_value(&first.margin) >= 0;
    if (c->status == DOM_OK && !any)
        c->status = probe_change(c, &first, &sample, &any);
    return c->status == DOM_OK && any ? limit_to_negative(c, &sample, found) : c->status;
}

KERNEL enum dom_status limit_pair(const struct request *train, struct dom_limit *limit)
{
    struct margin_context c = margin_of_pair(train);
    struct limit found;
    limit_begin(&c);
    enum dom_status status = c.status == DOM_OK ? pair_find(&c, &found) : c.status;
    if (status == DOM_OK)
        *limit = limit_public(&found);
    return status;
}
