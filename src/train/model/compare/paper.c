/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A comparison method: the recipe at the end of the paper's section 'A general domino train'. It uses the
 * paper's formulas for the angles, and plain sums. The tilt theta is raised in steps until H decreases, and
 * the growth r is raised in steps until the train stops. r_max is then interpolated between the last two
 * steps. Steps of sqrt(tol) / 2 give errors of about tol.
 *
 * Two mistakes of the recipe are corrected: here a follower detaches when its leader reaches theta_leave, and
 * the barrier is compared with J(0) tau^2 omega(0)^2; (26; c8) leaves out the factor J(0).
 */
#include "entry/method.h"
#include <math.h>

enum { PAPER_LINKS_MAX = 1000000 };

struct paper {
    const struct request *train;
    double s, r, d, q, tol, L;
    double theta_c, theta_f, theta_leave;
    double P, J0, kinetic;
    enum dom_status status;
};

struct paper_sums {
    double H, J; /* (19; c1), (20; c2) */
};

static struct paper_sums paper_chain(struct paper *p, double theta)
{
    struct paper_sums sums = {0, 0};
    double slope = 1, weight = 1, inertia = 1;
    size_t n = 0;
    for (; weight > p->tol / 8 && n < PAPER_LINKS_MAX && p->status == DOM_OK; n++) {
        if (n % 1024 == 0 && dom_interrupted(p->train->interrupt))
            p->status = DOM_INTERRUPTED;
        sums.H += weight * (cos(theta) + p->d * sin(theta));
        sums.J += inertia * slope * slope;
        weight *= pow(p->r, -p->q);
        inertia *= pow(p->r, -p->q - 1);
        if (theta >= p->theta_leave && theta > 0) {
            /* A detached domino and all its followers stay at theta_f. */
            sums.H += weight * (cos(p->theta_f) + p->d * sin(p->theta_f)) / (1 - pow(p->r, -p->q));
            break;
        }
        double X = p->r * (p->L * cos(theta) - p->d); /* (12; b8) */
        slope *= 1 - p->r * p->L * sin(theta) / sqrt(1 - X * X);
        theta += asin(X);
    }
    struct dom_work *work = p->train->work;
    if (work) {
        work->passes++;
        work->dominoes += n;
        work->longest = n > work->longest ? n : work->longest;
    }
    return sums;
}

/* Finds the constants of a cycle. Returns DOM_TOO_LONG for r = 1, where the sums diverge. */
static enum dom_status paper_begin(const struct request *t, double r, struct paper *p)
{
    double s = (double)t->s, d = (double)t->d, q = (double)t->q, L = s + d;
    *p = (struct paper){.train = t, .s = s, .r = r, .d = d, .q = q, .tol = (double)t->tol, .L = L};
    if (r * s > 1)
        return DOM_OUT_OF_REACH;
    if (r <= 1)
        return DOM_TOO_LONG;
    p->theta_c = asin(r * s);                 /* (2; a2) */
    bool falls = 1 / (r * r) < L * L - d * d; /* (41; A17) */
    p->theta_leave = falls ? acos((L * L + d * d - 1 / (r * r)) / (2 * d * L)) : 4;
    p->theta_f = falls ? asin((1 + r * r * (L * L - d * d)) / (2 * r * L)) /* (42; A18) */
                       : acos(d / L);                                      /* (40; A16) */
    struct paper_sums at_0 = paper_chain(p, 0), at_c = paper_chain(p, p->theta_c);
    double J0 = at_0.J;
    p->P = t->fuel == DOM_FUEL_PAPER ? 1 - cos(p->theta_f) - d * sin(p->theta_f)
                                     : at_0.H - at_c.H; /* (25; c7) */
    p->J0 = J0;
    p->kinetic = p->P * (J0 - 1) / (pow(r, q) * J0 - J0 + 1); /* J(0) omega(0)^2, (24; c6) */
    return p->status != DOM_OK ? p->status : isfinite(p->kinetic) ? DOM_OK : DOM_NOT_FINITE;
}

