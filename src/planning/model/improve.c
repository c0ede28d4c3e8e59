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
 * The minimizer is BFGS, with a step that is halved until the function falls. For eleven dominoes, 2.8 % of
 * rows still fail with errors of gaps, and 5.1 % with errors of four kinds. In trials, BFGS from GSL left 3.8
 * % and 5.1 %, COBYLA from NLopt 3.8 % and 5.9 %, the simplex method of Nelder and Mead 4.3 % and 5.5 %, and
 * cross-entropy with 40 candidates over 10 % with errors of gaps. If the variables are the heights, rather
 * than the growths from domino to domino, BFGS leaves 5.4 % with errors of gaps.
 */
#include "chance/model/draw.h"
#include "numerics/real.h"
#include "planning/model/shape.h"
#include "rows/model/study.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* The levels of the search. On each level, the function and its slopes are computed STEPS times from `rows`
 * random rows. `width` is the width of the smoothing, in standard deviations of the margin. */
static const struct level {
    size_t rows;
    double width;
} levels[] = {{128, 1}, {256, 0.5}, {512, 0.25}, {1024, 0.15}};
enum { LEVELS = sizeof levels / sizeof *levels, STEPS = 13, ROWS_ALL = STEPS * (128 + 256 + 512 + 1024) };

/* After CHECK steps of a level, and at its end, the result is checked with other random rows. */
enum { CHECK = 9 };

/* The standard deviation of a margin is estimated from this many rows. Its lower bound is SCATTER_LEAST. */
enum { SCATTER_ROWS = 128 };
#define SCATTER_LEAST 0.03

#define MARGIN_TOL 1e-5

/* Step of the difference quotients. The margins have errors of about 1e-7. */
#define NEAR 1e-4

/* The length of the minimizer's first step, and the largest change of a variable in one step. The variables
 * are logarithms, so these are relative changes. The first trial of a step may be halved HALVED times. */
#define FIRST_STEP 0.02
#define STEP_MOST  0.1
enum { HALVED = 4 };

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

struct search {
    struct shape shape;
    const struct dom_compute *compute;
    const struct dom_placement *placement; /* the rows that decide whether a result is kept */
    struct dom_compute rough;              /* settings of the search */
    struct dom_placement random;           /* the random rows of the search */
    size_t variables;
    /* For each variable: its value, its value at the end of a trial step, the last step, the slope of the
     * function at x, and the slope before the last step. */
    double *x, *next, *step, *slope, *before;
    double *inverse;           /* an estimate of the inverse matrix of the second derivatives */
    bool is_fresh;             /* it has not been estimated from two slopes */
    double value;              /* the function at x */
    double *fails;             /* for each row in `domino`, the smoothed fraction of failures */
    double *width;             /* the width of the smoothing for each margin on the current level */
    struct dom_domino *domino; /* the row at x and, for each variable, the row with this variable changed */
    struct dom_domino *candidate, *best; /* a row on the grid, and the best row so far */
    double least;                        /* the smoothed fraction of failures for the best row so far */
    struct dom_study *study;             /* two studies: of the original row, and of the best row so far */
    bool given_allowed;                  /* true if the original row is within the limits */
    bool is_allowed;                     /* true if the best row so far is within the limits */
    enum dom_status status;
    dom_progress *progress;
    void *context;
    size_t done; /* the part of ROWS_ALL that is done: the time of a level is proportional to its rows */
};

/* ---- The margins of one row ---- */

/* Collects the energy margins of a row while the row runs. */
struct run {
    double *margin;
    bool tips; /* true if the first domino is tipped over its edge, and therefore has no margin */
};

static bool margin_seen(const struct dom_fall *fall, void *context)
{
    const struct run *run = context;
    /* the barrier is infinite if friction locks the domino */
    const double z = fall->barrier > 0 ? log(fall->kinetic / fall->barrier) : MARGIN_MOST;
    if (!(run->tips && fall->domino == 1))
        run->margin[fall->domino - 1] = fmin(fmax(z, MARGIN_LEAST), MARGIN_MOST);
    return true;
}

/*
 * Draws random row i of a row with these dominoes, and finds its margins. There are two for each domino:
 * - The first row.count margins are the energy margins of the dominoes: ln(kinetic energy / barrier).
 * - The others are the margins of reach: 1 - gap / (height of the domino before the gap).
 */
