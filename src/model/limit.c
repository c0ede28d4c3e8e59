/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The largest growth: the margin as a function of r, scanned upwards from r = 1 to the reach r = 1/s.
 * The margin need not be monotone (thin dominoes: it falls, rises again and drops near 1/s), so a dip
 * between two samples is looked into before the scan goes on.
 */
#include "barrier.h"
#include <float.h>

/* Samples a factor e of r, far from the reach; then a decade of 1 - r s each. */
#define SCAN_PER_E   8
#define SCAN_DECADES 8

struct margin_context {
    const struct dom_train *train;
    enum dom_status (*margin)(const struct lean *, enum dom_fuel, double *);
    enum dom_status status;
};

/* K - B of the endless train (c8, corrected). */
static enum dom_status train_margin(const struct lean *g, enum dom_fuel fuel, double *margin)
{
    struct barrier b;
    struct dom_launch launch;
    /* At r = 1 the fuels agree, and the closed one needs no train. */
    if (g->r == 1 && energy_fuel_paper(g) <= 0)
        return DOM_NO_FUEL;
    enum dom_status status = collision_launch(g, fuel, &launch);
    if (status == DOM_OK)
        status = barrier_search(g, CHAIN_ENDLESS, tilt_angle(g->c), &b);
    if (status == DOM_OK)
        *margin = launch.kinetic - b.height;
    return status;
}

/* Kinetic energy of the pair after the collision less its barrier (b13). */
static enum dom_status pair_margin(const struct lean *g, enum dom_fuel fuel, double *margin)
{
    (void)fuel;
    struct barrier b;
    enum dom_status status = barrier_search(g, 2, tilt_angle(g->c), &b);
    if (status != DOM_OK)
        return status;
    double u = hypot(1, g->d);                  /* h(theta_u) (b2) */
    double sine = (g->c.x - g->d * g->c.y) / u; /* of theta_c - theta_u */
    double cosine = (g->c.y + g->d * g->c.x) / u;
    /* tau_1^2 omega_1c^2 = h(theta_u) - h(theta_c) (b5), without cancellation. */
    double omegasq_1c = u * sine * sine / (1 + cosine);
    double k = g->inertia, share = k / (1 + k); /* (b11) */
    double kinetic = (1 + k) * g->r * omegasq_1c * share * share;
    /* Before theta_u domino 1 has not tipped over when it hits (b0): no push, the barrier is not met. */
    *margin = sine > 0 ? kinetic - b.height : -b.height;
    return DOM_OK;
}

static double margin_at(double r, void *context)
{
    struct margin_context *c = context;
    struct lean g;
    double margin = DOM_NAN;
    c->status = lean_make_at(c->train, r, &g);
    if (c->status == DOM_OK)
        c->status = c->margin(&g, c->train->fuel, &margin);
    return c->status == DOM_OK ? margin : DOM_NAN;
}

static double margin_below(double r, void *context)
{
    return -margin_at(r, context);
}

/* The k-th sample of r between 1 and the reach; the last is 1/s itself, and larger k give it again. */
static double scan_sample(double s, int k)
{
    double ln_reach = -log(s);
    int far = (int)ceil(fmax(ln_reach - 0.1, 0) * SCAN_PER_E);
    if (k < far)
        return exp(k * fmax(ln_reach - 0.1, 0) / far);
    double short_of = fmin(0.1, 1 - s) * pow(10, -(k - far));
    return k - far > SCAN_DECADES ? 1 / s : fmax((1 - short_of) / s, 1);
}

/* First r > lo at which the margin, >= 0 at lo, is negative; DOM_END_REACH if there is none. */
static enum dom_status limit_scan(struct margin_context *c, int k, double margin, struct dom_limit *limit)
{
    double s = c->train->s, reach = 1 / s;
    double before = DOM_NAN, r_before = DOM_NAN, r = scan_sample(s, k), tol = c->train->tol / 8;
    while (r < reach) {
        double r_next = scan_sample(s, ++k), next = margin_at(r_next, c);
        if (c->status != DOM_OK)
            return c->status;
        if (next >= 0 && margin < before && margin < next) {
            double r_low, low;
            enum num_status solver = num_maximum(margin_below, c, r_before, r, r_next, 1e-6, &r_low);
            if (model_status(c->status, solver) == DOM_OK && (low = margin_at(r_low, c)) < 0) {
                r_next = r_low;
                next = low;
                if (r_low < r)
                    r = r_before;
            }
            if (c->status != DOM_OK)
                return c->status;
        }
        if (next < 0) {
            enum num_status solver = num_root(margin_at, c, r, r_next, tol, &limit->r_max);
            limit->ends = DOM_END_BARRIER;
            return model_status(c->status, solver);
        }
        before = margin;
        r_before = r;
        margin = next;
        r = r_next;
    }
    *limit = (struct dom_limit){.r_max = reach, .ends = DOM_END_REACH};
    return DOM_OK;
}

