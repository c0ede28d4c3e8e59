/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/fit.h"
#include "interpreter/command.h"
#include "language/quad.h"
#include "language/text.h"
#include "sweeps/sweeps.h"
#include <gsl/gsl_cdf.h>
#include <stdlib.h>
#include <string.h>

/* ---- The arguments ---- */

/* Parses "friction, push": names with commas between them. */
static bool fit_parse(struct reader *r, struct question *q)
{
    char name[32];
    if (!range_parse_names(r, q, FIT_UNKNOWNS))
        return false;
    /* Without this check, a name after a blank would be taken for the name of a file. */
    snprintf(name, sizeof name, "%.*s", (int)strcspn(r->at, " \t;>"), r->at);
    return names_exact(varied_names, NULL, name) < 0 ||
           problem_error(r->problem, "a comma is missing before '%s', as in 'fit friction, push FILE'", name);
}

/* ---- The answer ---- */

static const struct column fit_columns[] = {
    {"gap", "m",
     "the clear gap between neighbouring dominoes, if a speed or a total time was measured; all gaps of the "
     "row are equal",
     0},
    {"dominoes", "", "the number of dominoes of the row, if a total time was measured", 0},
    {"run", "", "the number of the run, if a hit was measured", 5},
    {"domino", "", "the number of the domino, if a hit was measured", 0},
    {"measured", "", "the measurement: a speed in m/s or a time in s", 0},
    {"fitted", "", "the model's result with the fitted values", 0},
    {"residual", "", "measured - fitted; for a speed or a total time, measured / fitted - 1", 0},
    {"friction", "", "the fitted value of friction; every fitted parameter has a column", 0},
    {"friction_sd", "", "the standard deviation of the fitted value", 0},
    {NULL, NULL, NULL, 0},
};
enum { COLUMN_GAP, COLUMN_DOMINOES, COLUMN_RUN, COLUMN_DOMINO, COLUMN_MEASURED, FITTED, RESIDUAL, UNKNOWN };

/* What differs between the kinds of measurements: the columns that are not used, and how all are weighted. */
static const struct {
    const char *unit, *unused, *residual, *alike;
} kinds[] = {
    [FIT_SPEEDS] = {"m/s", "dominoes run domino", "share", "All speeds have the same relative weight."},
    [FIT_HITS] = {"s", "gap dominoes", "s", "All times have the same weight."},
    [FIT_TOTALS] = {"s", "run domino", "share", "All times have the same relative weight."},
};

/* Makes the columns for the kind of measurement. csv and json also have columns for the fitted values. A
 * table has sentences below it instead. */
static void columns_make(struct answer *a, const struct fit *f, char deviation[FIT_UNKNOWNS][32])
{
    struct column *c = answer_columns(a, fit_columns) + UNKNOWN;
    for (int i = 0; i < f->unknowns && !answer_for_people(a); i++) {
        const struct parameter *p = f->unknown[i].parameter;
        snprintf(deviation[i], sizeof deviation[i], "%.24s_sd", p->name);
        *c++ = (struct column){p->name, "", "a fitted value", 0};
        *c++ = (struct column){deviation[i], "", "the standard deviation of the fitted value", 0};
    }
    *c = (struct column){NULL, NULL, NULL, 0};
    answer_describe(a, "measured", kinds[f->data.kind].unit, NULL);
    answer_describe(a, "fitted", kinds[f->data.kind].unit, NULL);
    answer_describe(a, "residual", kinds[f->data.kind].residual, NULL);
    answer_leave_out(a, kinds[f->data.kind].unused);
}

/* Computes the measured value, the fitted value and the residual of point k. If intervals are compared,
 * returns false for the first hit of a run. */
static bool compared(const struct fit *f, size_t k, double *measured_, double *fitted, double *residual)
{
    *measured_ = f->data.point[k].measured - (f->data.intervals && k > 0 ? f->data.point[k - 1].measured : 0);
    *fitted = f->computed[k] - (f->data.intervals && k > 0 ? f->computed[k - 1] : 0);
    *residual = fit_has_rows(&f->data) ? *measured_ / *fitted - 1 : *measured_ - *fitted;
    return !(f->data.intervals && fit_is_first(f, k));
}

