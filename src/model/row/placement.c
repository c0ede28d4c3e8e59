/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows with random errors, on all processors: each row has random numbers of its own, by its number alone. */
#include "numerics/api.h"
#include "numerics/quiet.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_roots.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Of a verdict only the sign of the margin counts: more digits would change one row in a billion. */
#define VERDICT_TOL ((dom_real)1e-9)

/* What an interval of 95 % leaves out at each end. */
#define TAIL 0.025

enum { BATCH = 16, THREADS_MAX = 256 };

/* Two neighbours of a plain counter would begin alike: its bits are mixed (Steele et al., splitmix64, 2014).
 */
static unsigned long row_seed(unsigned long seed, size_t i)
{
    unsigned long long z = seed * 0x9e3779b97f4a7c15ULL + i * 0xbf58476d1ce4e5b9ULL + 0x94d049bb133111ebULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return (unsigned long)(z ^ (z >> 31));
}

/* What all threads share, and what each has. */
struct shared {
    const struct dom_row *row;
    struct dom_compute compute;
    const struct dom_placement *placement;
    atomic_size_t next;
    atomic_int status; /* the first that was not DOM_OK */
};

struct worker {
    struct shared *shared;
    bool reports;
    gsl_rng *random[2];
    struct dom_domino *domino;
    size_t fall, unknown;
    size_t *stops; /* its own counts, or NULL */
    pthread_t thread;
};

/*
 * A standard normal: of two independent ones, since a generator of GSL takes 32 bits as its seed, of which a
 * million rows would share some.
 */
static double normal(const struct worker *w)
{
    return (gsl_ran_gaussian_ziggurat(w->random[0], 1) + gsl_ran_gaussian_ziggurat(w->random[1], 1)) *
           M_SQRT1_2;
}

/* Row number i. */
static void row_draw(const struct worker *w, size_t i)
{
    const struct dom_row *row = w->shared->row;
    const struct dom_placement *p = w->shared->placement;
    unsigned long seed = row_seed(p->seed, i);
    gsl_rng_set(w->random[0], seed & 0xffffffffUL);
    gsl_rng_set(w->random[1], seed >> 32);
    for (size_t k = 0; k < row->count; k++) {
        struct dom_domino d = row->domino[k];
        double gap = (double)d.gap + (double)p->sigma * normal(w);
        double grown = p->heights > 0 ? 1 + (double)p->heights * normal(w) : 1;
        d.gap = k > 0 && p->sigma > 0 ? (dom_real)(gap > 0 ? gap : 0) : d.gap;
        grown = grown > 0.01 ? grown : 0.01; /* a domino has some height */
        d.height *= (dom_real)grown;
        d.mass *= (dom_real)grown;
        w->domino[k] = d;
    }
}

static enum dom_status row_try(struct worker *w, size_t i)
{
    struct dom_row row = *w->shared->row;
    struct dom_compute compute = w->shared->compute;
    struct dom_verdict verdict;
    row_draw(w, i);
    row.domino = w->domino;
    row.floor = false;
    compute.work = NULL;
    compute.tol = compute.tol > VERDICT_TOL ? compute.tol : VERDICT_TOL;
    enum dom_status status = dom_row_run(&row, &compute, false, NULL, NULL, &verdict);
    if (status != DOM_OK)
        return status;
    bool unknown = verdict.end == DOM_ROW_PASSES || verdict.end == DOM_ROW_PARTS;
    w->unknown += unknown;
    w->fall += verdict.end == DOM_ROW_FALLS;
    if (w->stops && !unknown && verdict.end != DOM_ROW_FALLS)
        w->stops[verdict.domino - 1]++;
    return DOM_OK;
}

static void *worker_run(void *context)
{
    struct worker *w = context;
    struct shared *s = w->shared;
    const struct dom_placement *p = s->placement;
    for (;;) {
        size_t from = atomic_fetch_add(&s->next, BATCH), to = from + BATCH < p->rows ? from + BATCH : p->rows;
        for (size_t i = from; i < to; i++) {
            enum dom_status status = row_try(w, p->first + i);
            int none = DOM_OK;
            if (status != DOM_OK)
                atomic_compare_exchange_strong(&s->status, &none, (int)status);
        }
        if (from >= p->rows || atomic_load(&s->status) != DOM_OK)
            return NULL;
        if (w->reports && p->progress)
            p->progress(to, p->rows, p->context);
    }
}

