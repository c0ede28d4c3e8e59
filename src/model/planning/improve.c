/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the row that falls most reliably under random errors. The search minimizes the smoothed share of
 * random rows that do not fall (chance.h). It begins with few rows and a smoothing as wide as the standard
 * deviation of their margins, so that rows far from failing contribute, too. It goes on with more rows and
 * less smoothing, until the share is almost a plain count. All steps use the same random rows. Other random
 * rows decide whether a result is kept.
 *
 * The minimizer is BFGS from GSL. SLSQP from NLopt is slightly better: for rows of eleven dominoes, 7.2 %
 * failed after the second level instead of 7.6 %, with as many runs. But Debian has NLopt only as a shared
 * library. Loading it takes 190,000 instructions, and the whole program starts in 440,000.
 */
#include "dispatch/dispatch.h"
#include "numerics/quiet.h"
#include "planning/chance.h"
#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <stdlib.h>
#include <string.h>

/* The levels of the search: the number of rows, the width of the smoothing in standard deviations of the
 * margins, and the largest number of function evaluations. Evaluations are limited rather than steps, because
 * a line search of GSL may need 200 evaluations where the function has a kink. */
static const struct level {
    size_t rows;
    double width;
    size_t values;
} levels[] = {{256, 1, 60}, {1024, 0.25, 60}, {4096, 0.1, 60}};
enum { LEVELS = sizeof levels / sizeof *levels };

/* A result is checked after this many evaluations. */
enum { CHECK = 20 };

/* Rows whose margin is larger than this many widths are left out until the next level. */
#define FAR 8

/* A lower limit for the standard deviation of the margins. */
#define SCATTER_LEAST 0.05

/* The tolerance of the margins. */
#define MARGIN_TOL ((dom_real)1e-7)

/* The length of the minimizer's first step, in logarithms of gaps and heights, and the accuracy of its line
 * searches, which is the one that the manual of GSL recommends. */
#define FIRST_STEP 0.02
#define LINE_TOL   0.1

struct search {
    struct shape shape;
    struct chance chance;
    const struct dom_compute *compute;
    const struct dom_placement *placement; /* the random rows that decide whether a result is kept */
    double scatter;
    /* The dominoes of the row that is being evaluated, of the row that is being checked, and of the best row
     * so far. */
    struct dom_domino *domino, *candidate, *best;
    double *by_gap, *by_size;
    double *margin;       /* the margin of each row of a level */
    size_t *row;          /* indices of the rows that are run */
    gsl_vector *lowest_x; /* the variables at the lowest value on this level */
    double lowest;
    size_t left;             /* the number of evaluations that are left on this level */
    double fails;            /* the smoothed share for the best row, as the last level computes it */
    struct dom_study *study; /* the counts for the given row and for the best row so far */
    enum dom_status status;
    dom_progress *progress;
    void *context;
    size_t done;
};

static size_t values_all(void)
{
    size_t all = 0;
    for (int i = 0; i < LEVELS; i++)
        all += levels[i].values;
    return all;
}

/* Returns the number of rows on a level, at most about twice the number of rows that decide. */
static size_t rows_of(const struct dom_placement *placement, const struct level *level)
{
    const size_t most = 2 * placement->rows + 2;
    return level->rows < most ? level->rows : most;
}

static void level_set(struct search *s, const struct level *level)
{
    s->chance.row = NULL;
    s->chance.placement.rows = rows_of(s->placement, level);
    s->chance.width = level->width * s->scatter;
}

/* ---- The function that is minimized ---- */

/* Returns the logarithm of the odds that a row does not fall, and sets its gradient unless `gradient` is
 * NULL. Unlike the probability, the logarithm still has a slope where almost all rows fall, or almost none.
 * When no evaluations are left, the result is infinite, which ends a line search. */
static double odds(const gsl_vector *x, struct search *s, gsl_vector *gradient)
{
    double fails;
    if (s->status != DOM_OK || s->left == 0 || !shape_dominoes(&s->shape, x->data, false, s->domino))
        return HUGE_VAL;
    s->left--;
    if (s->progress)
        s->progress(++s->done, values_all(), s->context);
    const enum dom_status status =
        chance_find(&s->chance, s->domino, &fails, gradient ? s->by_gap : NULL, s->by_size);
    if (status != DOM_OK) {
        s->status = status;
        return HUGE_VAL;
    }
    fails = GSL_MIN_DBL(GSL_MAX_DBL(fails, DBL_MIN), 1 - DBL_EPSILON);
    for (size_t i = 0; gradient && i < x->size; i++) {
        /* the derivatives of gaps and heights by variable i, which cost nothing compared with running rows */
        const double step = 1e-6;
        double sum = 0, *moved = x->data + i * x->stride, at = *moved;
        *moved += step;
        (void)shape_dominoes(&s->shape, x->data, false, s->candidate);
        *moved = at;
        for (size_t k = 1; k < s->shape.row->count; k++)
            sum += s->by_gap[k] * (double)(s->candidate[k].gap - s->domino[k].gap) +
                   s->by_size[k] * (double)(s->candidate[k].height / s->domino[k].height - 1);
        gsl_vector_set(gradient, i, sum / step / (fails * (1 - fails)));
    }
    const double value = (double)log((dom_real)fails / (1 - (dom_real)fails));
    if (value < s->lowest) {
        s->lowest = value;
        gsl_vector_memcpy(s->lowest_x, x);
    }
    return value;
}