static const struct dom_limit no_limit = {.r_max = DOM_NAN, .ends = DOM_END_NONE};

enum dom_status dom_limit_rmax(const struct dom_train *train, struct dom_limit *limit, enum dom_status *why)
{
    struct margin_context c = {.train = train, .margin = train_margin};
    double margin = margin_at(1, &c);
    if (c.status == DOM_NO_FUEL || (c.status == DOM_OK && margin < 0)) {
        *limit = no_limit;
        if (why)
            *why = c.status == DOM_NO_FUEL ? DOM_NO_FUEL : DOM_STOPS;
        return DOM_OK;
    }
    return c.status == DOM_OK ? limit_scan(&c, 0, margin, limit) : c.status;
}

enum dom_status dom_limit_pair(const struct dom_train *train, struct dom_limit *limit)
{
    struct margin_context c = {.train = train, .margin = pair_margin};
    double r = 0;
    for (int k = 0; r < 1 / train->s; k++) {
        r = scan_sample(train->s, k);
        double margin = margin_at(r, &c);
        if (c.status != DOM_OK)
            return c.status;
        if (margin >= 0)
            return limit_scan(&c, k, margin, limit);
    }
    *limit = no_limit;
    return DOM_OK;
}

const char *dom_end_text(enum dom_end end)
{
    static const char *const text[] = {
        [DOM_END_NONE] = "none", [DOM_END_BARRIER] = "barrier", [DOM_END_REACH] = "reach"};
    return text[end];
}

/* ---- The best separation ---- */

struct best_context {
    struct dom_train train;
    enum dom_status status;
};

static double rmax_at(double s, void *context)
{
    struct best_context *c = context;
    struct dom_limit limit;
    c->train.s = s;
    c->status = dom_limit_rmax(&c->train, &limit, NULL);
    if (c->status != DOM_OK)
        return DOM_NAN;
    return limit.ends == DOM_END_NONE ? 0 : limit.r_max;
}

/* d r_max / d s by the five-point rule: its error, h^4 + roundoff / h, is least near h = 1e-3 s. */
static double rmax_slope(double s, void *context)
{
    double h = 1e-3 * s;
    double near = rmax_at(s + h, context) - rmax_at(s - h, context);
    double wide = rmax_at(s + 2 * h, context) - rmax_at(s - 2 * h, context);
    return (8 * near - wide) / (12 * h);
}

#define BEST_RATIO    0.9 /* of successive separations */
#define BEST_PATIENCE 8   /* as many lower ones in a row end the search */

enum dom_status dom_limit_best(const struct dom_train *train, struct dom_best *best)
{
    struct best_context c = {.train = *train};
    double s = 1, top = s, height = rmax_at(s, &c);
    for (int lower = 0; lower < BEST_PATIENCE && c.status == DOM_OK && s > 1e-9;) {
        s *= BEST_RATIO;
        double value = rmax_at(s, &c);
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

    double middle = top;
    enum num_status solver =
        num_maximum(rmax_at, &c, top * BEST_RATIO, middle, top / BEST_RATIO, train->tol, &top);
    enum dom_status status = model_status(c.status, solver);
    if (status != DOM_OK)
        return status;
    height = rmax_at(top, &c);
    /* A smooth top is where the slope vanishes; at a kink or a jump that would lie lower. */
    double smooth, width = 1e-4 * top;
    solver = num_root(rmax_slope, &c, top - width, top + width, train->tol, &smooth);
    if (solver == NUM_OK && rmax_at(smooth, &c) >= height * (1 - 16 * DBL_EPSILON))
        top = smooth;
    if (c.status != DOM_OK)
        return c.status;
    *best = (struct dom_best){.s = top, .r_max = rmax_at(top, &c)};
    return c.status;
}
