/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/drawing/falling_row.h"
#include "commands/rows/falling.h"
#include "commands/rows/slid.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

static bool domino_falls(const struct domq_fall *fall, void *context)
{
    struct falling_row *row = context;
    size_t k = fall->domino - 1;
    row->hit[k] = (double)fall->time;
    row->share[k] = (double)fall_share(fall);
    return true;
}

static bool end_seen(const struct domq_moment *moment, void *context)
{
    *(double *)context = (double)moment->time;
    return true;
}

static void row_place(struct falling_row *row)
{
    double at = 0;
    row->smallest = HUGE_VAL;
    row->tallest = 0;
    for (size_t k = 0; k < row->count; k++) {
        const struct domq_domino *d = &row->scene.domino[k];
        double height = (double)d->height;
        at += k > 0 ? (double)d->gap : 0;
        row->at[k] = at;
        at += (double)d->thickness;
        row->hit[k] = row->share[k] = (double)NAN;
        row->smallest = height < row->smallest ? height : row->smallest;
        row->tallest = height > row->tallest ? height : row->tallest;
    }
}

bool falling_row_make(const struct query *query, struct problem *problem, struct falling_row *row)
{
    const domq_real ever = (domq_real)HUGE_VAL;
    *row = (struct falling_row){.end = (double)NAN};
    if (!scene_row_make(query->scene, &row->scene, problem))
        return false;
    row->count = row->scene.row.count;
    row->tipped = isnan(row->scene.row.push);
    row->scene.row.floor = false; /* no picture shows it */
    row->at = calloc(4 * row->count, sizeof *row->at);
    if (!row->at || !report_begin(query, problem, &row->scene)) {
        falling_row_free(row);
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    }
    row->hit = row->at + row->count;
    row->share = row->hit + row->count;
    row->slid = row->share + row->count;
    row_place(row);
    enum dom_status status =
        domq_row_run(&row->scene.row, &row->scene.compute, true, domino_falls, row, &row->verdict);
    if (status == DOM_OK)
        status = falling_row_watch(row, &ever, 1, end_seen, &row->end);
    if (status == DOM_NO_MARGIN) /* it falls all the same */
        status = DOM_OK;
    if (status == DOM_OK)
        return true;
    falling_row_free(row);
    return row_status(query, problem, status);
}

void falling_row_free(struct falling_row *row)
{
    report_end(&row->scene);
    free(row->scene.domino);
    free(row->at);
}

double falling_row_begins(const struct falling_row *row)
{
    const struct domq_domino *d = &row->scene.domino[0];
    domq_real flat = d->thickness / d->height;
    /* The angle beyond the edge grows e times in each of these. */
    domq_real each = quad(sqrt)(2 * d->height / (3 * row->scene.row.g) * quad(sqrt)(1 + flat * flat));
    return row->tipped ? -3 * (double)each : 0;
}

enum dom_status falling_row_watch(const struct falling_row *row, const domq_real *times, size_t count,
                                  domq_moment_visit *visit, void *context)
{
    struct domq_verdict verdict;
    if (row->scene.row.engine)
        return scene_engine_watch(&row->scene.row, &row->scene.compute, times, count, visit, context,
                                  row->slid);
    return domq_row_watch(&row->scene.row, &row->scene.compute, times, count, visit, context, &verdict);
}

double falling_row_lean(const struct falling_row *row, size_t k)
{
    return (double)row->scene.domino[k].lean;
}

struct drawn falling_row_domino(const struct falling_row *row, size_t k, double tilt)
{
    const struct domq_domino *d = &row->scene.domino[k];
    double height = (double)d->height, thickness = (double)d->thickness;
    double rho = (double)row->scene.row.rho,
           radius = rho != 0 && d->radius > 0 ? (double)d->radius : rho * height;
    return drawn_at((int)k + 1, height, row->at[k] + row->slid[k] + thickness, tilt, thickness / height,
                    radius);
}

