/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "growth/limit.h"

#define SCAN_FINEST fmax((real)1e-6, 4096 * REAL_EPSILON)
/*
 * SCAN_ROUGH and SCAN_FINE are relative errors of the barrier: the error that a scan accepts from
 * margin_sign, and the smaller error of scan_sure. SCAN_CLOSE is the relative width at which scan_close hands
 * over to a root search.
 */
#define SCAN_ROUGH ((real)1e-3)
#define SCAN_FINE  fmax((real)1e-7, 64 * REAL_EPSILON)
#define SCAN_CLOSE fmax((real)1e-4, 4096 * REAL_EPSILON)

/*
 * Finds the root of the margin between lo and hi by following the maximum of H at hi down to the root. One
 * more search at the root checks that this maximum is the highest there; if it is not, a search for all
 * maxima is made at every r.
 */
KERNEL enum dom_status scan_root(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                 real *r)
{
    real tol = c->geometry.tol;
    if (c->geometry.dynamics->conservative) {
        enum dom_status status = root_between(c, lo, hi, r);
        if (status == DOM_INTERRUPTED || (status == DOM_OK && margin_highest(c, *r)))
            return status;
    }
    enum num_status solver = num_root_between(margin_at, c, lo->r, margin_value(&lo->margin), hi->r,
                                              margin_value(&hi->margin), tol / 8, r);
    return model_status(c->status, solver);
}

/* Finds the margin with its barrier correct to a relative tolerance, since margin_sign may have used only one
 * of several maxima of H. */
static enum dom_status scan_sure(struct margin_context *c, struct edge *edge)
{
    edge->margin = margin_rough(c, edge->r, fmax(SCAN_FINE, c->geometry.tol));
    return c->status;
}

KERNEL enum dom_status scan_bounds(struct margin_context *c, real lo, real hi, struct strip *strip)
{
    struct geometry at_lo = c->geometry, at_hi = c->geometry;
    enum dom_status status = geometry_set(&at_lo, c->s, lo);
    if (status == DOM_OK)
        status = geometry_set(&at_hi, c->s, hi);
    return status == DOM_OK ? strip_walk(&at_lo, &at_hi, c->train->fuel, barrier_most(&c->geometry),
                                         fmin((real)1e-2, log1p((hi - lo) / lo) / 16), strip)
                            : status;
}

KERNEL enum dom_status scan_strip(struct margin_context *c, const struct edge *lo, struct edge *hi,
                                  enum known *known)
{
    struct strip strip;
    real ln_r = log1p((hi->r - lo->r) / lo->r), most = barrier_most(&c->geometry);
    *known = KNOWN_NOTHING;
    enum dom_status status = scan_bounds(c, lo->r, hi->r, &strip);
    if (status != DOM_OK)
        return status;
    if (strip.clear) {
        hi->margin = (struct margin){.kinetic = strip.kinetic_least, .barrier = most, .most = true};
        *known = KNOWN_POSITIVE;
        return DOM_OK;
    }
    if (isnan(hi->margin.kinetic))
        hi->margin = margin_sign(c, hi->r);
    if (c->status != DOM_OK)
        return c->status;
    bool above = margin_value(&hi->margin) >= 0;
    if (strip.root_slope < 0) {
        *known = above ? KNOWN_POSITIVE : KNOWN_TO_FALL;
        return DOM_OK;
    }
    for (real wrong = 8 * SCAN_ROUGH; above && !hi->margin.most && *known == KNOWN_NOTHING;
         wrong = 8 * SCAN_FINE) {
        /* On the way up to hi the margin increases by at most strip.margin_slope * ln_r. */
        real left = margin_value(&hi->margin), spare = wrong * hi->margin.barrier;
        real barrier = strip_barrier_most(&strip, hi->margin.barrier + spare, most, ln_r);
        if (left - spare > strip.margin_slope * ln_r || strip.kinetic_least > barrier)
            *known = KNOWN_POSITIVE;
        else if (wrong <= 8 * SCAN_FINE ||
                 (left <= strip.margin_slope * ln_r && strip.kinetic_least <= barrier - spare))
            break;
        else if (scan_sure(c, hi) != DOM_OK)
            return c->status;
    }
    return DOM_OK;
}

/* Estimates how far beyond `from`, in ln r, the margin stays positive. */
static real scan_ahead(const struct margin_context *c, const struct edge *from)
{
    real most = barrier_most(&c->geometry), K = from->margin.kinetic;
    return (K > most ? log(2 * K / most) : (real)0.5) / margin_falls(c, from->r);
}

/* Estimates where the margin is 0 between lo and `below`, as a fraction of the distance from lo to `below`.
 * `pull` reduces the weight of the margin at `below`. */
