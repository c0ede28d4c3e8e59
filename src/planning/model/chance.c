/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes the probability that a row does not fall. The same sample of random rows is used in every
 * computation. Each random row contributes a number between 0 and 1, which depends smoothly on its margins:
 * the probability that this random row does not fall. The mean of these numbers is the result.
 *
 * A first-order reliability index would be cheaper. It needs only the derivatives of the margins at the row
 * without errors. But a gap can be too narrow, and it can be too wide. Somewhere in between, the margin has a
 * maximum. At this maximum, the derivative is 0, as if errors of the gap did not matter. A search with this
 * index found a row that stopped in 54 % of all cases. With the function in this file, the search found a row
 * that stopped in 29 %.
 */
#include "planning/model/chance.h"
#include "chance/model/draw.h"
#include "entry/study.h"
#include "numerics/real.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
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

/* If a random row almost certainly falls, or almost certainly does not fall, its derivatives are nearly 0. So
 * no derivatives are computed if its probability of falling is below SURE or above 1 - SURE. */
#define SURE 1e-3

/* If one gap or size changes, the margins of all later dominoes change too. But the farther away a domino is,
 * the less its margin changes. So the run of a changed row ends at the first domino whose margin changes by
 * at most this fraction of the largest change so far. */
#define DECAYED 1e-3

/* Relative step of the difference quotients. The margins have errors of about 1e-7. */
#define CHANGE 1e-4

enum { BATCH = 16 }; /* random rows in a batch */

/* ---- The margins of one row ---- */

/* Collects the energy margins of a row while the row runs. */
struct run {
    double *margin;
    bool tips;          /* true if the first domino is tipped over its edge, and therefore has no margin */
    const double *base; /* the margins before the change, or NULL if nothing was changed */
    size_t from;        /* number of the first domino that the change affects, counted from 1 */
    double most;        /* the largest change in a margin so far */
};

static bool margin_seen(const struct dom_fall *fall, void *context)
{
    struct run *run = context;
    const size_t k = fall->domino - 1;
    double z = fall->barrier > 0 ? log(fall->kinetic / fall->barrier) : MARGIN_MOST;
    z = z > MARGIN_LEAST ? z : MARGIN_LEAST; /* the barrier is infinite if friction locks the domino */
    if (!(run->tips && k == 0))
        run->margin[k] = z < MARGIN_MOST ? z : MARGIN_MOST;
    if (!run->base || fall->domino < run->from)
        return true;
    const double change = run->margin[k] - run->base[k], by = change < 0 ? -change : change;
    run->most = by > run->most ? by : run->most;
    return fall->domino < run->from + 2 || by > DECAYED * run->most;
}

/*
 * Runs a row and finds the energy margin of each domino.
 *
 * If `base` is not NULL, the row has been changed. The array `base` holds the margins before the change. The
 * change affects no domino before number `from`. As soon as a later margin almost equals its value in `base`,
 * the effect of the change has died out, and the run ends.
 */
static enum dom_status energies_find(const struct chance *c, const struct dom_row *row, const double *base,
                                     size_t from, double *margin)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    struct run run = {.margin = margin, .tips = isnan(row->push), .base = base, .from = from};
    for (size_t k = 0; k < row->count; k++)
        margin[k] = base ? base[k] : UNSEEN;
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

struct totals {
    double fails, *by_gap, *by_size;
};

/* Data that all batches share. Each batch has its own sums. They are added in a fixed order at the end, so
 * that the timing of threads does not affect the result. */
struct shared {
    const struct chance *chance;
    struct dom_row row;
    struct totals *sums;
    double *margin; /* the margins of each row; NULL if not wanted */
    enum dom_status *status;
};

/* Arrays for one row: margins, margins after a change, and derivatives of P(the row falls) with respect to
 * the margins. */
struct weighed {
    double *margin, *changed, *weight;
};

/* Returns the probability that the row falls. It is a product with one factor for each margin. Writes the
 * derivatives of this probability, one for each margin, to w->weight. */
static double weigh(const struct chance *c, size_t margins, const struct weighed *w)
{
    double before = 1, after = 1;
    for (size_t k = 0; k < margins; k++) {
        const double x = w->margin[k] / c->width[k];
        w->weight[k] = before * gsl_ran_ugaussian_pdf(x) / c->width[k];
        before *= gsl_cdf_ugaussian_P(x);
    }
    for (size_t k = margins; k-- > 0;) {
        w->weight[k] *= after;
        after *= gsl_cdf_ugaussian_P(w->margin[k] / c->width[k]);
    }
    return before;
}

/* Returns the change in P(the row falls), to first order in the changes of the energy margins. */
static double change_of(const struct weighed *w, size_t count)
{
    double sum = 0;
    for (size_t k = 0; k < count; k++)
        if (w->margin[k] < UNSEEN && w->changed[k] < UNSEEN)
            sum += w->weight[k] * (w->changed[k] - w->margin[k]);
    return sum;
}

