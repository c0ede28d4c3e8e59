/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The largest growth: the margin as a function of r, scanned upwards from r = 1 to the reach r = 1/s.
 * The margin need not be monotone (thin dominoes: it falls, rises again and drops near 1/s), so a dip
 * between two samples is looked into before the scan goes on.
 */
#include "growth/margin.h"

/* Samples a factor e of r, far from the reach; then a decade of 1 - r s each. */
#define SCAN_PER_E   8
#define SCAN_DECADES 8

/* The k-th sample of r between 1 and the reach; the last is 1/s itself, and larger k give it again. */
static real scan_sample(real s, int k)
{
    const real near = (real)0.1;
    real ln_reach = -log(s);
    int far = (int)ceil(fmax(ln_reach - near, 0) * SCAN_PER_E);
    if (k < far)
        return exp((real)k * fmax(ln_reach - near, 0) / (real)far);
    real short_of = fmin(near, 1 - s) * pow(10, (real)(far - k));
    return k - far > SCAN_DECADES ? 1 / s : fmax((1 - short_of) / s, 1);
}

/* A sample of the scan. */
struct edge {
    real r;
    struct margin margin;
};

struct limit {
    real r_max;
    enum dom_end ends;
};

static real margin_below(real r, void *context)
{
    return -margin_at(r, context);
}

/*
 * The root of the margin between lo and hi, for which the top of the barrier at hi is followed.  That it is
 * the highest also at the root is seen there by one more search; where it is not, all tops are searched at
 * every r.
 */
static enum dom_status limit_root(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                  real *r)
{
    real tol = c->lean.tol;
    enum num_status solver;
    if (c->train->mu == 0) {
        margin_follow_begin(c);
        solver = num_root_between(margin_follow, c, lo->r, margin_share(&lo->margin), hi->r,
                                  margin_share(&hi->margin), tol / 8, r);
        if (c->status == DOM_INTERRUPTED)
            return c->status;
        if (solver == NUM_OK && margin_highest(c, *r))
            return DOM_OK;
    }
    solver = num_root(margin_at, c, lo->r, hi->r, tol / 8, r);
    return model_status(c->status, solver);
}

/*
 * May the margin reach below 0 between the first and the last?  Where it is lowest in the middle; but kinetic
 * energy alone is smooth, and goes no deeper than a few times what the parabola through the three does.
 */
static bool dips(const struct edge edge[3])
{
    const struct margin *before = &edge[0].margin, *low = &edge[1].margin, *next = &edge[2].margin;
    real left = margin_left(low), down = margin_left(before) - left, up = margin_left(next) - left;
    real back = edge[1].r - edge[0].r, on = edge[2].r - edge[1].r;
    real bend = (up / on + down / back) / (back + on), slope = bend * back - down / back;
    bool smooth = before->most && low->most && next->most;
    return margin_left(next) >= 0 && down > 0 && up > 0 && !(smooth && left > slope * slope / bend);
}

/* First r > lo at which the margin, >= 0 at lo, is negative; DOM_END_REACH if there is none. */
static enum dom_status limit_scan(struct margin_context *c, int k, struct margin margin, struct limit *limit)
{
    real s = c->s, reach = 1 / s;
    struct edge edge[3] = {{REAL_NAN, {.kinetic = REAL_NAN}}, {scan_sample(s, k), margin}};
    while (edge[1].r < reach) {
        edge[2].r = scan_sample(s, ++k);
        edge[2].margin = margin_sign(c, edge[2].r);
        if (c->status != DOM_OK)
            return c->status;
        if (dips(edge)) {
            struct edge low = {0};
            enum num_status solver =
                num_maximum(margin_below, c, edge[0].r, edge[1].r, edge[2].r, (real)1e-6, &low.r);
            if (model_status(c->status, solver) == DOM_OK)
                low.margin = margin_sign(c, low.r);
            if (c->status != DOM_OK)
                return c->status;
            if (solver == NUM_OK && margin_left(&low.margin) < 0) {
                edge[1] = low.r < edge[1].r ? edge[0] : edge[1];
                edge[2] = low;
            }
        }
        if (margin_left(&edge[2].margin) < 0) {
            limit->ends = DOM_END_BARRIER;
            return limit_root(c, &edge[1], &edge[2], &limit->r_max);
        }
        edge[0] = edge[1];
        edge[1] = edge[2];
    }
    *limit = (struct limit){.r_max = reach, .ends = DOM_END_REACH};
    return DOM_OK;
}

/*
 * Of a root of the margin: what is left of the margin and what may be wrong with it, over its slope in r.
 * The slope is that of a difference wide enough to stand out from what may be wrong with both margins,
 * on this side of the reach.
 */
