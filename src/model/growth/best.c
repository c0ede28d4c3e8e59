/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The best separation. Samples give a growth R that some separation allows. Then all intervals of s are
 * excluded in which no separation allows more: either s R > 1 in the whole interval, or a bound (strip.h)
 * shows that no train of the interval goes on at R, or at a smaller growth at which a train of the interval
 * stops. The other intervals are halved. Tops of r_max(s) wider than BEST_FINEST of s are resolved; only the
 * middle of a narrower interval is computed. With friction there is no bound, and only samples are known.
 */
#include "growth/limit.h"

#define BEST_RATIO    ((real)0.9) /* ratio of successive samples */
#define BEST_PATIENCE 8           /* the search ends after this many lower samples in a row */
#define BEST_LOWEST   ((real)1e-6)
#define BEST_FINEST   ((real)2e-3)
#define BEST_FIRST    fmax((real)1e-6, 64 * REAL_EPSILON) /* smallest s until a growth is found */

struct search {
    struct margin_context *c;
    real s, r_max; /* the best separation so far */
    real finest;   /* width of the narrowest interval, over s */
    real finer;    /* the share of slope_step that is used */
};

/* Returns r_max at s, or 0 if not even a train with r = 1 goes on. */
static real rmax_at(real s, void *context)
{
    struct margin_context *c = context;
    struct limit limit;
    if (c->status != DOM_OK) /* keeps the reason of the first failure */
        return REAL_NAN;
    c->s = s;
    if (limit_find(c, &limit) != DOM_OK)
        return REAL_NAN;
    return limit.ends == DOM_END_NONE ? 0 : limit.r_max;
}

/* Returns r_max at s, and keeps s if it is the best so far. A coarse scan is enough unless s seems to be
 * better: a dip that the scan misses makes r_max larger, never smaller. */
static real search_at(struct search *b, real s)
{
    b->c->coarse = (real)1e-3;
    real r_max = rmax_at(s, b->c);
    b->c->coarse = 0;
    if (b->c->status == DOM_OK && r_max > b->r_max)
        r_max = rmax_at(s, b->c);
    if (b->c->status == DOM_OK && r_max > b->r_max) {
        b->s = s;
        b->r_max = r_max;
    }
    return r_max;
}

/* Finds the margin at one growth as a function of s. Without fuel the margin is negative. */
static enum dom_status margin_of_s(struct margin_context *c, real s, real r, struct margin *m)
{
    c->s = s;
    *m = margin_rough(c, r, fmax((real)1e-6, c->geometry.tol));
    if (c->status == DOM_NO_FUEL) {
        *m = (struct margin){.kinetic = -1};
        c->status = DOM_OK;
    }
    return c->status;
}

/* Sets *stops if no train between lo and hi goes on at the growth r. m is the margin at lo. */
static enum dom_status search_stops(struct margin_context *c, real lo, real hi, real r,
                                    const struct margin *m, bool *stops)
{
    struct geometry at_lo = c->geometry, at_hi = c->geometry;
    struct strip strip;
    *stops = false;
    enum dom_status status = geometry_set(&at_lo, lo, r);
    if (status == DOM_OK)
        status = geometry_set(&at_hi, hi, r);
    /* At r = 1 the fuels agree, and P increases with s where it is positive. */
    if (status == DOM_OK && r == 1 && at_hi.law->paper_fuel(&at_hi) <= 0) {
        *stops = true;
        return DOM_OK;
    }
    if (status == DOM_OK)
        status = strip_walk(&at_lo, &at_hi, c->train->fuel, (real)INFINITY,
                            fmin((real)1e-2, (hi - lo) / lo / 16), &strip);
    if (status != DOM_OK)
        return status;
    real barrier = m->barrier * (1 - (real)1e-5),
         least = strip_barrier_least(&strip, barrier, barrier_most(&at_lo), hi - lo);
    *stops = strip.kinetic_most <= 0 || strip.kinetic_most < least;
    return DOM_OK;
}

/*
 * Finds a growth at which a train stops, for a separation s where the margin at R is not negative but r_max
 * is lower than R: r_max, or a better witness a little above r_max.
 */
static enum dom_status search_witness(const struct search *b, real s, real r_max, real *witness)
{
    real lowest = 0;
    *witness = b->r_max;
    real step = (b->r_max - r_max) / 2;
    while (step > (real)1e-4 * r_max) {
        struct margin m;
        enum dom_status status = margin_of_s(b->c, s, r_max + step, &m);
        if (status != DOM_OK)
            return status;
        if (margin_share(&m) < lowest) {
            lowest = margin_share(&m);
            *witness = r_max + step;
        }
        step /= 2;
    }
    return DOM_OK;
}

