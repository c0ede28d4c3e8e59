/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the first growth at which the margin changes sign. An ordinary root finder could step over the first
 * root, because the margin of thin dominoes can dip below 0 and rise again.
 *
 * A root that is easy to find comes first (root_any). Then only smaller growths are searched for an earlier
 * one. The search samples the margin at a few growths. An interval between two samples is clear if the margin
 * is not curved enough to change sign there. Other intervals are halved. Where the slope of the margin
 * changes from minus to plus, the root of the slope gives the minimum itself. So the depth of a dip decides,
 * and not its width: only a minimum whose sign is hidden by rounding errors remains open.
 */
#include "growth/limit.h"

/* Returns the variable x = -sqrt(1 - r/reach), which replaces the growth r here. The margin is a smooth
 * function of x. As a function of r, it is not smooth at the reach. */
static real x_of(const struct margin_context *c, real r)
{
    return -sqrt(fmax(1 - r * c->s / c->geometry.span, 0));
}

static real r_of(const struct margin_context *c, real x)
{
    return (1 - x * x) * c->geometry.span / c->s;
}

/* The steps of ln r from one sample to the next: half of sqrt(s (s + 2 d)), the scale on which the weights of
 * the chain change near r = 1, but at least SAMPLE_LEAST and at most SAMPLE_MOST. The last samples are at 0.9
 * of the reach and at the reach itself. */
#define SAMPLE_LEAST ((real)0.1)
#define SAMPLE_MOST  ((real)0.2)
/* Enough for a reach of 1.6e6, the largest there is. */
enum { SAMPLES_MOST = 160 };

/* An interval is halved at most HALVES times, down to about 2e-6 r. After every LOOK_EVERY halvings, the
 * slopes at its ends tell whether it contains a minimum. */
enum { HALVES = 17, LOOK_EVERY = 4 };

/* An interval is clear if the scaled margin exceeds SAFETY f w^2 at both ends. Here w is the width of the
 * interval in x, and f is a second divided difference, which measures the curvature. If the margin were a
 * parabola, f w^2 / 4 would be enough. */
#define SAFETY 3

/* The largest relative tolerance of samples. Larger errors would look like curvature of the margin. */
#define SAMPLE_TOL ((real)1e-3)

/* A place where the scaled margin, minus `value`, is 0: the known root (power 1), or a minimum (power 2). If
 * no root is known, `power` is 0. */
struct zero {
    real x, value;
    int power;
};

static const struct zero no_zero = {.power = 0};

struct first {
    struct margin_context *c;
    real sign, from;         /* 1 if the margin is >= 0 at the start, otherwise -1; x of the start */
    real unit;               /* barrier_most */
    struct margin_sample at; /* the first sign change so far; infinitely far if none is known */
    struct limit limit;      /* its members falls, open and dip */
    struct zero root;
    real falls; /* scaled_value at the known root */
    real step;  /* of the difference quotient in scaled_slope */
};

/* An interval between two samples, with the samples before and after it if there are any, and the minimum
 * that has been found in it or near it. */
struct stretch {
    const struct margin_sample *before, *lo, *hi, *after;
    const struct zero *dip;
    int halves;
};

/* Returns true if the margin has its initial sign. A value within its error of 0 does not count as a change:
 * it may be the bottom of a dip, whose minimum decides. With friction, the estimate of the error can be as
 * large as a small barrier, and the value counts as it is. */
static bool sign_kept(const struct first *s, const struct margin_sample *sample)
{
    const struct margin *m = &sample->margin;
    if (!s->c->geometry.conservative)
        return (margin_value(m) >= 0) == (s->sign > 0);
    return s->sign * margin_value(m) >= -margin_error(s->c, m, margin_finest(s->c));
}

/* Returns the margin, scaled so that it varies smoothly with x. The value is positive as long as the margin
 * has its initial sign. If the barrier of `sample` is only an upper bound, uses the argument `barrier`
 * instead. */