static enum dom_status margins_find(const struct search *s, struct draw *draw,
                                    const struct dom_domino *domino, size_t i, double *margin)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    struct dom_row row = *s->shape.row;
    row.domino = domino;
    row.engine = NULL;
    draw_row(draw, &row, &s->random, s->random.first + i);
    struct run run = {.margin = margin, .tips = isnan(draw->row.push)};
    double *const reach = margin + row.count;
    for (size_t k = 0; k < row.count; k++) {
        margin[k] = UNSEEN;
        reach[k] = k > 0 ? 1 - draw->domino[k].gap / draw->domino[k - 1].height : MARGIN_MOST;
    }
    const enum dom_status status = row_run_on(&draw->row, &s->rough, margin_seen, &run, &verdict);
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        return status;
    if (status != DOM_OK)
        margin[0] = MARGIN_NONE;
    else if (verdict.end != DOM_ROW_FALLS && verdict.end != DOM_ROW_STOPS && verdict.end != DOM_ROW_MISSES)
        margin[verdict.domino > 0 ? verdict.domino - 1 : 0] = MARGIN_NONE;
    return DOM_OK;
}

/*
 * Sets the width of the smoothing for each margin of the row at x. The width is a multiple of the standard
 * deviation of the margin. Only small margins stop a row, so only the lower half of the distribution matters.
 * Hence the standard deviation is estimated from the median and a lower quantile.
 */
static void widths_set(struct search *s, double width)
{
    const size_t margins = 2 * s->shape.row->count, rows = SCATTER_ROWS;
    double *const margin = malloc((rows + 1) * margins * sizeof *margin), *const one =
                                                                              margin + rows * margins;
    struct draw draw;
    const enum dom_status begun = draw_begin(&draw, s->shape.row);
    s->status = !margin ? DOM_NO_MEMORY : begun;
    if (s->status == DOM_OK && !shape_dominoes(&s->shape, s->x, false, s->domino))
        s->status = DOM_BAD_HALL;
    for (size_t i = 0; i < rows && s->status == DOM_OK; i++) {
        s->status = margins_find(s, &draw, s->domino, i, one);
        for (size_t k = 0; k < margins && s->status == DOM_OK; k++)
            margin[k * rows + i] = one[k];
    }
    for (size_t k = 0; k < margins && s->status == DOM_OK; k++) {
        double *const sorted = margin + k * rows;
        gsl_sort(sorted, 1, rows);
        const double scatter = gsl_stats_quantile_from_sorted_data(sorted, 1, rows, 0.5) -
                               gsl_stats_quantile_from_sorted_data(sorted, 1, rows, gsl_cdf_ugaussian_P(-1));
        s->width[k] = width * fmax(SCATTER_LEAST, scatter);
    }
    draw_end(&draw);
    free(margin);
}

/* ---- The function that is minimized ---- */

/* Data that all batches share. Each batch has its own sums. They are added in a fixed order at the end, so
 * that the timing of threads does not affect the result. */
struct shared {
    const struct search *search;
    const struct dom_domino *domino; /* the dominoes of `count` rows, one row after the other */
    size_t count;
    double *sums; /* for each batch, `count` sums */
    atomic_int status;
};

/* Returns the probability that a row with these margins does not fall. */
static double fails_of(const struct search *s, const double *margin)
{
    double falls = 1;
    for (size_t k = 0; k < 2 * s->shape.row->count; k++)
        falls *= gsl_cdf_ugaussian_P(margin[k] / s->width[k]);
    return 1 - falls;
}

/* A dom_task that runs batch number `index` of the random rows. */
static void batch_run(size_t index, void *context)
{
    struct shared *shared = context;
    const struct search *s = shared->search;
    const size_t row = s->shape.row->count;
    double *const margin = malloc(2 * row * sizeof *margin), *const sums =
                                                                 shared->sums + index * shared->count;
    struct draw draw;
    enum dom_status status = draw_begin(&draw, s->shape.row);
    if (!margin)
        status = DOM_NO_MEMORY;
    for (size_t i = index * BATCH; i < s->random.rows && i < (index + 1) * BATCH; i++) {
        double fails = 0;
        bool is_sure = false;
        for (size_t k = 0; k < shared->count && status == DOM_OK; k++) {
            if (!is_sure) {
                status = margins_find(s, &draw, shared->domino + k * row, i, margin);
                fails = fails_of(s, margin);
            }
            is_sure = is_sure || (k == 0 && !(fails > SURE && fails < 1 - SURE));
            sums[k] += fails;
        }
    }
    if (status != DOM_OK)
        atomic_store(&shared->status, (int)status);
    draw_end(&draw);
    free(margin);
}