/* Returns the width of the narrowest interval. The width grows when an answer has done much of its allowed
 * work, so that the search ends. */
static real search_finest(const struct search *b)
{
    const struct geometry *geometry = &b->c->geometry;
    real done = (real)*geometry->effort / (real)geometry->effort_most;
    return b->r_max > 1 ? b->finest * (1 + 1024 * done * done) : BEST_FIRST;
}

/* Searches for a larger growth between lo and hi. `witness` is a growth at which the trains of the interval
 * may stop. */
static enum dom_status search_between(struct search *b, real lo, real hi, real witness)
{
    struct margin_context *c = b->c;
    struct margin m;
    enum dom_status status = DOM_OK;
    bool stops = false;
    real last = 1 / fmax(b->r_max, 1);
    hi = fmin(hi, last);
    if (lo >= hi)
        return DOM_OK;
    for (int k = 0; k < 2 && status == DOM_OK && !stops; k++) {
        real r = fmax(k == 0 ? b->r_max : witness, 1);
        if (k == 1 && (witness >= b->r_max || witness * hi > 1))
            break;
        status = margin_of_s(c, lo, r, &m);
        if (status == DOM_OK && margin_value(&m) < 0)
            status = search_stops(c, lo, hi, r, &m, &stops);
    }
    if (status != DOM_OK || stops)
        return status;
    real middle = sqrt(lo * hi);
    status = margin_of_s(c, middle, fmax(b->r_max, 1), &m);
    bool above = status == DOM_OK && margin_value(&m) >= 0;
    if (above && witness < b->r_max) {
        status = margin_of_s(c, middle, witness, &m);
        above = status == DOM_OK && margin_value(&m) >= 0;
    }
    if (above) {
        real r_max = search_at(b, middle);
        status = c->status;
        if (status == DOM_OK && r_max > 0 && r_max < b->r_max * (1 - (real)1e-3))
            status = search_witness(b, middle, r_max, &witness);
    }
    if (status != DOM_OK || hi - lo <= search_finest(b) * hi)
        return status;
    status = search_between(b, middle, hi, witness);
    return status == DOM_OK ? search_between(b, lo, middle, witness) : status;
}

/* Samples from the largest s downwards. */
static enum dom_status search_samples(struct search *b)
{
    int lower = 0;
    const real span = b->c->geometry.span;
    b->s = span;
    b->r_max = rmax_at(span, b->c);
    for (real s = span * BEST_RATIO; b->c->status == DOM_OK && lower < BEST_PATIENCE && s > BEST_LOWEST;
         s *= BEST_RATIO) {
        real before = b->r_max;
        search_at(b, s);
        lower = b->r_max > before ? 0 : lower + 1;
    }
    return b->c->status;
}

/* Searches with friction: near the best sample, and at all larger s that the reach allows, in smaller
 * steps. */
static enum dom_status search_finely(struct search *b)
{
    for (real ratio = sqrt(BEST_RATIO); ratio < 1 - 2 * BEST_FINEST && b->c->status == DOM_OK;
         ratio = sqrt(ratio)) {
        bool any = b->r_max > 0;
        const real span = b->c->geometry.span;
        real from = any ? fmin(b->s / (ratio * ratio), span) : span,
             to = any ? b->s * ratio * ratio : (real)0.5;
        for (real s = from; s > to && b->c->status == DOM_OK; s *= ratio)
            if (s * b->r_max < span)
                search_at(b, s);
    }
    return b->c->status;
}

/* ---- The top ---- */

/*
 * Returns the step h for d margin / ds at a fixed growth by the nine-point rule. The error of the rule is (h
 * / scale)^8, plus the rounding error over h: it is smallest near this h. The scale is a few percent of s, or
 * the distance to the reach.
 */
static real slope_step(real span, real s, real r)
{
    return fmin((real)0.03 * s, (span / r - s) / 2) * exp(log(REAL_EPSILON) / 9);
}

static real margin_slope_by(struct margin_context *c, real s, real r, real h)
{
    static const int weight[] = {672, -168, 32, -3};
    real sum = 0;
    for (int k = 1; k <= 4 && c->status == DOM_OK; k++) {
        c->s = s + (real)k * h;
        real after = margin_at(r, c);
        c->s = s - (real)k * h;
        sum += (real)weight[k - 1] * (after - (c->status == DOM_OK ? margin_at(r, c) : 0));
    }
    return c->status == DOM_OK ? sum / (840 * h) : REAL_NAN;
}

