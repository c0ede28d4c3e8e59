/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the first growth at which the margin changes sign. An ordinary root finder could step over the first
 * root, because the margin of thin dominoes can dip below 0 and rise again.
 *
 * A root that is easy to find comes first (root_guessed). Then only smaller growths are searched for an
 * earlier one. The search samples the margin at a few growths. An interval between two samples is clear if
 * the margin, divided by its known root, is not curved enough to change sign there. Other intervals are
 * halved. Where the slope of the margin changes from minus to plus, the root of the slope gives the minimum
 * itself. So the depth of a dip decides, and not its width: only a minimum whose sign is hidden by rounding
 * errors remains open.
 */
#include "growth/limit.h"

/* Returns the x of one growth minus that of another, without cancellation. */
static real x_apart(const struct growth *g, real from, real to)
{
    return (to - from) * g->s / g->geometry.span / -(x_of(g, from) + x_of(g, to));
}

/* Returns the growth of which x_of is x. */
static real r_of(const struct growth *g, real x)
{
    return (1 - x * x) * g->geometry.span / g->s;
}

/* The steps of ln r from one sample to the next: half of sqrt(s (s + 2 d)), the scale on which the weights of
 * the chain change near r = 1, but at least SAMPLE_LEAST and at most SAMPLE_MOST. The last samples are at
 * NEAR_REACH of the reach and at the reach itself. */
#define SAMPLE_LEAST ((real)0.1)
#define SAMPLE_MOST  ((real)0.2)
#define NEAR_REACH   ((real)0.9)
/* Enough for a reach of 1.6e6, the largest there is. */
enum { SAMPLES_MOST = 100 };

/* An interval is halved at most HALVES times, down to about 2e-6 r. After every LOOK_EVERY halvings, the
 * slopes at its ends tell whether it contains a minimum. */
enum { HALVES = 17, LOOK_EVERY = 4 };

/* An interval is clear if the scaled margin exceeds SAFETY c w^2 at both ends. Here w is the width of the
 * interval in x, and c is a second divided difference, which measures the curvature. If the margin were a
 * parabola, c w^2 / 4 would be enough. */
#define SAFETY 3

/* The largest relative tolerance of samples. Larger errors would look like curvature of the margin. */
#define SAMPLE_TOL ((real)1e-3)

struct first {
    struct growth *g;
    real sign, from;    /* 1 if the margin is >= 0 at the start, otherwise -1; x of the start */
    real unit;          /* barrier_most */
    struct limit limit; /* r_max is infinite while no sign change is known */
    struct margin at;   /* the first known root; its growth is limit.r_max */
    real falls;         /* scaled_value at this root, or 0 if none is known */
    real step;          /* of the difference quotient in scaled_slope */
};

/* An interval between two samples, with the samples before and after it if there are any. */
struct interval {
    const struct margin *before, *lo, *hi, *after;
    int halves; /* how often it may still be halved */
};

/* Returns true if the margin has its initial sign. A value within its error of 0 does not count as a change:
 * it may be the bottom of a dip, whose minimum decides. With losses, the estimate of the error can be as
 * large as a small barrier, and the value counts as it is. */
static bool sign_kept(const struct first *f, const struct margin *m)
{
    if (!f->g->geometry.conservative)
        return (margin_value(m) >= 0) == (f->sign > 0);
    return f->sign * margin_value(m) >= -margin_error(f->g, m, margin_finest(f->g));
}

/* Returns the margin, scaled so that it varies smoothly with x. The value is positive as long as the margin
 * has its initial sign. If the barrier of the sample is only an upper bound, uses the argument `barrier`
 * instead. */
static real scaled(const struct first *f, const struct margin *m, real barrier)
{
    return f->sign * (m->kinetic - (m->is_bound ? barrier : m->barrier)) / (fabs(m->kinetic) + f->unit);
}

/* If `divided` is true, divides the scaled margin by its known root, so that only its other roots are left.
 */
