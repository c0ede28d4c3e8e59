/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "growth/limit.h"

#define SCAN_FINEST fmax((real)1e-6, 4096 * REAL_EPSILON)
/* Relative errors of the barrier from margin_sign and from scan_sure. */
#define SCAN_ROUGH ((real)1e-3)
#define SCAN_FINE  fmax((real)1e-7, 64 * REAL_EPSILON)
/* If the bracket of a root is narrower than this in ln r, the root is assumed to be the first one. */
#define SCAN_CLOSE fmax((real)1e-4, 4096 * REAL_EPSILON)

/* Without friction, first follows one maximum of H to the root. If this fails, or if another maximum is
 * higher at that root, starts again with a search for all maxima at each growth. */
KERNEL enum dom_status scan_root(struct margin_context *c, const struct margin_sample *lo,
                                 const struct margin_sample *hi, real *r)
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

/* Computes the margin again from all maxima of H, with an accurate barrier. */
static enum dom_status scan_sure(struct margin_context *c, struct margin_sample *sample)
{
    sample->margin = margin_rough(c, sample->r, fmax(SCAN_FINE, c->geometry.tol));
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

KERNEL enum dom_status scan_strip(struct margin_context *c, const struct margin_sample *lo,
                                  struct margin_sample *hi, enum known *known)
{
    struct strip strip;
    real ln_r = log1p((hi->r - lo->r) / lo->r), most = barrier_most(&c->geometry);
    *known = KNOWN_NOTHING;
    enum dom_status status = scan_bounds(c, lo->r, hi->r, &strip);
    if (status != DOM_OK)
        return status;
    if (strip.clear) {
        hi->margin =
            (struct margin){.kinetic = strip.kinetic_least, .barrier = most, .barrier_is_bound = true};
        *known = KNOWN_POSITIVE;
        return DOM_OK;
    }
    if (isnan(hi->margin.kinetic))
        hi->margin = margin_sign(c, hi->r);
    if (c->status != DOM_OK)
        return c->status;
    bool above = margin_value(&hi->margin) >= 0;
    if (strip.root_slope < 0) {
        *known = above ? KNOWN_POSITIVE : KNOWN_DECREASING;
        return DOM_OK;
    }
    for (real wrong = 8 * SCAN_ROUGH; above && !hi->margin.barrier_is_bound && *known == KNOWN_NOTHING;
         wrong = 8 * SCAN_FINE) {
        /* From any growth in the strip up to hi, the margin rises by at most margin_slope * ln_r. So if the
         * margin at hi exceeds this product, the margin is positive over the whole strip. */
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
static real scan_ahead(const struct margin_context *c, const struct margin_sample *from)
{
    real most = barrier_most(&c->geometry), K = from->margin.kinetic;
    return (K > most ? log(2 * K / most) : (real)0.5) / margin_falls(c, from->r);
}

/* Returns the width of the narrowest step in ln r. After 1500 strips, this width grows. In this way about
 * 3000 strips are enough for any train. */
static real scan_finest(const struct margin_context *c, int strips)
{
    return fmax(SCAN_FINEST, c->coarse) * exp((real)0.7 * (real)(strips > 1500 ? (strips - 1500) / 100 : 0));
}

KERNEL enum dom_status scan_to_negative(struct margin_context *c, const struct margin_sample *from, real *r,
                                        enum dom_end *ends)
{
    const real reach = 1 / c->s;
    struct margin_sample lo = *from, below; /* the margin is positive up to lo, and negative at `below` */
    bool found = false, bracketed = false;
    enum dom_status status = root_first(c, &lo, r, &found);
    *ends = found && *r == reach ? DOM_END_REACH : DOM_END_BARRIER;
    if (status != DOM_OK || found)
        return status;
    real step = scan_ahead(c, &lo); /* in ln r */
    for (int strips = 1; lo.r < reach; strips++) {
        const real left = log((bracketed ? below.r : reach) / lo.r), finest = scan_finest(c, strips);
        if (bracketed && left <= fmax(SCAN_CLOSE, finest))
            return scan_root(c, &lo, &below, r);
        step = fmax(step, finest);
        step = bracketed ? fmin(step, left / 2) : step >= left * (real)0.8 ? left : step;
        struct margin_sample hi = {.r = step == left ? reach : lo.r * exp(step),
                                   .margin = {.kinetic = REAL_NAN}};
        enum known known = KNOWN_NOTHING;
        status = scan_strip(c, &lo, &hi, &known);
        if (status != DOM_OK && !(status == DOM_UNDERFLOW && step > finest))
            return status;
        if (known == KNOWN_DECREASING)
            return scan_root(c, &lo, &hi, r);
        const bool falls = status == DOM_OK && known == KNOWN_NOTHING && margin_value(&hi.margin) < 0;
        if (falls) {
            below = hi;
            bracketed = true;
        } else if (known == KNOWN_POSITIVE || step * (real)0.8 <= finest) {
            lo = hi;
            step = known == KNOWN_POSITIVE ? fmax(scan_ahead(c, &hi), 2 * step) : 2 * step;
        } else { /* a shorter strip may have better bounds, or no underflow */
            step /= 2;
        }
    }
    *r = reach;
    *ends = DOM_END_REACH;
    return DOM_OK;
}
