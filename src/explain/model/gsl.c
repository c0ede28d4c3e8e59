/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A method for comparison, which uses GSL's solvers:
 * - Brent's method finds the maximum of H near the highest of a few samples.
 * - It also finds r_max as the root of the margin.
 * - An adaptive quadrature finds the duration.
 */
#include "explain/model/methods.h"
#include "numerics/quiet.h"
#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_roots.h>
#include <math.h>

enum { SAMPLES = 16, ITERATIONS = 200, INTERVALS = 1000 };

/* A method, and the cycle that it has found last. */
struct cycle {
    struct method m;
    double theta_c, kinetic;
};

static struct dom_energy energy_at(struct cycle *c, double theta)
{
    struct dom_energy at = {.dH = 0, .J = 1};
    if (c->m.status == DOM_OK)
        c->m.status = dom_energy_find(&c->m.train, &c->m.compute, fmin(theta, c->theta_c), &at);
    return at;
}

/* Returns H(0) - H(theta), since GSL searches for minima. */
static double depth(double theta, void *cycle)
{
    return -energy_at(cycle, theta).dH;
}

/* Finds the maximum of H between `left` and `right`. At `middle`, H must be higher than at both ends. */
static void top_polish(struct cycle *c, double left, double middle, double right, struct dom_barrier *b)
{
    gsl_function f = {depth, c};
    gsl_min_fminimizer *solver = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    if (!solver) {
        c->m.status = DOM_NO_MEMORY;
        return;
    }
    int code = gsl_min_fminimizer_set(solver, &f, middle, left, right), done = GSL_CONTINUE;
    for (int i = 0; code == GSL_SUCCESS && done == GSL_CONTINUE && c->m.status == DOM_OK; i++) {
        code = i < ITERATIONS ? gsl_min_fminimizer_iterate(solver) : GSL_EMAXITER;
        /* sqrt(tol) is enough: the error of the height is of second order in the error of theta_m. */
        done = gsl_min_test_interval(gsl_min_fminimizer_x_lower(solver), gsl_min_fminimizer_x_upper(solver),
                                     0, sqrt(c->m.compute.tol));
    }
    b->theta_m = gsl_min_fminimizer_x_minimum(solver);
    b->barrier = -gsl_min_fminimizer_f_minimum(solver);
    gsl_min_fminimizer_free(solver);
    if (c->m.status == DOM_OK && code == GSL_EMAXITER)
        c->m.status = DOM_NOT_CONVERGED;
}

static void top_find(struct cycle *c, struct dom_barrier *b)
{
    const double step = c->theta_c / SAMPLES;
    int top = 0;
    for (int k = 1; k <= SAMPLES; k++) {
        const double height = -depth(k * step, c);
        if (height > b->barrier) {
            b->theta_m = k * step;
            b->barrier = height;
            top = k;
        }
    }
    if (top == SAMPLES)
        return;
    /* A maximum may lie before the first sample if no sample is above H(0). */
    double middle = top > 0 ? top * step : step / 2;
    while (top == 0 && middle > 1e-12 * step && depth(middle, c) >= 0 && c->m.status == DOM_OK)
        middle /= 2;
    if (c->m.status == DOM_OK && (top > 0 || depth(middle, c) < 0))
        top_polish(c, fmax(0, (top - 1) * step), middle, fmin((top + 1) * step, c->theta_c), b);
}

/* Finds the launch and the barrier of the train with growth r. Returns its margin. */
static double cycle_find(struct cycle *c, double r, struct dom_barrier *b)
{
    struct dom_angles angles = {.theta_c = 0};
    struct dom_launch l = {.J0 = 1};
    c->m.train.r = r;
    *b = (struct dom_barrier){.stop = DOM_NAN};
    if (c->m.status == DOM_OK)
        c->m.status = dom_angles_find(&c->m.train, &c->m.compute, &angles);
    if (c->m.status == DOM_OK)
        c->m.status = dom_launch_find(&c->m.train, &c->m.compute, &l);
    c->theta_c = angles.theta_c;
    c->kinetic = l.kinetic;
    if (c->m.status == DOM_NO_FUEL) { /* the search for a root needs a number (24; c6) */
        c->kinetic = l.fuel * (l.J0 - 1) / (pow(r, c->m.train.q) * l.J0 - l.J0 + 1);
        c->m.status = DOM_OK;
    }
    if (c->m.status == DOM_OK)
        top_find(c, b);
    b->kinetic = c->kinetic > 0 ? c->kinetic : DOM_NAN;
    b->margin = b->kinetic - b->barrier;
    return c->m.status == DOM_OK ? c->kinetic - b->barrier : 0;
}