static enum dom_status limit_error(struct margin_context *c, const struct limit *limit, real *error)
{
    real r = limit->r_max, reach = 1 / c->s;
    *error = c->train->mu > 0 ? REAL_NAN : UNIT * r;
    if (limit->ends != DOM_END_BARRIER || c->train->mu > 0)
        return DOM_OK;
    c->errors = true;
    real margin = margin_at(r, c), wrong = c->error, slope = 0;
    c->errors = false;
    real widest = fmin((reach - r) / 4, r / 4), h = fmin(sqrt(REAL_EPSILON) * 64 * r, widest);
    for (; c->status == DOM_OK && slope == 0; h = fmin(8 * h, widest)) {
        real lo = fmax(r - h, 1), above = margin_at(r + h, c);
        real below = c->status == DOM_OK ? margin_at(lo, c) : above;
        if (fabs(above - below) > 8 * wrong || h >= widest)
            slope = fabs(above - below) > 2 * wrong ? fabs(above - below) / (r + h - lo) : REAL_MIN;
    }
    /* Where even the widest shows no slope, all that is known is that r lies between 1 and the reach. */
    *error += slope > REAL_MIN ? 2 * (fabs(margin) + wrong) / slope : reach - 1;
    /* Near the reach the margin bends: the bound holds if the margins at its ends have their signs for sure.
     */
    for (bool sure = false; c->status == DOM_OK && !sure && *error < reach - 1; *error *= sure ? 1 : 4) {
        real lo = fmax(r - *error, 1), hi = fmin(r + *error, reach);
        sure = (lo == 1 || margin_at(lo, c) > wrong) && (hi == reach || margin_at(hi, c) < -wrong);
    }
    return c->status;
}

/* As the caller wants it. */
static enum dom_status limit_public(struct margin_context *c, const struct limit *limit,
                                    struct dom_limit *wide, struct dom_limit *error)
{
    real r_error = 0;
    enum dom_status status = error ? limit_error(c, limit, &r_error) : DOM_OK;
    if (status != DOM_OK)
        return status;
    *wide = (struct dom_limit){.r_max = limit->r_max, .ends = limit->ends};
    if (error)
        *error = (struct dom_limit){.r_max = r_error, .ends = limit->ends};
    return DOM_OK;
}

static const struct limit no_limit = {.r_max = REAL_NAN, .ends = DOM_END_NONE};

static enum dom_status rmax_find(struct margin_context *c, struct limit *limit, enum dom_status *why)
{
    struct margin margin = margin_sign(c, 1);
    if (c->status == DOM_NO_FUEL || (c->status == DOM_OK && margin_left(&margin) < 0)) {
        *limit = no_limit;
        if (why)
            *why = c->status == DOM_NO_FUEL ? DOM_NO_FUEL : c->locked ? DOM_LOCKS : DOM_STOPS;
        return c->status = DOM_OK;
    }
    return c->status == DOM_OK ? limit_scan(c, 0, margin, limit) : c->status;
}

KERNEL enum dom_status limit_rmax(const struct dom_train *train, struct dom_limit *limit,
                                  struct dom_limit *error, enum dom_status *why)
{
    struct margin_context c = margin_of_train(train);
    struct limit found;
    enum dom_status status = rmax_find(&c, &found, why);
    return status == DOM_OK ? limit_public(&c, &found, limit, error) : status;
}

KERNEL enum dom_status limit_pair(const struct dom_train *train, struct dom_limit *limit,
                                  struct dom_limit *error)
{
    struct margin_context c = margin_of_pair(train);
    struct limit found = no_limit;
    real r = 0;
    for (int k = 0; r < 1 / c.s; k++) {
        r = scan_sample(c.s, k);
        struct margin margin = margin_sign(&c, r);
        if (c.status != DOM_OK)
            return c.status;
        if (margin_left(&margin) >= 0) {
            enum dom_status status = limit_scan(&c, k, margin, &found);
            if (status != DOM_OK)
                return status;
            break;
        }
    }
    return limit_public(&c, &found, limit, error);
}

/* ---- The best separation ---- */

static real rmax_at(real s, void *context)
{
    struct margin_context *c = context;
    struct limit limit;
    if (c->status != DOM_OK) /* the reason of the first failure */
        return REAL_NAN;
    c->s = s;
    if (rmax_find(c, &limit, NULL) != DOM_OK)
        return REAL_NAN;
    return limit.ends == DOM_END_NONE ? 0 : limit.r_max;
}

