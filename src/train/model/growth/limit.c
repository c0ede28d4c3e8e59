/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds r_max, the largest growth. r_max is the first root of the margin between r = 1 and the reach. The
 * reach is r = 1/s with sharp edges, and less with rounded edges. If there is no root, r_max is the reach. */
#include "growth/limit.h"

/*
 * If the margin is known to the error e, its root is known to e / |m'|, where m' is the slope of the margin.
 * At the bottom of a dip m' is almost 0. The root is then known to sqrt(2 e / |m''|).
 */
KERNEL enum dom_status limit_uncertainty(struct growth *g, const struct limit *limit, real *uncertainty)
{
    const real r = limit->r_max, reach = g->geometry.span / g->s, tol = g->geometry.tol;
    /* 1/s is rounded once. With rounded edges, the reach has a few rounding errors more. */
    *uncertainty = (g->geometry.rolls ? 4 : 1) * ROUNDOFF * r;
    if (limit->ends != DOM_END_BARRIER)
        return DOM_OK;
    /* At the root, K and B are equal. The tails of their sums may be cut off at TAIL_SHARE tol. */
    const real K = limit->barrier,
               e = 2 * TAIL_SHARE * tol * K + 16 * REAL_EPSILON * (K + barrier_most(&g->geometry));
    const real falls = margin_value(&limit->beside) / (r - limit->beside.r);
    *uncertainty += r * tol / 4;
    if (!(falls * (reach - r) > e * 1000)) {
        const real step = fmin(sqrt(sqrt(REAL_EPSILON)) * r, fmin(reach - r, r - 1) / 2);
        const struct margin lo = margin_within(g, r - step, 0);
        const struct margin hi = g->status == DOM_OK ? margin_within(g, r + step, 0) : lo;
        const real wrong = e + 2 * fmax(lo.barrier_error, hi.barrier_error), up = margin_value(&lo),
                   down = margin_value(&hi);
        *uncertainty += fmin(2 * step * wrong / fabs(up - down), step * sqrt(2 * wrong / fabs(up + down)));
        return g->status;
    }
    *uncertainty += e / falls;
    return DOM_OK;
}

KERNEL enum dom_status limit_find(struct growth *g, struct limit *limit)
{
    struct margin first;
    struct geometry geometry = g->geometry;
    *limit = no_limit;
    limit->ends = DOM_END_BARRIER;
    if (g->status == DOM_OK && g->near > 0 && root_near(g, limit))
        return DOM_OK;
    if (g->status == DOM_OK)
        g->status = geometry_set(&geometry, g->s, 1);
    if (g->status == DOM_OK) {
        /* At r = 1 the kinetic energy K is P T. P has a closed form. T is a sum that is at least its first
         * term. With sharp edges, this term is 1. */
        const real least_T = geometry_inertia(&geometry, geometry.c) / geometry.upright_inertia;
        first = (struct margin){.r = 1,
                                .kinetic = geometry_paper_fuel(&geometry) * least_T,
                                .barrier = barrier_most(&geometry),
                                .is_bound = true};
        if (!geometry.conservative || !(first.kinetic > 2 * first.barrier))
            first = margin_signed(g, MARGIN_SIGN, 1, MARGIN_ROUGH);
    }
    if (g->status == DOM_OK && margin_value(&first) >= 0)
        return first_change(g, &first, limit);
    /* with rounded edges the reach may be less than 1 */
    const bool ends = g->status == DOM_OK || g->status == DOM_NO_FUEL || g->status == DOM_OUT_OF_REACH;
    *limit = no_limit;
    limit->why = g->status != DOM_OK ? g->status : g->locked ? DOM_LOCKS : DOM_STOPS;
    return g->status = ends ? DOM_OK : g->status;
}

static enum dom_status pair_find(struct growth *g, struct limit *found)
{
    *found = no_limit;
    /* If the growth is less than first.r, domino 1 does not tip over by itself before it hits the next domino
     * (5; b0). */
    const struct rounded *of = &g->geometry.rounded;
    const real theta_u = geometry_theta_u(&g->geometry),
               tips_at = of->rho * theta_u + of->tall * sin(theta_u), r = fmax(tips_at / g->s, 1);
    if (g->status != DOM_OK || r > g->geometry.span / g->s)
        return g->status;
    struct margin first = margin_signed(g, MARGIN_SIGN, r, MARGIN_ROUGH);
    const bool falls = margin_value(&first) >= 0;
    if (g->status != DOM_OK || first_change(g, &first, found) != DOM_OK || falls)
        return g->status;
    const real open = found->open;
    if (found->ends == DOM_END_BARRIER) { /* the margin becomes positive there */
        first = margin_signed(g, MARGIN_SIGN, found->r_max, MARGIN_ROUGH);
        if (g->status == DOM_OK)
            first_change(g, &first, found);
    } else
        *found = no_limit;
    /* the margin may or may not become positive at the first of two open growths */
    found->open = fmin(found->open, open);
    return g->status;
}

enum dom_status limit_answer(const struct dom_train *train, const struct dom_compute *compute, bool pair,
                             real near, struct dom_limit *limit)
{
    struct growth g;
    struct limit found;
    real uncertainty = REAL_NAN;
    growth_begin(train, compute, pair, near, &g);
    enum dom_status status = pair ? pair_find(&g, &found) : limit_find(&g, &found);
    if (status != DOM_OK)
        return status;
    const bool open = isfinite(found.open);
    if (found.ends != DOM_END_NONE)
        status = limit_uncertainty(&g, &found, &uncertainty);
    *limit = (struct dom_limit){.r_max = found.r_max,
                                .ends = found.ends,
                                .why = found.why,
                                .uncertainty = uncertainty,
                                .open = open ? found.open : REAL_NAN};
    return status == DOM_OK && open ? DOM_OPEN : status;
}
