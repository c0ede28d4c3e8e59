/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A method for comparison: the recipe at the end of the paper's section 'A general domino train'. It uses the
 * paper's formulas for the angles, and plain sums. The tilt theta is raised in steps until H decreases, and
 * the growth r is raised in steps until the train stops. r_max is then interpolated between the last two
 * steps. Steps of sqrt(tol) / 2 give errors of about tol.
 *
 * Two mistakes of the recipe are corrected: here a follower detaches when its leader reaches theta_leave, and
 * the barrier is compared with J(0) tau^2 omega(0)^2; (26; c8) leaves out the factor J(0).
 */
#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_proof.h"
#pragma GCC visibility pop
#include "numerics/interrupt.h"
#include <math.h>

enum { LINKS_MAX = 1000000 };

/* A cycle of a train with growth r. */
struct paper {
    const struct dom_train *train;
    struct dom_compute compute;
    enum dom_status status;
    double r, L, step;
    double theta_c, theta_f, theta_leave;
    double P, J0, kinetic;
};

struct paper_sums {
    double H, J; /* (19; c1), (20; c2) */
};

static struct paper_sums chain_sum(struct paper *p, double theta)
{
    const double r = p->r, d = p->train->d, q = p->train->q;
    struct paper_sums sums = {0, 0};
    double slope = 1, weight = 1, inertia = 1;
    size_t n = 0;
    for (; weight > p->compute.tol / 8 && n < LINKS_MAX && p->status == DOM_OK; n++) {
        if (n % 1024 == 0 && dom_interrupted(p->compute.interrupt))
            p->status = DOM_INTERRUPTED;
        sums.H += weight * (cos(theta) + d * sin(theta));
        sums.J += inertia * slope * slope;
        weight *= pow(r, -q);
        inertia *= pow(r, -q - 1);
        if (theta >= p->theta_leave && theta > 0) {
            /* A detached domino and all its followers stay at theta_f. */
            sums.H += weight * (cos(p->theta_f) + d * sin(p->theta_f)) / (1 - pow(r, -q));
            break;
        }
        const double X = r * (p->L * cos(theta) - d); /* (12; b8) */
        slope *= 1 - r * p->L * sin(theta) / sqrt(1 - X * X);
        theta += asin(X);
    }
    struct dom_work *work = p->compute.work;
    if (work) {
        work->passes++;
        work->dominoes += n;
        work->longest = n > work->longest ? n : work->longest;
    }
    return sums;
}

/* Finds the constants of the cycle of a train with growth r. Its status is not DOM_OK if the recipe has no
 * answer for this train. The sums diverge for r = 1. */
static struct paper cycle_begin(const struct dom_train *t, const struct dom_compute *compute, double r)
{
    const double d = t->d, L = t->s + d, q = t->q;
    struct paper p = {.train = t, .compute = compute ? *compute : dom_compute_default(), .r = r, .L = L};
    struct dom_train grown = *t;
    struct dom_angles angles;
    grown.r = r;
    p.status = dom_angles_find(&grown, compute, &angles);
    if (p.status == DOM_OK)
        p.status = dom_first_effect(t) ? DOM_NO_METHOD : r <= 1 ? DOM_TOO_LONG : DOM_OK;
    if (p.status != DOM_OK)
        return p;
    p.step = sqrt(p.compute.tol) / 2;
    p.theta_c = asin(r * t->s);                     /* (2; a2) */
    const bool falls = 1 / (r * r) < L * L - d * d; /* (41; A17) */
    p.theta_leave = falls ? acos((L * L + d * d - 1 / (r * r)) / (2 * d * L)) : 4;
    p.theta_f = falls ? asin((1 + r * r * (L * L - d * d)) / (2 * r * L)) /* (42; A18) */
                      : acos(d / L);                                      /* (40; A16) */
    const struct paper_sums at_0 = chain_sum(&p, 0), at_c = chain_sum(&p, p.theta_c);
    p.P =
        t->fuel == DOM_FUEL_PAPER ? 1 - cos(p.theta_f) - d * sin(p.theta_f) : at_0.H - at_c.H; /* (25; c7) */
    p.J0 = at_0.J;
    p.kinetic = p.P * (p.J0 - 1) / (pow(r, q) * p.J0 - p.J0 + 1); /* J(0) omega(0)^2, (24; c6) */
    if (p.status == DOM_OK && !isfinite(p.kinetic))
        p.status = DOM_NOT_FINITE;
    return p;
}

/* Finds the first maximum of H, and returns the margin. */
static double barrier_climb(struct paper *p, struct dom_barrier *b)
{
    const double H0 = chain_sum(p, 0).H, step = p->theta_c * p->step;
    double H = H0, theta_m = 0;
    for (double theta = step; theta <= p->theta_c && p->status == DOM_OK; theta += step) {
        const double next = chain_sum(p, theta).H;
        if (!(next > H))
            break;
        H = next;
        theta_m = theta;
    }
    *b = (struct dom_barrier){.theta_m = theta_m,
                              .barrier = H - H0,
                              .kinetic = p->kinetic,
                              .margin = p->kinetic - (H - H0),
                              .stop = DOM_NAN};
    return b->margin;
}

enum dom_status dom_paper_launch(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_launch *launch)
{
    struct paper p = cycle_begin(train, compute, train->r);
    *launch = (struct dom_launch){.fuel = p.P,
                                  .J0 = p.J0,
                                  .velocity_ratio = (p.J0 - 1) / p.J0,
                                  .omegasq = p.kinetic / p.J0,
                                  .kinetic = p.kinetic};
    return p.status;
}

enum dom_status dom_paper_barrier(const struct dom_train *train, const struct dom_compute *compute,
                                  struct dom_barrier *barrier)
{
    struct paper p = cycle_begin(train, compute, train->r);
    const bool goes_on = p.status == DOM_OK && barrier_climb(&p, barrier) >= 0;
    return p.status != DOM_OK ? p.status : goes_on ? DOM_OK : DOM_STOPS;
}

enum dom_status dom_paper_rmax(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit)
{
    struct paper p = cycle_begin(train, compute, 1);
    const double reach = 1 / train->s, step = sqrt(p.compute.tol) / 2;
    double before = 0;
    *limit = (struct dom_limit){.r_max = reach, .ends = DOM_END_REACH, .open = DOM_NAN};
    p.status = p.status == DOM_TOO_LONG ? DOM_OK : p.status; /* equal dominoes are where the search begins */
    for (size_t k = 1; p.status == DOM_OK && 1 + (double)k * step < reach; k++) {
        struct dom_barrier b = {.margin = 0};
        const double r = 1 + (double)k * step;
        p = cycle_begin(train, compute, r);
        const double margin = p.status == DOM_OK ? barrier_climb(&p, &b) : 0;
        if (p.status == DOM_OK && margin < 0) { /* the root is between r - step and r */
            limit->r_max = r - step * margin / (margin - before);
            limit->ends = DOM_END_BARRIER;
            return before > 0 ? DOM_OK : DOM_NOT_CONVERGED;
        }
        before = margin;
    }
    return p.status;
}
