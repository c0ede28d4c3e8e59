/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "growth/limit.h"

/* Returns the variable x = -sqrt(1 - r/reach), which replaces the growth r here. The margin is a smooth
 * function of x. As a function of r, it is not smooth at the reach. */
static real probe_x(const struct margin_context *c, real r)
{
    return -sqrt(fmax(1 - r * c->s / c->geometry.span, 0));
}

static real probe_r(const struct margin_context *c, real x)
{
    return (1 - x * x) * c->geometry.span / c->s;
}

/* The number of samples per unit of ln r. They lie between r = 1 and 0.9 of the reach. One more sample is
 * taken at the reach itself. */
#define PROBE_PER_E 5

/* Returns the growth of sample k. Beyond the last sample, the result is the reach. */
static real probe_place(const struct margin_context *c, int k)
{
    const real reach = c->geometry.span / c->s, ln_near = log((real)0.9 * reach);
    const int far = (int)ceil(fmax(ln_near, 0) * PROBE_PER_E);
    return far == 0 || k > far ? reach : exp((real)k * ln_near / (real)far);
}

/* The maximum number of bisections between two samples. The last interval is about 2e-6 r wide. */
#define PROBE_HALVES 17

/*
 * The margin is assumed to keep its sign between two samples if it exceeds PROBE_SAFETY f w^2 at both
 * samples. Here w is the distance between the samples in x, and f is a second divided difference, which
 * measures the curvature. If the margin were a parabola, f w^2 / 4 would be enough.
 */
#define PROBE_SAFETY 3

/* The largest relative tolerance of samples. Larger errors would look like curvature of the margin. */
#define PROBE_TOL ((real)1e-3)

struct probe {
    struct margin_context *c;
    bool positive; /* true if the margin is >= 0 at the start */
    /* The smallest growth found so far at which the sign changes, or infinity if none is known. If `positive`
     * is false, this is the growth of `after`, which is a sample just past the root. */
    real root;
    real falls; /* probe_value at a root that was found before any sample was taken */
    struct margin_sample after;
};

static enum dom_status probe_sample(struct probe *p, real r, struct margin_sample *sample)
{
    *sample = (struct margin_sample){r, margin_sign(p->c, r)};
    return p->c->status;
}

static bool probe_kept(const struct probe *p, const struct margin_sample *sample)
{
    return (margin_value(&sample->margin) >= 0) == p->positive;
}

/*
 * Returns the margin, scaled so that it varies smoothly with x. The value is positive as long as the margin
 * has its initial sign. If the barrier of `sample` is only an upper bound, uses the argument `barrier`
 * instead.
 */
static real probe_value(const struct probe *p, const struct margin_sample *sample, real barrier)
{
    const struct margin *m = &sample->margin;
    const real margin = m->kinetic - (m->barrier_is_bound ? barrier : m->barrier),
               value = (p->positive ? margin : -margin) / (fabs(m->kinetic) + barrier_most(&p->c->geometry));
    if (sample->r == p->root)
        return p->falls;
    /* division by the distance from a known root leaves only the other sign changes */
    return isfinite(p->root) ? value / (probe_x(p->c, p->root) - probe_x(p->c, sample->r)) : value;
}

/* Returns true if the margin is not curved enough to change sign between the samples lo and hi. Ignores the
 * sign change at p->root, if this root is known. The curvature is estimated from lo, hi and `third`, a sample
 * outside the interval. */
static bool probe_keeps(const struct probe *p, const struct margin_sample *third,
                        const struct margin_sample *lo, const struct margin_sample *hi)
{
    /* a mixture of upper bounds and true barriers would look like curvature */
    const real barrier = hi->margin.barrier_is_bound ? third->margin.barrier : hi->margin.barrier,
               at_lo = probe_value(p, lo, barrier), at_hi = probe_value(p, hi, barrier),
               at_third = probe_value(p, third, barrier), x = probe_x(p->c, lo->r),
               width = probe_x(p->c, hi->r) - x, before = probe_x(p->c, third->r) - x;
    /* if `third` is lo, `bend` is NaN, and the result is false */
    const real bend = (at_hi - at_lo - (at_third - at_lo) / before * width) * width / (width - before);
    return fmin(at_lo, at_hi) > PROBE_SAFETY * fabs(bend);
}

