/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Studies of rows with random placement errors, in batches that may run in parallel. The random numbers of a
 * row depend only on the seed and on the number of the row. */
#include "dispatch/dispatch.h"
#include "numerics/quiet.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_roots.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* A verdict depends only on the sign of the margin: a smaller tolerance would change one row in a billion. */
#define VERDICT_TOL ((dom_real)1e-9)

/* The probability that a 95 % confidence interval leaves out at each end. */
#define TAIL 0.025

/* Number of rows in a task. With so many rows, the time to allocate the memory of a task hardly counts. */
enum { BATCH = 16 };

/* Returns the seed of row i. Its bits are mixed with splitmix64 (Steele et al., 2014), since the consecutive
 * values of a plain counter would give similar random numbers. */
static unsigned long row_seed(unsigned long seed, size_t i)
{
    unsigned long long z = seed * 0x9e3779b97f4a7c15ULL + i * 0xbf58476d1ce4e5b9ULL + 0x94d049bb133111ebULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return (unsigned long)(z ^ (z >> 31));
}

/* The data that all batches of a study share. */
struct shared {
    const struct dom_row *row;
    struct dom_compute compute;
    const struct dom_placement *placement;
    atomic_int status; /* the first status that was not DOM_OK */
    atomic_size_t done, fall, unknown;
    atomic_size_t *stops; /* number of rows that ended at each domino, or NULL if not requested */
};

/* The data of one batch. */
struct batch {
    gsl_rng *random[2];
    struct dom_domino *domino;
    const struct kernel *kernel;
    struct random_row *sample; /* runs the rows; NULL if an engine runs them */
};

/* Returns a random number with a standard normal distribution. It combines two generators, because a
 * generator of GSL takes a seed of 32 bits, and with one generator some of a million rows would have the same
 * seed. */
static double normal(const struct batch *b)
{
    return (gsl_ran_gaussian_ziggurat(b->random[0], 1) + gsl_ran_gaussian_ziggurat(b->random[1], 1)) *
           M_SQRT1_2;
}

/* Draws row number i: writes its gaps, heights and masses with random errors to b->domino. */
static void row_draw(const struct batch *b, const struct dom_row *row, const struct dom_placement *p,
                     size_t i)
{
    unsigned long seed = row_seed(p->seed, i);
    gsl_rng_set(b->random[0], seed & 0xffffffffUL);
    gsl_rng_set(b->random[1], seed >> 32);
    for (size_t k = 0; k < row->count; k++) {
        const struct dom_domino *self = &row->domino[k];
        struct dom_domino *d = &b->domino[k];
        double gap = (double)self->gap + (double)p->sigma * normal(b);
        if (k > 0 && p->sigma > 0)
            d->gap = (dom_real)(gap > 0 ? gap : 0);
        if (p->heights > 0) {
            double grown = fmax(1 + (double)p->heights * normal(b), 0.01); /* no domino shrinks to nothing */
            d->height = self->height * (dom_real)grown;
            d->mass = self->mass * (dom_real)grown;
        }
    }
}

/* Runs the row that was drawn. */
static enum dom_status batch_verdict(const struct batch *b, const struct shared *s,
                                     struct dom_verdict *verdict)
{
    struct dom_row row = *s->row;
    if (!row.engine)
        return b->kernel->row_sampled(b->sample, b->domino, s->placement->heights <= 0, verdict);
    row.domino = b->domino;
    row.floor = false;
    return row_verdict(&row, &s->compute, false, NULL, NULL, verdict);
}

static enum dom_status row_try(const struct batch *b, struct shared *s, size_t i)
{
    struct dom_verdict verdict;
    row_draw(b, s->row, s->placement, i);
    enum dom_status status = batch_verdict(b, s, &verdict);
    if (status != DOM_OK)
        return status;
    bool unknown = verdict.end == DOM_ROW_PASSES || verdict.end == DOM_ROW_PARTS;
    s->unknown += unknown;
    s->fall += verdict.end == DOM_ROW_FALLS;
    s->done++;
    if (s->stops && !unknown && verdict.end != DOM_ROW_FALLS)
        s->stops[verdict.domino - 1]++;
    return DOM_OK;
}

/* Checks the row, and allocates the memory for runs of rows with the same number of dominoes. */
static enum dom_status batch_begin(struct batch *b, const struct shared *s)
{
    struct row_question q = row_question_make(s->row, &s->compute);
    q.request.floor = false;
    b->kernel = q.kernel;
    return ASK(q, row_sample, &b->sample);
}