static unsigned thread_count(const struct dom_placement *p)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    size_t n = p->threads > 0 ? p->threads : processors > 0 ? (size_t)processors : 1;
    size_t batches = (p->rows + BATCH - 1) / BATCH;
    n = n < batches ? n : batches;
    return (unsigned)(n < THREADS_MAX ? n : THREADS_MAX);
}

static bool worker_make(struct worker *w, struct shared *shared, bool reports, bool counts)
{
    size_t n = shared->row->count;
    *w = (struct worker){.shared = shared, .reports = reports};
    w->random[0] = gsl_rng_alloc(gsl_rng_taus2);
    w->random[1] = gsl_rng_alloc(gsl_rng_mrg);
    w->domino = malloc(n * sizeof *w->domino);
    w->stops = counts ? calloc(n, sizeof *w->stops) : NULL;
    return w->random[0] && w->random[1] && w->domino && (!counts || w->stops);
}

static void worker_free(struct worker *w)
{
    for (int i = 0; i < 2; i++)
        if (w->random[i])
            gsl_rng_free(w->random[i]);
    free(w->domino);
    free(w->stops);
}

/*
 * The chance that at least k, or at most k, of n rows fall, each with the probability p.  The terms of the
 * binomial distribution come from that of k by their ratios, and are divided by the sum of all: no factorial,
 * and no term is far from what it is added to.  gsl_cdf_beta_P, the same as a function of p, has no value at
 * some p from a million rows on, where its continued fraction does not end.
 */