static void rows_write(struct answer *a, const struct fit *f)
{
    for (size_t k = 0; k < f->data.points && !answer_lost(a); k++) {
        const struct fit_point *p = &f->data.point[k];
        double value, fitted, residual;
        if (!compared(f, k, &value, &fitted, &residual))
            continue;
        struct cell cell[ANSWER_COLUMNS] = {
            [COLUMN_GAP] = cell_real((domq_real)p->gap),
            [COLUMN_DOMINOES] = cell_count((domq_real)p->domino),
            [COLUMN_RUN] = cell_real((domq_real)f->data.run[p->run].number),
            [COLUMN_DOMINO] = cell_count((domq_real)p->domino),
            [COLUMN_MEASURED] = cell_real((domq_real)value),
            [FITTED] = cell_narrow((domq_real)fitted, 4),
            [RESIDUAL] = cell_narrow((domq_real)residual, 2),
        };
        int n = UNKNOWN;
        for (int u = 0; u < f->unknowns && !answer_for_people(a); u++) {
            cell[n++] = cell_narrow((domq_real)f->unknown[u].value, 4);
            cell[n++] = cell_narrow((domq_real)f->unknown[u].deviation, 4);
        }
        answer_row(a, cell, NULL);
    }
}

/* ---- In words ---- */

/* Says the best value with its interval, with as many digits as the ends of the interval need to differ. The
 * interval ends where the range of the parameter ends. */
static void value_say(struct answer *a, const struct fit_unknown *u, const char *unit, double t)
{
    const struct parameter *p = u->parameter;
    const domq_real least = quad_larger((domq_real)(u->value - t * u->deviation), p->value->lowest),
                    most = quad_smaller((domq_real)(u->value + t * u->deviation), p->value->highest);
    struct measured low, high;
    int digits = 4;
    do {
        low = measured(least, unit, digits);
        high = measured(most, unit, digits);
    } while (strcmp(low.text, high.text) == 0 && ++digits < 15);
    answer_say(a, "The best fit is %s %s, with a standard deviation of %s and a 95 %% interval of %s to %s.",
               p->name, measured((domq_real)u->value, unit, digits).text,
               measured((domq_real)u->deviation, unit, 2).text, low.text, high.text);
}

static void values_say(struct answer *a, const struct fit *f)
{
    char commands[300] = "";
    const double t = gsl_cdf_tdist_Pinv(0.975, (double)f->freedom);
    answer_say(a, "\n%zu measurements, %d unknown%s.", f->data.points, f->unknowns,
               f->unknowns > 1 ? "s" : "");
    for (int i = 0; i < f->unknowns; i++) {
        const struct fit_unknown *u = &f->unknown[i];
        const struct parameter *p = u->parameter;
        const char *unit = strcmp(p->value->unit, "h") == 0 ? "" : p->value->unit;
        const domq_real value = (domq_real)u->value;
        text_add(commands, sizeof commands, "%sset %s %.4g%s%s", i ? "; " : "", p->name, u->value,
                 *unit ? " " : "", unit);
        if (u->is_at_limit)
            answer_say(a, "The best fit is %s %s, which is the limit of its range.", p->name,
                       measured(value, unit, 4).text);
        else
            value_say(a, u, unit, t);
    }
    for (int i = 0; i < f->unknowns; i++)
        for (int j = 0; j < i; j++)
            if (isfinite(f->correlation[j][i]))
                answer_say(a, "The correlation of %s and %s is %.3f%s.", f->unknown[j].parameter->name,
                           f->unknown[i].parameter->name, f->correlation[j][i],
                           fabs(f->correlation[j][i]) > 0.95 ? ": these measurements hardly tell them apart"
                                                             : "");
    answer_say(a, "'%s' sets %s.", commands, f->unknowns > 1 ? "them" : "it");
}

static void residuals_say(struct answer *a, const struct fit *f)
{
    double most = 0;
    size_t worst = 0;
    for (size_t k = 0; k < f->data.points; k++) {
        double value, fitted, residual;
        if (!compared(f, k, &value, &fitted, &residual))
            continue;
        worst = fabs(residual) > most ? k : worst;
        most = fmax(most, fabs(residual));
    }
    if (f->data.intervals)
        answer_say(
            a, "The measured times drift away from the model's times, as they do if the gaps of a row are "
               "not all equal. The fit and the table therefore compare the times between successive hits.");
    else if (f->data.spread > 0)
        answer_say(a,
                   "Each line is the mean of its trials. Single trials differ from their mean by %s, and the "
                   "mean of n trials has this error divided by sqrt(n)%s.",
                   measured((domq_real)f->data.spread, "share", 2).text,
                   f->reduced_chi_squared > 2 ? ", which is smaller than the residuals" : "");
    else if (f->data.has_errors)
        answer_say(a, "The measurements are weighted by their errors%s.",
                   f->reduced_chi_squared > 2 ? ", which are smaller than the residuals" : "");
    else
        answer_say(a, "%s", kinds[f->data.kind].alike);
    char where[48] = "";
    if (!fit_has_rows(&f->data))
        snprintf(where, sizeof where, ", at domino %zu", f->data.point[worst].domino);
    answer_say(a, "The largest residual is %s%s.",
               measured((domq_real)most, kinds[f->data.kind].residual, 2).text, where);
}

