/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the row that falls most reliably in spite of random errors. The search minimizes a function: the
 * smoothed fraction of random rows that do not fall. It uses the same random rows in all steps, so that the
 * function has no noise. Other random rows decide whether a result is kept, because the search could have
 * adapted to its own random rows.
 *
 * Without smoothing, a row would either fall or not. With smoothing, a row falls with a certain probability.
 * Each of its margins contributes a factor to this probability: Phi(margin / width), where Phi is the
 * cumulative normal distribution. A first-order reliability index would be cheaper: it needs only the
 * derivatives of the margins at the row without errors. But somewhere between a gap that is too narrow and
 * one that is too wide, the margin has a maximum, and there errors of the gap would seem not to matter.
 *
 * The smoothing has a width for each margin. This width is a multiple of the standard deviation of the
 * margin. On the first level of the search, the multiple is 1. Then every random row contributes to the
 * fraction, even if it is unlikely to stop. Later levels use more random rows and less smoothing.
 *
 * A single width for all margins would be a mistake. Errors of a few mm hardly affect large dominoes. But
 * with a single width, large dominoes would get as much spare energy as small ones, without needing it.
 *
 * The minimizer is BFGS from GSL. For eleven dominoes, 3.8 % of rows still fail with errors of gaps, and 5.1
 * % with errors of four kinds. Methods without derivatives did not reach both in trials of up to 1,000
 * evaluations: COBYLA from NLopt 3.8 % and 5.9 %, the simplex method of Nelder and Mead 4.3 % and 5.5 %,
 * cross-entropy with 40 candidates over 10 % with errors of gaps.
 */
#include "chance/model/draw.h"
#include "rows/model/study.h"
#include "numerics/quiet.h"
#include "numerics/real.h"
#include "planning/model/shape.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <stdlib.h>
#include <string.h>

/* The levels of the search. On each level, the function is computed from `rows` random rows, and its gradient
 * VALUES times. `width` is the width of the smoothing, in standard deviations of the margin. */
static const struct level {
    size_t rows;
    double width;
} levels[] = {{128, 1}, {256, 0.5}, {512, 0.25}, {1024, 0.15}};
enum { LEVELS = sizeof levels / sizeof *levels, VALUES = 13, ROWS_ALL = VALUES * (128 + 256 + 512 + 1024) };

/* After every CHECK evaluations, the best result so far is checked with other random rows. */
enum { CHECK = 8 };

/* Lower bound on the standard deviation of a margin. */
#define SCATTER_LEAST 0.03

#define MARGIN_TOL 1e-5

/* Step of the difference quotients. The margins have errors of about 1e-7. */
#define STEP 1e-4

/* FIRST_STEP is the length of the minimizer's first step. The variables are logarithms, so a step is a
 * relative change. LINE_TOL is the accuracy of line searches; its value is the one that GSL's manual
 * recommends. */
#define FIRST_STEP 0.02
#define LINE_TOL   0.1

/*
 * The energy margin of a domino lies between MARGIN_LEAST and MARGIN_MOST. Three cases have a fixed value:
 * - MARGIN_MOST: the domino needs no energy
 * - MARGIN_LEAST: friction brings the domino to rest, whatever its energy
 * - MARGIN_NONE: the fall ends at this domino for a reason other than lack of energy or too wide a gap. If
 *   the row cannot be computed, its first domino has this margin too.
 */
#define MARGIN_MOST  9.0
#define MARGIN_NONE  (-1.0)
#define MARGIN_LEAST (-3.0)
/* margin of a domino that is not hit because the fall ends earlier, or of a first domino that is tipped */
#define UNSEEN 20.0

/* If a random row almost certainly falls, or almost certainly does not fall, a small change of its dominoes
 * does not matter. So a changed row is not run if the probability is below SURE or above 1 - SURE. */
#define SURE 1e-3

/* ---- The margins of one row ---- */

