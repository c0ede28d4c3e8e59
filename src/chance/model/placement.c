/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs many rows with random errors: the probability that a row falls, with its confidence interval, and how
 * large random errors may be if it must fall with a given probability. */
#include "chance/model/draw.h"
#include "search/search.h"
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

/* ---- The exact (Clopper-Pearson) confidence interval ---- */

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

/* ---- Many random rows ---- */

/* Whether a row falls depends only on the signs of its margins, so their values need not be accurate. A
 * smaller tolerance would change about one verdict in a billion. */
#define VERDICT_TOL 1e-9

/* The data that all random rows of a study share. */
struct shared {
    const struct dom_row *row;
    struct dom_compute compute;
    const struct dom_placement *placement;
    atomic_size_t done, fall, unknown;
    atomic_size_t *stops; /* how many falls ended at each domino, or NULL if not requested */
};

/* A draw_visit that runs a random row and adds the result to the counts. */
static enum dom_status row_count(struct draw *draw, size_t i, void *context)
{
    struct shared *s = context;
    struct dom_verdict verdict;
    draw_row(draw, s->row, s->placement, s->placement->first + i);
    const enum dom_status status = s->row->engine
                                       ? dom_row_run(&draw->row, &s->compute, false, NULL, NULL, &verdict)
                                       : draw_verdict(&draw->row, &s->compute, &verdict);
    if (status != DOM_OK)
        return status;
    const bool falls = verdict.end == DOM_ROW_FALLS,
               unknown = verdict.end == DOM_ROW_PASSES || verdict.end == DOM_ROW_PARTS;
    s->done++;
    s->fall += falls;
    s->unknown += unknown;
    if (s->stops && !falls && !unknown)
        s->stops[verdict.domino - 1]++;
    return DOM_OK;
}

enum dom_status dom_placement_study(const struct dom_row *row, const struct dom_compute *compute,
                                    const struct dom_placement *p, struct dom_study *study, size_t *stops)
{
    struct shared s = {.row = row, .compute = compute_or_default(compute), .placement = p};
    /* The model cannot check all arguments, since the study changes gaps and the tolerance before the model
     * sees them. */
    enum dom_status status = p->rows == 0                                      ? DOM_BAD_ROWS
                             : row->count == 0                                 ? DOM_BAD_COUNT
                             : !(s.compute.tol >= dom_arithmetic()->tol_floor) ? DOM_BAD_TOL
                                                                               : DOM_OK;
    for (int k = 0; k < DOM_ERROR_COUNT && status == DOM_OK; k++)
        if (!(p->error[k].size >= 0 && p->error[k].size < HUGE_VAL))
            status = DOM_BAD_ERROR;
    if (status == DOM_OK && p->error[DOM_ERROR_lean].size > 0 && (row->rho != 0 || row->engine))
        status = DOM_NO_LEAN;
    for (size_t k = 0; k < row->count && status == DOM_OK; k++)
        status = row->domino[k].gap >= 0 ? DOM_OK : DOM_BAD_GAP;
    if (status != DOM_OK)
        return status;
    s.compute.work = NULL; /* rows may run in parallel and must not share the counters */
    if (s.compute.tol < VERDICT_TOL)
        s.compute.tol = VERDICT_TOL;
    if (stops && !(s.stops = calloc(row->count, sizeof *s.stops)))
        return DOM_NO_MEMORY;
    status = draw_run(row, p, row_count, &s);
    struct dom_study found = {.rows = s.done, .fall = s.fall, .unknown = s.unknown};
    /* after an interrupt, the rows that were run count */
    if ((status == DOM_OK || (status == DOM_INTERRUPTED && found.rows > 0)) &&
        dom_study_interval(&found) == DOM_OK) {
        *study = found;
        for (size_t k = 0; stops && k < row->count; k++)
            stops[k] = s.stops[k];
    }
    free(s.stops);
    return status;
}

/* ---- The budget ---- */

enum { BUDGET_SEEN = 128 };

struct budget {
    const struct dom_row *row;
    const struct dom_compute *compute;
    const struct dom_placement *placement;
    /* the kind of error whose size is wanted, or DOM_ERROR_COUNT for all kinds together */
    enum dom_error_of kind;
    double widest; /* the largest sigma that is tried */
    double share;  /* the share of the rows that must fall */
    enum dom_status status;
    /* A cache of the latest results. It saves time because the searches for sigma and for both ends of its
     * confidence interval begin with the same values of sigma. */
    struct {
        double sigma, share;
    } seen[BUDGET_SEEN];
    int answers;
};

