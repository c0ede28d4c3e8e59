/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the model's result for each measurement of 'fit'. */
#include "fit/fit.h"
#include "language/names.h"
#include "train/falling.h"
#include <stdlib.h>

/* A copy of the session's state with trial values of the unknowns, and a query about it. */
struct trial {
    struct state state;
    struct query query;
};

/* Makes a scene with these values of the unknowns; if `value` is NULL, they keep the values of the session.
 * The scene has a row of `dominoes` dominoes, or that of the session if `dominoes` is 0. Their gap is that of
 * the session if `gap` is NaN. If the measurements are those of rows, all dominoes are equal. */
static bool trial_make(struct fit *f, const double *value, size_t dominoes, double gap, struct trial *t)
{
    struct assigned assigned[FIT_UNKNOWNS + 3];
    int count = 0;
    problem_begin(&f->problem, "fit");
    if (fit_has_rows(&f->data))
        assigned[count++] = (struct assigned){.parameter = parameter_find("r"), .value = 1};
    if (dominoes > 0 && !parameter_find("row"))
        return problem_error(&f->problem,
                             "times of rows need 'rows', which this build of the program leaves out");
    if (dominoes > 0)
        assigned[count++] =
            (struct assigned){.parameter = parameter_find("row"), .value = (domq_real)dominoes};
    if (!isnan(gap))
        assigned[count++] =
            (struct assigned){.parameter = parameter_find("s"), .length = {.m = (domq_real)gap}};
    for (int i = 0; i < f->unknowns && value; i++)
        assigned[count++] =
            (struct assigned){.parameter = f->unknown[i].parameter, .value = (domq_real)value[i]};
    return query_with(f->query, assigned, count, &t->state, &t->query, &f->problem);
}

/* Makes the scene of a run, whose row is that of the session or, if there is none, as long as the run. */
static bool run_trial(struct fit *f, const double *value, const struct fit_run *run, struct trial *t)
{
    const bool has_row = f->query->scene->effect[DOM_EFFECT_row].on;
    return trial_make(f, value, has_row ? 0 : run->dominoes + 1, run->gap, t);
}

/* ---- Speeds and total times ---- */

static bool speeds_compute(struct fit *f, const double *value, double *computed)
{
    struct trial t;
    if (!trial_make(f, value, 0, (double)NAN, &t))
        return false;
    struct domq_train train = t.query.scene->train;
    for (size_t k = 0; k < f->data.points; k++) {
        domq_real duration;
        train.s = (domq_real)f->data.point[k].gap / t.query.scene->scale.h;
        enum dom_status status = any_cycle_duration(&train, &t.query.scene->compute, &duration);
        if (status != DOM_OK)
            return problem_status(&f->problem, t.query.scene, status);
        computed[k] = (double)domq_scale_speed(&t.query.scene->scale, &train, duration);
    }
    return true;
}

/* Returns advice for a row that fell, but does not fall in the scene. */
static const char *push_advice(const struct fit *f, char text[192])
{
    bool is_fitted = false;
    char names[64] = "";
    for (int i = 0; i < f->unknowns; i++) {
        is_fitted = is_fitted || strcmp(f->unknown[i].parameter->name, "push") == 0;
        text_add(names, sizeof names, "%.24s, ", f->unknown[i].parameter->name);
    }
    if (!f->query->scene->effect[DOM_EFFECT_push].on)
        snprintf(text, 192, "if the row was pushed, enter 'set push'%s",
                 is_fitted ? "" : ", or fit push as well");
    else if (is_fitted)
        snprintf(text, 192, "the push may be too weak to begin with; enter a larger one with 'set push'");
    else
        snprintf(text, 192, "the push may be too weak; enter a larger one with 'set push', or 'fit %spush'",
                 names);
    return text;
}

/* Fills in how long each row takes to fall, as 'verdict' says. */
static bool totals_compute(struct fit *f, const double *value, double *computed)
{
    struct trial t;
    struct row_run row;
    for (size_t k = 0; k < f->data.points; k++) {
        const struct fit_point *p = &f->data.point[k];
        if (!trial_make(f, value, p->domino, p->gap, &t) || !row_run(&t.query, &f->problem, true, &row))
            return false;
        const struct domq_verdict verdict = row.verdict;
        row_run_free(&row);
        if (verdict.end != DOM_ROW_FALLS || !isfinite((double)verdict.seconds))
            return problem_no_answer(&f->problem,
                                     "%s:%ld: %zu dominoes with gaps of %s fell in %g s, but in the scene "
                                     "the fall ends at domino %zu; %s",
                                     names_shown(f->query->given->word[1]), p->line, p->domino,
                                     measured((domq_real)p->gap, "m", 4).text, p->measured, verdict.domino,
                                     push_advice(f, (char[192]){""}));
        computed[k] = (double)verdict.seconds;
    }
    return true;
}

