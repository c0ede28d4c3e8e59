/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerics.h"
#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdbool.h>

/* Bisection alone needs about 1100 halvings for any two doubles; Brent needs a few dozen. */
#define ITERATIONS_MAX 2000
#define INTERVALS_MAX  2000

/* What stands between GSL and f: notices a value that is not finite, which GSL would not. */
struct probe {
    num_function *f;
    void *context;
    double sign;
    bool failed;
};

static double probe_value(double x, void *p)
{
    struct probe *probe = p;
    if (probe->failed)
        return 0; /* the search is lost: let it end quickly */
    double value = probe->sign * probe->f(x, probe->context);
    if (isfinite(value))
        return value;
    probe->failed = true;
    return 0;
}

enum num_status num_root(num_function *f, void *context, double lo, double hi, double tol, double *x)
{
    struct probe probe = {f, context, 1, false};
    gsl_function function = {probe_value, &probe};
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    enum num_status status = solver ? NUM_OK : NUM_NO_MEMORY;
    if (status == NUM_OK && gsl_root_fsolver_set(solver, &function, lo, hi) != GSL_SUCCESS)
        status = NUM_NOT_BRACKETED;
    int verdict = GSL_CONTINUE;
    for (int i = 0; status == NUM_OK && verdict == GSL_CONTINUE; i++) {
        if (i == ITERATIONS_MAX || gsl_root_fsolver_iterate(solver) != GSL_SUCCESS)
            status = NUM_NOT_CONVERGED;
        lo = gsl_root_fsolver_x_lower(solver);
        hi = gsl_root_fsolver_x_upper(solver);
        verdict = gsl_root_test_interval(lo, hi, 0, fmax(tol, 4 * DBL_EPSILON));
    }
    if (probe.failed)
        status = NUM_NOT_FINITE;
    if (status == NUM_OK)
        *x = gsl_root_fsolver_root(solver);
    if (solver)
        gsl_root_fsolver_free(solver);
    gsl_set_error_handler(handler);
    return status;
}

enum num_status num_maximum(num_function *f, void *context, double lo, double middle, double hi, double tol,
                            double *x)
{
    struct probe probe = {f, context, -1, false};
    gsl_function function = {probe_value, &probe};
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    gsl_min_fminimizer *solver = gsl_min_fminimizer_alloc(gsl_min_fminimizer_goldensection);
    enum num_status status = solver ? NUM_OK : NUM_NO_MEMORY;
    if (status == NUM_OK && gsl_min_fminimizer_set(solver, &function, middle, lo, hi) != GSL_SUCCESS)
        status = NUM_NOT_BRACKETED;
    int verdict = GSL_CONTINUE;
    for (int i = 0; status == NUM_OK && verdict == GSL_CONTINUE; i++) {
        if (i == ITERATIONS_MAX)
            status = NUM_NOT_CONVERGED;
        if (gsl_min_fminimizer_iterate(solver) != GSL_SUCCESS)
            break; /* two equal values: as far as values can tell, this is the top */
        lo = gsl_min_fminimizer_x_lower(solver);
        hi = gsl_min_fminimizer_x_upper(solver);
        verdict = gsl_min_test_interval(lo, hi, 0, fmax(tol, 4 * DBL_EPSILON));
    }
    if (probe.failed)
        status = NUM_NOT_FINITE;
    if (status == NUM_OK)
        *x = gsl_min_fminimizer_x_minimum(solver);
    if (solver)
        gsl_min_fminimizer_free(solver);
    gsl_set_error_handler(handler);
    return status;
}

enum num_status num_integral(num_function *f, void *context, double lo, double hi, double tol,
                             double *integral)
{
    struct probe probe = {f, context, 1, false};
    gsl_function function = {probe_value, &probe};
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(INTERVALS_MAX);
    enum num_status status = space ? NUM_OK : NUM_NO_MEMORY;
    double value = 0, error = 0;
    if (space) {
        /* GSL refuses relative tolerances below 50 units; its error bound is a wide one. */
        int code = gsl_integration_qag(&function, lo, hi, 0, fmax(tol, 50 * DBL_EPSILON), INTERVALS_MAX,
                                       GSL_INTEG_GAUSS21, space, &value, &error);
        gsl_integration_workspace_free(space);
        /* Rounding may stop it short of tol: what it then bounds the error by must still be close. */
        bool close = code == GSL_SUCCESS || (code == GSL_EROUND && error <= fmax(tol, 1e-13) * fabs(value));
        status = close ? NUM_OK : NUM_NOT_CONVERGED;
    }
    if (probe.failed)
        status = NUM_NOT_FINITE;
    if (status == NUM_OK)
        *integral = value;
    gsl_set_error_handler(handler);
    return status;
}