struct chance {
    struct shape shape;
    struct dom_compute compute;
    struct dom_placement placement; /* describes the random rows */
    double *width;                  /* the width of the smoothing for each margin on the current level */
};

/* Collects the energy margins of a row while the row runs. */
struct run {
    double *margin;
    bool tips; /* true if the first domino is tipped over its edge, and therefore has no margin */
};

static bool margin_seen(const struct dom_fall *fall, void *context)
{
    const struct run *run = context;
    double z = fall->barrier > 0 ? log(fall->kinetic / fall->barrier) : MARGIN_MOST;
    z = z > MARGIN_LEAST ? z : MARGIN_LEAST; /* the barrier is infinite if friction locks the domino */
    if (!(run->tips && fall->domino == 1))
        run->margin[fall->domino - 1] = z < MARGIN_MOST ? z : MARGIN_MOST;
    return true;
}

/*
 * Draws random row i of a row with these dominoes, and finds its margins. There are two for each domino:
 * - The first row.count margins are the energy margins of the dominoes: ln(kinetic energy / barrier).
 * - The others are the margins of reach: 1 - gap / (height of the domino before the gap).
 */
static enum dom_status margins_find(const struct chance *c, struct draw *draw,
                                    const struct dom_domino *domino, size_t i, double *margin)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    struct dom_row row = *c->shape.row;
    row.domino = domino;
    row.engine = NULL;
    draw_row(draw, &row, &c->placement, c->placement.first + i);
    struct run run = {.margin = margin, .tips = isnan(draw->row.push)};
    double *const reach = margin + row.count;
    for (size_t k = 0; k < row.count; k++) {
        margin[k] = UNSEEN;
        reach[k] = k > 0 ? 1 - draw->domino[k].gap / draw->domino[k - 1].height : MARGIN_MOST;
    }
    const enum dom_status status = row_run_on(&draw->row, &c->compute, margin_seen, &run, &verdict);
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        return status;
    if (status != DOM_OK)
        margin[0] = MARGIN_NONE;
    else if (verdict.end != DOM_ROW_FALLS && verdict.end != DOM_ROW_STOPS && verdict.end != DOM_ROW_MISSES)
        margin[verdict.domino > 0 ? verdict.domino - 1 : 0] = MARGIN_NONE;
    return DOM_OK;
}

/* ---- Sums over random rows ---- */

/* Data that all batches share. Each batch has its own sums. They are added in a fixed order at the end, so
 * that the timing of threads does not affect the result. */
struct shared {
    const struct chance *chance;
    const struct dom_domino *domino; /* the dominoes of `rows` rows, one row after the other */
    size_t rows;
    double *sums;   /* for each batch, `rows` sums */
    double *margin; /* the margins of each random row; NULL if not wanted */
    enum dom_status *status;
};

/* Returns the probability that a row with these margins does not fall. */
static double fails_of(const struct chance *c, const double *margin)
{
    double falls = 1;
    for (size_t k = 0; k < 2 * c->shape.row->count; k++)
        falls *= gsl_cdf_ugaussian_P(margin[k] / c->width[k]);
    return 1 - falls;
}

/* Adds random row i of each row to the sums, or only writes its margins. */
static enum dom_status row_add(const struct shared *s, struct draw *draw, size_t i, double *margin,
                               double *sums)
{
    const struct chance *c = s->chance;
    const size_t count = c->shape.row->count;
    if (s->margin)
        return margins_find(c, draw, s->domino, i, s->margin + 2 * count * i);
    enum dom_status status = margins_find(c, draw, s->domino, i, margin);
    double fails = fails_of(c, margin);
    const bool is_sure = !(fails > SURE && fails < 1 - SURE);
    sums[0] += fails;
    for (size_t k = 1; k < s->rows && status == DOM_OK; k++) {
        if (!is_sure) {
            status = margins_find(c, draw, s->domino + k * count, i, margin);
            fails = fails_of(c, margin);
        }
        sums[k] += fails;
    }
    return status;
}

