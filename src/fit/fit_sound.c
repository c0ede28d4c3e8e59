/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers the hits of a sound. A recording has the times of hits, but not the dominoes, and may lack some
 * hits. */
#include "fit/fit.h"
#include "language/names.h"
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <stdlib.h>

/* The model's times of hits with the parameters of the session, from time[1] to time[count]. The intervals
 * between the hits of a sound are `scale` times those of the model. The session is not quite right, so
 * `scale` is found anew for each hit. */
struct sound {
    const double *time;
    size_t count;
    double scale;
};

/* Returns the median ratio of the measured intervals near hit k to those of the model. The median hardly
 * changes if a few of these hits are missing. The hits before hit k must have numbers. */
static double scale_find(const struct sound *s, const struct fit_point *point, size_t count, size_t k)
{
    enum { BEFORE = 3, AFTER = 5 };
    double ratio[BEFORE + AFTER];
    size_t n = 0;
    for (size_t i = k > BEFORE ? k - BEFORE : 1; i < count && i < k + AFTER; i++) {
        const size_t from = i <= k ? point[i - 1].domino : point[k - 1].domino + (i - k),
                     to = i < k ? point[i].domino : from + 1;
        if (to <= s->count && s->time[to] > s->time[from])
            ratio[n++] = (point[i].measured - point[i - 1].measured) / (s->time[to] - s->time[from]);
    }
    gsl_sort(ratio, 1, n);
    return n > 0 ? gsl_stats_median_from_sorted_data(ratio, 1, n) : (double)NAN;
}

/* Finds the domino that is hit `interval` seconds after domino d. Returns 0 if no hit of the model is near
 * this time, within a quarter of the interval that ends with this hit. */
static size_t domino_find(const struct sound *s, size_t d, double interval)
{
    const double near = 0.25;
    for (size_t to = d + 1; to <= s->count; to++) {
        const double away = s->scale * (s->time[to] - s->time[d]) - interval,
                     step = s->scale * (s->time[to] - s->time[to - 1]);
        if (fabs(away) <= near * step)
            return to;
        if (away > near * step)
            return 0;
    }
    return 0;
}

/* Reports that a hit cannot be numbered. */
static bool hit_unclear(const struct fit *f, const struct sound *s, size_t d, const struct fit_point *point,
                        bool is_beyond, struct problem *problem)
{
    const char *shown = names_shown(f->query->given->word[1]);
    if (is_beyond)
        return problem_no_answer(
            problem,
            "%s:%ld: this hit would be that of domino %zu or a later one, but the row has only %zu "
            "dominoes that are hit; enter a longer row, for example 'set row %zu'",
            shown, point->line, s->count + 1, s->count, 2 * s->count);
    return problem_no_answer(
        problem,
        "%s:%ld: the hit %s after that of domino %zu cannot be numbered: the next one is due after about "
        "%s; if it is an echo, delete the line, and otherwise give numbers in a column 'domino'%s",
        shown, point->line, measured((domq_real)(point->measured - point[-1].measured), "s", 3).text, d,
        measured((domq_real)(s->scale * (s->time[d + 1] - s->time[d])), "s", 3).text,
        f->query->scene->effect[DOM_EFFECT_push].on ? "" : ", or 'set push' if the row was pushed");
}

/* Numbers the hits of a run. Without a number, the first hit is that of domino 2, which domino 1 hits. */
static bool run_number(struct fit *f, struct fit_run *run, struct sound *s, struct problem *problem)
{
    struct fit_point *point = &f->data.point[run->first];
    point->domino = point->domino > 0 ? point->domino : 2;
    for (size_t k = 1; k < run->count; k++) {
        const size_t d = point[k - 1].domino;
        const double interval = point[k].measured - point[k - 1].measured;
        s->scale = scale_find(s, point, run->count, k);
        if (point[k].domino == 0 && d >= s->count)
            return hit_unclear(f, s, d, &point[k], true, problem);
        if (point[k].domino == 0 && (point[k].domino = domino_find(s, d, interval)) == 0)
            return hit_unclear(f, s, d, &point[k], s->scale * (s->time[s->count] - s->time[d]) < interval,
                               problem);
        if (point[k].domino <= d)
            return problem_no_answer(
                problem, "%s:%ld: domino %zu comes after domino %zu, which the line before has",
                names_shown(f->query->given->word[1]), point[k].line, point[k].domino, d);
    }
    run->dominoes = point[run->count - 1].domino;
    return true;
}

/* Returns true if no hit has a number, and there are as many as in the row of the session, so that none is
 * missing. */
static bool is_whole(const struct fit *f, const struct fit_run *run)
{
    const struct scene *scene = f->query->scene;
    bool whole = scene->effect[DOM_EFFECT_row].on && run->count + 1 == scene_row_count(scene);
    for (size_t k = run->first; k < run->first + run->count; k++)
        whole = whole && f->data.point[k].domino == 0;
    return whole;
}

bool fit_number(struct fit *f, struct problem *problem)
{
    bool done = true;
    for (size_t i = 0; i < f->data.runs && f->data.kind == FIT_HITS && done; i++) {
        struct fit_run *run = &f->data.run[i];
        bool numbered = true;
        for (size_t k = run->first; k < run->first + run->count; k++)
            numbered = numbered && f->data.point[k].domino > 0;
        if (numbered)
            continue;
        if (is_whole(f, run)) {
            for (size_t k = 0; k < run->count; k++)
                f->data.point[run->first + k].domino = k + 2;
            run->dominoes = run->count + 1;
            continue;
        }
        double *time;
        /* If the session has no row, there is room for as many missing hits as there are hits. */
        run->dominoes = run->dominoes + 2 * run->count + 2;
        struct sound s = {.count = run->dominoes};
        done = fit_hits(f, run, &time, &s.count);
        s.time = time;
        if (!done)
            *problem = f->problem;
        done = done && run_number(f, run, &s, problem);
        free(time);
    }
    return done;
}