static double odds_only(const gsl_vector *x, void *search)
{
    return odds(x, search, NULL);
}

static void odds_both(const gsl_vector *x, void *search, double *f, gsl_vector *gradient)
{
    gsl_vector_set_zero(gradient);
    *f = odds(x, search, gradient);
}

static void odds_gradient(const gsl_vector *x, void *search, gsl_vector *gradient)
{
    double f;
    odds_both(x, search, &f, gradient);
}

/* ---- The search ---- */

/* Finds the margins of the rows of this level. If `selects` is true, then selects the rows that may fail;
 * otherwise sorts the margins in increasing order. */
static void margins_find(struct search *s, const gsl_vector *x, bool selects)
{
    const size_t rows = s->chance.placement.rows;
    if (s->status == DOM_OK && !shape_dominoes(&s->shape, x->data, false, s->domino))
        s->status = DOM_BAD_HALL;
    if (s->status == DOM_OK)
        s->status = chance_margins(&s->chance, s->domino, s->margin);
    if (s->status != DOM_OK)
        return;
    if (!selects) {
        gsl_sort(s->margin, 1, rows);
        return;
    }
    s->chance.row = s->row;
    s->chance.rows = 0;
    for (size_t i = 0; i < rows; i++)
        if (s->margin[i] < FAR * s->chance.width)
            s->row[s->chance.rows++] = i;
}

/* Returns the standard deviation of the margins of the given row. It is estimated from the median and the
 * margins below the median, since the large margins say nothing about the rows that fail. */
static double scatter_of(struct search *s, const gsl_vector *x)
{
    const size_t rows = rows_of(s->placement, &levels[0]);
    level_set(s, &levels[0]);
    margins_find(s, x, false);
    if (s->status != DOM_OK)
        return SCATTER_LEAST;
    return GSL_MAX_DBL(SCATTER_LEAST,
                       gsl_stats_quantile_from_sorted_data(s->margin, 1, rows, 0.5) -
                           gsl_stats_quantile_from_sorted_data(s->margin, 1, rows, gsl_cdf_ugaussian_P(-1)));
}

/* Counts how many of the deciding rows fall. */
static enum dom_status count(struct search *s, const struct dom_domino *domino, struct dom_study *study)
{
    struct dom_row row = *s->shape.row;
    row.domino = domino;
    return dom_placement_study(&row, s->compute, s->placement, study, NULL);
}

/* Keeps a row if it does better than the best row so far in the random rows of the search, and no worse than
 * the given row in the deciding ones. */
static void consider(struct search *s, const gsl_vector *x)
{
    struct dom_study study;
    double fails;
    if (s->status != DOM_OK || !shape_dominoes(&s->shape, x->data, true, s->candidate) ||
        !shape_keeps(&s->shape, s->candidate))
        return;
    const struct chance now = s->chance;
    level_set(s, &levels[LEVELS - 1]);
    s->status = chance_find(&s->chance, s->candidate, &fails, NULL, NULL);
    s->chance = now;
    if (s->status != DOM_OK || !(fails < s->fails))
        return;
    const enum dom_status status = count(s, s->candidate, &study);
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        s->status = status;
    if (status != DOM_OK || study.fall < s->study[0].fall)
        return;
    memcpy(s->best, s->candidate, s->shape.row->count * sizeof *s->best);
    s->fails = fails;
    s->study[1] = study;
}

/* Minimizes on one level. The minimizer stops where the function has a kink, and is then restarted until a
 * restart no longer helps. */