/* ---- Rows ---- */

/* Checks that no measured domino comes after domino number `last`, the last one that the model has a result
 * for. If the check fails, `falls` tells why: if it is true, the row ends at `last`; if it is false, the row
 * is longer, but the fall ends there. */
static bool row_long_enough(struct fit *f, const struct fit_run *run, size_t last, bool falls)
{
    if (last >= run->dominoes)
        return true;
    if (falls)
        return problem_no_answer(
            &f->problem,
            "domino %zu was measured in run %g, but the row has only %zu dominoes; enter a longer "
            "row, for example 'set row %zu'",
            run->dominoes, run->number, last, run->dominoes);
    return problem_no_answer(
        &f->problem,
        "domino %zu was measured in run %g, but in the scene the fall ends at domino %zu: 'fall' "
        "shows why; %s",
        run->dominoes, run->number, last, push_advice(f, (char[192]){""}));
}

static bool hits_compute(struct fit *f, const double *value, const struct fit_run *run, double *computed)
{
    struct trial t;
    struct row_run row;
    if (!run_trial(f, value, run, &t) || !row_run(&t.query, &f->problem, true, &row))
        return false;
    size_t i = 0;
    bool done = true;
    for (size_t k = run->first; k < run->first + run->count && done; k++) {
        while (i < row.hits && row.fall[i].domino < f->data.point[k].domino)
            i++;
        done = i < row.hits && row.fall[i].domino == f->data.point[k].domino;
        computed[k] = done ? (double)row.fall[i].time : 0;
    }
    const size_t last = row.verdict.domino;
    const bool falls = row.verdict.end == DOM_ROW_FALLS, timeless = row.timeless;
    row_run_free(&row);
    return timeless ? row_status(&t.query, &f->problem, DOM_NO_MARGIN)
                    : done || row_long_enough(f, run, last, falls);
}

bool fit_hits(struct fit *f, const struct fit_run *run, double **time, size_t *count)
{
    struct trial t;
    struct row_run row;
    *time = calloc(*count + 1, sizeof **time);
    if (!*time)
        return problem_status(&f->problem, f->query->scene, DOM_NO_MEMORY);
    if (!run_trial(f, NULL, run, &t) || !row_run(&t.query, &f->problem, true, &row))
        return false;
    for (size_t k = 0; k <= *count; k++)
        (*time)[k] = (double)NAN;
    size_t last = 0;
    for (size_t i = 0; i < row.hits && row.fall[i].domino <= *count; i++)
        (*time)[last = row.fall[i].domino] = (double)row.fall[i].time;
    *count = last;
    row_run_free(&row);
    return true;
}

/* ---- Angles ---- */

/* Tilts to compute: tilt[k] is the tilt of domino point[k].domino at point[k].time. The times must not
 * decrease. */
struct watch {
    const struct fit_point *point;
    double clock; /* the time of the push or, without a push, of the first hit, on the clock of the
                     measurements */
    size_t count, done;
    double *tilt;
};

static bool tilt_keep(const struct domq_moment *moment, void *context)
{
    struct watch *w = context;
    w->tilt[w->done] = (double)moment->tilt[w->point[w->done].domino - 1];
    w->done++;
    return true;
}

/* Until the push, each domino keeps the tilt at which it was set up. */
static void tilts_before(struct watch *w, const struct scene_row *row)
{
    for (; w->done < w->count && w->point[w->done].time < w->clock; w->done++)
        w->tilt[w->done] = w->point[w->done].domino == 1
                               ? (double)scene_row_tilt(row)
                               : (double)row->domino[w->point[w->done].domino - 1].lean;
}

/* Fills in w->tilt for the measurements of one run. */
static bool tilts_find(struct fit *f, const double *value, const struct fit_run *run, struct watch *w)
{
    struct trial t;
    struct scene_row row;
    struct domq_verdict verdict;
    if (!run_trial(f, value, run, &t) || !scene_row_make(t.query.scene, &row, &f->problem))
        return false;
    const bool engine = row.row.engine, fits = run->dominoes <= row.row.count;
    enum dom_status status = DOM_OK;
    if (!engine && fits && !isnan(row.row.push))
        tilts_before(w, &row);
    if (!engine && fits && w->done < w->count) {
        domq_real *time = malloc((w->count - w->done) * sizeof *time);
        for (size_t k = w->done; k < w->count && time; k++)
            time[k - w->done] = (domq_real)(w->point[k].time - w->clock);
        status = time
                     ? any_row_watch(&row.row, &row.compute, time, w->count - w->done, tilt_keep, w, &verdict)
                     : DOM_NO_MEMORY;
        free(time);
    }
    free(row.domino);
    if (engine)
        return problem_no_answer(&f->problem,
                                 "angles can be compared with the model, but not with the rigid-body engine; "
                                 "times of hits can be compared with both");
    return row_long_enough(f, run, fits ? run->dominoes : (size_t)row.row.count, true) &&
           (status == DOM_OK || row_status(&t.query, &f->problem, status));
}