static real scaled(const struct first *s, const struct margin_sample *sample, real barrier)
{
    const struct margin *m = &sample->margin;
    return s->sign * (m->kinetic - (m->barrier_is_bound ? barrier : m->barrier)) /
           (fabs(m->kinetic) + s->unit);
}

/* Divides the scaled margin by its known zeros, so that only the others are left: by the distance from the
 * known root or, after the value of a known minimum has been subtracted, by the square of the distance from
 * this minimum. */
static real scaled_value(const struct first *s, const struct margin_sample *sample, real barrier,
                         const struct zero *zero)
{
    const real value = scaled(s, sample, barrier) - zero->value;
    if (zero->power == 0)
        return value;
    if (sample->r == s->at.r && zero->power == 1)
        return s->falls;
    const real distance = zero->x - x_of(s->c, sample->r);
    return zero->power == 1 ? value / distance : value / (distance * distance);
}

/* Returns f w^2 of a third sample and the two ends of an interval of width w, where f is a second divided
 * difference of the scaled value. Sets ends[] to the values at the ends. */
static real bend_of(const struct first *s, const struct stretch *in, const struct margin_sample *third,
                    const struct zero *zero, real ends[2])
{
    /* a mixture of upper bounds and true barriers would look like curvature */
    const real barrier = in->hi->margin.barrier_is_bound ? third->margin.barrier : in->hi->margin.barrier,
               at_third = scaled_value(s, third, barrier, zero), x = x_of(s->c, in->lo->r),
               width = x_of(s->c, in->hi->r) - x, offset = x_of(s->c, third->r) - x;
    ends[0] = scaled_value(s, in->lo, barrier, zero);
    ends[1] = scaled_value(s, in->hi, barrier, zero);
    return (ends[1] - ends[0] - (at_third - ends[0]) / offset * width) * width / (width - offset);
}

/* Returns true if the kinetic energy of this sample exceeds every possible barrier by far. */
static bool is_high(const struct first *s, const struct margin_sample *sample)
{
    return s->sign > 0 && sample->margin.kinetic > SAFETY * s->unit;
}

/* Returns true if the interval has no sign change, apart from the known root. The third samples on both sides
 * must agree. */
static bool is_clear(const struct first *s, const struct stretch *in, const struct zero *zero)
{
    if (is_high(s, in->lo) && is_high(s, in->hi))
        return true;
    /* beyond the known root, the margin may change on much smaller scales */
    const struct margin_sample *after =
                                   in->after && in->after->r > s->at.r && s->sign > 0 ? &s->at : in->after,
                               *const third[] = {in->before, after};
    bool clear = in->before || after;
    for (int k = 0; k < 2 && clear; k++)
        if (third[k]) {
            real ends[2];
            const real bend = bend_of(s, in, third[k], zero, ends);
            clear = fmin(ends[0], ends[1]) > SAFETY * fabs(bend);
        }
    return clear;
}

static enum dom_status sample_finely(const struct first *s, real r, struct margin_sample *sample)
{
    *sample = (struct margin_sample){r, margin_within(s->c, r, 0)};
    return s->c->status;
}

/* Returns the derivative of the scaled margin with respect to x, or NaN after an error. Near a minimum, the
 * error of the difference quotient moves the minimum so little that its value does not change. */
static real scaled_slope(real x, void *context)
{
    struct first *s = context;
    const real step = s->step, lo = fmax(x - step, s->from), hi = fmin(x + step, 0);
    const struct margin_sample a = {.r = r_of(s->c, lo), .margin = margin_within(s->c, r_of(s->c, lo), 0)};
    if (s->c->status != DOM_OK)
        return REAL_NAN;
    const struct margin_sample b = {.r = r_of(s->c, hi), .margin = margin_within(s->c, r_of(s->c, hi), 0)};
    return s->c->status == DOM_OK ? (scaled(s, &b, 0) - scaled(s, &a, 0)) / (hi - lo) : REAL_NAN;
}