/*
 * An edge_test: returns true if enough random rows fall. The errors of b->kind have the size `sigma`. If
 * b->kind is DOM_ERROR_COUNT, all errors are multiplied by `sigma`. The random numbers are the same for every
 * sigma, so that the shares for two sigmas can be compared. After an error, nothing more is run.
 */
static bool enough_fall(double sigma, double *spare, void *context)
{
    struct budget *b = context;
    (void)spare; /* the share is a step function */
    if (b->status != DOM_OK)
        return false;
    if (sigma < 1e-9 / 4096 * b->widest) /* errors this small are negligible in a real row */
        return true;
    for (int i = 0; i < b->answers && i < BUDGET_SEEN; i++)
        if (b->seen[i].sigma == sigma)
            return b->seen[i].share >= b->share;
    struct dom_placement p = *b->placement;
    struct dom_study study = {.rows = p.rows};
    for (int k = 0; k < DOM_ERROR_COUNT; k++)
        if (b->kind == DOM_ERROR_COUNT)
            p.error[k].size *= sigma;
        else if (k == (int)b->kind)
            p.error[k].size = sigma;
    b->status = dom_placement_study(b->row, b->compute, &p, &study, NULL);
    if (b->status != DOM_OK)
        return false;
    const double share = (double)study.fall / (double)study.rows;
    b->seen[b->answers % BUDGET_SEEN].sigma = sigma;
    b->seen[b->answers++ % BUDGET_SEEN].share = share;
    return share >= b->share;
}

/* Finds the largest sigma at which the share b->share of the rows falls, to a relative tolerance of 1e-3. If
 * this share falls even at b->widest, returns infinity. */
static double sigma_find(struct budget *b)
{
    double lo = 0, hi = b->widest / 4096;
    for (; enough_fall(hi, NULL, b); hi *= 2) {
        if (hi >= b->widest)
            return HUGE_VAL;
        lo = hi;
    }
    return edge_find(enough_fall, b, lo, &hi, 0, 1e-3);
}

enum dom_status dom_placement_budget(const struct dom_row *row, const struct dom_compute *compute,
                                     const struct dom_placement *p, enum dom_error_of kind, double share,
                                     struct dom_budget *budget)
{
    struct budget b = {.row = row, .compute = compute, .placement = p, .kind = kind, .share = share};
    if (!(share > 0 && share < 1))
        return DOM_BAD_PROBABILITY;
    if (kind > DOM_ERROR_COUNT)
        return DOM_BAD_ERROR;
    if (!enough_fall(0, NULL, &b))
        return b.status != DOM_OK ? b.status : DOM_STOPS;
    const bool lengths = kind == DOM_ERROR_gap || kind == DOM_ERROR_place,
               angles = kind == DOM_ERROR_lean || kind == DOM_ERROR_slope;
    b.widest = angles                    ? row_steepest(row)
               : kind == DOM_ERROR_push  ? fmax(row->push, 0) /* 0 without a push */
               : kind == DOM_ERROR_COUNT ? 64
                                         : !lengths;
    for (size_t k = 1; k < row->count && lengths; k++)
        b.widest = fmax(b.widest, row->domino[k].gap);
    /* If rows fall with the probability `share`, at least `many` of them, or at most `few`, fall with a
     * probability of less than 2.5 %. */
    const double N = (double)p->rows;
    double few = floor(share * N), many = ceil(share * N);
    while (few > 0 && binomial_tail(few, N, share, false) >= TAIL)
        few--;
    while (many <= N && binomial_tail(many, N, share, true) >= TAIL)
        many++;
    struct dom_budget found = {.low = 0};
    found.sigma = sigma_find(&b);
    if (b.status != DOM_OK)
        return b.status;
    b.share = many / N;
    if (many <= N)
        found.low = sigma_find(&b);
    b.share = few / N;
    if (b.status == DOM_OK)
        found.high = sigma_find(&b);
    if (b.status == DOM_OK)
        *budget = found;
    return b.status;
}
