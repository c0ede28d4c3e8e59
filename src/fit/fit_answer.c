/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/fit.h"
#include "interpreter/feature.h"
#include "language/quad.h"
#include "language/text.h"
#include "sweeps/sweeps.h"
#include "tables/csv.h"
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

/* ---- The file ---- */

enum { POINTS_MOST = 20000 };

/* The columns of both kinds of files, and then those that only files of times have. */
enum { GAP, PITCH, MEASURED, ERROR, SHARE, DOMINO, DOMINOES, FRAME, RATE, RUN };

#define SPEED             "m/s", "m/s, cm/s, mm/s, ft/s", "m/s", "write a speed such as 1.3 m/s"
#define TIME              "s", "s, ms", "s", "write a time such as 0.12 s"
#define PLAIN             "", "none", "", "write a plain number"
#define PERCENT           "", "%", "%", "write a percentage such as 5 %", CSV_ABOVE_0, 1, "more than 0, up to 100 %"
#define FRAMES            "", "none", "", "write the number of frames per second, such as 240"
#define LENGTH            CSV_LENGTH, "write a length such as 9 mm", CSV_ABOVE_0, 1e9, "more than 0, up to 1e9 m"
#define UP_TO(most, unit) CSV_ABOVE_0, most, "more than 0, up to " #most unit

static const struct csv_column speed_columns[] = {
    [GAP] = {"gap", CSV_REQUIRED | CSV_ONE_OF_2, LENGTH},
    [PITCH] = {"pitch", CSV_ONE_OF_2, LENGTH},
    [MEASURED] = {"speed", CSV_REQUIRED | CSV_REPEATED, SPEED, UP_TO(3e8, " m/s")},
    [ERROR] = {"error", CSV_EMPTY | CSV_ONE_OF_3, SPEED, UP_TO(3e8, " m/s")},
    [SHARE] = {"error %", CSV_EMPTY | CSV_ONE_OF_3, PERCENT},
};
static const struct csv_column time_columns[] = {
    [GAP] = {"gap", CSV_ONE_OF_2, LENGTH},
    [PITCH] = {"pitch", CSV_ONE_OF_2, LENGTH},
    [MEASURED] = {"time", CSV_REQUIRED | CSV_ONE_OF | CSV_EMPTY | CSV_BARE | CSV_REPEATED, TIME, -1e9, 1e9,
                  "-1e9 .. 1e9 s"},
    [ERROR] = {"error", CSV_EMPTY | CSV_ONE_OF_3, TIME, UP_TO(1e9, " s")},
    [SHARE] = {"error %", CSV_EMPTY | CSV_ONE_OF_3, PERCENT},
    [DOMINO] = {"domino", CSV_WHOLE | CSV_EMPTY, PLAIN, 1, 1e6, "1 .. 1e6"},
    [DOMINOES] = {"dominoes", CSV_WHOLE, PLAIN, 2, 1e5, "2 .. 100000"},
    [FRAME] = {"frame", CSV_ONE_OF | CSV_EMPTY, PLAIN, -1e12, 1e12, "-1e12 .. 1e12"},
    [RATE] = {"rate", 0, FRAMES, UP_TO(1e9, "")},
    [RUN] = {"run", 0, PLAIN, -1e12, 1e12, "-1e12 .. 1e12"},
};

static const struct csv_kind times = {
    .column = time_columns,
    .columns = sizeof time_columns / sizeof *time_columns,
    .rows_most = POINTS_MOST,
    .item = "measurement",
    .items = "measurements",
    .names = "domino, time (s) or frame, and, if needed, rate, run, gap (mm), error (s)",
    .example = "domino, time (s)",
};
static const struct csv_kind speeds = {
    .column = speed_columns,
    .columns = sizeof speed_columns / sizeof *speed_columns,
    .rows_most = POINTS_MOST,
    .item = "measured row",
    .items = "speeds",
    .names = "gap (mm), speed (m/s), and, if known, error (m/s); or gap (mm), dominoes, time (s); or domino, "
             "time (s); or, for the hits of a sound, only time (s)",
    .example = "gap (mm), speed (m/s)",
    .otherwise = &times,
};