/* Returns true if the scaled margin changes by so much that the interval cannot contain a minimum: by more
 * than its curvature and the errors of the samples allow. For thin dominoes whose r_max is near 1, this saves
 * two thirds of the work. */
static bool is_steep(const struct first *s, const struct stretch *in)
{
    const struct margin *m = &in->hi->margin;
    const struct margin_sample *third[] = {in->before, in->after};
    real ends[2] = {0},
         least = 8 * SAMPLE_TOL * (fabs(m->kinetic) + m->barrier) / (fabs(m->kinetic) + s->unit);
    for (int k = 0; k < 2; k++)
        if (third[k])
            least = fmax(least, 2 * fabs(bend_of(s, in, third[k], &no_zero, ends)));
    return fabs(ends[1] - ends[0]) > least;
}

/* Looks for a minimum of the scaled margin inside the interval. */
static enum dom_status find_minimum(struct first *s, const struct stretch *in, struct margin_sample *minimum,
                                    struct zero *dip, bool *found)
{
    const real lo = x_of(s->c, in->lo->r), hi = x_of(s->c, in->hi->r);
    *found = false;
    if (in->dip && in->dip->x >= lo && in->dip->x <= hi) /* this minimum is known */
        return DOM_OK;
    if (is_steep(s, in))
        return DOM_OK;
    s->step = fmin(cbrt(REAL_EPSILON) / 8, (hi - lo) / 256);
    const real at_lo = scaled_slope(lo, s), at_hi = at_lo < 0 ? scaled_slope(hi, s) : 0;
    if (s->c->status != DOM_OK || !(at_lo < 0 && at_hi > 0))
        return s->c->status;
    /* near the minimum, the margin changes with the square of the distance */
    const real tol = sqrt(REAL_EPSILON) * (hi - lo) / fabs(lo);
    const enum num_status solver = num_root_between(scaled_slope, s, lo, at_lo, hi, at_hi, tol, &dip->x);
    enum dom_status status = model_status(s->c->status, solver);
    if (status == DOM_OK)
        status = sample_finely(s, r_of(s->c, dip->x), minimum);
    if (status != DOM_OK)
        return status;
    dip->value = scaled(s, minimum, 0);
    dip->power = 2;
    *found = true;
    return DOM_OK;
}

/* Takes note of a root. Converts its slope from r to x, and to the unit of `scaled`. */
static void keep_root(struct first *s, const struct root *root)
{
    const struct margin_context *c = s->c;
    s->at = (struct margin_sample){root->r, {.kinetic = root->barrier, .barrier = root->barrier}};
    s->limit.falls = root->falls;
    s->falls = -(x_of(c, root->r) + x_of(c, root->beside)) * c->geometry.span / c->s * root->falls /
               (root->barrier + s->unit);
    s->root = (struct zero){.x = x_of(c, root->r), .power = 1};
}

/* Finds a root between lo and hi, where the margin has opposite signs. */
static enum dom_status find_root(struct first *s, const struct stretch *in)
{
    struct margin_context *c = s->c;
    const real tol = c->geometry.tol;
    const bool follows = c->geometry.conservative,
               shallow = fabs(scaled(s, in->hi, in->hi->margin.barrier)) < SAMPLE_TOL;
    struct root root = {.r = in->lo->r, .barrier = in->lo->margin.barrier};
    enum dom_status status = DOM_OK;
    c->geometry.tol = shallow && follows ? margin_finest(c) : tol;
    if (margin_value(&in->lo->margin) >= 0) /* otherwise it is 0 within its error */
        status = root_between(c, in->lo, in->hi, follows && !shallow, &root);
    c->geometry.tol = tol;
    if (shallow) /* the line to a growth outside the dip does not give the slope */
        root.falls = 0;
    keep_root(s, &root);
    if (status != DOM_OK || root.falls > 0)
        return status;
    s->step = cbrt(REAL_EPSILON) / 8;
    s->falls = -scaled_slope(x_of(c, root.r), s);
    return c->status;
}