/* Adds the derivatives for one random row to the sums. */
static enum dom_status slopes_add(const struct chance *c, struct draw *draw, const struct weighed *w,
                                  struct totals *sums)
{
    const size_t count = draw->row.count;
    const struct dom_limits *limits = c->shape->limits;
    enum dom_status status = DOM_OK;
    for (size_t k = 1; k < count; k++) {
        const double height = draw->domino[k - 1].height;
        sums->by_gap[k] += w->weight[count + k] / height;
        sums->by_size[k - 1] -= w->weight[count + k] * draw->domino[k].gap / height;
    }
    for (size_t k = 1; k < count && w->margin[k] < UNSEEN && status == DOM_OK; k++) {
        struct dom_domino *d = &draw->domino[k], before = *d;
        const double step = CHANGE * d[-1].height;
        d->gap += step;
        status = energies_find(c, &draw->row, w->margin, k, w->changed);
        sums->by_gap[k] -= change_of(w, count) / step;
        *d = before;
        if (status != DOM_OK || !limits->sizes || k + 1 == count)
            continue;
        shape_resize(c->shape, d, d->height * (1 + CHANGE),
                     d->thickness * (shape_from_board(c->shape, d->height) ? 1 : 1 + CHANGE));
        status = energies_find(c, &draw->row, w->margin, k, w->changed);
        sums->by_size[k] -= change_of(w, count) / CHANGE;
        *d = before;
    }
    return status;
}

static enum dom_status row_add(struct shared *s, struct draw *draw, size_t i, const struct weighed *w,
                               struct totals *sums)
{
    const struct chance *c = s->chance;
    const size_t count = s->row.count;
    draw_row(draw, &s->row, &c->placement, c->placement.first + i, 0);
    enum dom_status status = energies_find(c, &draw->row, NULL, 0, w->margin);
    reaches_find(&draw->row, w->margin + count);
    if (s->margin)
        memcpy(s->margin + 2 * count * i, w->margin, 2 * count * sizeof *w->margin);
    if (s->margin || status != DOM_OK)
        return status;
    const double falls = weigh(c, 2 * count, w);
    sums->fails += 1 - falls;
    if (sums->by_gap && falls > SURE && falls < 1 - SURE)
        status = slopes_add(c, draw, w, sums);
    return status;
}

/* A dom_task that runs batch number `index` of the random rows. */
static void batch_run(size_t index, void *context)
{
    struct shared *s = context;
    const size_t rows = s->chance->placement.rows, margins = 2 * s->row.count;
    struct draw draw;
    double *memory = malloc(3 * margins * sizeof *memory);
    enum dom_status status = draw_begin(&draw, &s->row);
    if (!memory) {
        status = DOM_NO_MEMORY;
    } else {
        const struct weighed w = {memory, memory + margins, memory + 2 * margins};
        for (size_t i = index * BATCH; i < rows && i < (index + 1) * BATCH && status == DOM_OK; i++)
            status = row_add(s, &draw, i, &w, &s->sums[index]);
    }
    draw_end(&draw);
    free(memory);
    s->status[index] = status;
}

static enum dom_status batches_run(struct shared *s, size_t batches)
{
    const struct dom_placement *p = &s->chance->placement;
    enum dom_status status = DOM_OK;
    for (size_t i = 0; i < batches; i++)
        s->status[i] = DOM_INTERRUPTED; /* batch_run replaces this status */
    if (p->parallel)
        status = p->parallel(batches, batch_run, s, p->pool);
    for (size_t i = 0; i < batches && !p->parallel; i++)
        batch_run(i, s);
    for (size_t i = 0; i < batches && status == DOM_OK; i++)
        status = s->status[i];
    return status;
}

/* Runs all random rows. If `margin` is not NULL, only writes the margins of each random row to this array. If
 * `margin` is NULL, computes for each random row the probability that it does not fall, and adds all these
 * probabilities to total->fails. If total->by_gap is not NULL, also adds their derivatives to total->by_gap
 * and total->by_size. */
static enum dom_status chance_run(const struct chance *c, const struct dom_domino *domino, double *margin,
                                  struct totals *total)
{
    const size_t count = c->shape->row->count, batches = (c->placement.rows + BATCH - 1) / BATCH,
                 slopes = total->by_gap ? 2 * count : 0;
    struct shared s = {.chance = c, .row = *c->shape->row, .margin = margin};
    s.row.domino = domino;
    s.row.engine = NULL;
    s.sums = calloc(batches, sizeof *s.sums);
    s.status = calloc(batches, sizeof *s.status);
    double *slope = slopes ? calloc(batches * slopes, sizeof *slope) : NULL;
    enum dom_status status = s.sums && s.status && (slope || !slopes) ? DOM_OK : DOM_NO_MEMORY;
    for (size_t i = 0; slope && status == DOM_OK && i < batches; i++) {
        s.sums[i].by_gap = slope + i * slopes;
        s.sums[i].by_size = s.sums[i].by_gap + count;
    }
    if (status == DOM_OK)
        status = batches_run(&s, batches);
    for (size_t i = 0; i < batches && status == DOM_OK; i++) {
        total->fails += s.sums[i].fails;
        for (size_t k = 0; slope && k < count; k++) {
            total->by_gap[k] += s.sums[i].by_gap[k];
            total->by_size[k] += s.sums[i].by_size[k];
        }
    }
    free(slope);
    free(s.status);
    free(s.sums);
    return status;
}

enum dom_status chance_find(const struct chance *c, const struct dom_domino *domino, double *fails,
                            double *by_gap, double *by_size)
{
    const size_t count = c->shape->row->count;
    const double rows = (double)c->placement.rows;
    struct totals total = {0, by_gap, by_size};
    for (size_t k = 0; by_gap && k < count; k++)
        by_gap[k] = by_size[k] = 0;
    const enum dom_status status = chance_run(c, domino, NULL, &total);
    *fails = total.fails / rows;
    for (size_t k = 0; by_gap && k < count; k++) {
        by_gap[k] /= rows;
        by_size[k] /= rows;
    }
    return status;
}

enum dom_status chance_margins(const struct chance *c, const struct dom_domino *domino, double *margin)
{
    struct totals none = {0, NULL, NULL};
    return chance_run(c, domino, margin, &none);
}
