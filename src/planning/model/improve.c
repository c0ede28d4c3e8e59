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
 * The minimizer uses only the signs of the slopes. Each variable moves by a step of its own against the sign
 * of its slope. The step grows while the sign stays the same, and is halved when the sign changes (Rprop,
 * Riedmiller and Braun, 1993). So neither second derivatives nor searches along a line are needed. For eleven
 * dominoes, 2.9 % of rows still fail with errors of gaps, and 5.1 % with errors of four kinds. In trials,
 * BFGS left 2.8 % and 5.1 %, and of the methods of NLopt, BOBYQA 4.2 % and 5.2 %, SLSQP, in less than half
 * the time, 5.9 % and 5.4 %, and COBYLA, in more than twice the time, 7.8 % and 5.1 %. Cross-entropy with 40
 * candidates left 5.6 % and 5.7 %, in almost three times the time.
 */
#include "chance/model/draw.h"
#include "numerics/real.h"
#include "planning/model/shape.h"
#include "row/row.h"
#include "search/search.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <stdlib.h>
#include <string.h>

/* The levels of the search. On each level, the search makes STEPS steps with `rows` random rows. `width` is
 * the width of the smoothing, in standard deviations of the margin. */
enum { LEVELS = 4, STEPS = 13, ROWS_MOST = 1024, ROWS_ALL = STEPS * (128 + 256 + 512 + ROWS_MOST) };
static const struct level {
    size_t rows;
    double width;
} levels[LEVELS] = {{128, 1}, {256, 0.5}, {512, 0.25}, {ROWS_MOST, 0.15}};

/* The standard deviation of a margin is estimated from this many rows. Its lower bound is SCATTER_LEAST. */
enum { SCATTER_ROWS = 128 };
#define SCATTER_LEAST 0.03

#define MARGIN_TOL 1e-5

/* Step of the difference quotients. The margins have errors of about 1e-7. */
#define NEAR 1e-4

/* The first step of each variable, and the largest one. The variables are logarithms, so these are relative
 * changes. */
#define FIRST_STEP 0.005
#define STEP_MOST  0.1

/* The factors by which a step becomes longer or shorter. */
#define LONGER  1.2
#define SHORTER 0.5

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

/* ---- The dominoes that the variables describe ----
 *
 * Each gap has one variable: ln(gap / height of the domino before the gap). If sizes may change, each domino
 * between the first and the last has one, too: the logarithm of the factor by which this domino and those
 * after it, except the last, become larger.
 */

/* Limits of a gap, as fractions of the height of the domino before it. */
#define LEAST (1.0 / 1000)
#define MOST  (98.0 / 100)

/* If a row is too long for the hall, its gaps are narrowed. To avoid a kink, the narrowing sets in gradually,
 * a little before the row fills the hall. The larger this exponent, the more abruptly the narrowing sets in.
 * If the row exactly fills the hall, its gaps are multiplied by 2^(-1 / SHARP). */
#define SHARP 64.0

/* A height is multiplied or divided by at most this factor. */
#define FARTHEST 4.0

/* Two lengths count as equal if their relative difference is at most this, because of rounding errors. */
#define SAME 1e-9

enum dom_status limits_check(const struct dom_limits *l)
{
    enum dom_status status = !(l->q > 0 && l->q < HUGE_VAL)          ? DOM_BAD_Q
                             : !(l->hall > 0)                        ? DOM_BAD_HALL
                             : !(l->grid >= 0 && l->grid < HUGE_VAL) ? DOM_BAD_GAP
                                                                     : DOM_OK;
    for (size_t i = 0; i < l->boards && status == DOM_OK; i++)
        status = l->board[i] > 0 && l->board[i] < HUGE_VAL ? DOM_OK : DOM_BAD_THICKNESS;
    return status;
}

/* Returns the number of dominoes whose sizes may change: those from index 1 on. */
static size_t sizes_of(const struct shape *s)
{
    return s->limits->sizes && s->row->count > 2 ? s->row->count - 2 : 0;
}