/* A dom_task: runs batch number `index` of the rows, unless another batch has failed. */
static void batch_run(size_t index, void *context)
{
    struct shared *s = context;
    const struct dom_placement *p = s->placement;
    if (atomic_load(&s->status) != DOM_OK)
        return;
    struct batch b = {.random = {gsl_rng_alloc(gsl_rng_taus2), gsl_rng_alloc(gsl_rng_mrg)},
                      .domino = malloc(s->row->count * sizeof *b.domino)};
    enum dom_status status = b.random[0] && b.random[1] && b.domino ? DOM_OK : DOM_NO_MEMORY;
    if (status == DOM_OK)
        memcpy(b.domino, s->row->domino, s->row->count * sizeof *b.domino);
    if (status == DOM_OK && !s->row->engine)
        status = batch_begin(&b, s);
    for (size_t i = index * BATCH; i < p->rows && i < (index + 1) * BATCH && status == DOM_OK; i++)
        status = row_try(&b, s, p->first + i);
    int none = DOM_OK;
    if (status != DOM_OK)
        atomic_compare_exchange_strong(&s->status, &none, (int)status);
    for (int i = 0; i < 2; i++)
        if (b.random[i])
            gsl_rng_free(b.random[i]);
    if (b.sample)
        (void)b.kernel->row_sample_end(b.sample);
    free(b.domino);
}

/* A dom_parallel without a thread pool: runs one task after the other. */
static enum dom_status in_order(size_t count, dom_task *task, void *context, void *pool)
{
    (void)pool;
    for (size_t i = 0; i < count; i++)
        task(i, context);
    return DOM_OK;
}

/*
 * Returns the probability that at least k, or at most k, of n rows fall if each row falls with the
 * probability p. Every term of the binomial distribution is computed from its neighbour by their ratio,
 * starting at the term of k, and the sum is divided by the sum of all terms. So there are no factorials, and
 * all terms are relative to that of k. gsl_cdf_beta_P computes the same probability, but from a million rows
 * on it fails at some p, where its continued fraction does not converge.
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

/* Finds the probability p of a single row at which the tail of the distribution equals TAIL. Bisection is
 * used, since the tail is flat where it is 0. */