/* Finds when the domino of the first measurement reaches an angle for the first time, by interpolation
 * between its measurements. Returns NaN if its measurements never rise from below the angle to the angle or
 * above. */
static double angle_time(const struct fit_point *point, size_t count, double angle)
{
    const struct fit_point *last = point;
    for (const struct fit_point *p = point + 1; p < point + count; p++) {
        if (p->domino != point->domino)
            continue;
        if (last->measured < angle && p->measured >= angle)
            return last->time +
                   (p->time - last->time) * (angle - last->measured) / (p->measured - last->measured);
        last = p;
    }
    return (double)NAN;
}

/* Estimates the time of the push in a run or, without a push, of the first hit. The function compares the
 * first measured domino with the same domino in the model. It chooses the time so that both dominoes reach
 * half of the largest measured angle at the same time. */
static bool run_clock(struct fit *f, const double *value, const struct fit_run *run, double *clock)
{
    enum { STEPS = 400 };
    const struct fit_point *first = &f->data.point[run->first];
    struct fit_point *model = calloc(STEPS, sizeof *model);
    double tilt[STEPS] = {0}, most = 0, length = first[run->count - 1].time - first->time;
    if (!model)
        return problem_status(&f->problem, f->query->scene, DOM_NO_MEMORY);
    for (size_t k = 0; k < run->count; k++)
        if (first[k].domino == first->domino)
            most = fmax(most, first[k].measured);
    for (int k = 0; k < STEPS; k++)
        model[k] =
            (struct fit_point){.domino = first->domino, .time = 2 * length * (k + 0.5 - STEPS / 2.0) / STEPS};
    struct watch w = {model, 0, STEPS, 0, tilt};
    bool done = tilts_find(f, value, run, &w);
    for (int k = 0; k < STEPS; k++)
        model[k].measured = tilt[k];
    /* a first domino that is released may begin beyond half of its largest angle */
    const bool released = first->domino == 1 && scene_release(f->query->scene) > 0;
    const double half = (most + (released ? tilt[0] : 0)) / 2;
    *clock = angle_time(first, run->count, half) - angle_time(model, STEPS, half);
    free(model);
    return done && (isfinite(*clock) ||
                    problem_no_answer(&f->problem,
                                      "run %g: no line shows domino %zu before it passes half of its largest "
                                      "angle; begin the measurement before the domino moves",
                                      run->number, first->domino));
}

bool fit_clocks(struct fit *f, const double *value, double *clock)
{
    bool done = true;
    for (size_t k = 0; k < f->data.runs && f->data.kind == FIT_ANGLES && done; k++)
        done = run_clock(f, value, &f->data.run[k], &clock[k]);
    return done;
}

/* ---- All kinds ---- */

double fit_error(const struct fit *f, size_t k)
{
    const struct fit_point *point = &f->data.point[k];
    return f->data.has_errors ? point->error : fit_has_rows(&f->data) ? point->measured : 1;
}

/* Shifts the computed times of a run to minimise the sum of its squared residuals. */
static void clock_add(const struct fit *f, const struct fit_run *run, double *computed)
{
    double sum = 0, weights = 0;
    for (size_t k = run->first; k < run->first + run->count; k++) {
        const double weight = 1 / (fit_error(f, k) * fit_error(f, k));
        sum += weight * (f->data.point[k].measured - computed[k]);
        weights += weight;
    }
    for (size_t k = run->first; k < run->first + run->count; k++)
        computed[k] += sum / weights;
}

bool fit_compute(struct fit *f, const double *value, const double *clock, double *computed)
{
    const struct fit_data *d = &f->data;
    if (d->kind == FIT_SPEEDS)
        return speeds_compute(f, value, computed);
    if (d->kind == FIT_TOTALS)
        return totals_compute(f, value, computed);
    bool done = true;
    for (size_t k = 0; k < d->runs && done; k++) {
        const struct fit_run *run = &d->run[k];
        if (d->kind == FIT_HITS) {
            done = hits_compute(f, value, run, computed);
            if (done)
                clock_add(f, run, computed);
        } else {
            struct watch w = {&d->point[run->first], clock[k], run->count, 0, &computed[run->first]};
            done = tilts_find(f, value, run, &w);
        }
    }
    return done;
}