static enum dom_status search_stretch(struct first *s, const struct stretch *in);

/* Returns a sample with its barrier instead of an upper bound. */
static enum dom_status sample_exactly(const struct first *s, const struct margin_sample *bound,
                                      struct margin_sample *sample)
{
    *sample = *bound;
    if (bound->margin.barrier_is_bound)
        sample->margin = margin_sign(s->c, bound->r, false);
    return s->c->status;
}

/* Searches the two halves of an interval. */
static enum dom_status search_halves(struct first *s, const struct stretch *in)
{
    struct margin_sample middle;
    const real r = r_of(s->c, (x_of(s->c, in->lo->r) + x_of(s->c, in->hi->r)) / 2);
    enum dom_status status;
    if (in->dip) {
        struct stretch inside = *in;
        status = sample_finely(s, r, &middle);
        inside.before = NULL;
        inside.after = &middle;
        if (status != DOM_OK || is_clear(s, &inside, in->dip))
            return status;
    } else {
        middle = (struct margin_sample){r, margin_sign(s->c, r, true)};
        status = s->c->status;
    }
    if (status == DOM_OK)
        status = search_stretch(
            s, &(struct stretch){in->before, in->lo, &middle, in->hi, in->dip, in->halves - 1});
    return status == DOM_OK ? search_stretch(s, &(struct stretch){in->lo, &middle, in->hi, in->after, in->dip,
                                                                  in->halves - 1})
                            : status;
}

/* Searches an interval that has a minimum. */
static enum dom_status search_dip(struct first *s, const struct stretch *in,
                                  const struct margin_sample *minimum, const struct zero *dip)
{
    const struct margin *m = &minimum->margin;
    const real error = margin_error(s->c, m, margin_finest(s->c)) / (fabs(m->kinetic) + s->unit);
    if (fabs(dip->value) < fabs(s->limit.dip))
        s->limit.dip = dip->value;
    if (dip->value < -error && s->sign < 0) {
        s->at = *minimum;
        return DOM_OK;
    }
    if (dip->value < -error)
        return search_stretch(s,
                              &(struct stretch){in->before, in->lo, minimum, in->hi, NULL, in->halves - 1});
    if (dip->value <= error)
        s->limit.open = fmin(s->limit.open, minimum->r);
    if (in->halves <= 0)
        return DOM_OK;
    struct margin_sample lo, hi;
    enum dom_status status = sample_finely(s, in->lo->r, &lo);
    if (status == DOM_OK)
        status = sample_finely(s, in->hi->r, &hi);
    return status == DOM_OK ? search_halves(s, &(struct stretch){NULL, &lo, &hi, NULL, dip, in->halves})
                            : status;
}

/* Looks for the first sign change in an interval. Ignores sign changes beyond the known root. At `lo` the
 * margin has its initial sign. */