static double binomial_tail(double k, double n, double p, bool at_least)
{
    const double odds = p / (1 - p), enough = 1e-17, most = 1e20;
    double above = 0, below = 0;
    if (!(p > 0 && p < 1))
        return (p >= 1) == at_least;
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

/* The probability at which the tail has its chance; by halving, since where there is none left it is flat. */
static enum dom_status tail_inverse(struct tail tail, double *p)
{
    enum { STEPS = 200 }; /* 50 for the digits, and 64 to a root as small as one of the most rows can be */
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

/* The exact interval for n of N: its ends are where this many or this few would be a 2.5 % chance. */
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

/* This thread is the first worker; where no more can be had, fewer do it. */
static enum dom_status workers_run(struct worker *worker, unsigned n)
{
    unsigned begun = 1;
    while (begun < n && pthread_create(&worker[begun].thread, NULL, worker_run, &worker[begun]) == 0)
        begun++;
    worker_run(&worker[0]);
    for (unsigned i = 1; i < begun; i++)
        pthread_join(worker[i].thread, NULL);
    return (enum dom_status)atomic_load(&worker[0].shared->status);
}

enum dom_status dom_placement_study(const struct dom_row *row, const struct dom_compute *compute,
                                    const struct dom_placement *p, struct dom_study *study, size_t *stops)
{
    struct dom_study found = {.rows = p->rows};
    enum dom_status bad = !(p->sigma >= 0 && (double)p->sigma < HUGE_VAL) ? DOM_BAD_SIGMA
                          : !(p->heights >= 0 && p->heights <= 1)         ? DOM_BAD_HEIGHTS
                          : p->rows == 0                                  ? DOM_BAD_ROWS
                          : row->count == 0                               ? DOM_BAD_COUNT
                                                                          : DOM_OK;
    if (bad != DOM_OK)
        return bad;
    struct shared shared = {
        .row = row, .compute = compute ? *compute : dom_compute_default(), .placement = p, .status = DOM_OK};
    dom_quiet_begin();
    unsigned n = thread_count(p);
    struct worker *worker = calloc(n, sizeof *worker);
    bool made = worker != NULL;
    for (unsigned i = 0; made && i < n; i++)
        made = worker_make(&worker[i], &shared, i == 0, stops != NULL);
    enum dom_status status = made ? workers_run(worker, n) : DOM_NO_MEMORY;
    if (stops)
        memset(stops, 0, row->count * sizeof *stops);
    for (unsigned i = 0; worker && i < n; i++) {
        found.fall += worker[i].fall;
        found.unknown += worker[i].unknown;
        for (size_t k = 0; stops && worker[i].stops && k < row->count; k++)
            stops[k] += worker[i].stops[k];
        worker_free(&worker[i]);
    }
    free(worker);
    if (compute && compute->work)
        compute->work->entered[DOM_EFFECT_placement] += p->rows;
    if (status == DOM_OK)
        status = dom_study_interval(&found);
    if (status == DOM_OK)
        *study = found;
    dom_quiet_end();
    return status;
}

/* ---- The budget ---- */

/* The same rows at every sigma, with errors that are longer or shorter: so what differs is sigma alone. */
static enum dom_status fall_share(const struct dom_row *row, const struct dom_compute *compute,
                                  struct dom_placement p, double sigma, double *share)
{
    struct dom_study study = {.rows = p.rows};
    p.sigma = (dom_real)sigma;
    enum dom_status status = dom_placement_study(row, compute, &p, &study, NULL);
    *share = (double)study.fall / (double)study.rows;
    return status;
}

/* Between lo, where more than the share fall, and hi, where fewer do: to a thousandth. */
static enum dom_status sigma_between(const struct dom_row *row, const struct dom_compute *compute,
                                     const struct dom_placement *p, double share, double lo, double hi,
                                     double *sigma)
{
    const double none = 1e-9 * hi; /* what nobody can place */
    while (hi - lo > 1e-3 * hi && hi > none) {
        double at = 0.5 * (lo + hi), falls;
        enum dom_status status = fall_share(row, compute, *p, at, &falls);
        if (status != DOM_OK)
            return status;
        *(falls >= share ? &lo : &hi) = at;
    }
    *sigma = lo;
    return DOM_OK;
}

/* The first of doubled sigmas at which fewer than the share fall; infinite where it is beyond `widest`. */
static enum dom_status sigma_at(const struct dom_row *row, const struct dom_compute *compute,
                                const struct dom_placement *p, double share, double widest, double *sigma)
{
    double lo = 0, falls = 1;
    for (double hi = widest / 4096;; lo = hi, hi *= 2) {
        enum dom_status status = fall_share(row, compute, *p, hi, &falls);
        if (status != DOM_OK)
            return status;
        if (falls < share)
            return sigma_between(row, compute, p, share, lo, hi, sigma);
        if (hi >= widest) {
            *sigma = HUGE_VAL;
            return DOM_OK;
        }
    }
}

/*
 * How many of the rows may fall by chance where the share is the true one: fewer than `few` would be a chance
 * of 2.5 %, and so would more than `many`.
 */
static void chance(double share, size_t rows, double *few, double *many)
{
    double N = (double)rows, lo = -1, hi = N;
    while (hi - lo > 1) {
        double k = floor((lo + hi) / 2);
        *(binomial_tail(k, N, share, false) < TAIL ? &lo : &hi) = k;
    }
    *few = fmax(lo, 0);
    lo = 0;
    hi = N + 1;
    while (hi - lo > 1) {
        double k = floor((lo + hi) / 2);
        *(binomial_tail(k, N, share, true) < TAIL ? &hi : &lo) = k;
    }
    *many = hi;
}

enum dom_status dom_placement_budget(const struct dom_row *row, const struct dom_compute *compute,
                                     const struct dom_placement *p, double share, struct dom_budget *budget)
{
    double falls, widest = 0, few, many;
    if (!(share > 0 && share < 1))
        return DOM_BAD_PROBABILITY;
    if (p->rows == 0)
        return DOM_BAD_ROWS;
    enum dom_status status = fall_share(row, compute, *p, 0, &falls);
    if (status != DOM_OK || falls < share)
        return status != DOM_OK ? status : DOM_STOPS;
    for (size_t k = 1; k < row->count; k++)
        widest = fmax(widest, (double)row->domino[k].gap);
    chance(share, p->rows, &few, &many);
    double N = (double)p->rows;
    struct dom_budget found = {.low = 0};
    status = sigma_at(row, compute, p, share, widest, &found.sigma);
    if (status == DOM_OK && many <= N)
        status = sigma_at(row, compute, p, many / N, widest, &found.low);
    if (status == DOM_OK)
        status = sigma_at(row, compute, p, few / N, widest, &found.high);
    if (status == DOM_OK)
        *budget = found;
    return status;
}