/* ---- The fit ---- */

static bool fit_make(const struct query *query, struct fit *f, struct problem *problem)
{
    const struct grid *named = &((const struct sweep *)query->given->bound)->grid;
    const char *shown = names_shown(query->given->word[1]);
    *f = (struct fit){.query = query, .unknowns = named->axes};
    for (int i = 0; i < named->axes; i++)
        f->unknown[i].parameter = named->axis[i].parameter;
    const double rate = query->given->count > 2 ? (double)query->given->number[2] : (double)NAN;
    if (!fit_read(query, query->given->word[1], rate, &f->data, problem))
        return false;
    for (int i = 0; i < f->unknowns && f->data.has_pitch; i++)
        if (names_index("d,h", ',', f->unknown[i].parameter->name) >= 0)
            return problem_no_answer(problem,
                                     "%s has pitches, from which the gaps follow only if the thickness is "
                                     "known; measure gaps to fit the size of a domino",
                                     shown);
    if (!fit_number(f, problem) || !fit_solve(f, problem))
        return false;
    for (int i = 0; i < f->unknowns; i++)
        if (f->unknown[i].deviation == HUGE_VAL)
            return problem_no_answer(
                problem, "%s: the measurements do not depend on %s%s", shown, f->unknown[i].parameter->name,
                f->unknowns > 1 ? ", or not separately from the others; fit fewer parameters" : "");
    return true;
}

static bool run_fit(const struct query *query, struct answer *a, struct problem *problem)
{
    struct fit f;
    char deviation[FIT_UNKNOWNS][32];
    const bool done = fit_make(query, &f, problem);
    if (done) {
        a->in_double = a->style.precision == IN_QUAD;
        columns_make(a, &f, deviation);
        rows_write(a, &f);
        values_say(a, &f);
        residuals_say(a, &f);
    }
    free(f.data.point);
    free(f.data.run);
    free(f.computed);
    return done;
}

/* ---- The command ---- */

static const struct command fit_commands[] = {
    {.name = "fit",
     .synonyms = "measured camera video tracker regression estimate calibrate",
     .argument = {{.name = "NAME",
                   .kind = ARGUMENT_GRID,
                   .parse = fit_parse,
                   .bind = sweep_bind,
                   .choices = varied_names},
                  {.name = "FILE", .kind = ARGUMENT_FILE},
                  {.name = "FPS", .kind = ARGUMENT_NUMBER, .optional = true}},
     .summary = "the parameters that explain measurements best",
     .help =
         "NAME is a parameter or an effect, or up to four of them with commas between them, as in "
         "'friction, push'. FILE is a csv file of one of four kinds. In a file with 'gap (mm)' and 'speed "
         "(m/s)', each line has the speed of one row of equal dominoes. With 'gap (mm)', 'dominoes' and "
         "'time (s)', each line has the time that a row of that many equal dominoes takes to fall: from the "
         "push or the release or, without these, from the first hit, until the last one lies on the floor. "
         "The columns 'domino' and 'time (s)' (or 'frame') say when each domino of the row is hit, as a "
         "camera shows it. A file with only 'time (s)' has the hits of a sound, some of which may be "
         "missing: "
         "the first is that of domino 2, and the others are numbered by a run of the session's row.\n\n"
         "A 'pitch', from front face to front face, can take the place of the gap. FPS is the number of "
         "frames per second; a column 'rate' can give this number instead. A column 'run' numbers several "
         "runs, each with its own clock. A column 'gap (mm)' gives the gap of each run. A column 'error' "
         "gives the standard errors, for speeds and rows also 'error (%)'. Columns 'speed 1', 'speed 2', or "
         "'trial 1 (s)', 'trial 2 (s)', have repeated measurements, whose spread is their error.\n\n"
         "Hits are those of the row of 'set row' or, without it, of a row with the growth r. Each residual "
         "is divided by its error, and 'fit' finds the values with the smallest sum of squares. It also "
         "finds their standard deviations and correlations.",
     .see = "solve duration fall sensitivity",
     .access.files = true,
     .rows = true,
     ANSWER(fit)},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"What measurements say", "planning", fit_commands},
    {NULL, NULL, NULL},
};

const struct feature fit_feature = {.name = "fit", .groups = groups};