static real scaled_value(const struct first *f, const struct margin *m, real barrier, bool divided)
{
    const real value = scaled(f, m, barrier), distance = divided ? x_apart(f->g, m->r, f->at.r) : 1;
    return distance == 0 ? f->falls : value / distance;
}

/* Returns c w^2 of a third sample and the two ends of an interval of width w, where c is a second divided
 * difference of the scaled value. Sets ends[] to the values at the ends. */
static real bend_of(const struct first *f, const struct interval *in, const struct margin *third,
                    bool divided, real ends[2])
{
    /* a mixture of upper bounds and true barriers would look like curvature */
    const real barrier = in->hi->is_bound ? third->barrier : in->hi->barrier,
               at_third = scaled_value(f, third, barrier, divided),
               width = x_apart(f->g, in->lo->r, in->hi->r), offset = x_apart(f->g, in->lo->r, third->r);
    ends[0] = scaled_value(f, in->lo, barrier, divided);
    ends[1] = scaled_value(f, in->hi, barrier, divided);
    return (ends[1] - ends[0] - (at_third - ends[0]) / offset * width) * width / (width - offset);
}

/* Returns true if the kinetic energy of this sample exceeds every possible barrier by far. */
static bool is_high(const struct first *f, const struct margin *m)
{
    return f->sign > 0 && m->kinetic > SAFETY * f->unit;
}

/* Returns true if the interval has no sign change, apart from the known root. The third samples on both sides
 * must agree. */
static bool is_clear(const struct first *f, const struct interval *in)
{
    if (is_high(f, in->lo) && is_high(f, in->hi))
        return true;
    /* beyond the known root, the margin may change on much smaller scales */
    const bool beyond = in->after && in->after->r > f->limit.r_max;
    /* and near the reach on smaller scales than a third sample on one side shows */
    if (!in->after && in->halves == HALVES && in->hi->r > NEAR_REACH * f->g->geometry.span / f->g->s)
        return false;
    const struct margin *const third[] = {in->before, beyond && f->sign > 0 ? &f->at : in->after};
    bool clear = third[0] || third[1];
    for (int k = 0; k < 2 && clear; k++)
        if (third[k]) {
            real ends[2];
            const real bend = bend_of(f, in, third[k], f->falls != 0, ends);
            clear = fmin(ends[0], ends[1]) > SAFETY * fabs(bend);
        }
    return clear;
}

/* Returns the derivative of the scaled margin with respect to x, or NaN after an error. Near a minimum, the
 * error of the difference quotient moves the minimum so little that its value does not change. */
static real scaled_slope(real x, void *context)
{
    struct first *f = context;
    const real lo = fmax(x - f->step, f->from), hi = fmin(x + f->step, 0);
    const struct margin a = margin_within(f->g, r_of(f->g, lo), 0);
    if (f->g->status != DOM_OK)
        return REAL_NAN;
    const struct margin b = margin_within(f->g, r_of(f->g, hi), 0);
    return (scaled(f, &b, 0) - scaled(f, &a, 0)) / (hi - lo);
}

/* Returns true if the scaled margin changes by so much that the interval cannot contain a minimum: by more
 * than its curvature and the errors of the samples allow. For thin dominoes whose r_max is near 1, this saves
 * two thirds of the work. */
static bool is_steep(const struct first *f, const struct interval *in)
{
    const struct margin *m = in->hi, *third[] = {in->before, in->after};
    real ends[2] = {0},
         least = 8 * SAMPLE_TOL * (fabs(m->kinetic) + m->barrier) / (fabs(m->kinetic) + f->unit);
    for (int k = 0; k < 2; k++)
        if (third[k])
            least = fmax(least, 2 * fabs(bend_of(f, in, third[k], false, ends)));
    return fabs(ends[1] - ends[0]) > least;
}

/* Takes note of the root in f->limit. Converts its slope from r to x, and to the unit of `scaled`. */
static void keep_root(struct first *f)
{
    const struct limit *root = &f->limit;
    f->at = (struct margin){.r = root->r_max, .kinetic = root->barrier, .barrier = root->barrier};
    f->falls = scaled(f, &root->beside, 0) / x_apart(f->g, root->beside.r, root->r_max);
}