static real scan_share(const struct edge *lo, const struct edge *below, real pull)
{
    real up = margin_value(&lo->margin), down = -margin_value(&below->margin) * pull,
         share = up / (up + down);
    real K = lo->margin.kinetic, K_below = below->margin.kinetic, barrier = below->margin.barrier;
    if (K > 2 * lo->margin.barrier && K_below > 0 && barrier > K_below && K > 2 * barrier)
        share = log(K / barrier) / log(K / K_below) * pull + share * (1 - pull);
    return fmin(fmax(K_below > 0 ? share : (real)0.5, (real)0.1), (real)0.9);
}

/* The state of a search. The margin is positive up to lo. `below` is a growth at which the margin is
 * negative, once one has been found. */
struct scan {
    struct edge lo, below;
    real step;  /* the next step to try, in ln r */
    int strips; /* number of strips tried so far */
};

/* Returns the narrowest step: SCAN_FINEST for the first 1500 strips, and then doubled after every further 100
 * strips. No search takes more than about 3,000 strips. */
static real scan_finest(const struct margin_context *c, const struct scan *scan)
{
    return fmax(SCAN_FINEST, c->coarse) *
           exp((real)0.7 * (real)(scan->strips > 1500 ? (scan->strips - 1500) / 100 : 0));
}

/* Narrows the interval from scan->lo to scan->below until the root in it can only be the first root. */
static enum dom_status scan_close(struct margin_context *c, struct scan *scan, real *r)
{
    struct edge *lo = &scan->lo, *below = &scan->below, next;
    enum known known = KNOWN_NOTHING;
    /* Weight of the margin at `below` in the linear interpolation, halved each time lo moves (the Illinois
     * rule). */
    real pull = 1;
    while (known != KNOWN_TO_FALL && below->r - lo->r > SCAN_CLOSE * lo->r) {
        real width = scan_share(lo, below, pull) * (below->r - lo->r);
        for (;; width /= 2) {
            next = (struct edge){.r = lo->r + width, .margin = {.kinetic = REAL_NAN}};
            enum dom_status status = scan_strip(c, lo, &next, &known);
            scan->strips++;
            if (status != DOM_OK)
                return status;
            if (known != KNOWN_NOTHING || margin_value(&next.margin) < 0 ||
                width <= scan_finest(c, scan) * lo->r)
                break;
        }
        bool above = margin_value(&next.margin) >= 0;
        *(above ? lo : below) = next;
        pull = above ? pull / 2 : 1;
    }
    return scan_root(c, lo, below, r);
}

KERNEL enum dom_status scan_to_negative(struct margin_context *c, const struct edge *from, real *r,
                                        enum dom_end *ends)
{
    const real reach = 1 / c->s;
    struct scan scan = {.lo = *from};
    bool found = false;
    *ends = DOM_END_BARRIER;
    enum dom_status status = foresee_root(c, &scan.lo, r, &found);
    *ends = found && *r == reach ? DOM_END_REACH : DOM_END_BARRIER;
    if (status != DOM_OK || found)
        return status;
    scan.step = scan_ahead(c, &scan.lo);
    while (scan.lo.r < reach) {
        real left = log(reach / scan.lo.r), step = fmax(scan.step, scan_finest(c, &scan));
        bool last = step >= left * (real)0.8;
        struct edge hi = {.r = last ? reach : scan.lo.r * exp(step), .margin = {.kinetic = REAL_NAN}};
        step = last ? left : step;
        enum known known;
        status = scan_strip(c, &scan.lo, &hi, &known);
        bool finest = step <= scan_finest(c, &scan);
        scan.strips++;
        if (status == DOM_UNDERFLOW && !finest) { /* a shorter strip may not underflow */
            scan.step = step / 2;
            continue;
        }
        if (status != DOM_OK)
            return status;
        if (known == KNOWN_TO_FALL) {
            *ends = DOM_END_BARRIER;
            return scan_root(c, &scan.lo, &hi, r);
        }
        if (known != KNOWN_POSITIVE && margin_value(&hi.margin) < 0 && step <= 1) {
            scan.below = hi;
            *ends = DOM_END_BARRIER;
            return scan_close(c, &scan, r);
        }
        if (known == KNOWN_POSITIVE || finest) {
            scan.lo = hi;
            scan.step = known == KNOWN_POSITIVE ? fmax(scan_ahead(c, &hi), 2 * step) : 2 * step;
        } else {
            scan.step = step / 2;
        }
    }
    *r = reach;
    *ends = DOM_END_REACH;
    return DOM_OK;
}