enum dom_status dom_gsl_barrier(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_barrier *b)
{
    struct cycle c = {.m = method_begin(train, compute)};
    dom_quiet_begin();
    cycle_find(&c, train->r, b);
    dom_quiet_end();
    return c.m.status != DOM_OK ? c.m.status
           : isnan(b->kinetic)  ? DOM_NO_FUEL
           : b->margin >= 0     ? DOM_OK
                                : DOM_STOPS;
}

static double margin(double r, void *cycle)
{
    struct dom_barrier b;
    return cycle_find(cycle, r, &b);
}

static double root_find(struct cycle *c, double low, double high)
{
    gsl_function f = {margin, c};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    if (!solver) {
        c->m.status = DOM_NO_MEMORY;
        return low;
    }
    int code = gsl_root_fsolver_set(solver, &f, low, high), done = GSL_CONTINUE;
    for (int i = 0; code == GSL_SUCCESS && done == GSL_CONTINUE && c->m.status == DOM_OK; i++) {
        code = i < ITERATIONS ? gsl_root_fsolver_iterate(solver) : GSL_EMAXITER;
        done = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), 0,
                                      c->m.compute.tol);
    }
    const double root = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    if (c->m.status == DOM_OK && code != GSL_SUCCESS)
        c->m.status = DOM_NOT_CONVERGED;
    return root;
}

enum dom_status dom_gsl_rmax(const struct dom_train *train, const struct dom_compute *compute,
                             struct dom_limit *limit)
{
    struct cycle c = {.m = method_begin_growth(train, compute)};
    const double reach = 1 / train->s;
    *limit = (struct dom_limit){.r_max = reach, .ends = DOM_END_REACH, .open = DOM_NAN};
    dom_quiet_begin();
    if (margin(1, &c) < 0) {
        limit->ends = DOM_END_NONE;
        limit->r_max = DOM_NAN;
        limit->why = c.kinetic > 0 ? DOM_STOPS : DOM_NO_FUEL;
    } else if (margin(reach, &c) < 0) {
        limit->ends = DOM_END_BARRIER;
        limit->r_max = root_find(&c, 1, reach);
    }
    dom_quiet_end();
    return c.m.status;
}

static double slowness(double theta, void *cycle)
{
    struct cycle *c = cycle;
    const struct dom_energy at = energy_at(c, theta);
    return sqrt(at.J / (c->kinetic - at.dH));
}

enum dom_status dom_gsl_duration(const struct dom_train *train, const struct dom_compute *compute,
                                 double *duration)
{
    struct cycle c = {.m = method_begin(train, compute)};
    struct dom_barrier b;
    gsl_function f = {slowness, &c};
    double error;
    dom_quiet_begin();
    if (cycle_find(&c, train->r, &b) < 0)
        c.m.status = DOM_STOPS;
    gsl_integration_workspace *space =
        c.m.status == DOM_OK ? gsl_integration_workspace_alloc(INTERVALS) : NULL;
    if (c.m.status == DOM_OK && !space)
        c.m.status = DOM_NO_MEMORY;
    if (space) {
        const double tol = fmax(c.m.compute.tol, 50 * DBL_EPSILON);
        const int code = gsl_integration_qags(&f, 0, c.theta_c, 0, tol, INTERVALS, space, duration, &error);
        gsl_integration_workspace_free(space);
        if (c.m.status == DOM_OK && code != GSL_SUCCESS)
            c.m.status = DOM_NOT_CONVERGED;
    }
    dom_quiet_end();
    return c.m.status;
}