/* Returns d margin / ds at r = r_max(s), which has the sign of d r_max / ds. At the reach r_max = 1/s
 * decreases. */
static real top_slope(real s, void *context)
{
    struct search *b = context;
    struct margin_context *c = b->c;
    real r = rmax_at(s, c), span = c->geometry.span, h = slope_step(span, s, r) * b->finer;
    if (c->status != DOM_OK)
        return REAL_NAN;
    return r > 0 && s + 4 * h < span / r ? margin_slope_by(c, s, r, h) : -1;
}

/*
 * Finds the part of slope_step at which the error of the rule is smallest. Its nodes may contain a jump of
 * the second derivative, where a follower begins to detach. The difference of two steps shows such a jump;
 * the rounding error over h bounds the step below.
 */
static void search_step(struct search *b)
{
    real span = b->c->geometry.span, s = b->s, r = b->r_max, h = slope_step(span, s, r),
         least = (real)INFINITY;
    b->finer = 1;
    if (!(h > 0) || s + 4 * h >= span / r)
        return;
    real last = margin_slope_by(b->c, s, r, h), K = barrier_most(&b->c->geometry);
    for (real share = 1; share > (real)1e-5 && b->c->status == DOM_OK; share /= 4) {
        real next = margin_slope_by(b->c, s, r, h * share / 4);
        real wrong = fabs(next - last) + 16 * fmax(b->c->geometry.tol, REAL_EPSILON) * K / (h * share);
        if (wrong < least) {
            least = wrong;
            b->finer = share;
        }
        last = next;
    }
}

/* Finds the top near b->s. If it is smooth, the slope changes its sign there; at a kink or a jump golden
 * section finds it. */
static enum dom_status search_top(struct search *b, real tol, bool *smooth)
{
    struct margin_context *c = b->c;
    const real span = c->geometry.span;
    real s = b->s, low = 0, high = 0, width;
    c->geometry.tol = (real)c->train->tol;
    /* Moves the interval up, as wide as it is, and widens it until r_max is lower on both sides. */
    for (width = b->finest / 2; c->status == DOM_OK && width < (real)0.5; width *= 2) {
        low = rmax_at(s * (1 - width), c);
        high = s * (1 + width) <= span ? rmax_at(s * (1 + width), c) : 0;
        if (!(low >= b->r_max || high >= b->r_max))
            break;
        if (low > b->r_max || high > b->r_max) {
            s = low > high ? s * (1 - width) : s * (1 + width);
            b->s = s;
            b->r_max = fmax(low, high);
            width /= 2;
        }
    }
    *smooth = false;
    if (c->status != DOM_OK)
        return c->status;
    real top = s, hi = fmin(s * (1 + width), span);
    enum num_status solver =
        s < hi ? num_maximum(rmax_at, c, s * (1 - width), s, hi, tol, &top) : NUM_NOT_BRACKETED;
    if (model_status(c->status, solver) != DOM_OK && solver != NUM_NOT_BRACKETED)
        return model_status(c->status, solver);
    search_at(b, top);
    /* The slope of the margin is a difference, and needs all digits. */
    c->geometry.tol = fmax((real)c->train->tol / 512, 8 * REAL_EPSILON);
    search_step(b);
    /* Values alone fix a smooth top only to the square root of their noise; a bracket for the slope begins
     * outside of that distance. */
    for (width = 16 * sqrt(fmax(tol, REAL_EPSILON)); c->status == DOM_OK && width < (real)0.02; width *= 4) {
        real lo = b->s * (1 - width), up = b->s * (1 + width), zero;
        real before = top_slope(lo, b), after = up <= span ? top_slope(up, b) : -1;
        if (c->status != DOM_OK || !(before > 0 && after < 0))
            continue;
        /* At a smooth top the slope decreases with the distance; at a kink or a jump the slope of one side
         * does not. */
        real near_lo = top_slope(b->s * (1 - width / 8), b), near_up = top_slope(b->s * (1 + width / 8), b);
        if (c->status != DOM_OK || near_lo > before / 4 || near_up < after / 4)
            break;
        if (num_root_between(top_slope, b, lo, before, up, after, tol / 8, &zero) != NUM_OK)
            break;
        real height = rmax_at(zero, c);
        if (c->status == DOM_OK && height >= b->r_max * (1 - fmax(16 * tol, 64 * REAL_EPSILON))) {
            *smooth = slope_step(c->geometry.span, zero, height) > 0 && zero * height < c->geometry.span;
            b->s = zero;
            b->r_max = height;
        }
        break;
    }
    return c->status;
}

