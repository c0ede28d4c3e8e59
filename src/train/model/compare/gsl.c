/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A comparison method: it computes energies as the library's own method does, but uses GSL's solvers.
 * - Brent's method finds the maximum of H near the highest of a few samples.
 * - It also finds r_max as the root of the margin.
 * - An adaptive quadrature finds the duration.
 *
 * Second maxima, kinks and trains that nearly stop get no special treatment.
 */
#include "numerics/quiet.h"
#include "precision/double.c" // NOLINT(bugprone-suspicious-include): the functions of the kernel in double
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_roots.h>

enum { GSL_SAMPLES = 16, GSL_ITERATIONS = 200, GSL_INTERVALS = 1000 };

struct gsl_context {
    const struct request *train;
    struct geometry geometry;
    double kinetic;
    enum dom_status status;
};

/* Returns H(0) - H(theta), since GSL searches for minima. */
static double gsl_depth(double theta, void *context)
{
    struct gsl_context *c = context;
    struct sums at = {0};
    c->status = chain_energy_at(&c->geometry, theta, &at);
    return -at.dH;
}

/* Finds the maximum of H between `left` and `right`. At `middle`, H must be higher than at both ends. */
static enum dom_status gsl_polish(struct gsl_context *c, double left, double middle, double right,
                                  struct barrier *b)
{
    gsl_function f = {gsl_depth, c};
    gsl_min_fminimizer *solver = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    if (!solver)
        return DOM_NO_MEMORY;
    int code = gsl_min_fminimizer_set(solver, &f, middle, left, right), done = GSL_CONTINUE;
    for (int i = 0; code == GSL_SUCCESS && done == GSL_CONTINUE && c->status == DOM_OK; i++) {
        code = i < GSL_ITERATIONS ? gsl_min_fminimizer_iterate(solver) : GSL_EMAXITER;
        /* sqrt(tol) is enough: the error of the height is of second order in the error of theta_m. */
        done = gsl_min_test_interval(gsl_min_fminimizer_x_lower(solver), gsl_min_fminimizer_x_upper(solver),
                                     0, sqrt((double)c->train->tol));
    }
    *b = (struct barrier){.theta_m = gsl_min_fminimizer_x_minimum(solver),
                          .height = -gsl_min_fminimizer_f_minimum(solver)};
    gsl_min_fminimizer_free(solver);
    return c->status != DOM_OK ? c->status : code == GSL_EMAXITER ? DOM_NOT_CONVERGED : DOM_OK;
}

static enum dom_status gsl_barrier(struct gsl_context *c, struct barrier *b)
{
    double theta_c = tilt_angle(c->geometry.c), step = theta_c / GSL_SAMPLES;
    int top = 0;
    *b = (struct barrier){.theta_m = 0, .height = 0};
    c->status = DOM_OK;
    for (int k = 1; k <= GSL_SAMPLES && c->status == DOM_OK; k++) {
        double height = -gsl_depth(fmin(k * step, theta_c), c);
        if (height > b->height) {
            *b = (struct barrier){.theta_m = k * step, .height = height};
            top = k;
        }
    }
    if (c->status != DOM_OK || top == GSL_SAMPLES)
        return c->status;
    /* A maximum may lie before the first sample if no sample is above H(0). */
    double middle = top > 0 ? top * step : step / 2;
    while (top == 0 && middle > 1e-12 * step && -gsl_depth(middle, c) <= 0 && c->status == DOM_OK)
        middle /= 2;
    if (c->status != DOM_OK || (top == 0 && -gsl_depth(middle, c) <= 0))
        return c->status;
    return gsl_polish(c, fmax(0, (top - 1) * step), middle, (top + 1) * step, b);
}

/* Finds the launch and the barrier of the train with growth r. */
static enum dom_status gsl_cycle(struct gsl_context *c, double r, struct barrier *b)
{
    struct launch launch = {0};
    enum dom_status status = geometry_set(&c->geometry, (double)c->train->s, r);
    if (status == DOM_OK) {
        far_make(&c->geometry, 16);
        status = dynamics_collide(&c->geometry, c->train->fuel, &launch);
    }
    if (status == DOM_OK)
        status = gsl_barrier(c, b);
    c->kinetic = launch.kinetic;
    return status;
}