/* Sets the height and the thickness of a domino. Its mass, its width and the radius of its edges change
 * accordingly. */
static void resize(const struct shape *s, struct dom_domino *d, double height, double thickness)
{
    const struct dom_domino before = *d;
    const double x = height / d->height, slimmer = thickness / d->thickness / x, q = s->limits->q;
    d->width *= x;
    d->radius *= x;
    d->height = height;
    d->thickness = thickness;
    /* The mass of a solid domino (q = 4) is proportional to its thickness. The mass of a domino with thin
     * walls (q = 3) hardly depends on its thickness. */
    d->mass *= wood_factor(s->row, &before, d, pow(x, q - 1) * pow(slimmer, q - 3));
}

/* Returns the multiple of the grid nearest to a length, but at least one grid step. */
static double on_grid(const struct shape *s, double length)
{
    const double grid = s->limits->grid;
    return grid > 0 ? multiple_of(fmax(floor(length / grid + 0.5), 1), grid) : length;
}

/* Returns the thickness that a domino gets if `thickness` is wanted: that of the closest board, if it must be
 * made from a board. If boxes_above of the row is > 0, boxes may have any thickness. */
static double board_near(const struct shape *s, double height, double thickness, bool final)
{
    const struct dom_limits *l = s->limits;
    const bool is_free = l->boards == 0 || (s->row->boxes_above > 0 && walls_of(s->row, height) > 0);
    double near = is_free ? thickness : l->board[0];
    for (size_t i = 1; i < l->boards && !is_free; i++)
        near = fabs(l->board[i] - thickness) < fabs(near - thickness) ? l->board[i] : near;
    return is_free && final ? on_grid(s, near) : near;
}

/* Rounds all gaps to the grid. If each gap were rounded alone, the rounding errors could add up. So before a
 * gap is rounded, the rounding error of the earlier gaps is added to it. */
static void gaps_round(const struct shape *s, struct dom_domino *d)
{
    const double grid = s->limits->grid;
    double exact = 0, rounded = 0;
    for (size_t k = 1; k < s->row->count && grid > 0; k++) {
        exact += d[k].gap;
        d[k].gap = multiple_of(fmax(floor((exact - rounded) / grid + 0.5), 0), grid);
        rounded += d[k].gap;
    }
}

/* Writes the dominoes that the variables x describe. If a domino cannot reach across the gap after it, this
 * gap is narrowed. If the row is too long for the hall, all gaps are narrowed. If `final` is true, lengths
 * are rounded to the grid. If the hall is too short even without gaps, returns false. */
static bool shape_dominoes(const struct shape *s, const double *x, bool final, struct dom_domino *d)
{
    const size_t count = s->row->count;
    const struct dom_domino *given = s->row->domino;
    double room = s->limits->hall - given[count - 1].height - s->limits->grid, sum = 0, larger = 0;
    memcpy(d, given, count * sizeof *d);
    for (size_t k = 1; k <= sizes_of(s); k++) {
        larger += x[count - 2 + k];
        const double wish = given[k].height * exp(fmin(fmax(larger, -log(FARTHEST)), log(FARTHEST))),
                     height = final ? on_grid(s, wish) : wish;
        resize(s, &d[k], height, board_near(s, height, given[k].thickness / given[k].height * height, final));
    }
    for (size_t k = 0; k < count; k++)
        room -= d[k].thickness;
    for (size_t k = 1; k < count; k++) {
        d[k].gap = fmin(fmax(exp(x[k - 1]), LEAST), MOST) * d[k - 1].height;
        sum += d[k].gap;
    }
    if (room <= 0 && count > 1)
        return false;
    /* This is min(1, room / sum) without the kink, so that the minimizer can follow the limit. */
    const double narrower = isinf(room) ? 1 : pow(1 + pow(sum / room, SHARP), -1 / SHARP);
    for (size_t k = 1; k < count; k++)
        d[k].gap *= narrower;
    if (final)
        gaps_round(s, d);
    return true;
}