static void level_run(struct search *s, const struct level *level, gsl_multimin_fdfminimizer *m,
                      gsl_vector *x)
{
    gsl_multimin_function_fdf f = {odds_only, odds_gradient, odds_both, x->size, s};
    const size_t begun = s->done;
    double before = HUGE_VAL;
    level_set(s, level);
    margins_find(s, x, true);
    s->left = level->values;
    s->lowest = HUGE_VAL;
    gsl_vector_memcpy(s->lowest_x, x);
    size_t check = s->left - CHECK;
    bool more = gsl_multimin_fdfminimizer_set(m, &f, x, FIRST_STEP, LINE_TOL) == GSL_SUCCESS;
    while (more && s->left > 0 && s->status == DOM_OK) {
        if (gsl_multimin_fdfminimizer_iterate(m) != GSL_SUCCESS) {
            more = s->lowest < before - 0.01;
            before = s->lowest;
            gsl_vector_memcpy(x, s->lowest_x);
            more = more && gsl_multimin_fdfminimizer_set(m, &f, x, FIRST_STEP, LINE_TOL) == GSL_SUCCESS;
        }
        if (s->left < check) {
            check = s->left - GSL_MIN(s->left, CHECK);
            consider(s, s->lowest_x);
        }
    }
    s->done = begun + level->values;
    gsl_vector_memcpy(x, s->lowest_x);
    consider(s, x);
}

/* Runs the search on all levels. */
static void search_run(struct search *s)
{
    const size_t variables = shape_variables(&s->shape);
    gsl_vector *x = gsl_vector_alloc(variables);
    gsl_multimin_fdfminimizer *m =
        gsl_multimin_fdfminimizer_alloc(gsl_multimin_fdfminimizer_vector_bfgs2, variables);
    s->lowest_x = gsl_vector_alloc(variables);
    s->status = x && m && s->lowest_x ? DOM_OK : DOM_NO_MEMORY;
    if (s->status == DOM_OK) {
        shape_begin(&s->shape, x->data);
        s->scatter = scatter_of(s, x);
    }
    level_set(s, &levels[LEVELS - 1]);
    if (s->status == DOM_OK)
        s->status = chance_find(&s->chance, s->best, &s->fails, NULL, NULL);
    for (int i = 0; i < LEVELS && s->status == DOM_OK; i++)
        level_run(s, &levels[i], m, x);
    if (m)
        gsl_multimin_fdfminimizer_free(m);
    if (s->lowest_x)
        gsl_vector_free(s->lowest_x);
    if (x)
        gsl_vector_free(x);
}

static enum dom_status limits_check(const struct dom_limits *l)
{
    enum dom_status status = !(l->q > 0 && (double)l->q < HUGE_VAL)          ? DOM_BAD_Q
                             : !(l->hall > 0)                                ? DOM_BAD_HALL
                             : !(l->heaviest > 0)                            ? DOM_BAD_MASS
                             : !(l->grid >= 0 && (double)l->grid < HUGE_VAL) ? DOM_BAD_GAP
                                                                             : DOM_OK;
    for (size_t i = 0; i < l->boards && status == DOM_OK; i++)
        status = l->board[i] > 0 && (double)l->board[i] < HUGE_VAL ? DOM_OK : DOM_BAD_THICKNESS;
    return status;
}

enum dom_status dom_row_improve(const struct dom_row *row, const struct dom_compute *compute,
                                const struct dom_placement *placement, const struct dom_limits *limits,
                                dom_progress *progress, void *context, struct dom_domino *domino,
                                struct dom_study study[2])
{
    const size_t n = row->count;
    struct search s = {.shape = {row, limits},
                       .compute = compute,
                       .placement = placement,
                       .study = study,
                       .best = domino,
                       .progress = progress,
                       .context = context};
    study[0] = study[1] = (struct dom_study){.rows = 0};
    s.status = limits_check(limits);
    if (s.status == DOM_OK)
        s.status = count(&s, row->domino, &study[0]);
    if (s.status != DOM_OK) {
        study[0].rows = 0;
        return s.status;
    }
    memcpy(domino, row->domino, n * sizeof *domino);
    study[1] = study[0];
    if (study[0].fall == study[0].rows || n < 2)
        return DOM_OK;
    s.chance =
        (struct chance){.shape = &s.shape, .compute = compute_or_default(compute), .placement = *placement};
    s.chance.compute.precision = DOM_DOUBLE;
    s.chance.compute.tol = MARGIN_TOL;
    s.chance.compute.work = NULL;
    s.chance.placement.first += placement->rows;
    s.domino = malloc(n * sizeof *s.domino);
    s.candidate = malloc(n * sizeof *s.candidate);
    s.by_gap = malloc(n * sizeof *s.by_gap);
    s.by_size = malloc(n * sizeof *s.by_size);
    s.margin = malloc(levels[LEVELS - 1].rows * sizeof *s.margin);
    s.row = malloc(levels[LEVELS - 1].rows * sizeof *s.row);
    s.status = s.domino && s.candidate && s.by_gap && s.by_size && s.margin && s.row ? DOM_OK : DOM_NO_MEMORY;
    dom_quiet_begin();
    if (s.status == DOM_OK)
        search_run(&s);
    dom_quiet_end();
    free(s.row);
    free(s.margin);
    free(s.by_size);
    free(s.by_gap);
    free(s.candidate);
    free(s.domino);
    return s.status;
}
