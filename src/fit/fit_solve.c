/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the model's result for each measurement of 'fit', and finds the parameter values with the smallest
 * sum of squared residuals. A coarse grid provides the starting point for GSL's Levenberg-Marquardt method.
 */
#include "fit/fit.h"
#include "language/names.h"
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <stdlib.h>

/* ---- The model ---- */

/* Returns the standard error of measurement k. If no errors are known, all times of hits get the error 1, and
 * each speed or total time gets its own value as the error, so that all have the same relative error. */
static double fit_error(const struct fit *f, size_t k)
{
    const struct fit_point *point = &f->data.point[k];
    return f->data.has_errors ? point->error : fit_has_rows(&f->data) ? point->measured : 1;
}

/* A copy of the session's state with trial values of the unknowns, and a query about it. */
struct trial {
    struct state state;
    struct query query;
};

/* Makes a scene with these values of the unknowns, or those of the session if `value` is NULL. The scene has
 * a row of `dominoes` dominoes, or that of the session if `dominoes` is 0. Their gap is that of the session
 * if `gap` is NaN. If the measurements are those of rows, all dominoes are equal. */
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

bool fit_ends(struct problem *problem, const char *what, const struct domq_verdict *verdict)
{
    const size_t last = verdict->domino;
    if (verdict->end == DOM_ROW_FALLS)
        return problem_no_answer(
            problem,
            "%s, but the row has only %zu dominoes; enter a longer row, for example 'set "
            "row %zu'",
            what, last, 2 * last);
    return problem_no_answer(problem,
                             "%s, but in the scene the fall ends at domino %zu: 'fall' shows why; if the row "
                             "was pushed, 'set push' to about its speed, or fit push as well",
                             what, last);
}

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
        if (verdict.end != DOM_ROW_FALLS || !isfinite((double)verdict.seconds)) {
            char what[256];
            snprintf(what, sizeof what, "%s:%ld: %zu dominoes with gaps of %s fell in %g s",
                     names_shown(f->query->given->word[1]), p->line, p->domino,
                     measured((domq_real)p->gap, "m", 4).text, p->measured);
            return fit_ends(&f->problem, what, &verdict);
        }
        f->computed[k] = (double)verdict.seconds;
    }
    return true;
}

bool fit_row(struct fit *f, const double *value, const struct fit_run *run, size_t dominoes,
             struct row_run *row)
{
    const bool has_row = f->query->scene->effect[DOM_EFFECT_row].on;
    struct trial t;
    if (!trial_make(f, value, has_row ? 0 : dominoes + 1, run->gap, &t) ||
        !row_run(&t.query, &f->problem, true, row))
        return false;
    if (!row->timeless)
        return true;
    row_run_free(row);
    return row_status(&t.query, &f->problem, DOM_NO_MARGIN);
}

/* Fills in the times of the hits of a run. Shifts the times so that the sum of the squared residuals is
 * smallest. */
static bool hits_compute(struct fit *f, const double *value, const struct fit_run *run)
{
    const size_t end = run->first + run->count, dominoes = f->data.point[end - 1].domino;
    struct row_run row;
    if (!fit_row(f, value, run, dominoes, &row))
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
    const struct domq_verdict verdict = row.verdict;
    char what[64];
    row_run_free(&row);
    snprintf(what, sizeof what, "domino %zu was measured in run %g", dominoes, run->number);
    return done || verdict.domino >= dominoes || fit_ends(&f->problem, what, &verdict);
}

/* Computes what the model predicts for each measurement if the unknowns have the values `value`. The clock of
 * each run starts where the hits agree best. Returns false and sets fit->problem if there is no answer. */
static bool fit_compute(struct fit *f, const double *value)
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

/* ---- Residuals ---- */

/* Finds the unknowns that are not at a limit and discards the correlations of an earlier search. */
static void free_find(struct fit *f)
{
    f->free_count = 0;
    for (int i = 0; i < f->unknowns; i++) {
        if (!f->unknown[i].is_at_limit)
            f->free[f->free_count++] = i;
        for (int j = 0; j < i; j++)
            f->correlation[j][i] = (double)NAN;
    }
}

static bool is_interrupted(const struct fit *f)
{
    return dom_raised(f->query->scene->compute.interrupt);
}

/* The width of the range in which the search looks for starting values. */
static double width_of(const struct fit_unknown *u)
{
    return (double)u->parameter->to - (double)u->parameter->from;
}