static enum dom_status gsl_barrier_find(const struct request *train, struct dom_barrier *barrier)
{
    struct gsl_context c = {.train = train};
    dynamics_read(train, &c.geometry);
    struct barrier b;
    dom_quiet_begin();
    enum dom_status status = gsl_cycle(&c, (double)train->r, &b);
    dom_quiet_end();
    if (status != DOM_OK)
        return status;
    if (!(c.kinetic > 0))
        c.kinetic = (double)DOM_NAN;
    *barrier = (struct dom_barrier){.theta_m = b.theta_m,
                                    .barrier = b.height,
                                    .kinetic = c.kinetic,
                                    .margin = c.kinetic - b.height,
                                    .stop = DOM_NAN};
    return isnan(c.kinetic) ? DOM_NO_FUEL : c.kinetic >= b.height ? DOM_OK : DOM_STOPS;
}

static double gsl_margin(double r, void *context)
{
    struct gsl_context *c = context;
    struct barrier b = {0};
    c->status = gsl_cycle(c, r, &b);
    return c->status == DOM_OK ? c->kinetic - b.height : 0;
}

static enum dom_status gsl_root(struct gsl_context *c, double lo, double hi, double *r)
{
    gsl_function f = {gsl_margin, c};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    if (!solver)
        return DOM_NO_MEMORY;
    int code = gsl_root_fsolver_set(solver, &f, lo, hi), done = GSL_CONTINUE;
    for (int i = 0; code == GSL_SUCCESS && done == GSL_CONTINUE && c->status == DOM_OK; i++) {
        code = i < GSL_ITERATIONS ? gsl_root_fsolver_iterate(solver) : GSL_EMAXITER;
        done = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), 0,
                                      (double)c->train->tol);
    }
    *r = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    return c->status != DOM_OK ? c->status : code != GSL_SUCCESS ? DOM_NOT_CONVERGED : DOM_OK;
}

static enum dom_status gsl_limit_rmax(const struct request *train, struct dom_limit *limit)
{
    dom_quiet_begin();
    struct gsl_context c = {.train = train};
    dynamics_read(train, &c.geometry);
    double reach = 1 / (double)train->s, r = reach, at_1 = gsl_margin(1, &c);
    enum dom_end ends = DOM_END_REACH;
    enum dom_status why = DOM_OK;
    if (c.status == DOM_OK && at_1 < 0) {
        ends = DOM_END_NONE;
        r = (double)DOM_NAN;
        why = c.kinetic > 0 ? DOM_STOPS : DOM_NO_FUEL;
    } else if (c.status == DOM_OK && gsl_margin(reach, &c) < 0) {
        ends = DOM_END_BARRIER;
        c.status = gsl_root(&c, 1, reach, &r);
    }
    dom_quiet_end();
    if (c.status == DOM_OK)
        *limit = (struct dom_limit){.r_max = r, .ends = ends, .why = why};
    return c.status;
}

static double gsl_slowness(double theta, void *context)
{
    struct gsl_context *c = context;
    struct sums at = {.J = 1};
    c->status = chain_energy_at(&c->geometry, theta, &at);
    return sqrt(at.J / (c->kinetic - at.dH));
}

static enum dom_status gsl_integral(struct gsl_context *c, dom_real *duration)
{
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(GSL_INTERVALS);
    if (!space)
        return DOM_NO_MEMORY;
    gsl_function f = {gsl_slowness, c};
    double value = 0, estimate = 0, tol = fmax((double)c->train->tol, 50 * REAL_EPSILON);
    int code = gsl_integration_qags(&f, 0, tilt_angle(c->geometry.c), 0, tol, GSL_INTERVALS, space, &value,
                                    &estimate);
    gsl_integration_workspace_free(space);
    if (c->status == DOM_OK && code == GSL_SUCCESS)
        *duration = value;
    return c->status != DOM_OK ? c->status : code != GSL_SUCCESS ? DOM_NOT_CONVERGED : DOM_OK;
}

static enum dom_status gsl_cycle_duration(const struct request *train, dom_real *duration)
{
    struct gsl_context c = {.train = train};
    dynamics_read(train, &c.geometry);
    struct barrier b;
    dom_quiet_begin();
    enum dom_status status = gsl_cycle(&c, (double)train->r, &b);
    if (status == DOM_OK && c.kinetic < b.height)
        status = DOM_STOPS;
    if (status == DOM_OK)
        status = gsl_integral(&c, duration);
    dom_quiet_end();
    return status;
}

const struct method method_gsl = {
    .barrier_find = gsl_barrier_find,
    .limit_rmax = gsl_limit_rmax,
    .cycle_duration = gsl_cycle_duration,
};
