/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the best separation: the separation s with the largest r_max. r_max(s) is smooth, apart from kinks
 * and jumps. It jumps where a dip of the margin touches 0, and the best separation is often at such a jump.
 *
 * Samples of s come first, then more samples where a larger value may hide between two of them. Near the
 * largest sample the search closes in on the place where r_max(s) stops increasing, whether it is a smooth
 * maximum, a kink or a jump. Quad precision starts there, from the result of double precision.
 */
#include "growth/limit.h"

/* The ratio of one sample of s to the next larger one. */
#define BEST_RATIO ((real)0.9)
/* Sampling ends after this many successive samples without a larger r_max, or at BEST_LOWEST. */
enum { BEST_PATIENCE = 16, BEST_MOST = 140, KINK_STEPS = 32 };
#define BEST_LOWEST ((real)1e-6)
/* Intervals of s are halved down to this width, relative to s. Until an r_max above 1 is found, they are
 * halved down to BEST_FIRST. */
#define BEST_FINEST ((real)1e-3)
#define BEST_FIRST  fmax((real)1e-6, 64 * REAL_EPSILON)

/* Where r_max is below this fraction of the largest one, a bound on it is enough: no r_max up to the next
 * sample can then be larger. */
#define BEST_FAR ((real)0.8)

struct best {
    struct growth *g;
    real s, r_max;     /* the best separation so far, and r_max there */
    struct limit last; /* of the last separation that was tried */
    real finer;        /* slope_step is multiplied by this factor */
    real low;          /* the growth at the bottom of the dip at the best separation, or infinity */
    real stops;        /* a growth at which another train stopped in a dip, or infinity */
};

/* Returns r_max at s, or 0 if there is no r_max. After an error, returns NaN. At an open dip the result is
 * its growth: the train goes on at least up to there. */
static real rmax_at(real s, void *context)
{
    struct best *b = context;
    struct growth *g = b->g;
    struct limit *limit = &b->last;
    if (g->status != DOM_OK) /* a later failure does not replace the status of the first one */
        return REAL_NAN;
    g->s = s;
    if (limit_find(g, limit) != DOM_OK)
        return REAL_NAN;
    const real r_max = limit->ends == DOM_END_NONE ? 0 : fmin(limit->r_max, limit->open);
    if (r_max > b->r_max) {
        b->s = s;
        b->r_max = r_max;
        b->low = limit->low;
    }
    return r_max;
}

/* Returns the margin at s and r, as a fraction of the energies, or NaN. */
static real margin_beside(struct best *b, real s, real r)
{
    struct growth *g = b->g;
    if (g->status != DOM_OK || !(r * s < g->geometry.span))
        return REAL_NAN;
    g->s = s;
    const struct margin m = margin_signed(g, MARGIN_SIGN, r, MARGIN_ROUGH);
    /* without a margin here, the search can go on elsewhere */
    if (!growth_ends(g->status))
        g->status = DOM_OK;
    return margin_value(&m) / (fabs(m.kinetic) + barrier_most(&g->geometry));
}

/* Returns r_max at s. If r_max is at most BEST_FAR b->r_max, the result may be an upper bound on r_max, for
 * which one margin is enough: a train that stops at a growth has a smaller r_max. Trains at neighbouring
 * separations mostly stop in the same dip. */
static real rmax_or_bound(struct best *b, real s)
{
    const real most = BEST_FAR * b->r_max, tried[] = {fmin(b->stops, most), most};
    for (int k = 0; k < 2 && most > 1; k++)
        if (margin_beside(b, s, tried[k]) < 0)
            return tried[k];
    const real r = rmax_at(s, b);
    real lowest = 0;
    /* keep the growth above r_max at which this train lacks most energy, to try it with the next trains */
    for (real by = r; r > 1 && r + by < most && by > r / 100; by /= 2) {
        const real margin = margin_beside(b, s, r + by);
        if (margin < lowest) {
            lowest = margin;
            b->stops = r + by;
        }
    }
    return r;
}

/* A point of the curve r_max(s). */
struct point {
    real s, r_max;
};

/* Returns an upper bound on r_max between a point and another one at the distance `width`, estimated from the
 * slope of the curve on the far side of the point. If this slope is unknown, it is taken to be that of the
 * reach. */
