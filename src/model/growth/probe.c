/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "growth/limit.h"

/* Far from the reach, PROBE_PER_E samples are taken per factor of e in r. Near the reach, PROBE_DECADES
 * samples are taken, one per decade of 1 - r s. */
#define PROBE_PER_E   8
#define PROBE_DECADES 8

/* Returns sample k of r, between 1 and the reach span / s. The last sample is the reach itself, and any
 * larger k returns the reach as well. */
static real probe_place(real span, real s, int k)
{
    const real near = (real)0.1;
    real ln_reach = log(span) - log(s);
    int far = (int)ceil(fmax(ln_reach - near, 0) * PROBE_PER_E);
    if (k < far)
        return exp((real)k * fmax(ln_reach - near, 0) / (real)far);
    real short_of = fmin(near, (span - s) / span) * pow(10, (real)(far - k));
    return k - far > PROBE_DECADES ? span / s : fmax((1 - short_of) * span / s, 1);
}

/* The largest number of bisections of an interval. They divide an interval from r to r e^(1/8) into parts
 * that are 1e-3 r wide. */
#define PROBE_HALVES 7

/*
 * The margin is taken to keep its sign between two samples if it exceeds this multiple of its deviation from
 * a straight line between them. For a parabola, the deviation over an interval is a quarter of the deviation
 * over an interval of twice the length.
 */
#define PROBE_SAFETY 3

struct probe {
    struct margin_context *c;
    bool positive; /* true if the margin is >= 0 at the start */
    struct edge *before, *after;
    bool found;
};

static enum dom_status probe_sample(struct probe *p, real r, struct edge *edge)
{
    *edge = (struct edge){r, margin_sign(p->c, r)};
    return p->c->status;
}

static bool probe_kept(const struct probe *p, const struct edge *edge)
{
    return (margin_value(&edge->margin) >= 0) == p->positive;
}

/*
 * Finds whether the margin changes its sign between two samples, by taking further samples between them. At
 * `lo` the margin has the sign that p->positive states. Searches the lower half first, so that the first
 * change is found.
 */
static enum dom_status probe_between(struct probe *p, const struct edge *lo, const struct edge *hi,
                                     real deviation, int halves)
{
    real at_lo = margin_share(&lo->margin), at_hi = margin_share(&hi->margin);
    bool kept = probe_kept(p, hi);
    if (kept && fmin(fabs(at_lo), fabs(at_hi)) > PROBE_SAFETY * deviation)
        return DOM_OK;
    if (halves == 0 || hi->r - lo->r <= 64 * REAL_EPSILON * hi->r) {
        if (!kept) {
            *p->before = *lo;
            *p->after = *hi;
            p->found = true;
        }
        return DOM_OK;
    }
    struct edge middle;
    enum dom_status status = probe_sample(p, lo->r + (hi->r - lo->r) / 2, &middle);
    real at = margin_share(&middle.margin), off = fabs(at - (at_lo + at_hi) / 2);
    if (status == DOM_OK)
        status = probe_between(p, lo, &middle, off / 2, halves - 1);
    if (status == DOM_OK && !p->found)
        status = probe_between(p, &middle, hi, off / 2, halves - 1);
    return status;
}

KERNEL enum dom_status probe_change(struct margin_context *c, const struct edge *from, struct edge *before,
                                    struct edge *after, bool *found)
{
    const real span = c->geometry.span, reach = span / c->s;
    struct probe p = {.c = c, .positive = margin_value(&from->margin) >= 0, .before = before, .after = after};
    struct edge lo = *from, hi = *from;
    real deviation = 0;
    enum dom_status status = DOM_OK;
    for (int k = 0; status == DOM_OK && !p.found && hi.r < reach; k++) {
        real r = probe_place(span, c->s, k);
        if (r <= hi.r)
            continue;
        const struct edge last = lo;
        lo = hi;
        status = probe_sample(&p, r, &hi);
        if (status != DOM_OK)
            break;
        /* Deviation of the previous sample from the line through its neighbours; for the first interval, a
         * quarter of the change over the interval. */
        real across = hi.r - last.r, part = across > 0 ? (lo.r - last.r) / across : 0;
        real line = margin_share(&last.margin) * (1 - part) + margin_share(&hi.margin) * part;
        deviation =
            part > 0 ? fabs(margin_share(&lo.margin) - line) : fabs(margin_share(&hi.margin) - line) / 4;
        status = probe_between(&p, &lo, &hi, deviation, PROBE_HALVES);
    }
    *found = p.found;
    return status;
}