/* Adds a measurement to the last run or, if the row of the file has another number of a run, to a new run. */
static bool point_add(struct fit_data *d, struct csv_table *csv, struct fit_point point)
{
    const double number = csv->column[RUN] ? (double)csv->value[RUN] : 1,
                 gap = fit_has_rows(d) ? (double)NAN : point.gap;
    const bool known = point.error > 0;
    bool is_new = true;
    if (d->points > 0 && known != d->has_errors)
        return csv_wrong(&csv->file, csv_cell(csv, csv->column[SHARE] ? SHARE : ERROR).at,
                         "some %s have an error and some have none; give an error to all of them, or to none",
                         csv->kind->items);
    for (size_t k = 0; k < d->runs && is_new; k++) {
        is_new = d->run[k].number != number;
        if (!is_new && k + 1 < d->runs)
            return csv_wrong(&csv->file, csv_cell(csv, RUN).at,
                             "the lines of run %g are interrupted by another run; put them together", number);
        if (!is_new && d->run[k].gap != gap && !isnan(gap))
            return csv_wrong(&csv->file, csv_cell(csv, GAP).at,
                             "run %g has two gaps; give each run a single gap, or leave out the column and "
                             "enter the row with 'set row'",
                             number);
    }
    struct fit_run *runs = is_new ? realloc(d->run, (d->runs + 1) * sizeof *runs) : d->run;
    d->run = runs ? runs : d->run;
    struct fit_point *points = realloc(d->point, (d->points + 1) * sizeof *points);
    d->point = points ? points : d->point;
    if (!runs || !points)
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    if (is_new)
        d->run[d->runs++] = (struct fit_run){.number = number, .gap = gap, .first = d->points};
    struct fit_run *run = &d->run[d->runs - 1];
    const struct fit_point *last = run->count > 0 ? &d->point[d->points - 1] : NULL;
    if (d->kind == FIT_HITS && last && point.domino > 0 && last->domino >= point.domino)
        return csv_wrong(
            &csv->file, csv_cell(csv, DOMINO).at,
            "domino %zu comes after domino %zu; list the dominoes of a run in the order in which "
            "they are hit, each once",
            point.domino, last->domino);
    if (d->kind == FIT_HITS && last && last->measured >= point.measured)
        return csv_wrong(&csv->file, csv->row.at,
                         "the time %g s is not later than %g s, the time on the line above", point.measured,
                         last->measured);
    point.run = d->runs - 1;
    d->has_errors = known;
    d->point[d->points++] = point;
    run->count++;
    return true;
}

/* Adds the measurement in the current row of the file, unless its time is missing. */
static bool row_add(const struct query *query, struct fit_data *d, struct csv_table *csv, double rate)
{
    const domq_real *value = csv->value;
    const struct scene *scene = query->scene;
    const struct effect_state *row = &scene->effect[DOM_EFFECT_row];
    const domq_real thickness = scene->train.d * scene->scale.h,
                    gap = csv->column[PITCH] ? value[PITCH] - thickness : value[GAP];
    struct fit_point point = {.gap = (double)gap,
                              .line = csv->row.at.line,
                              .measured = (double)value[MEASURED],
                              .error = (double)value[ERROR]};
    if (gap <= 0)
        return csv_wrong(
            &csv->file, csv_cell(csv, PITCH).at,
            "the pitch %s must exceed the thickness of a domino, d h = %s; 'set d' changes the thickness",
            measured(value[PITCH], "m", 6).text, measured(thickness, "m", 6).text);
    if (gap > scene->scale.h)
        return csv_wrong(&csv->file, csv_cell(csv, csv->column[PITCH] ? PITCH : GAP).at,
                         "the gap %s is longer than the domino is tall, h = %s; 'set h' changes this height",
                         measured(gap, "m", 6).text, measured(scene->scale.h, "m", 6).text);
    if (csv->column[RATE])
        rate = (double)value[RATE];
    if (csv->column[FRAME] && isnan(rate) && !isnan((double)value[FRAME]))
        return csv_wrong(&csv->file, csv_cell(csv, FRAME).at,
                         "frames need a frame rate: enter 'fit ... FILE 240' for 240 frames per second, or "
                         "add a column 'rate'");
    if (csv->column[FRAME])
        point.measured = (double)value[FRAME] / rate;
    if (isnan(point.measured))
        return true;
    if (csv->trials > 1 && (csv->column[ERROR] || csv->column[SHARE]))
        return csv_wrong(&csv->file, csv->head.cell[csv->column[csv->column[SHARE] ? SHARE : ERROR] - 1].at,
                         "both repeated measurements, whose spread is their error, and a column of errors "
                         "are given; leave one of them out");
    if (d->kind == FIT_HITS && (csv->trials > 1 || csv->column[SHARE]))
        return csv_wrong(&csv->file, csv->head.at,
                         "hits have one column 'time (s)', and errors in s; number repeated runs in a column "
                         "'run'; times of whole rows need the columns 'gap (mm)' and 'dominoes'");
    if (csv->trials > 1) /* the errors are known, apart from the spread */
        point.error = point.measured / sqrt(csv->repeated);
    else if (csv->column[SHARE])
        point.error = (double)value[SHARE] * point.measured;
    if (d->kind == FIT_HITS && !isnan((double)value[DOMINO]))
        point.domino = (size_t)value[DOMINO];
    else if (d->kind == FIT_TOTALS && csv->column[DOMINOES])
        point.domino = (size_t)value[DOMINOES];
    else if (d->kind == FIT_TOTALS && row->on && !scene->listed.domino)
        point.domino = (size_t)row->value[0];
    if (d->kind == FIT_TOTALS && isnan(point.gap))
        return csv_wrong(&csv->file, csv->head.at,
                         "how wide were the gaps of these rows? Add a column 'gap (mm)' or 'pitch (mm)'");
    if (d->kind == FIT_TOTALS && point.domino == 0)
        return csv_wrong(&csv->file, csv->head.at,
                         "how many dominoes fell in this time? Add a column 'dominoes', or enter, for "
                         "example, 'set row 28'");
    if (d->kind == FIT_TOTALS && !(point.measured > 0))
        return csv_wrong(&csv->file, csv_cell(csv, MEASURED).at,
                         "the time in which a row falls must be more than 0");
    return point_add(d, csv, point);
}