static real highest_near(const struct point *at, const struct point *beyond, real width)
{
    const bool known = beyond && beyond->r_max > 0;
    const real slope =
        known ? 2 * fabs((at->r_max - beyond->r_max) / (at->s - beyond->s)) : at->r_max / at->s;
    return at->r_max + fmin(slope, 2 * at->r_max / at->s) * width;
}

/* Halves an interval of s as long as a larger r_max may hide inside. */
static void best_between(struct best *b, const struct point *before, const struct point *lo,
                         const struct point *hi, const struct point *after)
{
    const real width = hi->s - lo->s, reach = b->g->geometry.span / lo->s,
               highest = fmin(fmax(highest_near(lo, before, width), highest_near(hi, after, width)), reach);
    if (b->g->status != DOM_OK || width <= (b->r_max > 1 ? BEST_FINEST : BEST_FIRST) * hi->s ||
        !(highest > b->r_max))
        return;
    const real s = (lo->s + hi->s) / 2;
    const struct point middle = {s, rmax_or_bound(b, s)};
    best_between(b, before, lo, &middle, hi);
    best_between(b, lo, &middle, hi, after);
}

/* Samples r_max(s), from large separations down. */
static void best_sample(struct best *b)
{
    struct point at[BEST_MOST];
    const real span = b->g->geometry.span;
    int n = 0, lower = 0;
    for (real s = span; n < BEST_MOST && s > BEST_LOWEST && lower < BEST_PATIENCE && b->g->status == DOM_OK;
         s *= BEST_RATIO, n++) {
        const real before = b->r_max;
        at[n] = (struct point){s, rmax_or_bound(b, s)};
        lower = b->r_max > before || b->r_max == 0 ? 0 : lower + 1;
    }
    for (int k = 0; k + 1 < n; k++)
        best_between(b, k + 2 < n ? &at[k + 2] : NULL, &at[k + 1], &at[k], k > 0 ? &at[k - 1] : NULL);
}

/* Where r_max(s) drops by more than this fraction, it jumps. */
#define BEST_JUMP ((real)1e-6)

/* Near a jump, the scaled margin (first.c) at a dip is below BEST_DIP. */
#define BEST_DIP ((real)1e-2)

/* Returns the step h of the nine-point rule for d margin / ds at a fixed growth. */
static real slope_step(real span, real s, real r)
{
    /* The error of the rule is about (h / scale)^8 + REAL_EPSILON / h. The factor fmin(...) is the scale. */
    return fmin((real)0.03 * s, (span / r - s) / 2) * exp(log(REAL_EPSILON) / 9);
}

static real margin_slope(struct growth *g, real s, real r, real h)
{
    static const int weight[] = {672, -168, 32, -3};
    const real tol = g->geometry.tol;
    real sum = 0;
    g->geometry.tol = fmax(tol / 512, 8 * REAL_EPSILON); /* a difference quotient needs all digits */
    for (int k = 1; k <= 4 && g->status == DOM_OK; k++) {
        g->s = s + (real)k * h;
        const struct margin after = margin_within(g, r, g->geometry.tol);
        g->s = s - (real)k * h;
        const struct margin before = g->status == DOM_OK ? margin_within(g, r, g->geometry.tol) : after;
        sum += (real)weight[k - 1] * (margin_value(&after) - margin_value(&before));
    }
    g->geometry.tol = tol;
    return sum / (840 * h);
}

/* Returns d margin / ds at r_max(s), which has the sign of d r_max / ds. If r_max is limited by the reach,
 * returns -1, because the reach decreases with s. Beyond a jump, the sign points back to the best
 * separation. Near a jump, the size is the scaled margin at the dip, which is 0 at the jump. Farther beyond,
 * the size is the margin at the growth of the best dip. */
static real best_slope(real s, void *context)
{
    struct best *b = context;
    struct growth *g = b->g;
    const real r = rmax_at(s, b), h = r > 0 ? slope_step(g->geometry.span, s, r) * b->finer : 0;
    if (g->status != DOM_OK)
        return REAL_NAN;
    const bool beyond = r < b->r_max * (1 - BEST_JUMP), in_dip = beyond && isfinite(b->low);
    real slope = -1, size = fabs(b->last.dip);
    if (!in_dip && b->last.ends == DOM_END_BARRIER && s + h > s)
        slope = margin_slope(g, s, r, h);
    if (!(size < BEST_DIP))
        size = in_dip ? fabs(margin_beside(b, s, b->low)) : fmin(fabs(slope), 1);
    return ((beyond ? b->s > s : slope > 0) ? 1 : -1) * fmax(size, REAL_EPSILON);
}

