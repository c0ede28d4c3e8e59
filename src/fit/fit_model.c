/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the model's result for each measurement of 'fit'. */
#include "fit/fit.h"
#include "language/names.h"
#include "train/falling.h"

/* A copy of the session's state with trial values of the unknowns, and a query about it. */
struct trial {
    struct state state;
    struct query query;
};

/* Makes a scene with these values of the unknowns. The scene has a row of `dominoes` dominoes, or that of the
 * session if `dominoes` is 0. Their gap is that of the session if `gap` is NaN. If the measurements are those
 * of rows, all dominoes are equal. */
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
    for (int i = 0; i < f->unknowns; i++)
        assigned[count++] =
            (struct assigned){.parameter = f->unknown[i].parameter, .value = (domq_real)value[i]};
    return query_with(f->query, assigned, count, &t->state, &t->query, &f->problem);
}

static bool speeds_compute(struct fit *f, const double *value)
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
        f->computed[k] = (double)domq_scale_speed(&t.query.scene->scale, &train, duration);
    }
    return true;
}

/* Advice for a row that fell, but does not fall in the scene. */
static const char push_advice[] = "if the row was pushed, 'set push' to about its speed, or fit push as well";

/* Fills in how long each row takes to fall, as 'verdict' says. */
static bool totals_compute(struct fit *f, const double *value)
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
                                     push_advice);
        f->computed[k] = (double)verdict.seconds;
    }
    return true;
}

/* Fills in the times of the hits of a run, in the row of the session or, if there is none, in one as long as
 * the run. Shifts the times so that the sum of the squared residuals is smallest. */
static bool hits_compute(struct fit *f, const double *value, const struct fit_run *run)
{
    const size_t end = run->first + run->count, dominoes = f->data.point[end - 1].domino;
    const bool has_row = f->query->scene->effect[DOM_EFFECT_row].on;
    struct trial t;
    struct row_run row;
    if (!trial_make(f, value, has_row ? 0 : dominoes + 1, run->gap, &t) ||
        !row_run(&t.query, &f->problem, true, &row))
        return false;
    double sum = 0, weights = 0;
    bool done = true;
    for (size_t k = run->first, i = 0; k < end && done; k++) {
        const double weight = 1 / (fit_error(f, k) * fit_error(f, k));
        while (i < row.hits && row.fall[i].domino < f->data.point[k].domino)
            i++;
        done = i < row.hits && row.fall[i].domino == f->data.point[k].domino;
        f->computed[k] = done ? (double)row.fall[i].time : 0;
        sum += weight * (f->data.point[k].measured - f->computed[k]);
        weights += weight;
    }
    for (size_t k = run->first; k < end; k++)
        f->computed[k] += sum / weights;
    const size_t last = row.verdict.domino;
    const bool falls = row.verdict.end == DOM_ROW_FALLS, timeless = row.timeless;
    row_run_free(&row);
    if (timeless)
        return row_status(&t.query, &f->problem, DOM_NO_MARGIN);
    if (!done && last < dominoes && falls)
        return problem_no_answer(
            &f->problem,
            "domino %zu was measured in run %g, but the row has only %zu dominoes; enter a longer "
            "row, for example 'set row %zu'",
            dominoes, run->number, last, dominoes);
    if (!done && last < dominoes)
        return problem_no_answer(
            &f->problem,
            "domino %zu was measured in run %g, but in the scene the fall ends at domino %zu: 'fall' "
            "shows why; %s",
            dominoes, run->number, last, push_advice);
    return true;
}

double fit_error(const struct fit *f, size_t k)
{
    const struct fit_point *point = &f->data.point[k];
    return f->data.has_errors ? point->error : fit_has_rows(&f->data) ? point->measured : 1;
}

bool fit_compute(struct fit *f, const double *value)
{
    const struct fit_data *d = &f->data;
    if (d->kind == FIT_SPEEDS)
        return speeds_compute(f, value);
    if (d->kind == FIT_TOTALS)
        return totals_compute(f, value);
    bool done = true;
    for (size_t k = 0; k < d->runs && done; k++)
        done = hits_compute(f, value, &d->run[k]);
    return done;
}