void shape_round(const struct shape *s, size_t count, struct dom_domino *d)
{
    for (size_t k = 1; k < count; k++) {
        const double height = k + 1 < s->row->count ? on_grid(s, d[k].height) : d[k].height;
        resize(s, &d[k], height, board_near(s, height, d[k].thickness * (height / d[k].height), true));
    }
    gaps_round(s, d);
}

static bool is_near(double a, double b)
{
    return fabs(a - b) <= SAME * fabs(b);
}

/* Returns true if a row is within the limits. `rounded` has room for its dominoes. */
static bool shape_keeps(const struct shape *s, const struct dom_domino *d, struct dom_domino *rounded)
{
    const size_t count = s->row->count;
    double length = d[count - 1].height;
    bool keeps = true;
    memcpy(rounded, d, count * sizeof *d);
    shape_round(s, 1 + sizes_of(s), rounded);
    for (size_t k = 0; k < count; k++) {
        length += d[k].gap + d[k].thickness;
        keeps = keeps && is_near(d[k].height, rounded[k].height) &&
                is_near(d[k].thickness, rounded[k].thickness) && is_near(d[k].gap, rounded[k].gap);
    }
    return keeps && length <= s->limits->hall * (1 + SAME);
}

/* ---- The state of the search ---- */

struct search {
    struct shape shape;
    const struct dom_compute *compute;
    const struct dom_placement *placement; /* the rows that decide whether a result is kept */
    dom_progress *progress;
    void *context;
    size_t done;                 /* the part of ROWS_ALL that is done: a step takes as long as it has rows */
    struct dom_compute rough;    /* settings of the search */
    struct dom_placement random; /* the random rows of the search */
    size_t variables;
    double *x, *step, *slope; /* for each variable: its value, its next step, the slope of the function */
    double *width;            /* the width of the smoothing for each margin on the current level */
    /* The row that is tried now, without an engine. Of each of its random rows: the margins, and the
     * probability that it fails. `near` has the probabilities for a row that nearly equals it, or is NULL. */
    struct dom_row tried;
    double *margin, *fails;
    const double *near;
    double *probability;                   /* memory for `fails` and `near` */
    struct dom_domino *domino, *candidate; /* the row at x or close to it, and a row on the grid */
    struct dom_domino *best;               /* the best row so far */
    double least;                          /* the smoothed fraction of failures for the best row so far */
    /* Two studies: of the original row, and of the best row so far. The latter has no rows as long as no row
     * is within the limits. */
    struct dom_study *study;
    bool given_allowed; /* true if the original row is within the limits */
    enum dom_status status;
};

/* ---- The function that is minimized ---- */

/* Collects the energy margins of a row while the row runs. */
static bool margin_seen(const struct dom_fall *fall, void *context)
{
    double *const margin = context;
    /* the barrier is infinite if friction locks the domino */
    const double z = fall->barrier > 0 ? log(fall->kinetic / fall->barrier) : MARGIN_MOST;
    margin[fall->domino - 1] = fmin(fmax(z, MARGIN_LEAST), MARGIN_MOST);
    return true;
}

/*
 * A draw_visit. Draws random row i of s->tried, and finds its margins and the probability that it fails.
 * There are two margins for each domino:
 * - The first half are the energy margins of the dominoes: ln(kinetic energy / barrier).
 * - The others are the margins of reach: 1 - gap / (height of the domino before the gap).
 */