static enum dom_status paper_barrier(struct paper *p, double *theta_m, double *height)
{
    double step = p->theta_c * sqrt(p->tol) / 2, H0 = paper_chain(p, 0).H, H = H0;
    *theta_m = 0;
    for (double theta = step; theta <= p->theta_c && p->status == DOM_OK; theta += step) {
        double next = paper_chain(p, theta).H;
        if (!(next > H))
            break;
        H = next;
        *theta_m = theta;
    }
    *height = H - H0;
    return p->status;
}

static enum dom_status paper_launch_find(const struct request *train, struct dom_launch *launch)
{
    struct paper p;
    enum dom_status status = paper_begin(train, (double)train->r, &p);
    if (status == DOM_OK)
        *launch = (struct dom_launch){.fuel = p.P,
                                      .J0 = p.J0,
                                      .velocity_ratio = (p.J0 - 1) / p.J0,
                                      .omegasq = p.kinetic / p.J0,
                                      .kinetic = p.kinetic};
    return status;
}

static enum dom_status paper_fuel_find(const struct request *train, struct dom_fuels *fuels)
{
    struct request exact = *train;
    struct paper p;
    exact.fuel = DOM_FUEL_EXACT;
    enum dom_status status = paper_begin(&exact, (double)train->r, &p);
    if (status == DOM_OK)
        *fuels = (struct dom_fuels){.exact = p.P, .paper = 1 - cos(p.theta_f) - p.d * sin(p.theta_f)};
    return status;
}

static enum dom_status paper_barrier_find(const struct request *train, struct dom_barrier *barrier)
{
    struct paper p;
    double theta_m, height;
    enum dom_status status = paper_begin(train, (double)train->r, &p);
    if (status == DOM_OK)
        status = paper_barrier(&p, &theta_m, &height);
    if (status != DOM_OK)
        return status;
    *barrier = (struct dom_barrier){.theta_m = theta_m,
                                    .barrier = height,
                                    .kinetic = p.kinetic,
                                    .margin = p.kinetic - height,
                                    .stop = DOM_NAN};
    return p.kinetic >= height ? DOM_OK : DOM_STOPS;
}

static enum dom_status paper_limit_rmax(const struct request *train, struct dom_limit *limit)
{
    double reach = 1 / (double)train->s, step = sqrt((double)train->tol) / 2, before = 0;
    for (size_t k = 1; 1 + (double)k * step < reach; k++) {
        double r = 1 + (double)k * step;
        struct paper p;
        double theta_m, height;
        enum dom_status status = paper_begin(train, r, &p);
        if (status == DOM_OK)
            status = paper_barrier(&p, &theta_m, &height);
        if (status != DOM_OK)
            return status;
        double margin = p.kinetic - height;
        if (margin < 0) { /* the root is between r - step and r */
            if (!(before > 0))
                return DOM_NOT_CONVERGED;
            *limit =
                (struct dom_limit){.r_max = r - step * margin / (margin - before), .ends = DOM_END_BARRIER};
            return DOM_OK;
        }
        before = margin;
    }
    *limit = (struct dom_limit){.r_max = reach, .ends = DOM_END_REACH};
    return DOM_OK;
}

/* Integrates 1/(tau omega) with the trapezoidal rule, since the paper names no method. */
static enum dom_status paper_cycle_duration(const struct request *train, dom_real *duration)
{
    struct paper p;
    enum dom_status status = paper_begin(train, (double)train->r, &p);
    if (status != DOM_OK)
        return status;
    size_t steps = (size_t)ceil(2 / sqrt(p.tol));
    double H0 = paper_chain(&p, 0).H, sum = 0;
    for (size_t k = 0; k <= steps && p.status == DOM_OK; k++) {
        struct paper_sums at = paper_chain(&p, p.theta_c * (double)k / (double)steps);
        double omegasq = (p.kinetic - (at.H - H0)) / at.J; /* (21; c3) */
        if (!(omegasq > 0))
            return DOM_STOPS;
        sum += (k == 0 || k == steps ? 0.5 : 1) / sqrt(omegasq);
    }
    if (p.status == DOM_OK)
        *duration = sum * p.theta_c / (double)steps;
    return p.status;
}

const struct method method_paper = {
    .fuel_find = paper_fuel_find,
    .launch_find = paper_launch_find,
    .barrier_find = paper_barrier_find,
    .limit_rmax = paper_limit_rmax,
    .cycle_duration = paper_cycle_duration,
};