static enum dom_status search_stretch(struct first *s, const struct stretch *in)
{
    enum dom_status status = DOM_OK;
    if (in->lo->r >= s->at.r)
        return DOM_OK;
    const bool changes = !sign_kept(s, in->hi) && in->hi->r < s->at.r,
               finest = in->halves <= 0 || in->hi->r - in->lo->r <= 64 * REAL_EPSILON * in->hi->r;
    /* find any root first; the bisection below looks for earlier ones */
    if (changes && s->sign > 0) {
        status = find_root(s, in);
        const struct margin_sample root = s->at;
        return status == DOM_OK
                   ? search_stretch(s, &(struct stretch){in->before, in->lo, &root, NULL, NULL, in->halves})
                   : status;
    }
    if (changes && finest)
        s->at = *in->hi;
    if (status != DOM_OK || is_clear(s, in, &s->root) || (in->dip && is_clear(s, in, in->dip)))
        return status;
    if (in->halves >= 0 && in->halves < HALVES && (finest || (HALVES - in->halves) % LOOK_EVERY == 0)) {
        struct margin_sample minimum, lo, hi;
        struct zero dip;
        bool found;
        if (in->lo->margin.barrier_is_bound || in->hi->margin.barrier_is_bound) {
            /* the bound on the barrier may hide that the margin is large */
            const struct stretch exact = {in->before, &lo, &hi, in->after, in->dip, in->halves};
            status = sample_exactly(s, in->lo, &lo);
            if (status == DOM_OK)
                status = sample_exactly(s, in->hi, &hi);
            return status == DOM_OK ? search_stretch(s, &exact) : status;
        }
        status = find_minimum(s, in, &minimum, &dip, &found);
        if (status != DOM_OK || found)
            return found ? search_dip(s, in, &minimum, &dip) : status;
    }
    return finest ? DOM_OK : search_halves(s, in);
}

KERNEL enum dom_status first_change(struct margin_context *c, const struct margin_sample *from,
                                    struct limit *limit)
{
    struct first s = {.c = c,
                      .sign = margin_value(&from->margin) >= 0 ? 1 : -1,
                      .from = x_of(c, from->r),
                      .unit = barrier_most(&c->geometry),
                      .at = {.r = (real)INFINITY},
                      .limit = {.open = (real)INFINITY, .dip = (real)INFINITY}};
    struct margin_sample sample[SAMPLES_MOST] = {*from};
    const real tol = c->geometry.tol, reach = c->geometry.span / c->s;
    int n = 1;
    c->geometry.tol = fmin(tol, SAMPLE_TOL);
    enum dom_status status = DOM_OK;
    struct root root = {.r = (real)INFINITY};
    if (s.sign > 0 && c->geometry.conservative && c->geometry.n == CHAIN_ENDLESS)
        status = root_any(c, from->r, 0, &root);
    if (isfinite(root.r))
        keep_root(&s, &root);
    while (status == DOM_OK && n < SAMPLES_MOST && sample[n - 1].r < fmin(root.r, reach)) {
        const real last = sample[n - 1].r, near = (real)0.9 * reach,
                   first = sqrt(c->s * (c->s + 2 * c->geometry.d)) / 2,
                   step = last > 1 ? SAMPLE_MOST : fmin(fmax(first, SAMPLE_LEAST), SAMPLE_MOST),
                   r = last >= near
                           ? reach
                           : fmin(last * exp(step), last * exp(step * (real)1.25) > near ? near : reach);
        sample[n] = r < root.r ? (struct margin_sample){r, margin_sign(c, r, true)} : s.at;
        status = c->status;
        /* the kinetic energy at the start may be only a lower bound */
        if (n == 1 && status == DOM_OK && from->margin.barrier_is_bound && !is_high(&s, &sample[1])) {
            sample[0].margin = margin_sign(c, from->r, true);
            status = c->status;
        }
        if (!sign_kept(&s, &sample[n++]))
            break;
    }
    /* An interval that ends in a known root is searched first: earlier roots make the later ones irrelevant,
     * but the known root helps to show that there are none. */
    for (int i = n - 1; status == DOM_OK && i > 0; i--)
        status = search_stretch(
            &s,
            &(struct stretch){i > 2 || (i > 1 && !is_high(&s, &sample[1])) ? &sample[i - 2] : NULL,
                              &sample[i - 1], &sample[i], i + 1 < n ? &sample[i + 1] : NULL, NULL, HALVES});
    c->geometry.tol = tol;
    const bool found = isfinite(s.at.r);
    *limit = s.limit;
    limit->r_max = found ? s.at.r : reach;
    limit->barrier = s.at.margin.barrier;
    limit->ends = found ? DOM_END_BARRIER : DOM_END_REACH;
    if (limit->open >= s.at.r)
        limit->open = (real)INFINITY;
    return status;
}