/* Finds a root between lo and hi, where the margin has opposite signs. */
static void find_root(struct first *f, const struct margin *lo, const struct margin *hi)
{
    struct growth *g = f->g;
    const real tol = g->geometry.tol;
    const bool shallow = fabs(scaled(f, hi, hi->barrier)) < SAMPLE_TOL;
    g->geometry.tol = shallow && g->geometry.conservative ? margin_finest(g) : tol;
    if (margin_value(lo) >= 0) {
        g->status = root_between(g, lo, hi, !shallow, &f->limit);
    } else { /* it is 0 within its error */
        f->limit.r_max = lo->r;
        f->limit.barrier = lo->barrier;
        f->limit.beside = *hi;
    }
    g->geometry.tol = tol;
    keep_root(f);
}

/* Takes note of a minimum. Its sign decides: if it is beyond 0, the sign changes before it. */
static void keep_minimum(struct first *f, const struct margin *lo, const struct margin *minimum)
{
    const real value = scaled(f, minimum, 0),
               error = margin_error(f->g, minimum, margin_finest(f->g)) / (fabs(minimum->kinetic) + f->unit);
    if (fabs(value) < fabs(f->limit.dip)) {
        f->limit.dip = value;
        f->limit.low = minimum->r;
    }
    if (fabs(value) <= error)
        f->limit.open = fmin(f->limit.open, minimum->r);
    else if (value < 0 && f->sign < 0)
        f->limit.r_max = minimum->r;
    else if (value < 0) {
        const struct margin before = margin_within(f->g, lo->r, 0);
        if (f->g->status == DOM_OK)
            find_root(f, &before, minimum);
    }
}

/* Looks for a minimum of the scaled margin inside the interval. Returns true if there is one. */
static bool find_minimum(struct first *f, const struct interval *in)
{
    struct growth *g = f->g;
    const real lo = x_of(g, in->lo->r), hi = x_of(g, in->hi->r);
    if (is_steep(f, in))
        return false;
    f->step = fmin(cbrt(REAL_EPSILON) / 8, (hi - lo) / 256);
    const real at_lo = scaled_slope(lo, f), at_hi = at_lo < 0 ? scaled_slope(hi, f) : 0;
    if (g->status != DOM_OK || !(at_lo < 0 && at_hi > 0))
        return false;
    /* near the minimum, the margin changes with the square of the distance */
    const real tol = sqrt(REAL_EPSILON) * (hi - lo) / fabs(lo);
    real x = lo;
    g->status = model_status(g->status, num_root_between(scaled_slope, f, lo, at_lo, hi, at_hi, tol, &x));
    const struct margin minimum = g->status == DOM_OK ? margin_within(g, r_of(g, x), 0) : *in->lo;
    if (g->status == DOM_OK)
        keep_minimum(f, in->lo, &minimum);
    return true;
}

static void search_interval(struct first *f, const struct interval *in);

/* Searches the two halves of an interval. */
static void search_halves(struct first *f, const struct interval *in)
{
    if (f->g->status != DOM_OK) /* the next margin would replace the status */
        return;
    const real r = r_of(f->g, (x_of(f->g, in->lo->r) + x_of(f->g, in->hi->r)) / 2);
    const struct margin middle = margin_signed(f->g, MARGIN_SIGN, r, MARGIN_ROUGH);
    search_interval(f, &(struct interval){in->before, in->lo, &middle, in->hi, in->halves - 1});
    search_interval(f, &(struct interval){in->lo, &middle, in->hi, in->after, in->halves - 1});
}

/*
 * Looks for the first sign change in an interval. Ignores sign changes beyond the known root. At `lo` the
 * margin has its initial sign. If it has the other sign at `hi`, finds any root in between, and then searches
 * the interval up to this root. An interval that is not clear is halved, unless it contains a minimum, which
 * find_minimum has then found.
 */