/* Fills in the residuals, each divided by its error, and returns the sum of their squares. */
static double residuals_fill(const struct fit *f, gsl_vector *residual)
{
    const struct fit_data *d = &f->data;
    double squares;
    size_t n = 0;
    for (size_t k = 0; k < d->points; k++) {
        double left = f->computed[k] - d->point[k].measured;
        if (d->intervals && fit_is_first(f, k))
            continue;
        if (d->intervals) /* the random errors of n gaps add up to sqrt(n) times the error of one gap */
            left = (left - (f->computed[k - 1] - d->point[k - 1].measured)) /
                   sqrt((double)(d->point[k].domino - d->point[k - 1].domino));
        gsl_vector_set(residual, n++, left / fit_error(f, k));
    }
    gsl_blas_ddot(residual, residual, &squares);
    return squares;
}

/* Fills in all unknowns. The values of the free ones are in *x, or those of an earlier search if x is NULL. A
 * value beyond a limit of its range is reflected there. The sum of squares then has a mirror image beyond a
 * limit. If the sum decreases all the way to a limit, the limit is therefore a minimum. */
static void values_of(const struct fit *f, const gsl_vector *x, double *value)
{
    for (int i = 0; i < f->unknowns; i++)
        value[i] = f->unknown[i].value;
    for (size_t n = 0; x && n < f->free_count; n++) {
        const struct parameter *p = f->unknown[f->free[n]].parameter;
        const double lowest = (double)p->value->lowest, highest = (double)p->value->highest;
        double inside = gsl_vector_get(x, n);
        inside = inside < lowest ? 2 * lowest - inside : inside;
        value[f->free[n]] = inside > highest ? 2 * highest - inside : inside;
    }
}

/* Fills in the residuals. Returns false if the model has no answer, or after an interrupt. */
static bool residuals_at(struct fit *f, const gsl_vector *x, gsl_vector *residual)
{
    double value[FIT_UNKNOWNS];
    values_of(f, x, value);
    bool done = !is_interrupted(f) && fit_compute(f, value);
    if (done)
        residuals_fill(f, residual);
    else
        gsl_vector_set_all(residual, 1e12); /* so large that the search does not move to x */
    return done;
}

static int residuals_of_gsl(const gsl_vector *x, void *context, gsl_vector *residual)
{
    residuals_at(context, x, residual);
    return GSL_SUCCESS;
}

/* Fills in the derivatives of the residuals, by central differences if possible. The error of a difference
 * quotient with the step h is of the order h^2 + tol / h: a large step is inexact, and a small step amplifies
 * the errors of the model. The engine's answers are accurate to about three digits. */
static int derivatives_of_gsl(const gsl_vector *x, void *context, gsl_matrix *J)
{
    struct fit *f = context;
    const struct scene *scene = f->query->scene;
    const double relative = scene_engine(scene) ? 0.02 : fmax(1e-5, 10 * sqrt((double)scene->compute.tol));
    gsl_vector *at = gsl_vector_alloc(x->size), *left = gsl_vector_alloc(J->size1),
               *right = gsl_vector_alloc(J->size1);
    for (size_t i = 0; i < x->size && at && left && right; i++) {
        const double here = gsl_vector_get(x, i),
                     step = relative * fmax(fabs(here), width_of(&f->unknown[f->free[i]]) / 50);
        gsl_vector_memcpy(at, x);
        gsl_vector_set(at, i, here - step);
        double width = residuals_at(f, at, left) ? step : 0;
        gsl_vector_set(at, i, here + step);
        const bool above = residuals_at(f, at, right);
        /* If the model has an answer on only one side, the difference is one-sided. */
        if (!above || width == 0)
            residuals_at(f, x, above ? left : right);
        width += above ? step : 0;
        gsl_vector_sub(right, left);
        gsl_vector_scale(right, width > 0 ? 1 / width : 0);
        gsl_matrix_set_col(J, i, right);
    }
    const bool done = at && left && right;
    gsl_vector_free(at);
    gsl_vector_free(left);
    gsl_vector_free(right);
    return done ? GSL_SUCCESS : GSL_ENOMEM;
}

/* ---- Where the search begins ---- */

/* Tries all combinations of starting values and stores the one with the smallest sum of squares in the
 * unknowns. The starting values of an unknown are its current value and others that are spread over its
 * range. If the unknown is an effect that is off, a value just above the lower end of the range takes the
 * place of the current one. Fails if the model has no answer for any combination. */