/* A dom_task that runs batch number `index` of the random rows. */
static void batch_run(size_t index, void *context)
{
    struct shared *s = context;
    const size_t rows = s->chance->placement.rows;
    struct draw draw;
    double *margin = malloc(2 * s->chance->shape.row->count * sizeof *margin);
    enum dom_status status = draw_begin(&draw, s->chance->shape.row);
    if (!margin)
        status = DOM_NO_MEMORY;
    for (size_t i = index * BATCH; i < rows && i < (index + 1) * BATCH && status == DOM_OK; i++)
        status = row_add(s, &draw, i, margin, s->sums + index * s->rows);
    draw_end(&draw);
    free(margin);
    s->status[index] = status;
}

/*
 * Runs all random rows for each of the `rows` rows whose dominoes are in the array `domino`, one row after
 * the other. The rows after the first must nearly equal the first. Stores in fails[k] the smoothed fraction
 * of the random rows that do not fall. All rows have the same random errors, so that the differences of
 * `fails` have no noise. If `margin` is not NULL, only writes the margins of the random rows of one row.
 */
static enum dom_status chance_find(const struct chance *c, const struct dom_domino *domino, size_t rows,
                                   double *fails, double *margin)
{
    struct shared s = {.chance = c, .domino = domino, .rows = rows, .margin = margin};
    const struct dom_placement *p = &c->placement;
    const size_t batches = (p->rows + BATCH - 1) / BATCH;
    s.sums = calloc(batches * rows, sizeof *s.sums);
    s.status = calloc(batches, sizeof *s.status);
    enum dom_status status = s.sums && s.status ? DOM_OK : DOM_NO_MEMORY;
    for (size_t i = 0; i < batches && status == DOM_OK; i++)
        s.status[i] = DOM_INTERRUPTED; /* batch_run replaces this status */
    if (status == DOM_OK)
        status = placement_run(p, batch_run, &s);
    for (size_t i = 0; i < batches && status == DOM_OK; i++)
        status = s.status[i];
    for (size_t k = 0; k < rows && fails && status == DOM_OK; k++) {
        fails[k] = 0;
        for (size_t i = 0; i < batches; i++)
            fails[k] += s.sums[i * rows + k] / (double)p->rows;
    }
    free(s.status);
    free(s.sums);
    return status;
}

/* ---- The search ---- */

struct search {
    struct chance chance;
    const struct dom_compute *compute;
    const struct dom_placement *placement; /* the rows that decide whether a result is kept */
    struct dom_domino *domino; /* the row that is evaluated and, for each variable, the changed row */
    struct dom_domino *candidate, *best; /* a row on the grid, and the best row so far */
    double *moved;                       /* the fractions of failures of the rows in `domino` */
    double *margin;                      /* the margins of all random rows */
    double *sorted;                      /* the values of one margin in all random rows, in ascending order */
    gsl_vector *lowest_x;                /* the point at which the function was lowest on the current level */
    double lowest;
    const struct level *level; /* the current level */
    size_t left;               /* evaluations that remain on the current level */
    double fails;              /* the smoothed fraction of failures for the best row so far */
    struct dom_study *study;   /* two studies: of the original row, and of the best row so far */
    bool given_allowed;        /* true if the original row is within the limits */
    bool is_allowed;           /* true if the best row so far is within the limits */
    enum dom_status status;
    dom_progress *progress;
    void *context;
    size_t done; /* the part of ROWS_ALL that is done: the time of a level is proportional to its rows */
};

/* ---- The function that is minimized ---- */

/* Returns ln(p / (1 - p)), where p is the smoothed fraction of the rows that do not fall. Where p is nearly 0
 * or 1, p itself is almost constant, but this logarithm has a clear slope. If x describes no row that fits
 * into the hall, returns infinity. Also returns infinity after an error, or if no evaluations remain, to end
 * a line search. */
