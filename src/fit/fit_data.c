/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the measurements of 'fit', and numbers the hits of a sound. */
#include "fit/fit.h"
#include "language/quad.h"
#include "tables/csv.h"
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <stdlib.h>

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
    .names = "domino, time (s) or frame, and, if needed, rate, run, gap (mm), error (s)",
};
static const struct csv_kind speeds = {
    .column = speed_columns,
    .columns = sizeof speed_columns / sizeof *speed_columns,
    .rows_most = POINTS_MOST,
    .names = "gap (mm), speed (m/s), and, if known, error (m/s); or gap (mm), dominoes, time (s); or domino, "
             "time (s); or, for the hits of a sound, only time (s)",
    .otherwise = &times,
};

/* Adds a measurement to the last run or, if its run or its gap is another one, to a new run. */
static bool point_add(struct fit_data *d, struct csv_table *csv, struct fit_point point)
{
    const double number = csv->column[RUN] ? (double)csv->value[RUN] : 1,
                 gap = fit_has_rows(d) ? (double)NAN : point.gap;
    const bool known = point.error > 0;
    const size_t now = d->runs - 1;
    if (d->runs == 0 || d->run[now].number != number || (d->run[now].gap != gap && !isnan(gap)))
        d->run[d->runs++] = (struct fit_run){.number = number, .gap = gap, .first = d->points};
    struct fit_run *run = &d->run[d->runs - 1];
    const bool follows = d->kind == FIT_HITS && run->count > 0;
    const struct fit_point *last = &d->point[d->points - follows];
    if (d->points > 0 && known != d->has_errors)
        return csv_wrong(
            &csv->file, csv_cell(csv, csv->column[SHARE] ? SHARE : ERROR).at,
            "some lines have an error and some have none; give an error to all of them, or to none");
    if (follows && point.domino > 0 && last->domino >= point.domino)
        return csv_wrong(
            &csv->file, csv_cell(csv, DOMINO).at,
            "domino %zu comes after domino %zu; list the dominoes of a run in the order in which "
            "they are hit, each once",
            point.domino, last->domino);
    if (follows && last->measured >= point.measured)
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
    if (d->kind == FIT_HITS && (csv->trials > 1 || csv->column[SHARE]))
        return csv_wrong(&csv->file, csv->head.at,
                         "hits have one column 'time (s)', and errors in s; number repeated runs in a column "
                         "'run'; times of whole rows need the columns 'gap (mm)' and 'dominoes'");
    if (csv->column[SHARE])
        point.error = (double)value[SHARE] * point.measured;
    else if (csv->trials > 1 && !csv->column[ERROR]) /* the error is known, apart from the spread */
        point.error = point.measured / sqrt(csv->repeated);
    if (d->kind == FIT_HITS && !isnan((double)value[DOMINO]))
        point.domino = (size_t)value[DOMINO];
    else if (d->kind == FIT_TOTALS && csv->column[DOMINOES])
        point.domino = (size_t)value[DOMINOES];
    else if (d->kind == FIT_TOTALS && row->on && !row_has_file(scene))
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

bool fit_read(const struct query *query, const char *name, double rate, struct fit_data *data,
              struct problem *problem)
{
    *data = (struct fit_data){.point = calloc(POINTS_MOST, sizeof *data->point),
                              .run = calloc(POINTS_MOST, sizeof *data->run)};
    if (!data->point || !data->run)
        return query_status(query, problem, DOM_NO_MEMORY);
    struct csv_table *csv = csv_named(query->run_context, name, &speeds, problem);
    bool is_spread = false;
    if (csv) {
        const int *column = csv->column;
        is_spread = csv->trials > 1 && !column[ERROR] && !column[SHARE];
        const bool of_rows = !column[DOMINO] && (column[GAP] || column[PITCH] || column[DOMINOES]);
        data->kind = csv->kind == &speeds ? FIT_SPEEDS : of_rows ? FIT_TOTALS : FIT_HITS;
        data->has_pitch = column[PITCH];
    }
    while (csv && csv_next(csv) && row_add(query, data, csv, rate)) {
    }
    /* Single lines have too few trials to tell how large their errors are, so all lines share one relative
     * spread. */
    if (is_spread) {
        data->has_errors = csv->squares > 0;
        data->spread = data->has_errors ? sqrt((double)csv->squares / csv->freedom) : 0;
        for (size_t k = 0; k < data->points; k++)
            data->point[k].error *= data->spread;
    }
    return csv_end(csv, problem);
}

/* ---- Sounds ---- */

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
    char what[256];
    snprintf(what, sizeof what, "%s:%ld: this hit would be that of domino %zu or a later one", shown,
             hit->line, last + 1);
    return hit->domino == 0
               ? fit_ends(problem, what, &row->verdict)
               : hit->domino > d ||
                     problem_no_answer(problem,
                                       "%s:%ld: domino %zu comes after domino %zu, which the line before has",
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