static bool start_find(struct fit *f, gsl_vector *residual)
{
    static const double few[] = {0.01, 0.06, 0.25, 0.6}, many[] = {0.01, 0.025, 0.06, 0.125, 0.25, 0.5, 0.85};
    const double *share = f->unknowns > 2 ? few : many;
    const int each = f->unknowns > 2 ? 4 : 7, all = (int)lround(pow(each, f->unknowns));
    double least = HUGE_VAL, value[FIT_UNKNOWNS] = {0};
    struct problem first = {.kind = PROBLEM_NONE};
    for (int k = 0; k < all && !is_interrupted(f); k++) {
        for (int i = 0, rest = k; i < f->unknowns; i++, rest /= each) {
            const struct parameter *p = f->unknown[i].parameter;
            const domq_real now = parameter_get(f->query->state, p);
            value[i] = rest % each == 0 && now != EFFECT_OFF
                           ? (double)now
                           : (double)p->from + share[rest % each] * width_of(&f->unknown[i]);
        }
        const bool done = fit_compute(f, value);
        const double squares = done ? residuals_fill(f, residual) : HUGE_VAL;
        if (!done && first.kind == PROBLEM_NONE)
            first = f->problem;
        for (int i = 0; i < f->unknowns && squares < least; i++)
            f->unknown[i].value = value[i];
        least = fmin(least, squares);
    }
    if (!(least < HUGE_VAL))
        f->problem = first;
    return least < HUGE_VAL;
}

/* ---- The search ---- */

/* Finds the standard deviations and the correlations of the unknowns from the derivatives at the minimum. If
 * the measurements do not determine an unknown, its deviation is infinite. */
static bool deviations_find(struct fit *f, const gsl_matrix *derivatives)
{
    const size_t n = derivatives->size2;
    gsl_matrix *J = gsl_matrix_alloc(derivatives->size1, n), *covariance = gsl_matrix_calloc(n, n);
    double norm[FIT_UNKNOWNS] = {0};
    const bool done = J && covariance;
    if (done) {
        gsl_matrix_memcpy(J, derivatives);
        /* The columns are scaled to the same length, so that all unknowns matter equally. */
        for (size_t i = 0; i < n; i++) {
            gsl_vector_view column = gsl_matrix_column(J, i);
            norm[i] = gsl_blas_dnrm2(&column.vector);
            if (norm[i] > 0)
                gsl_vector_scale(&column.vector, 1 / norm[i]);
        }
        gsl_multifit_nlinear_covar(J, 1e-7, covariance);
    }
    /* The covariance assumes the errors that fit_error returns. If the user gave no errors, or if the
     * residuals are too large for the given errors, the size of the errors is taken from the residuals
     * instead. */
    const double factor = f->data.has_errors ? fmax(f->reduced_chi_squared, 1) : f->reduced_chi_squared;
    for (size_t a = 0; a < n && done; a++) {
        const double variance = gsl_matrix_get(covariance, a, a);
        f->unknown[f->free[a]].deviation =
            variance > 0 && norm[a] > 0 ? sqrt(factor * variance) / norm[a] : HUGE_VAL;
        for (size_t b = 0; b < a; b++)
            f->correlation[f->free[b]][f->free[a]] =
                gsl_matrix_get(covariance, a, b) / sqrt(variance * gsl_matrix_get(covariance, b, b));
    }
    gsl_matrix_free(J);
    gsl_matrix_free(covariance);
    return done;
}

/* Moves the unknowns that are not at a limit to a local minimum of the sum of squares. Returns a GSL
 * status. */
static int minimum_search(struct fit *f, gsl_vector *residual)
{
    enum { STEPS_MOST = 50 };
    const gsl_multifit_nlinear_parameters usual = gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_fdf problem = {.f = residuals_of_gsl,
                                        .df = derivatives_of_gsl,
                                        .n = residual->size,
                                        .p = f->free_count,
                                        .params = f};
    gsl_vector *x = NULL;
    gsl_multifit_nlinear_workspace *w = NULL;
    int info = 0, status = GSL_SUCCESS;
    double value[FIT_UNKNOWNS];
    if (f->free_count > 0) {
        x = gsl_vector_alloc(f->free_count);
        w = x ? gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &usual, problem.n, problem.p) : NULL;
        for (size_t n = 0; n < f->free_count && w; n++)
            gsl_vector_set(x, n, f->unknown[f->free[n]].value);
        status = w ? gsl_multifit_nlinear_init(x, &problem, w) : GSL_ENOMEM;
        if (status == GSL_SUCCESS)
            status = gsl_multifit_nlinear_driver(STEPS_MOST, 1e-10, 1e-12, 0, NULL, NULL, &info, w);
        if (info == GSL_ENOPROG) /* the starting point is already the minimum */
            status = GSL_SUCCESS;
        if (w)
            gsl_vector_memcpy(x, gsl_multifit_nlinear_position(w));
    }
    if ((w || f->free_count == 0) && !is_interrupted(f)) {
        if (!residuals_at(f, x, residual) && f->free_count == 0) /* recomputes f->computed at the minimum */
            status = GSL_EDOM;
        f->reduced_chi_squared = residuals_fill(f, residual) / (double)f->freedom;
        values_of(f, x, value);
        for (int i = 0; i < f->unknowns; i++)
            f->unknown[i].value = value[i];
        if (w && !deviations_find(f, gsl_multifit_nlinear_jac(w)))
            status = GSL_ENOMEM;
    }
    gsl_multifit_nlinear_free(w);
    gsl_vector_free(x);
    return status;
}