/* Reads the measurements. `rate` is in frames per second, or NaN if it is not known. */
static bool fit_read(const struct query *query, const char *name, double rate, struct fit_data *data,
                     struct problem *problem)
{
    *data = (struct fit_data){.points = 0};
    struct csv_table *csv = csv_named(query->scene, query->run_context, name, &speeds, problem);
    if (csv) {
        const int *column = csv->column;
        const bool of_rows = !column[DOMINO] && (column[GAP] || column[PITCH] || column[DOMINOES]);
        data->kind = csv->kind == &speeds ? FIT_SPEEDS : of_rows ? FIT_TOTALS : FIT_HITS;
        data->has_pitch = column[PITCH];
    }
    while (csv && csv_next(csv) && row_add(query, data, csv, rate)) {
    }
    /* Single lines have too few trials to tell how large their errors are, so all lines share one relative
     * spread. */
    if (csv && csv->trials > 1) {
        data->has_errors = csv->squares > 0;
        data->spread = data->has_errors ? sqrt((double)csv->squares / csv->freedom) : 0;
        for (size_t k = 0; k < data->points; k++)
            data->point[k].error *= data->spread;
    }
    return csv_end(csv, problem);
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
    {"friction_push", "",
     "the correlation of friction and push; every pair of fitted parameters has a column", 0},
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

/* The keys of the columns for standard deviations and correlations. */
struct fit_keys {
    char deviation[FIT_UNKNOWNS][32], correlation[FIT_UNKNOWNS * FIT_UNKNOWNS][64];
};

/* Makes the columns for the kind of measurement. csv and json also have columns for the fitted values. A
 * table has sentences below it instead. */
static void columns_make(struct answer *a, const struct fit *f, struct fit_keys *keys)
{
    struct column *c = answer_columns(a, fit_columns) + UNKNOWN;
    for (int i = 0, n = 0; i < f->unknowns && !answer_for_people(a); i++) {
        const struct parameter *p = f->unknown[i].parameter;
        snprintf(keys->deviation[i], sizeof keys->deviation[i], "%.24s_sd", p->name);
        *c++ = (struct column){p->name, "", "a fitted value", 0};
        *c++ = (struct column){keys->deviation[i], "", "the standard deviation of the fitted value", 0};
        for (int j = 0; j < i; j++, n++) {
            snprintf(keys->correlation[n], sizeof keys->correlation[n], "%.24s_%.24s",
                     f->unknown[j].parameter->name, p->name);
            *c++ = (struct column){keys->correlation[n], "", "a correlation", 0};
        }
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
            for (int v = 0; v < u; v++)
                cell[n++] = cell_narrow((domq_real)f->correlation[v][u], 4);
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

bool fit_make(const struct query *query, struct fit *f, struct problem *problem)
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

void fit_free(struct fit *f)
{
    free(f->data.point);
    free(f->data.run);
    free(f->computed);
}

bool run_fit(const struct query *query, struct answer *a, struct problem *problem)
{
    struct fit f;
    struct fit_keys keys;
    const bool done = fit_make(query, &f, problem);
    if (done) {
        columns_make(a, &f, &keys);
        rows_write(a, &f);
        values_say(a, &f);
        residuals_say(a, &f);
    }
    fit_free(&f);
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
     .see = "plot solve duration fall sensitivity",
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
