/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the best separation: the separation s with the largest r_max. Samples of s give a first growth R.
 * Then bounds (strip.h) exclude the intervals of s in which no train can have a growth above R. The intervals
 * that remain are bisected until their width is BEST_FINEST * s, or more in a long search (search_finest). A
 * peak of r_max(s) that is narrower than this width can be missed.
 *
 * With friction or rounded edges no bounds are known, so there are only samples.
 *
 * Quad precision starts from the result of double precision and refines it. If the refinement fails, quad
 * precision searches all s itself.
 */
#include "growth/limit.h"

/* The ratio of one sample of s to the next larger one. */
#define BEST_RATIO ((real)0.9)
/* Sampling ends after this many successive samples without a larger r_max. */
#define BEST_PATIENCE 8
#define BEST_LOWEST   ((real)1e-6)
#define BEST_FINEST   ((real)2e-3)
/* Until an r_max above 1 is found, intervals of s are bisected down to this width, relative to s. */
#define BEST_FIRST fmax((real)1e-6, 64 * REAL_EPSILON)

struct search {
    struct margin_context *c;
    real s, r_max; /* the best separation so far, and r_max there */
    real finest;   /* width of the narrowest interval, relative to s */
    real finer;    /* slope_step is multiplied by this factor */
};

/* Returns r_max at s, or 0 if there is no r_max. After an error, returns NaN. */
static real rmax_at(real s, void *context)
{
    struct margin_context *c = context;
    struct limit limit;
    if (c->status != DOM_OK) /* a later failure does not replace the status of the first one */
        return REAL_NAN;
    c->s = s;
    if (limit_find(c, &limit) != DOM_OK)
        return REAL_NAN;
    return limit.ends == DOM_END_NONE ? 0 : limit.r_max;
}

/* If r_max at s is the largest r_max so far, stores s and r_max in *b. Returns r_max. If r_max is not larger
 * than b->r_max, the result may be only an upper bound on r_max. */
