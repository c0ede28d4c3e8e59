/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers the hits of a sound. A recording has the times of hits, but not the dominoes, and may lack some
 * hits. */
#include "fit/fit.h"
#include "language/names.h"
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

/* Returns when the row of the session hits a domino, or NaN if it does not. */
static double time_of(const struct row_run *row, size_t domino)
{
    const size_t i = domino - row->fall[0].domino;
    return i < row->hits ? (double)row->fall[i].time : (double)NAN;
}

/* Returns the median ratio of the measured intervals near hit k to those of the row. The session is not quite
 * right, so this ratio is found anew for each hit. The median hardly changes if a few of these hits are
 * missing. The hits before hit k must have numbers. */
static double scale_find(const struct row_run *row, const struct fit_point *point, size_t count, size_t k)
{
    enum { BEFORE = 3, AFTER = 5 };
    double ratio[BEFORE + AFTER];
    size_t n = 0;
    for (size_t i = k > BEFORE ? k - BEFORE : 1; i < count && i < k + AFTER; i++) {
        const size_t from = i <= k ? point[i - 1].domino : point[k - 1].domino + (i - k),
                     to = i < k ? point[i].domino : from + 1;
        const double interval = time_of(row, to) - time_of(row, from);
        if (interval > 0)
            ratio[n++] = (point[i].measured - point[i - 1].measured) / interval;
    }
    gsl_sort(ratio, 1, n);
    return n > 0 ? gsl_stats_median_from_sorted_data(ratio, 1, n) : (double)NAN;
}

/* Numbers hit k of a run, which comes after that of domino d: it is the hit of the row that is near the
 * measured time, within a quarter of the interval that ends with this hit of the row. */
static bool hit_number(const struct fit *f, const struct row_run *row, const struct fit_run *run, size_t k,
                       struct problem *problem)
{
    const double near = 0.25;
    struct fit_point *point = &f->data.point[run->first], *hit = &point[k];
    const size_t d = hit[-1].domino, last = row->hits > 0 ? row->fall[row->hits - 1].domino : 0;
    const double interval = hit->measured - hit[-1].measured, scale = scale_find(row, point, run->count, k);
    const char *shown = names_shown(f->query->given->word[1]);
    for (size_t to = d + 1; to <= last && hit->domino == 0; to++) {
        const double away = scale * (time_of(row, to) - time_of(row, d)) - interval,
                     step = scale * (time_of(row, to) - time_of(row, to - 1));
        if (fabs(away) <= near * step)
            hit->domino = to;
        else if (away > near * step)
            return problem_no_answer(
                problem,
                "%s:%ld: the hit %s after that of domino %zu cannot be numbered: the next one is due after "
                "about %s; if it is an echo, delete the line, and otherwise give numbers in a column "
                "'domino'%s",
                shown, hit->line, measured((domq_real)interval, "s", 3).text, d,
                measured((domq_real)(scale * (time_of(row, d + 1) - time_of(row, d))), "s", 3).text,
                f->query->scene->effect[DOM_EFFECT_push].on ? "" : ", or 'set push' if the row was pushed");
    }
    if (hit->domino == 0 && row->verdict.end != DOM_ROW_FALLS)
        return problem_no_answer(
            problem,
            "%s:%ld: this hit would be that of domino %zu or a later one, but in the scene the fall ends at "
            "domino %zu: 'fall' shows why; if the row was pushed, 'set push' to about its speed",
            shown, hit->line, last + 1, last);
    if (hit->domino == 0)
        return problem_no_answer(
            problem,
            "%s:%ld: this hit would be that of domino %zu or a later one, but the row has only %zu "
            "dominoes; enter a longer row, for example 'set row %zu'",
            shown, hit->line, last + 1, last, 2 * last);
    return hit->domino > d ||
           problem_no_answer(problem, "%s:%ld: domino %zu comes after domino %zu, which the line before has",
                             shown, hit->line, hit->domino, d);
}

bool fit_number(struct fit *f, struct problem *problem)
{
    const struct scene *scene = f->query->scene;
    bool good = true;
    for (size_t i = 0; i < f->data.runs && f->data.kind == FIT_HITS && good; i++) {
        const struct fit_run *run = &f->data.run[i];
        struct fit_point *point = &f->data.point[run->first];
        size_t numbered = 0, highest = 0;
        for (size_t k = 0; k < run->count; k++) {
            numbered += point[k].domino > 0;
            highest = point[k].domino > 0 ? point[k].domino : highest;
        }
        if (numbered == run->count)
            continue;
        point->domino = point->domino > 0 ? point->domino : 2; /* domino 1 hits domino 2 */
        /* If there are as many hits as in the row of the session, none is missing. */
        if (numbered == 0 && scene->effect[DOM_EFFECT_row].on && run->count + 1 == scene_row_count(scene)) {
            for (size_t k = 1; k < run->count; k++)
                point[k].domino = k + 2;
            continue;
        }
        /* If the session has no row, there is room for as many missing hits as there are hits. */
        struct row_run row;
        if (!fit_row(f, NULL, run, highest + 2 * run->count + 2, &row)) {
            *problem = f->problem;
            return false;
        }
        for (size_t k = 1; k < run->count && good; k++)
            good = hit_number(f, &row, run, k, problem);
        row_run_free(&row);
    }
    return good;
}
