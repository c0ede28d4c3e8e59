/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the exact (Clopper-Pearson) confidence interval for the probability that a row falls. */
#include "chance/model/draw.h"
#include <math.h>

/* The probability that the true value lies beyond one given end of a 95 % confidence interval. */
#define TAIL 0.025

/*
 * Each of n rows falls with the probability p. If `at_least` is true, returns the probability that at least k
 * rows fall. Otherwise returns the probability that at most k rows fall.
 *
 * The terms of the distribution are added up. The sum over the tail is divided by the sum over all terms. The
 * functions gsl_cdf_beta_P and gsl_cdf_beta_Pinv are not used: from 10,000 rows on, they do not converge for
 * some p.
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

/* Returns the probability p at which binomial_tail is TAIL, by bisection. A tail that is almost constant, as
 * near p = 0 and p = 1, does not matter to this method. */
static double tail_inverse(double k, double n, bool at_least)
{
    double lo = 0, hi = 1;
    while (hi - lo > 1e-15 * hi) {
        const double p = 0.5 * (lo + hi);
        *((binomial_tail(k, n, p, at_least) < TAIL) == at_least ? &lo : &hi) = p;
    }
    return 0.5 * (lo + hi);
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
    const double N = (double)s->rows, few = (double)s->fall, many = (double)(s->fall + s->unknown);
    s->low = few > 0 ? tail_inverse(few, N, true) : 0;
    s->high = many < N ? tail_inverse(many, N, false) : 1;
    return DOM_OK;
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