/* Looks for the first sign change between the samples `lo` and `hi`. Ignores sign changes beyond p->root. At
 * `lo` the margin has its initial sign. */
static enum dom_status probe_between(struct probe *p, const struct margin_sample *third,
                                     const struct margin_sample *lo, const struct margin_sample *hi,
                                     int halves)
{
    enum dom_status status = DOM_OK;
    if (lo->r >= p->root)
        return DOM_OK;
    const bool changes = !probe_kept(p, hi) && hi->r < p->root,
               finest = halves == 0 || hi->r - lo->r <= 64 * REAL_EPSILON * hi->r;
    /* find any root first; the bisection below looks for earlier ones */
    if (changes && p->positive)
        status = scan_root(p->c, lo, hi, &p->root);
    else if (changes && finest) {
        p->after = *hi;
        p->root = hi->r;
    }
    if (status != DOM_OK || finest || probe_keeps(p, third, lo, hi))
        return status;
    struct margin_sample middle;
    status = probe_sample(p, probe_r(p->c, (probe_x(p->c, lo->r) + probe_x(p->c, hi->r)) / 2), &middle);
    if (status == DOM_OK)
        status = probe_between(p, hi, lo, &middle, halves - 1);
    return status == DOM_OK ? probe_between(p, lo, &middle, hi, halves - 1) : status;
}

/*
 * Searches for the first sign change after the sample `lo`. Takes the first sample after `lo` whose number is
 * at least k, and stores it in *hi. (If a known root comes before this sample, *hi is the root.) Then
 * probe_between searches between `lo` and *hi. To estimate the curvature, probe_between needs a third sample,
 * normally the one after *hi. So if the sign has not changed at *hi, this function first calls itself to
 * search beyond *hi. If no sample is taken after *hi, the third sample is `last`, the one before `lo`.
 */
static enum dom_status probe_from(struct probe *p, const struct margin_sample *last,
                                  const struct margin_sample *lo, int k, struct margin_sample *hi)
{
    struct margin_sample next = *last;
    real r = lo->r;
    while (r <= lo->r)
        r = probe_place(p->c, k++);
    const real end = fmin(p->root, p->c->geometry.span / p->c->s);
    enum dom_status status = DOM_OK;
    if (r < p->root)
        status = probe_sample(p, r, hi);
    else
        *hi = (struct margin_sample){p->root,
                                     {.kinetic = p->c->nearest.height, .barrier = p->c->nearest.height}};
    if (status == DOM_OK && probe_kept(p, hi) && r < end)
        status = probe_from(p, lo, hi, k, &next);
    return status == DOM_OK ? probe_between(p, &next, lo, hi, PROBE_HALVES) : status;
}

KERNEL enum dom_status probe_change(struct margin_context *c, const struct margin_sample *from,
                                    struct margin_sample *change, bool *found)
{
    struct probe p = {
        .c = c, .positive = margin_value(&from->margin) >= 0, .root = (real)INFINITY, .after = *from};
    struct margin_sample hi;
    const real tol = c->geometry.tol;
    c->geometry.tol = fmin(tol, PROBE_TOL);
    enum dom_status status = DOM_OK;
    if (p.positive && c->geometry.dynamics->conservative && c->dominoes == CHAIN_ENDLESS)
        status = root_any(c, from, &p.root, &p.falls);
    /* convert the slope from r to x, and to the unit of probe_value */
    p.falls *=
        -2 * probe_x(c, p.root) * c->geometry.span / c->s / (c->nearest.height + barrier_most(&c->geometry));
    if (status == DOM_OK && from->r < c->geometry.span / c->s)
        status = probe_from(&p, from, from, 0, &hi);
    c->geometry.tol = tol;
    *found = isfinite(p.root);
    *change = (struct margin_sample){p.root, p.after.margin};
    return status;
}