/*
 * d r_max / d s by the nine-point rule.  Its error is (h / scale)^8, where r_max bends over a few percent
 * of s, and roundoff / h: least near this h.
 */
static real slope_step(real s)
{
    return (real)0.03 * exp(log(REAL_EPSILON) / 9) * s;
}

static real rmax_slope_by(real s, real h, void *context)
{
    static const int weight[] = {672, -168, 32, -3};
    real sum = 0;
    for (int k = 1; k <= 4; k++)
        sum += (real)weight[k - 1] * (rmax_at(s + (real)k * h, context) - rmax_at(s - (real)k * h, context));
    return sum / (840 * h);
}

static real rmax_slope(real s, void *context)
{
    return rmax_slope_by(s, slope_step(s), context);
}

#define BEST_RATIO    ((real)0.9) /* of successive separations */
#define BEST_PATIENCE 8           /* as many lower ones in a row end the search */
#define BEST_LOWEST   ((real)2e-6)

/* How much lower r_max is at s + step than the top; 0 behind a jump, whose lower side is not the top's. */
static real best_fall(struct margin_context *c, real s, real step, real top)
{
    real far = fabs(rmax_at(s + step, c) - top), near = fabs(rmax_at(s + step / 8, c) - top);
    return near > far / 2 && far > 64 * UNIT * top ? 0 : far;
}

/*
 * Near a smooth top r_max is flat: what rounding and tol leave of its slope bounds s, over the curvature;
 * at a kink or a jump s is bracketed to tol itself.  r_max may be off by as much as it changes over that.
 */
static enum dom_status best_error(struct margin_context *c, real s, bool smooth, struct dom_best *error)
{
    real h = slope_step(s), width = 4 * h, r_error = 0;
    struct limit limit;
    c->s = s;
    enum dom_status status = rmax_find(c, &limit, NULL);
    if (status == DOM_OK)
        status = limit_error(c, &limit, &r_error);
    real s_error = 2 * fmax((real)c->train->tol, 4 * REAL_EPSILON) * s;
    if (status == DOM_OK && smooth) {
        real bend = fabs(rmax_slope(s + width, c) - rmax_slope(s - width, c)) / (2 * width);
        /* Twice the step has 256 times the error of the rule. */
        real slope = rmax_slope(s, c), rule = fabs(rmax_slope_by(s, 2 * h, c) - slope) / 32;
        s_error = 2 * UNIT * s + (fabs(slope) + rule + 2 * r_error / h) / bend;
    }
    if (c->status == DOM_OK && status == DOM_OK)
        r_error += fmax(best_fall(c, s, -fmin(s_error, s / 2), limit.r_max),
                        best_fall(c, s, fmin(s_error, 1 - s), limit.r_max));
    *error = (struct dom_best){.s = s_error, .r_max = r_error};
    return status != DOM_OK ? status : c->status;
}

KERNEL enum dom_status limit_best(const struct dom_train *train, struct dom_best *best,
                                  struct dom_best *error)
{
    struct margin_context c = margin_of_train(train);
    real s = 1, top = s, height = rmax_at(s, &c);
    for (int lower = 0; lower < BEST_PATIENCE && c.status == DOM_OK && s > BEST_LOWEST;) {
        s *= BEST_RATIO;
        real value = rmax_at(s, &c);
        lower = value > height ? 0 : lower + 1;
        if (value > height) {
            height = value;
            top = s;
        }
    }
    if (c.status != DOM_OK)
        return c.status;
    if (!(height > 1) || top == 1)
        return DOM_NO_GROWTH;

    enum num_status solver =
        num_maximum(rmax_at, &c, top * BEST_RATIO, top, top / BEST_RATIO, (real)train->tol, &top);
    enum dom_status status = model_status(c.status, solver);
    if (status != DOM_OK)
        return status;
    height = rmax_at(top, &c);
    /* A smooth top is where the slope vanishes; at a kink or a jump that would lie lower. */
    real zero, width = fmax((real)1e-4, 16 * sqrt(REAL_EPSILON)) * top;
    solver = num_root(rmax_slope, &c, top - width, top + width, (real)train->tol, &zero);
    bool smooth = solver == NUM_OK && rmax_at(zero, &c) >= height * (1 - 16 * REAL_EPSILON);
    top = smooth ? zero : top;
    height = c.status == DOM_OK ? rmax_at(top, &c) : 0;
    if (c.status == DOM_OK && error)
        c.status = best_error(&c, top, smooth, error);
    if (c.status == DOM_OK)
        *best = (struct dom_best){.s = top, .r_max = height};
    return c.status;
}