static void search_interval(struct first *f, const struct interval *in)
{
    if (f->g->status != DOM_OK || in->lo->r >= f->limit.r_max)
        return;
    const bool changes = !sign_kept(f, in->hi) && in->hi->r < f->limit.r_max,
               finest = in->halves <= 0 || in->hi->r - in->lo->r <= 64 * REAL_EPSILON * in->hi->r;
    if (changes && f->sign > 0) {
        f->g->hard = false;
        find_root(f, in->lo, in->hi);
        const struct margin root = f->at;
        const struct interval below = {in->before, in->lo, &root, NULL, in->halves};
        /* Where a root is hard to find, three samples do not show how the margin is curved. */
        (f->g->hard && !finest ? search_halves : search_interval)(f, &below);
        return;
    }
    if (changes && finest)
        f->limit.r_max = in->hi->r;
    const bool look = in->halves < HALVES && (finest || (HALVES - in->halves) % LOOK_EVERY == 0);
    if (!is_clear(f, in) && !(look && find_minimum(f, in)) && !finest)
        search_halves(f, in);
}

/* Returns the growth of the sample after `last`. `step` is the step of ln r. */
static real next_sample(real last, real step, real reach)
{
    const real near = NEAR_REACH * reach;
    if (last >= near)
        return reach;
    return last * exp(step * (real)1.25) > near ? near : last * exp(step);
}

/* Samples the margin up to a root that is easy to find, or up to the reach. Then searches the intervals
 * between the samples. */
KERNEL enum dom_status first_change(struct growth *g, const struct margin *from, struct limit *limit)
{
    struct first f = {.g = g,
                      .sign = margin_value(from) >= 0 ? 1 : -1,
                      .from = x_of(g, from->r),
                      .unit = barrier_most(&g->geometry),
                      .limit = no_limit};
    struct margin sample[SAMPLES_MOST];
    sample[0] = *from;
    f.limit.r_max = (real)INFINITY;
    const real tol = g->geometry.tol, reach = g->geometry.span / g->s,
               first = fmin(fmax(sqrt(g->s * (g->s + 2 * g->geometry.d)) / 2, SAMPLE_LEAST), SAMPLE_MOST);
    int n = 1;
    g->geometry.tol = fmin(tol, SAMPLE_TOL);
    if (f.sign > 0 && g->geometry.conservative && g->geometry.n == CHAIN_ENDLESS &&
        root_guessed(g, from->r, &f.limit))
        keep_root(&f);
    while (g->status == DOM_OK && n < SAMPLES_MOST && sample[n - 1].r < fmin(f.limit.r_max, reach) &&
           sign_kept(&f, &sample[n - 1])) {
        const real last = sample[n - 1].r, r = next_sample(last, last > 1 ? SAMPLE_MOST : first, reach);
        sample[n++] = r < f.limit.r_max ? margin_signed(g, MARGIN_SIGN, r, MARGIN_ROUGH) : f.at;
        /* the kinetic energy at the start may be only a lower bound */
        if (n == 2 && g->status == DOM_OK && from->is_bound && !is_high(&f, &sample[1]))
            sample[0] = margin_signed(g, MARGIN_SIGN, from->r, MARGIN_ROUGH);
    }
    /* An interval that ends in a known root is searched first: earlier roots make the later ones irrelevant,
     * but the known root helps to show that there are none. If the energies at the start are only bounds,
     * they do not show how the margin is curved. */
    for (int i = n - 1; g->status == DOM_OK && i > 0; i--) {
        const bool before = i > 2 || (i > 1 && !is_high(&f, &sample[1])), after = i + 1 < n;
        search_interval(&f, &(struct interval){before ? &sample[i - 2] : NULL, &sample[i - 1], &sample[i],
                                               after ? &sample[i + 1] : NULL, HALVES});
    }
    g->geometry.tol = tol;
    *limit = f.limit;
    limit->ends = isfinite(limit->r_max) ? DOM_END_BARRIER : DOM_END_REACH;
    limit->r_max = fmin(limit->r_max, reach);
    if (limit->open >= f.limit.r_max)
        limit->open = (real)INFINITY;
    return g->status;
}