/* Sets b->finer to the factor at which the estimated error of the nine-point rule is smallest. A smaller step
 * is better where a follower begins to detach: the second derivative of the margin jumps there. */
static void best_step(struct best *b)
{
    struct growth *g = b->g;
    const real s = b->s, r = b->r_max, h = slope_step(g->geometry.span, s, r),
               most = barrier_most(&g->geometry);
    real least = (real)INFINITY;
    b->finer = 1;
    if (!(s + h > s))
        return;
    real last = margin_slope(g, s, r, h);
    for (real share = 1; share > (real)1e-5 && g->status == DOM_OK; share /= 4) {
        const real rounding = 128 * REAL_EPSILON * most / (h * share);
        if (rounding >= least)
            break;
        const real next = margin_slope(g, s, r, h * share / 4), wrong = fabs(next - last) + rounding;
        if (wrong < least) {
            least = wrong;
            b->finer = share;
        }
        last = next;
    }
}

/*
 * Close to a kink of r_max(s), the nine-point rule mixes the slopes on both sides. There, finds the maximum
 * from r_max alone, within `width` of b->s. It is where two lines intersect, each through two separations on
 * one side. The lines are then drawn again, as close to the kink as the last ones were wrong.
 */
static enum dom_status best_kink(struct best *b, real width, bool *found)
{
    const real noise = 64 * REAL_EPSILON * b->r_max;
    *found = false;
    for (int k = 0; k < KINK_STEPS && b->g->status == DOM_OK; k++) {
        const real s = b->s, r = b->r_max, right = fmin(width, b->g->geometry.span - s),
                   far[] = {r - rmax_at(s - width, b), r - rmax_at(s + right, b)},
                   near[] = {r - rmax_at(s - width / 2, b), r - rmax_at(s + right / 2, b)};
        if (b->r_max > r + noise) /* another separation is nearer to the kink */
            continue;
        const real up = (far[0] - near[0]) * 2 / width, down = (far[1] - near[1]) * 2 / right,
                   flat = fmin(up, down);
        /* next to a smooth maximum, r_max falls with the square of the distance */
        *found = flat > 0 && ((far[0] > noise && near[0] > (real)0.4 * far[0]) ||
                              (far[1] > noise && near[1] > (real)0.4 * far[1]));
        if (!*found)
            break;
        /* the heights of the lines at s, above r, and the distance of the intersection from s */
        const real left_line = far[0] - 2 * near[0], right_line = far[1] - 2 * near[1],
                   by = (right_line - left_line) / (up + down);
        const real wrong = fabs(left_line + up * by - (rmax_at(s + by, b) - r));
        width = fmin(width / 4, 16 * wrong / flat);
        if (width <= fmax(b->g->geometry.tol / 8 * s, 4 * noise / flat))
            break;
    }
    return b->g->status;
}

/* Finds the maximum of r_max(s) near b->s, within the distance `width`, relative to s. If there is none,
 * *found is false. */
static enum dom_status best_top(struct best *b, real width, bool *found)
{
    struct growth *g = b->g;
    const real lo = b->s * (1 - width), hi = fmin(b->s * (1 + width), g->geometry.span);
    best_step(b);
    const real up = best_slope(lo, b), down = g->status == DOM_OK ? best_slope(hi, b) : up;
    real s = hi;
    *found = g->status == DOM_OK && up > 0;
    if (*found && down < 0) {
        const enum num_status solver =
            num_root_between(best_slope, b, lo, up, hi, down, g->geometry.tol / 8, &s);
        g->status = model_status(g->status, solver);
        const real r = rmax_at(s, b);
        /* A smooth maximum is flat: the errors of r_max decide which of the separations near it has the
         * largest r_max. The root of the slope has more digits. */
        const real error = fmax(g->geometry.tol, 64 * REAL_EPSILON);
        if (g->status == DOM_OK && r >= b->r_max * (1 - error)) {
            b->s = s;
            b->r_max = r;
        }
        const real h = slope_step(g->geometry.span, b->s, b->r_max) * b->finer;
        bool kink;
        if (g->status == DOM_OK && fabs(b->last.dip) > BEST_DIP && s + h > s)
            best_kink(b, 8 * h, &kink);
    } else if (g->near > 0)
        best_kink(b, width * b->s, found);
    else
        *found = *found && hi == g->geometry.span;
    return g->status;
}