/* Looks for an unknown that is close to a limit of its range. If there is one, sets it to this limit and
 * returns true. Close means within `near` times the width of the searched range. */
static bool limit_take(struct fit *f, double near)
{
    for (int i = 0; i < f->unknowns; i++) {
        struct fit_unknown *u = &f->unknown[i];
        const double lowest = (double)u->parameter->value->lowest,
                     highest = (double)u->parameter->value->highest;
        const bool low = u->value - lowest < near * width_of(u),
                   high = highest - u->value < near * width_of(u);
        if (!u->is_at_limit && (low || high)) {
            u->is_at_limit = true;
            u->value = low ? lowest : highest;
            u->deviation = (double)NAN;
            return true;
        }
    }
    return false;
}

/* Finds the minimum. If an unknown is near a limit of its range, the search would jump back and forth across
 * the limit. Such an unknown is set to the limit, and the others are fitted again. */
static int minimum_find(struct fit *f, gsl_vector *residual)
{
    int status;
    do {
        free_find(f);
        status = minimum_search(f, residual);
    } while (limit_take(f, status == GSL_SUCCESS ? 1e-6 : 1e-3));
    return status;
}

/* Returns the Durbin-Watson statistic sum (e_k - e_(k-1))^2 / sum e_k^2 of the residuals e_k. It is near 2 if
 * the residuals are independent. It is near 0 if they change slowly from one to the next, which shows that
 * the model does not fit. */
static double drift_of(const struct fit *f, const gsl_vector *residual)
{
    double steps = 0, all = 0;
    for (size_t k = 0; k < f->data.points; k++) {
        const double here = gsl_vector_get(residual, k);
        all += here * here;
        if (!fit_is_first(f, k))
            steps += pow(here - gsl_vector_get(residual, k - 1), 2);
    }
    return steps / all;
}

static int fit_once(struct fit *f)
{
    for (int i = 0; i < f->unknowns; i++)
        f->unknown[i].is_at_limit = false;
    free_find(f);
    const bool of_hits = f->data.kind == FIT_HITS;
    const size_t residuals = f->data.points - (f->data.intervals ? f->data.runs : 0);
    gsl_vector *residual = gsl_vector_alloc(residuals);
    /* Each run of hits has an unknown start. */
    f->freedom = residuals - f->free_count - (of_hits && !f->data.intervals ? f->data.runs : 0);
    int status = !residual ? GSL_ENOMEM : !start_find(f, residual) ? GSL_EDOM : minimum_find(f, residual);
    /* If the gaps differ, the times of hits drift away from the times of the model. */
    const bool drifts = status == GSL_SUCCESS && of_hits && !f->data.has_errors && !f->data.intervals &&
                        f->freedom >= 8 && drift_of(f, residual) < 1;
    gsl_vector_free(residual);
    f->data.intervals = f->data.intervals || drifts;
    return drifts ? GSL_CONTINUE : status;
}

bool fit_solve(struct fit *f, struct problem *problem)
{
    const bool has_rows = fit_has_rows(&f->data);
    if (f->data.points <= (size_t)f->unknowns + (has_rows ? 0 : f->data.runs))
        return problem_no_answer(
            problem,
            "%zu measurements are too few for %d unknown%s%s; measure more, or name fewer "
            "unknowns",
            f->data.points, f->unknowns, f->unknowns > 1 ? "s" : "",
            has_rows ? "" : " and the start time of each run");
    f->computed = calloc(f->data.points, sizeof *f->computed);
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    int status = f->computed ? fit_once(f) : GSL_ENOMEM;
    if (status == GSL_CONTINUE)
        status = fit_once(f);
    gsl_set_error_handler(handler);
    if (is_interrupted(f))
        return problem_status(problem, f->query->scene, DOM_INTERRUPTED);
    if (status == GSL_ENOMEM)
        return problem_status(problem, f->query->scene, DOM_NO_MEMORY);
    if (status == GSL_EDOM)
        *problem = f->problem;
    else if (status != GSL_SUCCESS)
        problem_no_answer(
            problem,
            "the search does not converge: many values explain the measurements equally well; fit fewer "
            "parameters, or set the parameters that are not fitted closer to their true values");
    return status == GSL_SUCCESS;
}
