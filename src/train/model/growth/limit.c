/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds r_max, the largest growth. r_max is the first root of the margin between r = 1 and the reach. The
 * reach is r = 1/s with sharp edges, and less with rounded edges. If there is no root, r_max is the reach. */
#include "growth/limit.h"

/*
 * If the margin is known to the error e, its root is known to e / |m'|, where m' is the slope of the margin.
 * At the bottom of a dip m' is almost 0. The root is then known to sqrt(2 e / |m''|).
 */
KERNEL enum dom_status limit_uncertainty(struct margin_context *c, const struct limit *limit,
                                         real *uncertainty)
{
    const real r = limit->r_max, reach = c->geometry.span / c->s, tol = c->geometry.tol;
    *uncertainty = ROUNDOFF * r;
    if (limit->ends != DOM_END_BARRIER)
        return DOM_OK;
    /* At the root, K and B are equal. The tails of their sums may be cut off at TAIL_SHARE tol. */
    const real K = limit->barrier,
               e = 2 * TAIL_SHARE * tol * K + 16 * REAL_EPSILON * (K + barrier_most(&c->geometry));
    real falls = limit->falls;
    *uncertainty += r * tol / 4;
    if (!(falls * (reach - r) > e * 1000)) {
        const real step = fmin(sqrt(sqrt(REAL_EPSILON)) * r, fmin(reach - r, r - 1) / 2);
        const struct margin lo = margin_within(c, r - step, 0);
        const struct margin hi = c->status == DOM_OK ? margin_within(c, r + step, 0) : lo;
        const real wrong = e + 2 * fmax(lo.barrier_error, hi.barrier_error), up = margin_value(&lo),
                   down = margin_value(&hi);
        *uncertainty += fmin(2 * step * wrong / fabs(up - down), step * sqrt(2 * wrong / fabs(up + down)));
        return c->status;
    }
    *uncertainty += e / falls;
    return DOM_OK;
}

static const struct limit no_limit = {
    .r_max = REAL_NAN, .ends = DOM_END_NONE, .open = (real)INFINITY, .dip = (real)INFINITY};

KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit)
{
    struct margin_sample first = {.r = 1};
    struct geometry geometry = c->geometry;
    *limit = (struct limit){.ends = DOM_END_BARRIER, .open = (real)INFINITY, .dip = (real)INFINITY};
    /* A coarser kernel has already found c->near as the first root. */
    struct root root = {.r = (real)INFINITY};
    if (c->status == DOM_OK && c->near > 0)
        c->status = root_any(c, 0, c->near, &root);
    limit->r_max = root.r;
    limit->barrier = root.barrier;
    limit->falls = root.falls;
    if (isfinite(root.r))
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
    first.margin = (struct margin){.kinetic = geometry_paper_fuel(&geometry) * own,
                                   .barrier = barrier_most(&geometry),
                                   .barrier_is_bound = true};
    if (!geometry.conservative || !(first.margin.kinetic > 2 * first.margin.barrier))
        first.margin = margin_sign(c, 1, true);
    if (c->status == DOM_NO_FUEL || (c->status == DOM_OK && margin_value(&first.margin) < 0)) {
        *limit = no_limit;
        limit->why = c->status == DOM_NO_FUEL ? DOM_NO_FUEL : c->locked ? DOM_LOCKS : DOM_STOPS;
        return c->status = DOM_OK;
    }
    if (c->status == DOM_OK)
        c->status = first_change(c, &first, limit);
    return c->status;
}

KERNEL void limit_begin(struct margin_context *c)
{
    c->geometry.effort = &c->effort;
    /* The maximum number of visits to dominoes. In double, they take about a second. */
    c->geometry.effort_most = c->geometry.rolls ? 7000000 : c->geometry.conservative ? 60000000 : 15000000;
}

static enum dom_status pair_find(struct margin_context *c, struct limit *found)
{
    *found = no_limit;
    /* If the growth is less than first.r, domino 1 does not tip over by itself before it hits the next domino
     * (5; b0). */
    const struct rounded *of = &c->geometry.rounded;
    const real theta_u = geometry_theta_u(&c->geometry),
               tips_at = of->rho * theta_u + of->tall * sin(theta_u);
    struct margin_sample first = {.r = fmax(tips_at / c->s, 1)};
    if (first.r > c->geometry.span / c->s)
        return DOM_OK;
    first.margin = margin_sign(c, first.r, true);
    if (c->status != DOM_OK)
        return c->status;
    const bool falls = margin_value(&first.margin) >= 0;
    enum dom_status status = first_change(c, &first, found);
    if (falls || status != DOM_OK)
        return status;
    const real open = found->open;
    if (found->ends == DOM_END_BARRIER) { /* the margin becomes positive there */
        first = (struct margin_sample){.r = found->r_max, .margin = margin_sign(c, found->r_max, true)};
        status = c->status == DOM_OK ? first_change(c, &first, found) : c->status;
    } else
        *found = no_limit;
    /* the margin may or may not become positive at the first of two open growths */
    found->open = fmin(found->open, open);
    return status;
}

KERNEL enum dom_status limit_answer(const struct dom_train *train, const struct dom_compute *compute,
                                    bool pair, real near, struct dom_limit *limit)
{
    struct margin_context c = pair ? margin_of_pair(train, compute) : margin_of_train(train, compute);
    struct limit found;
    real uncertainty = REAL_NAN;
    c.near = near;
    limit_begin(&c);
    enum dom_status status = c.status != DOM_OK ? c.status
                             : pair             ? pair_find(&c, &found)
                                                : limit_find(&c, &found);
    if (status != DOM_OK)
        return status;
    const bool open = isfinite(found.open);
    if (found.ends != DOM_END_NONE)
        status = limit_uncertainty(&c, &found, &uncertainty);
    *limit = (struct dom_limit){.r_max = found.r_max,
                                .ends = found.ends,
                                .why = found.why,
                                .uncertainty = uncertainty,
                                .open = open ? found.open : REAL_NAN};
    return status == DOM_OK && open ? DOM_OPEN : status;
}