static real search_at(struct search *b, real s)
{
    /* A coarse scan gives an upper bound on r_max, so it can rule out this s. */
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

/* Finds the margin at s and r. A train without fuel gets a negative margin. */
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

/* Tries to show that, at growth r, the trains of all separations from lo to hi stop. *stops is true if the
 * bounds show this. m is the margin at the separation lo. */
static enum dom_status search_stops(struct margin_context *c, real lo, real hi, real r,
                                    const struct margin *m, bool *stops)
{
    struct geometry at_lo = c->geometry, at_hi = c->geometry;
    struct strip strip;
    *stops = false;
    enum dom_status status = geometry_set(&at_lo, lo, r);
    if (status == DOM_OK)
        status = geometry_set(&at_hi, hi, r);
    /* At r = 1 paper_fuel is exact. Where it is positive, it increases with s. So if it is not positive at
     * hi, no train of the interval has any fuel. */
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
 * Looks for growths between r_max and b->r_max at which the train stops. Sets *witness to the growth with the
 * most negative margin_share. If the train stops at none of the growths that are tried, sets *witness to
 * b->r_max.
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

/* Returns the width, relative to s, below which an interval of s is no longer bisected. Once a growth above 1
 * is known, this width grows with the work that the search has done, so that the search ends in time. */
static real search_finest(const struct search *b)
{
    const struct geometry *geometry = &b->c->geometry;
    real done = (real)*geometry->effort / (real)geometry->effort_most;
    return b->r_max > 1 ? b->finest * (1 + 1024 * done * done) : BEST_FIRST;
}

/*
 * Searches the separations between lo and hi for an r_max above b->r_max. If a train stops at some growth,
 * its r_max is below this growth. So the interval is skipped if bounds show that all of its trains stop at
 * the growth b->r_max. It is also skipped if bounds show that all of its trains stop at `witness`, a growth
 * below b->r_max at which a train with a similar separation is known to stop. If no such growth is known, the
 * caller passes b->r_max or infinity as `witness`. An interval that is not skipped is bisected.
 */
static enum dom_status search_between(struct search *b, real lo, real hi, real witness)
{
    struct margin_context *c = b->c;
    struct margin m;
    enum dom_status status = DOM_OK;
    bool stops = false;
    real last = 1 / fmax(b->r_max, 1); /* at a larger s, the growth b->r_max is beyond the reach */
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

/* Takes samples of s near the best separation, in smaller and smaller steps. Used instead of search_between
 * if no bounds are known. */
static enum dom_status search_finely(struct search *b)
{
    for (real ratio = sqrt(BEST_RATIO); ratio < 1 - 2 * BEST_FINEST && b->c->status == DOM_OK;
         ratio = sqrt(ratio)) {
        bool any = b->r_max > 0; /* if every train has stopped so far, s goes down to 0.5 */
        const real span = b->c->geometry.span;
        real from = any ? fmin(b->s / (ratio * ratio), span) : span,
             to = any ? b->s * ratio * ratio : (real)0.5;
        for (real s = from; s > to && b->c->status == DOM_OK; s *= ratio)
            if (s * b->r_max < span)
                search_at(b, s);
    }
    return b->c->status;
}

/* ---- The maximum of r_max(s) ---- */

/* Returns the step h of the nine-point rule for d margin / ds at a fixed growth. */
static real slope_step(real span, real s, real r)
{
    /* The error of the rule is about (h / scale)^8 + REAL_EPSILON / h. The factor fmin(...) is the scale. */
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

/* Returns d margin / ds at r_max(s), which has the sign of d r_max / ds. */
static real top_slope(real s, void *context)
{
    struct search *b = context;
    struct margin_context *c = b->c;
    real r = rmax_at(s, c), span = c->geometry.span, h = slope_step(span, s, r) * b->finer;
    if (c->status != DOM_OK)
        return REAL_NAN;
    /* if r_max is limited by the reach, it decreases with s */
    return r > 0 && s + 4 * h < span / r ? margin_slope_by(c, s, r, h) : -1;
}

/* Sets b->finer to the factor at which the estimated error of the nine-point rule is smallest. */
static void search_step(struct search *b)
{
    real span = b->c->geometry.span, s = b->s, r = b->r_max, h = slope_step(span, s, r),
         least = (real)INFINITY;
    b->finer = 1;
    if (!(h > 0) || s + 4 * h >= span / r)
        return;
    real last = margin_slope_by(b->c, s, r, h), K = barrier_most(&b->c->geometry);
    /* A smaller step is better where a follower begins to detach: the second derivative jumps there. */
    for (real share = 1; share > (real)1e-5 && b->c->status == DOM_OK; share /= 4) {
        real rounding = 16 * fmax(b->c->geometry.tol, REAL_EPSILON) * K / (h * share);
        if (rounding >= least)
            break;
        /* The slope is computed with this step and with a quarter of it. The error is estimated as the
         * difference between the two slopes, plus the rounding error. */
        real next = margin_slope_by(b->c, s, r, h * share / 4), wrong = fabs(next - last) + rounding;
        if (wrong < least) {
            least = wrong;
            b->finer = share;
        }
        last = next;
    }
}

/* Finds the maximum of r_max near b->s by golden section, to the tolerance tol. */
static enum dom_status search_golden(struct search *b, real tol)
{
    struct margin_context *c = b->c;
    const real span = c->geometry.span;
    real s = b->s, low = 0, high = 0, width;
    c->geometry.tol = (real)c->train->tol;
    /* If r_max is larger at an end of the interval, move s to that end. If r_max at an end only equals r_max
     * at s, widen the interval. */
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
    if (c->status != DOM_OK)
        return c->status;
    real top = s, hi = fmin(s * (1 + width), span);
    enum num_status solver =
        s < hi ? num_maximum(rmax_at, c, s * (1 - width), s, hi, tol, &top) : NUM_NOT_BRACKETED;
    if (model_status(c->status, solver) != DOM_OK && solver != NUM_NOT_BRACKETED)
        return model_status(c->status, solver);
    search_at(b, top);
    return c->status;
}

/* Finds a smooth maximum of r_max near b->s, as a root of the slope. If the maximum is a kink or a jump
 * instead, sets *smooth to false. `width` must be much larger than the relative error of b->s. */
static enum dom_status search_smooth(struct search *b, real width, real tol, bool *smooth)
{
    struct margin_context *c = b->c;
    const real span = c->geometry.span;
    *smooth = false;
    /* The slope is a difference quotient of the margin, so the margin needs all its digits. */
    c->geometry.tol = fmax((real)c->train->tol / 512, 8 * REAL_EPSILON);
    search_step(b);
    for (; c->status == DOM_OK && width < (real)0.02; width *= 4) {
        real lo = b->s * (1 - width), up = b->s * (1 + width), zero;
        real before = top_slope(lo, b), after = up <= span ? top_slope(up, b) : -1;
        if (c->status != DOM_OK || !(before > 0 && after < 0))
            continue;
        /* Close to a kink or a jump, the slope remains large on one side. */
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

/* Finds the maximum of r_max near b->s. *smooth is true on entry if b->s is already close to the maximum. */
static enum dom_status search_top(struct search *b, real tol, bool *smooth)
{
    /* Rounding noise in r_max shifts a smooth maximum by about the square root of the noise. The bracket must
     * be wider than this shift. */
    const real width = 16 * sqrt(fmax(tol, REAL_EPSILON));
    enum dom_status status = *smooth ? search_smooth(b, width, tol, smooth) : DOM_OK;
    if (status == DOM_OK && !*smooth) {
        status = search_golden(b, tol);
        if (status == DOM_OK)
            status = search_smooth(b, width, tol, smooth);
    }
    return status;
}

/* Searches all separations, without the help of a coarser kernel. */
static enum dom_status search_all(struct search *b, bool *smooth)
{
    struct margin_context *c = b->c;
    const bool bounded = dynamics_bounded(&c->geometry);
    enum dom_status status = search_samples(b);
    if (status == DOM_OK)
        status = bounded ? search_between(b, BEST_LOWEST, 1, INFINITY) : search_finely(b);
    if (status == DOM_OK && !(b->r_max > 1))
        status = DOM_NO_GROWTH;
    if (status == DOM_OK)
        status = search_top(b, (real)1e-6, smooth);
    /* Near a jump there may be several maxima. Search again around the best one, in narrower intervals. */
    real before = 0;
    for (int k = 0; status == DOM_OK && bounded && !*smooth && k < 3 && b->r_max > before; k++) {
        before = b->r_max;
        b->finest = BEST_FINEST / 64;
        status =
            search_between(b, b->s * (1 - 4 * BEST_FINEST), b->s * (1 + 4 * BEST_FINEST), (real)INFINITY);
    }
    return status == DOM_OK ? search_top(b, (real)c->train->tol, smooth) : status;
}

/* Quad precision first looks for the best separation s within this distance, relative to s, of the separation
 * that the double kernel found. The distance is larger than the error of the double kernel. */
#define NEAR_WIDTH ((real)1e-8)

/* The straight line through two points of the curve r_max(s). */
struct line {
    real s[2], r[2], slope;
};

/* Replaces the older point of the line by the point of the curve at s. */
static void line_to(struct line *line, struct margin_context *c, real s)
{
    line->s[0] = line->s[1];
    line->r[0] = line->r[1];
    line->s[1] = s;
    line->r[1] = rmax_at(s, c);
    line->slope = (line->r[1] - line->r[0]) / (line->s[1] - line->s[0]);
}

/* Finds a kink of r_max very close to b->s. Each side of the kink is extrapolated as a straight line. The
 * kink is the point where the two lines meet. Returns false if there is no kink. */
static bool search_kink(struct search *b, real tol)
{
    struct line up = {.slope = 0}, down = up;
    real s = b->s, aside = NEAR_WIDTH * s, moved = aside;
    line_to(&up, b->c, s - 2 * aside);
    line_to(&down, b->c, s + 2 * aside);
    while (b->c->status == DOM_OK && moved > tol * s) {
        line_to(&up, b->c, s - aside);
        line_to(&down, b->c, s + aside);
        real next =
            s + ((down.r[1] - down.slope * aside) - (up.r[1] + up.slope * aside)) / (up.slope - down.slope);
        moved = fabs(next - s);
        s = next;
        if (!(up.slope > 0 && down.slope < 0 && moved < aside))
            return false;
        aside = fmin(4 * moved, aside / 4);
    }
    b->s = s;
    b->r_max = rmax_at(s, b->c);
    return b->c->status == DOM_OK;
}

/* Refines c->s, the best separation that the double kernel found. Sets *found on success. */
static enum dom_status best_near(struct search *b, bool *smooth, bool *found)
{
    struct margin_context *c = b->c;
    const real tol = (real)c->train->tol;
    b->s = c->s;
    b->r_max = rmax_at(b->s, c);
    if (c->status == DOM_OK && search_smooth(b, NEAR_WIDTH, tol, smooth) == DOM_OK)
        *found = *smooth || search_kink(b, tol);
    /* If the refinement has failed, s may lie beyond a jump of r_max, where r_max is far from c->near. So
     * c->near is cleared, and the search over all separations does not look there. */
    c->near = *found ? c->near : 0;
    return c->status;
}

static enum dom_status best_find(struct margin_context *c, struct dom_best *best)
{
    struct search b = {.c = c, .finest = BEST_FINEST, .finer = 1};
    bool smooth = false, found = false;
    enum dom_status status = c->near > 0 ? best_near(&b, &smooth, &found) : DOM_OK;
    if (status == DOM_OK && !found)
        status = search_all(&b, &smooth);
    struct dom_best answer = {.s = b.s, .r_max = b.r_max};
    if (status == DOM_OK)
        *best = answer;
    return c->status = status;
}

KERNEL enum dom_status limit_best(const struct request *train, struct dom_best *best)
{
    struct margin_context c = margin_of_train(train);
    limit_begin(&c);
    return c.status == DOM_OK ? best_find(&c, best) : c.status;
}