static enum dom_status row_fails(struct draw *draw, size_t i, void *context)
{
    const struct search *s = context;
    const size_t count = s->tried.count;
    double *const margin = s->margin + i * 2 * count, *const reach = margin + count, falls = 1;
    if (s->near && !(s->near[i] > SURE && s->near[i] < 1 - SURE)) {
        s->fails[i] = s->near[i];
        return DOM_OK;
    }
    draw_row(draw, &s->tried, &s->random, s->random.first + i);
    for (size_t k = 0; k < count; k++) {
        margin[k] = UNSEEN;
        reach[k] = k > 0 ? 1 - draw->domino[k].gap / draw->domino[k - 1].height : MARGIN_MOST;
    }
    static const struct run_options options = {.carries_on = true};
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    const enum dom_status status = row_run(&draw->row, &s->rough, &options, margin_seen, margin, &verdict);
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        return status;
    if (isnan(draw->row.push))
        margin[0] = UNSEEN;
    if (status != DOM_OK)
        margin[0] = MARGIN_NONE;
    else if (verdict.end != DOM_ROW_FALLS && verdict.end != DOM_ROW_STOPS && verdict.end != DOM_ROW_MISSES)
        margin[verdict.domino > 0 ? verdict.domino - 1 : 0] = MARGIN_NONE;
    for (size_t k = 0; k < 2 * count; k++)
        falls *= gsl_cdf_ugaussian_P(margin[k] / s->width[k]);
    s->fails[i] = 1 - falls;
    return DOM_OK;
}

/*
 * Runs the random rows of these dominoes, and returns the smoothed fraction that does not fall. Stores the
 * probability that each of them fails in `fails`. All rows have the same random errors, so that differences
 * of the results have no noise. After an error, s->status is not DOM_OK, and the result is 1.
 */
static double fails_find(struct search *s, const struct dom_domino *domino, const double *near, double *fails)
{
    double sum = 0;
    s->tried.domino = domino;
    s->near = near;
    s->fails = fails;
    if (s->status == DOM_OK)
        s->status = draw_run(&s->tried, &s->random, row_fails, s);
    for (size_t i = 0; i < s->random.rows && s->status == DOM_OK; i++)
        sum += fails[i];
    return s->status == DOM_OK ? sum / (double)s->random.rows : 1;
}

/*
 * Sets the width of the smoothing for each margin of the row in s->domino. The width is a multiple of the
 * standard deviation of the margin. Only small margins stop a row, so only the lower half of the distribution
 * matters. Hence the standard deviation is estimated from the median and a lower quantile.
 */
static void widths_set(struct search *s, double width)
{
    const size_t margins = 2 * s->tried.count, rows = s->random.rows = SCATTER_ROWS;
    (void)fails_find(s, s->domino, NULL, s->probability);
    for (size_t k = 0; k < margins && s->status == DOM_OK; k++) {
        double *const margin = s->margin + k;
        gsl_sort(margin, margins, rows);
        s->width[k] = gsl_stats_quantile_from_sorted_data(margin, margins, rows, 0.5) -
                      gsl_stats_quantile_from_sorted_data(margin, margins, rows, gsl_cdf_ugaussian_P(-1));
        s->width[k] = width * fmax(SCATTER_LEAST, s->width[k]);
    }
}

/* ---- The search ---- */

/*
 * Decides whether the row at x becomes the best row. First, the row is rounded to the grid. Then the rounded
 * row must be within the limits and must pass two tests:
 * - Its smoothed fraction of failures must be the smallest so far. If no row so far was within the limits,
 *   this test is omitted.
 * - In the study, it must fall more often than the original row. If the original row is outside the limits,
 *   this test is omitted.
 */
static void consider(struct search *s)
{
    struct dom_study study;
    if (!shape_dominoes(&s->shape, s->x, true, s->candidate) ||
        !shape_keeps(&s->shape, s->candidate, s->domino))
        return;
    const double fails = fails_find(s, s->candidate, NULL, s->probability);
    if (s->status != DOM_OK || !(fails < s->least || s->study[1].rows == 0))
        return;
    struct dom_row row = *s->shape.row;
    row.domino = s->candidate;
    const enum dom_status status = dom_placement_study(&row, s->compute, s->placement, &study, NULL);
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        s->status = status;
    if (status != DOM_OK || (s->given_allowed && study.fall <= s->study[0].fall))
        return;
    memcpy(s->best, s->candidate, s->shape.row->count * sizeof *s->best);
    s->least = fails;
    s->study[1] = study;
}

/* Moves each variable by this part of its step, against the sign of its slope. */
static void x_move(struct search *s, double part)
{
    for (size_t i = 0; i < s->variables; i++)
        s->x[i] -= part * s->step[i] * ((s->slope[i] > 0) - (s->slope[i] < 0));
}