/*
 * Runs all random rows for each of `count` rows, whose dominoes are in the array `domino`, one row after the
 * other. The rows after the first must nearly equal the first. Stores in fails[k] the smoothed fraction of
 * the random rows that do not fall. All rows have the same random errors, so that the differences of `fails`
 * have no noise. Returns false after an error.
 */
static bool fails_find(struct search *s, const struct dom_domino *domino, size_t count, double *fails)
{
    const size_t batches = (s->random.rows + BATCH - 1) / BATCH;
    struct shared shared = {s, domino, count, calloc(batches * count, sizeof *shared.sums), DOM_OK};
    if (s->status == DOM_OK)
        s->status = shared.sums ? placement_run(&s->random, batch_run, &shared) : DOM_NO_MEMORY;
    if (s->status == DOM_OK)
        s->status = (enum dom_status)shared.status;
    for (size_t k = 0; k < count && s->status == DOM_OK; k++) {
        fails[k] = 0;
        for (size_t i = 0; i < batches; i++)
            fails[k] += shared.sums[i * count + k] / (double)s->random.rows;
    }
    free(shared.sums);
    return s->status == DOM_OK;
}

/* ---- The search ---- */

/* Runs the random rows that decide whether a result is kept. Counts how many of them fall. */
static enum dom_status count(const struct search *s, const struct dom_domino *domino, struct dom_study *study)
{
    struct dom_row row = *s->shape.row;
    row.domino = domino;
    return dom_placement_study(&row, s->compute, s->placement, study, NULL);
}

/*
 * Decides whether the row at x becomes the best row. First, the row is rounded to the grid.
 * Then the rounded row must be within the limits and must pass two tests:
 * - Its smoothed fraction of failures must be the smallest so far. If no row so far was within the limits,
 *   this test is omitted.
 * - In the study, it must fall more often than the original row. If the original row is outside the limits,
 *   this test is omitted.
 */
static void consider(struct search *s)
{
    struct dom_study study;
    double fails;
    if (!shape_dominoes(&s->shape, s->x, true, s->candidate) ||
        !shape_keeps(&s->shape, s->candidate, s->domino) || !fails_find(s, s->candidate, 1, &fails) ||
        (s->is_allowed && !(fails < s->least)))
        return;
    const enum dom_status status = count(s, s->candidate, &study);
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        s->status = status;
    if (status != DOM_OK || (s->given_allowed && study.fall <= s->study[0].fall))
        return;
    s->is_allowed = true;
    memcpy(s->best, s->candidate, s->shape.row->count * sizeof *s->best);
    s->least = fails;
    s->study[1] = study;
}

/* ---- The minimizer ---- */

/* Where the fraction p of the rows that do not fall is nearly 0 or 1, it is almost constant, but this
 * function of p has a clear slope. */
static double odds_of(double p)
{
    p = fmin(fmax(p, DBL_MIN), 1 - DBL_EPSILON);
    return log(p / (1 - p));
}

/* Computes the function and its slopes at x. Returns false after an error. */
static bool slopes_find(struct search *s)
{
    const struct shape *shape = &s->shape;
    (void)shape_dominoes(shape, s->x, false, s->domino);
    for (size_t i = 0; i < s->variables; i++) {
        const double at = s->x[i];
        s->x[i] += NEAR;
        (void)shape_dominoes(shape, s->x, false, s->domino + (i + 1) * shape->row->count);
        s->x[i] = at;
    }
    if (!fails_find(s, s->domino, 1 + s->variables, s->fails))
        return false;
    s->value = odds_of(s->fails[0]);
    for (size_t i = 0; i < s->variables; i++) {
        s->before[i] = s->slope[i];
        s->slope[i] = (odds_of(s->fails[i + 1]) - s->value) / NEAR;
    }
    return true;
}

/* Begins without knowledge of second derivatives: the first step has the length FIRST_STEP. */
static void inverse_begin(struct search *s)
{
    const size_t n = s->variables;
    double square = 0;
    for (size_t i = 0; i < n; i++)
        square += s->slope[i] * s->slope[i];
    for (size_t i = 0; i < n * n; i++)
        s->inverse[i] = i % (n + 1) == 0 && square > 0 ? FIRST_STEP / sqrt(square) : 0;
    s->is_fresh = true;
}

/* Learns from how the slopes y have changed in the last step. Before the first lesson, the inverse gets the
 * right scale (Nocedal and Wright, 2006, section 6.1). */