/* Returns how much lower than the top r_max is at s + step. Returns 0 after a jump, whose lower side does not
 * belong to the top. */
static real best_fall(struct margin_context *c, real s, real step, real top)
{
    real far = fabs(rmax_at(s + step, c) - top), near = fabs(rmax_at(s + step / 8, c) - top);
    return near > far / 2 && far > 64 * UNIT * top ? 0 : far;
}

/*
 * Finds the error bounds. If the law of motion is not conservative, no bound is known: both are NaN. Near a
 * smooth top the slope is 0: what rounding, tol and the rule leave of the slope, over its derivative, bounds
 * s. At a kink or a jump s is bracketed to tol itself. r_max may be wrong by its change over the error of s.
 */
static enum dom_status best_error(struct search *b, bool smooth, struct dom_best_error *error)
{
    struct margin_context *c = b->c;
    real s = b->s, r = b->r_max, r_error = 0;
    *error = (struct dom_best_error){.s = REAL_NAN, .r_max = REAL_NAN};
    if (!dynamics_bounded(&c->geometry))
        return DOM_OK;
    struct limit limit;
    c->s = s;
    enum dom_status status = limit_find(c, &limit);
    if (status == DOM_OK)
        status = limit_error(c, &limit, &r_error);
    /* r_max(s) jumps where a dip of the margin begins; the shallowest dips are not resolved (scan.c). */
    real s_error = 2 * fmax((real)c->train->tol, smooth ? 4 * REAL_EPSILON : (real)1e-8) * s;
    if (status == DOM_OK && smooth) {
        real h = slope_step(c->geometry.span, s, r) * b->finer, width = 4 * h;
        real second_derivative = fabs(top_slope(s + width, b) - top_slope(s - width, b)) / (2 * width);
        c->s = s;
        c->errors = true;
        margin_at(r, c);
        const real wrong = c->error;
        c->errors = false;
        /* Twice the step has 256 times the error of the rule. The weights of the rule add up to 1750 / 840 /
         * h. */
        real slope = margin_slope_by(c, s, r, h), rule = fabs(margin_slope_by(c, s, r, 2 * h) - slope) / 32;
        /* An error of r changes the slope, too. */
        const real dr = fmin(r, 1 / (s + 4 * h) - r) * (real)1e-3;
        real by_r = dr > 0 ? fabs(margin_slope_by(c, s, r + dr, h) - slope) / dr : 0;
        s_error +=
            2 * UNIT * s + (fabs(slope) + rule + (real)2.1 * wrong / h + by_r * r_error) / second_derivative;
    }
    if (c->status == DOM_OK && status == DOM_OK)
        r_error += fmax(best_fall(c, s, -fmin(s_error, s / 2), r), best_fall(c, s, fmin(s_error, 1 - s), r));
    *error = (struct dom_best_error){.s = s_error, .r_max = r_error};
    return status != DOM_OK ? status : c->status;
}

static enum dom_status best_find(struct margin_context *c, struct dom_best *best)
{
    struct search b = {.c = c, .finest = BEST_FINEST, .finer = 1};
    bool smooth;
    enum dom_status status = search_samples(&b);
    if (status == DOM_OK)
        status =
            dynamics_bounded(&c->geometry) ? search_between(&b, BEST_LOWEST, 1, INFINITY) : search_finely(&b);
    if (status != DOM_OK)
        return c->status = status;
    if (!(b.r_max > 1))
        return c->status = DOM_NO_GROWTH;
    /* Next to a jump there may be several tops: searches once more near the best, in narrower intervals. */
    real before = 0;
    status = search_top(&b, (real)1e-6, &smooth);
    for (int k = 0;
         status == DOM_OK && dynamics_bounded(&c->geometry) && !smooth && k < 3 && b.r_max > before; k++) {
        before = b.r_max;
        b.finest = BEST_FINEST / 64;
        status = search_between(&b, b.s * (1 - 4 * BEST_FINEST), b.s * (1 + 4 * BEST_FINEST), (real)INFINITY);
    }
    if (status == DOM_OK)
        status = search_top(&b, (real)c->train->tol, &smooth);
    struct dom_best found = {.s = b.s, .r_max = b.r_max};
    if (status == DOM_OK && c->train->errors)
        status = best_error(&b, smooth, &found.error);
    if (status == DOM_OK)
        *best = found;
    return c->status = status;
}

KERNEL enum dom_status limit_best(const struct request *train, struct dom_best *best)
{
    struct margin_context c = margin_of_train(train);
    limit_begin(&c);
    return c.status == DOM_OK ? best_find(&c, best) : c.status;
}