static double odds(const gsl_vector *x, struct search *s, gsl_vector *gradient)
{
    double fails;
    if (s->status != DOM_OK || s->left == 0 || !shape_dominoes(&s->chance.shape, x->data, false, s->domino))
        return HUGE_VAL;
    if (gradient) {
        s->left--;
        if (s->progress)
            s->progress(s->done += s->level->rows, ROWS_ALL, s->context);
    }
    for (size_t i = 0; gradient && i < x->size; i++) {
        double *moved = x->data + i * x->stride, at = *moved;
        *moved += STEP;
        (void)shape_dominoes(&s->chance.shape, x->data, false,
                             s->domino + (i + 1) * s->chance.shape.row->count);
        *moved = at;
    }
    s->status = chance_find(&s->chance, s->domino, gradient ? 1 + x->size : 1, s->moved, NULL);
    if (s->status != DOM_OK)
        return HUGE_VAL;
    fails = GSL_MIN_DBL(GSL_MAX_DBL(s->moved[0], DBL_MIN), 1 - DBL_EPSILON);
    for (size_t i = 0; gradient && i < x->size; i++)
        gsl_vector_set(gradient, i, (s->moved[i + 1] - s->moved[0]) / STEP / (fails * (1 - fails)));
    const double value = log(fails / (1 - fails));
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

/* ---- The levels ---- */

/*
 * Sets the width of the smoothing for each margin. The width is a multiple of the standard deviation of the
 * margin. Only small margins stop a row, so only the lower half of the distribution matters. Hence the
 * standard deviation is estimated from the median and a lower quantile.
 */
static void widths_set(struct search *s, const struct level *level, const gsl_vector *x)
{
    const size_t rows = s->chance.placement.rows, margins = 2 * s->chance.shape.row->count;
    if (s->status == DOM_OK && !shape_dominoes(&s->chance.shape, x->data, false, s->domino))
        s->status = DOM_BAD_HALL;
    if (s->status == DOM_OK)
        s->status = chance_find(&s->chance, s->domino, 1, NULL, s->margin);
    for (size_t k = 0; k < margins && s->status == DOM_OK; k++) {
        for (size_t i = 0; i < rows; i++)
            s->sorted[i] = s->margin[i * margins + k];
        gsl_sort(s->sorted, 1, rows);
        const double scatter =
            gsl_stats_quantile_from_sorted_data(s->sorted, 1, rows, 0.5) -
            gsl_stats_quantile_from_sorted_data(s->sorted, 1, rows, gsl_cdf_ugaussian_P(-1));
        s->chance.width[k] = level->width * GSL_MAX_DBL(SCATTER_LEAST, scatter);
    }
}

/* Runs the random rows that decide whether a result is kept. Counts how many of them fall. */
static enum dom_status count(const struct search *s, const struct dom_domino *domino, struct dom_study *study)
{
    struct dom_row row = *s->chance.shape.row;
    row.domino = domino;
    return dom_placement_study(&row, s->compute, s->placement, study, NULL);
}

/*
 * Decides whether the row with the variables x becomes the best row. First, the row is rounded to the grid.
 * Then the rounded row must be within the limits and must pass two tests:
 * - Its smoothed fraction of failures must be the smallest so far. If no row so far was within the limits,
 *   this test is omitted.
 * - In the study, it must fall more often than the original row. If the original row is outside the limits,
 *   this test is omitted.
 */
static void consider(struct search *s, const gsl_vector *x)
{
    struct dom_study study;
    double fails;
    if (s->status != DOM_OK || !shape_dominoes(&s->chance.shape, x->data, true, s->candidate) ||
        !shape_keeps(&s->chance.shape, s->candidate))
        return;
    s->status = chance_find(&s->chance, s->candidate, 1, &fails, NULL);
    if (s->status != DOM_OK || !(fails < s->fails || !s->is_allowed))
        return;
    const enum dom_status status = count(s, s->candidate, &study);
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        s->status = status;
    if (status != DOM_OK || (s->given_allowed && study.fall <= s->study[0].fall))
        return;
    s->is_allowed = true;
    memcpy(s->best, s->candidate, s->chance.shape.row->count * sizeof *s->best);
    s->fails = fails;
    s->study[1] = study;
}

/* Runs the minimizer on one level. If the function has a kink, the minimizer stops there. It is then
 * restarted, as long as restarts help. */
static void level_run(struct search *s, const struct level *level, gsl_multimin_fdfminimizer *m,
                      gsl_vector *x)
{
    gsl_multimin_function_fdf f = {odds_only, odds_gradient, odds_both, x->size, s};
    const size_t begun = s->done;
    double before = HUGE_VAL;
    s->chance.placement.rows = GSL_MIN(level->rows, 2 * s->placement->rows + 2);
    widths_set(s, level, x);
    if (s->status == DOM_OK)
        s->status = chance_find(&s->chance, s->best, 1, &s->fails, NULL);
    s->level = level;
    s->left = VALUES;
    s->lowest = HUGE_VAL;
    gsl_vector_memcpy(s->lowest_x, x);
    if (!s->is_allowed)
        consider(s, x);
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
    s->done = begun + VALUES * level->rows;
    gsl_vector_memcpy(x, s->lowest_x);
    consider(s, x);
}

static void search_run(struct search *s)
{
    const size_t variables = shape_variables(&s->chance.shape);
    gsl_vector *x = gsl_vector_alloc(variables);
    gsl_multimin_fdfminimizer *m =
        gsl_multimin_fdfminimizer_alloc(gsl_multimin_fdfminimizer_vector_bfgs2, variables);
    s->lowest_x = gsl_vector_alloc(variables);
    s->status = x && m && s->lowest_x ? DOM_OK : DOM_NO_MEMORY;
    if (s->status == DOM_OK)
        shape_begin(&s->chance.shape, x->data);
    for (int i = 0; i < LEVELS && s->status == DOM_OK; i++)
        level_run(s, &levels[i], m, x);
    if (m)
        gsl_multimin_fdfminimizer_free(m);
    if (s->lowest_x)
        gsl_vector_free(s->lowest_x);
    if (x)
        gsl_vector_free(x);
}

enum dom_status dom_row_improve(const struct dom_row *row, const struct dom_compute *compute,
                                const struct dom_placement *placement, const struct dom_limits *limits,
                                dom_progress *progress, void *context, struct dom_domino *domino,
                                struct dom_study study[2])
{
    const size_t n = row->count;
    struct search s = {
        .chance = {.shape = {row, limits}, .compute = compute_or_default(compute), .placement = *placement},
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
    s.given_allowed = s.is_allowed = shape_keeps(&s.chance.shape, row->domino);
    if (s.given_allowed)
        study[1] = study[0];
    if ((study[0].fall == study[0].rows && s.given_allowed) || n < 2)
        return DOM_OK;
    s.chance.compute.tol = MARGIN_TOL;
    s.chance.compute.work = NULL;
    s.chance.placement.first += placement->rows;
    const size_t rows = levels[LEVELS - 1].rows, variables = shape_variables(&s.chance.shape);
    s.domino = malloc((2 + variables) * n * sizeof *s.domino);
    s.margin = malloc((2 * n * (rows + 1) + rows + 1 + variables) * sizeof *s.margin);
    if (s.domino && s.margin) {
        s.candidate = s.domino + (1 + variables) * n;
        s.sorted = s.margin + 2 * n * rows;
        s.chance.width = s.sorted + rows;
        s.moved = s.chance.width + 2 * n;
        dom_quiet_begin();
        search_run(&s);
        dom_quiet_end();
    } else
        s.status = DOM_NO_MEMORY;
    free(s.margin);
    free(s.domino);
    return s.status;
}
