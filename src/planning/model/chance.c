/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes the probability that a row does not fall. The same sample of random rows is used in every
 * computation. Each random row contributes a number between 0 and 1, which depends smoothly on its margins:
 * the probability that this random row does not fall. The mean of these numbers is the result.
 *
 * A first-order reliability index would be cheaper: it needs only the derivatives of the margins at the row
 * without errors. But somewhere between a gap that is too narrow and one that is too wide, the margin has a
 * maximum, and there errors of the gap would seem not to matter.
 */
#include "planning/model/chance.h"
#include "chance/model/draw.h"
#include "entry/study.h"
#include "numerics/real.h"
#include <gsl/gsl_cdf.h>
#include <stdlib.h>
#include <string.h>

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

enum { BATCH = 16 }; /* random rows in a batch */

/* ---- The margins of one row ---- */

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

/* Runs a row and finds the energy margin of each domino. */
static enum dom_status energies_find(const struct chance *c, const struct dom_row *row, double *margin)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    struct run run = {.margin = margin, .tips = isnan(row->push)};
    for (size_t k = 0; k < row->count; k++)
        margin[k] = UNSEEN;
    const enum dom_status status = row_run_on(row, &c->compute, margin_seen, &run, &verdict);
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        return status;
    if (status != DOM_OK)
        margin[0] = MARGIN_NONE;
    else if (verdict.end != DOM_ROW_FALLS && verdict.end != DOM_ROW_STOPS && verdict.end != DOM_ROW_MISSES)
        margin[verdict.domino > 0 ? verdict.domino - 1 : 0] = MARGIN_NONE;
    return DOM_OK;
}

static void reaches_find(const struct dom_row *row, double *margin)
{
    margin[0] = MARGIN_MOST;
    for (size_t k = 1; k < row->count; k++)
        margin[k] = 1 - row->domino[k].gap / row->domino[k - 1].height;
}

/* ---- Sums over rows ---- */

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

/* Draws random row i of row number k, and finds its margins. */
static enum dom_status margins_find(const struct shared *s, struct draw *draw, size_t k, size_t i,
                                    double *margin)
{
    struct dom_row row = *s->chance->shape->row;
    row.domino = s->domino + k * row.count;
    row.engine = NULL;
    draw_row(draw, &row, &s->chance->placement, s->chance->placement.first + i, 0);
    reaches_find(&draw->row, margin + row.count);
    return energies_find(s->chance, &draw->row, margin);
}

/* Returns the probability that a row with these margins does not fall. */
static double fails_of(const struct chance *c, size_t margins, const double *margin)
{
    double falls = 1;
    for (size_t k = 0; k < margins; k++)
        falls *= gsl_cdf_ugaussian_P(margin[k] / c->width[k]);
    return 1 - falls;
}

/* Adds random row i of each row to the sums, or only writes its margins. */
static enum dom_status row_add(const struct shared *s, struct draw *draw, size_t i, double *margin,
                               double *sums)
{
    const size_t margins = 2 * s->chance->shape->row->count;
    if (s->margin)
        return margins_find(s, draw, 0, i, s->margin + margins * i);
    enum dom_status status = margins_find(s, draw, 0, i, margin);
    double fails = fails_of(s->chance, margins, margin);
    const bool is_sure = !(fails > SURE && fails < 1 - SURE);
    sums[0] += fails;
    for (size_t k = 1; k < s->rows && status == DOM_OK; k++) {
        if (!is_sure) {
            status = margins_find(s, draw, k, i, margin);
            fails = fails_of(s->chance, margins, margin);
        }
        sums[k] += fails;
    }
    return status;
}

/* A dom_task that runs batch number `index` of the random rows. */
static void batch_run(size_t index, void *context)
{
    struct shared *s = context;
    const size_t rows = s->chance->placement.rows, margins = 2 * s->chance->shape->row->count;
    struct draw draw;
    double *margin = malloc(margins * sizeof *margin);
    enum dom_status status = draw_begin(&draw, s->chance->shape->row);
    if (!margin)
        status = DOM_NO_MEMORY;
    for (size_t i = index * BATCH; i < rows && i < (index + 1) * BATCH && status == DOM_OK; i++)
        status = row_add(s, &draw, i, margin, s->sums + index * s->rows);
    draw_end(&draw);
    free(margin);
    s->status[index] = status;
}

/* Runs all random rows. */
static enum dom_status chance_run(struct shared *s, double *fails)
{
    const struct dom_placement *p = &s->chance->placement;
    const size_t batches = (p->rows + BATCH - 1) / BATCH;
    s->sums = calloc(batches * s->rows, sizeof *s->sums);
    s->status = calloc(batches, sizeof *s->status);
    enum dom_status status = s->sums && s->status ? DOM_OK : DOM_NO_MEMORY;
    for (size_t i = 0; i < batches && status == DOM_OK; i++)
        s->status[i] = DOM_INTERRUPTED; /* batch_run replaces this status */
    if (status == DOM_OK && p->parallel)
        status = p->parallel(batches, batch_run, s, p->pool);
    for (size_t i = 0; i < batches && status == DOM_OK; i++) {
        if (!p->parallel)
            batch_run(i, s);
        status = s->status[i];
    }
    for (size_t k = 0; k < s->rows && fails && status == DOM_OK; k++) {
        fails[k] = 0;
        for (size_t i = 0; i < batches; i++)
            fails[k] += s->sums[i * s->rows + k] / (double)p->rows;
    }
    free(s->status);
    free(s->sums);
    return status;
}

enum dom_status chance_find(const struct chance *c, const struct dom_domino *domino, size_t rows,
                            double *fails)
{
    struct shared s = {.chance = c, .domino = domino, .rows = rows};
    return chance_run(&s, fails);
}

enum dom_status chance_margins(const struct chance *c, const struct dom_domino *domino, double *margin)
{
    struct shared s = {.chance = c, .domino = domino, .rows = 1, .margin = margin};
    return chance_run(&s, NULL);
}