/* Finds the uncertainty of s and r_max. */
static enum dom_status best_uncertainty(struct best *b, struct dom_best *best)
{
    struct growth *g = b->g;
    const real s = b->s, r = b->r_max, span = g->geometry.span, tol = fmax(g->geometry.tol, REAL_EPSILON);
    struct limit limit = {.ends = DOM_END_NONE};
    real r_error = 0, s_error = 4 * tol * s, drop = s * tol * 4;
    g->s = s;
    if (limit_find(g, &limit) != DOM_OK || limit_uncertainty(g, &limit, &r_error) != DOM_OK)
        return g->status;
    const struct margin at = {.kinetic = limit.barrier, .barrier = limit.barrier};
    const real error = margin_error(g, &at, margin_finest(g)), h = slope_step(span, s, r) * b->finer;
    /* on which side r_max is lower by a jump, if at all */
    struct best aside = *b;
    aside.r_max = (real)INFINITY;
    const real below = rmax_at(s - drop, &aside), above = s + drop < span ? rmax_at(s + drop, &aside) : r;
    if (g->status == DOM_OK && fmin(below, above) < r * (1 - BEST_JUMP)) {
        /* The lower side stops in a dip. The margin at this dip is 0 at the jump. */
        const real dip = fmax(fmin(below, above), 1),
                   by = fabs(margin_slope(g, s, dip, slope_step(span, s, dip)));
        s_error += 2 * error / by;
        const real far = rmax_at(below < above ? s + 2 * s_error : s - 2 * s_error, &aside);
        r_error += fabs(far - r);
    } else if (g->status == DOM_OK && limit.ends == DOM_END_BARRIER && s + h > s) {
        const real second = fabs(best_slope(s + 4 * h, b) - best_slope(s - 4 * h, b)) / (8 * h);
        s_error += 3 * error / h / second;
    }
    *best = (struct dom_best){.s = s, .r_max = r, .s_uncertainty = s_error, .r_uncertainty = r_error};
    return g->status;
}

/* Quad precision looks for the best separation within these distances, relative to s, of the one that the
 * double kernel found. Within the first distance, r_max is close to the one that the double kernel found, but
 * dips are not noticed. */
#define NEAR_WIDTH ((real)1e-11)
#define JUMP_WIDTH ((real)1e-9)

static enum dom_status best_find(struct best *b)
{
    struct growth *g = b->g;
    enum dom_status status = g->status;
    bool found = false;
    if (g->near > 0) {
        b->s = g->s;
        rmax_at(b->s, b);
        status = best_top(b, NEAR_WIDTH, &found);
        if (status == DOM_OK && !found) {
            g->near = b->r_max = 0;
            rmax_at((real)g->train->s, b);
            status = best_top(b, JUMP_WIDTH, &found);
        }
    }
    if (status != DOM_OK || found)
        return status;
    b->r_max = 0;
    best_sample(b);
    if (g->status == DOM_OK && !(b->r_max > 1))
        g->status = DOM_NO_GROWTH;
    for (real width = 2 * BEST_FINEST; g->status == DOM_OK && !found && width < (real)0.5; width *= 4)
        best_top(b, width, &found);
    return g->status;
}

enum dom_status limit_best(const struct dom_train *train, const struct dom_compute *compute, real near,
                           struct dom_best *best)
{
    struct growth g;
    struct best b = {.g = &g, .finer = 1, .low = (real)INFINITY, .stops = (real)INFINITY};
    growth_begin(train, compute, false, near, &g);
    enum dom_status status = g.status == DOM_OK ? best_find(&b) : g.status;
    if (status == DOM_OK)
        status = best_uncertainty(&b, best);
    return status;
}