static void inverse_learn(struct search *s)
{
    const size_t n = s->variables;
    double *const of_y = s->next, step_y = 0, y_of_y = 0;
    for (size_t i = 0; i < n; i++) {
        of_y[i] = 0;
        for (size_t k = 0; k < n; k++)
            of_y[i] += s->inverse[i * n + k] * (s->slope[k] - s->before[k]);
        step_y += s->step[i] * (s->slope[i] - s->before[i]);
        y_of_y += of_y[i] * (s->slope[i] - s->before[i]);
    }
    const double scale = s->is_fresh ? step_y / y_of_y : 1, both = 1 + scale * y_of_y / step_y;
    if (!(step_y > 0 && y_of_y > 0))
        return;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++)
            s->inverse[i * n + k] =
                scale * s->inverse[i * n + k] +
                (both * s->step[i] * s->step[k] - scale * (of_y[i] * s->step[k] + s->step[i] * of_y[k])) /
                    step_y;
    s->is_fresh = false;
}

/* Makes a step from x. Returns false if the function does not fall, or after an error. */
static bool x_move(struct search *s)
{
    const size_t n = s->variables;
    double fall = 0, most = 0, fails;
    for (size_t i = 0; i < n; i++) {
        s->step[i] = 0;
        for (size_t k = 0; k < n; k++)
            s->step[i] -= s->inverse[i * n + k] * s->slope[k];
        fall += s->step[i] * s->slope[i];
        most = fmax(most, fabs(s->step[i]));
    }
    double part = most > STEP_MOST ? STEP_MOST / most : 1;
    for (int k = 0; k <= HALVED; k++, part /= 2) {
        for (size_t i = 0; i < n; i++)
            s->next[i] = s->x[i] + part * s->step[i];
        if (!shape_dominoes(&s->shape, s->next, false, s->domino) || !fails_find(s, s->domino, 1, &fails))
            return false;
        if (odds_of(fails) < s->value + 1e-4 * part * fall) {
            for (size_t i = 0; i < n; i++)
                s->step[i] *= part;
            memcpy(s->x, s->next, n * sizeof *s->x);
            return true;
        }
    }
    return false;
}

static void level_run(struct search *s, const struct level *level)
{
    const size_t begun = s->done, enough = 2 * s->placement->rows + 2;
    s->random.rows = level->rows < enough ? level->rows : enough;
    widths_set(s, level->width);
    (void)fails_find(s, s->best, 1, &s->least);
    if (!s->is_allowed)
        consider(s);
    bool moves = true;
    for (int i = 0; i < STEPS && moves && slopes_find(s); i++) {
        if (s->progress)
            s->progress(s->done += level->rows, ROWS_ALL, s->context);
        if (i == CHECK)
            consider(s);
        if (i == 0)
            inverse_begin(s);
        else
            inverse_learn(s);
        moves = i + 1 < STEPS && x_move(s);
        if (!moves && i + 1 < STEPS && !s->is_fresh) { /* the function may have a kink here */
            inverse_begin(s);
            moves = x_move(s);
        }
    }
    consider(s);
    s->done = begun + STEPS * level->rows;
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
                       .rough = compute_or_default(compute),
                       .random = *placement,
                       .best = domino,
                       .study = study,
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
    s.rough.tol = MARGIN_TOL;
    s.rough.work = NULL;
    s.random.first += placement->rows;
    const size_t v = s.variables = shape_variables(&s.shape);
    s.domino = malloc((2 + v) * n * sizeof *s.domino);
    s.x = calloc(6 * v + 1 + v * v + 2 * n, sizeof *s.x);
    if (s.domino && s.x) {
        s.candidate = s.domino + (1 + v) * n;
        s.next = s.x + v;
        s.step = s.next + v;
        s.slope = s.step + v;
        s.before = s.slope + v;
        s.inverse = s.before + v;
        s.fails = s.inverse + v * v;
        s.width = s.fails + v + 1;
        s.given_allowed = s.is_allowed = shape_keeps(&s.shape, domino, s.candidate);
        if (s.given_allowed)
            study[1] = study[0];
        shape_begin(&s.shape, s.x);
        const bool is_needed = n > 1 && !(s.given_allowed && study[0].fall == study[0].rows);
        for (int i = 0; i < LEVELS && is_needed && s.status == DOM_OK; i++)
            level_run(&s, &levels[i]);
    } else
        s.status = DOM_NO_MEMORY;
    free(s.x);
    free(s.domino);
    return s.status;
}