bool row_ends_at(const struct falling_row *row, size_t k)
{
    return row->verdict.end != DOM_ROW_FALLS && k + 1 == row->verdict.domino;
}

bool row_weakest_is(const struct falling_row *row, size_t k)
{
    return row->count > 1 && k + 1 == row->verdict.weakest && isfinite(row->verdict.spare);
}

double row_step(double least)
{
    double ten = (double)quad(pow)(10, quad(floor)(quad(log10)((domq_real)least)));
    return least <= ten ? ten : least <= 2 * ten ? 2 * ten : least <= 5 * ten ? 5 * ten : 10 * ten;
}

/* ---- In words ---- */

void falling_row_summary(const struct falling_row *row, char text[ROW_SENTENCE])
{
    struct measured least = measured((domq_real)row->smallest, "m", 3),
                    most = measured((domq_real)row->tallest, "m", 3);
    bool alike = strcmp(least.text, most.text) == 0;
    snprintf(text, ROW_SENTENCE, "%zu domino%s, %s%s%s tall", row->count, row->count == 1 ? "" : "es",
             least.text, alike ? "" : " to ", alike ? "" : most.text);
}

void falling_row_verdict(const struct falling_row *row, const char *mark, char text[ROW_SENTENCE])
{
    size_t end = row->verdict.domino;
    if (row->verdict.end == DOM_ROW_FALLS && isfinite(row->end) && row->count > 1)
        snprintf(text, ROW_SENTENCE, "%.40s: the last lies %.40s after the %s.",
                 all_fall_words(row->count).text, measured((domq_real)row->end, "s", 3).text,
                 row->tipped ? "first hit" : "push");
    else if (row->verdict.end == DOM_ROW_FALLS)
        snprintf(text, ROW_SENTENCE, "%.40s.", all_fall_words(row->count).text);
    else if (row->verdict.end == DOM_ROW_STOPS && row->share[end - 1] < 1)
        snprintf(text, ROW_SENTENCE, "Domino %zu (%s) stops the row: it has %s.", end, mark,
                 energy_words((domq_real)row->share[end - 1]).text);
    else
        snprintf(text, ROW_SENTENCE, "The row ends at domino %zu (%s): %s.", end, mark,
                 dom_row_end_text(row->verdict.end));
}

void falling_row_weakest(const struct falling_row *row, const char *mark, char text[ROW_SENTENCE])
{
    text[0] = '\0';
    if (row->verdict.weakest > 0 && row_weakest_is(row, row->verdict.weakest - 1))
        snprintf(text, ROW_SENTENCE, "Weakest%s: domino %zu (%s), with %s.",
                 row->verdict.end == DOM_ROW_FALLS ? "" : " of those that fall", row->verdict.weakest, mark,
                 energy_words(row->verdict.spare + 1).text);
}

void falling_row_moment(const struct falling_row *row, size_t head, double time, char text[ROW_SENTENCE])
{
    size_t after = row->count - head;
    bool over = time >= row->end;
    int at = snprintf(text, ROW_SENTENCE, "%.3f s after the %s: ", time, row->tipped ? "first hit" : "push");
    if (time < 0)
        at = snprintf(text, ROW_SENTENCE, "%.3f s before the first hit: ", -time);
    if (over && row->verdict.end == DOM_ROW_FALLS)
        snprintf(text + at, ROW_SENTENCE - (size_t)at, row->count > 1 ? "all lie." : "it lies.");
    else if (over)
        snprintf(text + at, ROW_SENTENCE - (size_t)at, "the row has ended at domino %zu, %zu still stand%s.",
                 head, after, after == 1 ? "s" : "");
    else if (after == 0)
        snprintf(text + at, ROW_SENTENCE - (size_t)at, "domino %zu, the last, falls.", head);
    else
        snprintf(text + at, ROW_SENTENCE - (size_t)at, "domino %zu falls, %zu still stand%s.", head, after,
                 after == 1 ? "s" : "");
}
