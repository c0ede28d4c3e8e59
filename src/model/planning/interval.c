/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the exact (Clopper-Pearson) confidence interval for the probability that a row falls. */
#include "planning/interval.h"
#include "numerics/quiet.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <math.h>

/* The probability that the true value lies beyond one given end of a 95 % confidence interval. */
#define TAIL 0.025

/*
 * Each of n rows falls with the probability p. If `at_least` is true, returns the probability that at least k
 * rows fall. Otherwise returns the probability that at most k rows fall.
 *
 * The terms of the distribution are added up. The sum over the tail is divided by the sum over all terms. The
 * function gsl_cdf_beta_P is not used: if n is a million or more, it does not converge for some p.
 */
static double binomial_tail(double k, double n, double p, bool at_least)
{
    const double odds = p / (1 - p), enough = 1e-17, most = 1e20;
    double above = 0, below = 0;
    if (!(p > 0 && p < 1))
        return (p >= 1) == at_least;
    /* Term k of the distribution is scaled to 1. Ratios of successive terms give all other terms. */
    double term = 1;
    for (double i = k; i < n && above < most && (term > enough * above || i < n * p); i++)
        above += term *= (n - i) / (i + 1) * odds;
    term = 1;
    for (double i = k; i > 0 && below < most && (term > enough * below || i > n * p); i--)
        below += term *= i / (n - i + 1) / odds;
    return (at_least ? 1 + above : 1 + below) / (1 + above + below);
}

struct tail {
    double k, n;
    bool at_least;
};

static double tail_off(double p, void *context)
{
    const struct tail *t = context;
    double chance = binomial_tail(t->k, t->n, p, t->at_least);
    return t->at_least ? chance - TAIL : TAIL - chance;
}

/* Finds the probability p at which binomial_tail returns TAIL. The tail is almost constant near p = 0 and
 * near p = 1. Bisection works well with such a function. */
static enum dom_status tail_inverse(struct tail tail, double *p)
{
    /* If the root is near 1, 50 bisections give all its digits. A small root needs more. If one of 2^64 rows
     * has fallen, the root is near 2^-64, and 64 more bisections are needed. */
    enum { STEPS = 200 };
    gsl_function f = {tail_off, &tail};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_bisection);
    int code = solver ? gsl_root_fsolver_set(solver, &f, 0, 1) : GSL_ENOMEM, done = GSL_CONTINUE;
    for (int i = 0; i < STEPS && code == GSL_SUCCESS && done == GSL_CONTINUE; i++) {
        code = gsl_root_fsolver_iterate(solver);
        done = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), 0,
                                      1e-15);
    }
    *p = solver ? gsl_root_fsolver_root(solver) : 0;
    if (solver)
        gsl_root_fsolver_free(solver);
    return code == GSL_SUCCESS && done == GSL_SUCCESS ? DOM_OK : solver ? DOM_NOT_CONVERGED : DOM_NO_MEMORY;
}

/*
 * Finds the exact 95 % confidence interval [low, high] for the probability that a row falls. At the ends of
 * the interval, the observed counts are just barely plausible:
 * - If P(a row falls) = low, at least s->fall rows fall with a probability of only 2.5 %.
 * - If P(a row falls) = high, at most s->fall + s->unknown rows fall with a probability of only 2.5 %.
 */
enum dom_status dom_study_interval(struct dom_study *s)
{
    if (s->rows == 0 || s->fall > s->rows || s->unknown > s->rows - s->fall)
        return DOM_BAD_ROWS;
    double N = (double)s->rows, few = (double)s->fall, many = (double)(s->fall + s->unknown);
    s->low = 0;
    s->high = 1;
    dom_quiet_begin();
    enum dom_status status = few > 0 ? tail_inverse((struct tail){few, N, true}, &s->low) : DOM_OK;
    if (status == DOM_OK && many < N)
        status = tail_inverse((struct tail){many, N, false}, &s->high);
    dom_quiet_end();
    return status;
}

double unlikely_count(double share, double rows, bool at_least)
{
    double lo = at_least ? 0 : -1, hi = lo + rows + 1;
    while (hi - lo > 1) {
        double k = floor((lo + hi) / 2);
        *((binomial_tail(k, rows, share, at_least) < TAIL) == at_least ? &hi : &lo) = k;
    }
    return at_least ? hi : lo;
}