/* Makes a step from the row at x to another row that fits into the hall. */
static void step_make(struct search *s)
{
    double *const near = s->probability, *const other = near + s->random.rows;
    (void)shape_dominoes(&s->shape, s->x, false, s->domino);
    const double value = fails_find(s, s->domino, NULL, near);
    for (size_t i = 0; i < s->variables && s->status == DOM_OK; i++) {
        const double at = s->x[i];
        s->x[i] += NEAR;
        (void)shape_dominoes(&s->shape, s->x, false, s->domino);
        s->x[i] = at;
        const double slope = fails_find(s, s->domino, near, other) - value, turn = slope * s->slope[i];
        s->step[i] = fmin(s->step[i] * (turn > 0 ? LONGER : turn < 0 ? SHORTER : 1), STEP_MOST);
        s->slope[i] = turn < 0 ? 0 : slope; /* where the sign has changed, the variable waits for a step */
    }
    x_move(s, 1);
    for (double part = 0.5; !shape_dominoes(&s->shape, s->x, false, s->domino) && part > DBL_EPSILON;
         part /= 2)
        x_move(s, -part);
}

static void level_run(struct search *s, const struct level *level)
{
    const size_t enough = 2 * s->placement->rows + 2;
    (void)shape_dominoes(&s->shape, s->x, false, s->domino);
    widths_set(s, level->width);
    s->random.rows = level->rows < enough ? level->rows : enough;
    s->least = fails_find(s, s->best, NULL, s->probability);
    if (s->study[1].rows == 0)
        consider(s);
    for (int i = 0; i < STEPS && s->status == DOM_OK; i++) {
        step_make(s);
        if (s->progress && s->status == DOM_OK)
            s->progress(s->done += level->rows, ROWS_ALL, s->context);
    }
    consider(s);
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
                       .tried = *row,
                       .rough = compute_or_default(compute),
                       .random = *placement,
                       .best = domino,
                       .study = study,
                       .progress = progress,
                       .context = context};
    study[0] = study[1] = (struct dom_study){.rows = 0};
    s.status = limits_check(limits);
    if (s.status == DOM_OK)
        s.status = dom_placement_study(row, compute, placement, &study[0], NULL);
    if (s.status != DOM_OK) {
        study[0].rows = 0;
        return s.status;
    }
    memcpy(domino, row->domino, n * sizeof *domino);
    s.rough.tol = MARGIN_TOL;
    s.rough.work = NULL;
    s.tried.engine = NULL;
    s.random.first += placement->rows;
    s.domino = malloc(2 * n * sizeof *s.domino);
    s.x = calloc(2 * (n * (4 + ROWS_MOST) + ROWS_MOST), sizeof *s.x);
    if (s.domino && s.x) {
        s.candidate = s.domino + n;
        s.step = s.x + 2 * n;
        s.slope = s.step + 2 * n;
        s.width = s.slope + 2 * n;
        s.margin = s.width + 2 * n;
        s.probability = s.margin + 2 * n * ROWS_MOST;
        s.given_allowed = shape_keeps(&s.shape, domino, s.candidate);
        study[1] = s.given_allowed ? study[0] : study[1];
        s.variables = n - 1 + sizes_of(&s.shape);
        for (size_t i = 0; i < s.variables; i++)
            s.step[i] = FIRST_STEP;
        for (size_t k = 0; k + 1 < n; k++)
            s.x[k] = log(fmax(domino[k + 1].gap / domino[k].height, LEAST));
        const bool is_needed = n > 1 && !(s.given_allowed && study[0].fall == study[0].rows);
        if (is_needed && !shape_dominoes(&s.shape, s.x, false, s.domino))
            s.status = DOM_BAD_HALL;
        for (int i = 0; i < LEVELS && is_needed && s.status == DOM_OK; i++)
            level_run(&s, &levels[i]);
    } else
        s.status = DOM_NO_MEMORY;
    free(s.x);
    free(s.domino);
    return s.status;
}