static enum dom_status tail_inverse(struct tail tail, double *p)
{
    /* 50 halvings give the digits. Up to 64 more reach a root as small as that for one row out of the largest
     * possible number of rows. */
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

/* The exact confidence interval for n of N rows. If its lower end is the true probability, n or more rows
 * fall with a probability of 2.5 %; if its upper end is, n or fewer do. At the upper end, rows whose outcome
 * is unknown are counted as fallen. */
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

/* Checks the arguments of a study. The gaps and the tolerance are checked here, since the study replaces them
 * before the model sees them. */
static enum dom_status study_check(const struct dom_row *row, const struct dom_compute *compute,
                                   const struct dom_placement *p)
{
    enum dom_status status = !(p->sigma >= 0 && (double)p->sigma < HUGE_VAL) ? DOM_BAD_SIGMA
                             : !(p->heights >= 0 && p->heights <= 1)         ? DOM_BAD_HEIGHTS
                             : p->rows == 0                                  ? DOM_BAD_ROWS
                             : row->count == 0                               ? DOM_BAD_COUNT
                             : compute->precision > DOM_QUAD                 ? DOM_BAD_PRECISION
                             : !(compute->tol >= dom_arithmetic(compute->precision)->tol_floor) ? DOM_BAD_TOL
                                                                                                : DOM_OK;
    for (size_t k = 0; k < row->count && status == DOM_OK; k++)
        status = row->domino[k].gap >= 0 ? DOM_OK : DOM_BAD_GAP;
    return status;
}

enum dom_status dom_placement_study(const struct dom_row *row, const struct dom_compute *compute,
                                    const struct dom_placement *p, struct dom_study *study, size_t *stops)
{
    struct shared shared = {.row = row, .compute = compute_or_default(compute), .placement = p};
    struct dom_work *work = shared.compute.work;
    shared.status = (int)study_check(row, &shared.compute, p);
    if (shared.status != DOM_OK)
        return (enum dom_status)shared.status;
    shared.compute.work = NULL; /* rows may run in parallel, and must not share the counters */
    if (shared.compute.tol < VERDICT_TOL)
        shared.compute.tol = VERDICT_TOL;
    shared.stops = stops ? calloc(row->count, sizeof *shared.stops) : NULL;
    if (stops && !shared.stops)
        return DOM_NO_MEMORY;
    dom_quiet_begin();
    enum dom_status status = (p->parallel ? p->parallel : in_order)(p->rows / BATCH + (p->rows % BATCH > 0),
                                                                    batch_run, &shared, p->pool);
    if (shared.status != DOM_OK)
        status = (enum dom_status)shared.status;
    else if (status == DOM_OK && shared.done < p->rows) /* the pool has not run all batches */
        status = DOM_INTERRUPTED;
    if (work)
        work->entered[DOM_EFFECT_placement] += p->rows;
    struct dom_study found = {.rows = shared.done, .fall = shared.fall, .unknown = shared.unknown};
    bool partial = status == DOM_INTERRUPTED && found.rows > 0;
    enum dom_status counted = status == DOM_OK || partial ? dom_study_interval(&found) : status;
    if (counted == DOM_OK)
        *study = found;
    for (size_t k = 0; stops && counted == DOM_OK && k < row->count; k++)
        stops[k] = shared.stops[k];
    status = partial ? status : counted;
    free(shared.stops);
    dom_quiet_end();
    return status;
}

/* ---- The budget ---- */

enum { BUDGET_SEEN = 128 };

struct budget {
    const struct dom_row *row;
    const struct dom_compute *compute;
    const struct dom_placement *placement;
    double widest; /* the largest gap of the row */
    /* the best known bounds of sigma: at lo at least the share of rows falls, at hi fewer do */
    double lo, hi;
    bool of_answer; /* sigma itself is being searched for, not the ends of its confidence interval */
    struct {
        double sigma, share;
        /* cache of the last results, many of which the searches for the interval need again */
    } seen[BUDGET_SEEN];
    int answers;
};

/* Finds the fraction of the rows that fall. Every sigma uses the same random numbers, so that two studies
 * differ only in the size of the errors of the gaps. */
static enum dom_status fall_share(struct budget *b, double sigma, double *share)
{
    for (int i = 0; i < b->answers && i < BUDGET_SEEN; i++)
        if (b->seen[i].sigma == sigma) {
            *share = b->seen[i].share;
            return DOM_OK;
        }
    struct dom_placement p = *b->placement;
    struct dom_study study = {.rows = p.rows};
    p.sigma = (dom_real)sigma;
    enum dom_status status = dom_placement_study(b->row, b->compute, &p, &study, NULL);
    *share = (double)study.fall / (double)study.rows;
    if (status == DOM_OK) {
        b->seen[b->answers % BUDGET_SEEN].sigma = sigma;
        b->seen[b->answers++ % BUDGET_SEEN].share = *share;
    }
    return status;
}

/* Records the bounds of sigma that are known so far, for the case that the search is interrupted. */
static void known(struct budget *b, double lo, double hi)
{
    b->lo = b->of_answer ? lo : b->lo;
    b->hi = b->of_answer ? hi : b->hi;
}

/* Finds sigma with a relative tolerance of 1e-3. At lo at least the share of rows falls, at hi fewer do. */
static enum dom_status sigma_between(struct budget *b, double share, double lo, double hi, double *sigma)
{
    const double none = 1e-9 * hi; /* smaller than any error of real rows */
    while (hi - lo > 1e-3 * hi && hi > none) {
        double at = 0.5 * (lo + hi), falls;
        enum dom_status status = fall_share(b, at, &falls);
        if (status != DOM_OK)
            return status;
        *(falls >= share ? &lo : &hi) = at;
        known(b, lo, hi);
    }
    *sigma = lo;
    known(b, lo, lo);
    return DOM_OK;
}

/* Finds the largest sigma at which the share of rows falls, by doubling and then by bisection. *sigma is
 * infinite if it is larger than the widest gap. */
static enum dom_status sigma_at(struct budget *b, double share, double *sigma)
{
    double lo = 0, falls = 1;
    for (double hi = b->widest / 4096;; lo = hi, hi *= 2) {
        enum dom_status status = fall_share(b, hi, &falls);
        if (status != DOM_OK)
            return status;
        known(b, falls < share ? lo : hi, falls < share ? hi : HUGE_VAL);
        if (falls < share)
            return sigma_between(b, share, lo, hi, sigma);
        if (hi >= b->widest) {
            *sigma = HUGE_VAL;
            return DOM_OK;
        }
    }
}

/* If `at_least` is true, returns the smallest count such that this many rows or more fall with a probability
 * below 2.5 %, where `share` is the true probability of a single row. Otherwise returns the largest count
 * such that this many or fewer fall with a probability below 2.5 %, or -1 if there is none. */
static double unlikely(double share, double rows, bool at_least)
{
    double lo = at_least ? 0 : -1, hi = lo + rows + 1;
    while (hi - lo > 1) {
        double k = floor((lo + hi) / 2);
        *((binomial_tail(k, rows, share, at_least) < TAIL) == at_least ? &hi : &lo) = k;
    }
    return at_least ? hi : lo;
}

enum dom_status dom_placement_budget(const struct dom_row *row, const struct dom_compute *compute,
                                     const struct dom_placement *p, double share, struct dom_budget *budget)
{
    struct budget b = {.row = row, .compute = compute, .placement = p, .hi = HUGE_VAL, .of_answer = true};
    double falls;
    if (!(share > 0 && share < 1))
        return DOM_BAD_PROBABILITY;
    enum dom_status status = fall_share(&b, 0, &falls);
    if (status != DOM_OK || falls < share)
        return status != DOM_OK ? status : DOM_STOPS;
    for (size_t k = 1; k < row->count; k++)
        b.widest = fmax(b.widest, (double)row->domino[k].gap);
    double N = (double)p->rows, few = fmax(unlikely(share, N, false), 0), many = unlikely(share, N, true);
    struct dom_budget found = {.low = 0};
    status = sigma_at(&b, share, &found.sigma);
    b.of_answer = false;
    if (status == DOM_OK && many <= N)
        status = sigma_at(&b, many / N, &found.low);
    if (status == DOM_OK)
        status = sigma_at(&b, few / N, &found.high);
    if (status == DOM_INTERRUPTED && b.lo > 0)
        *budget = (struct dom_budget){.sigma = b.lo, .low = b.lo, .high = b.hi};
    if (status == DOM_OK)
        *budget = found;
    return status;
}
