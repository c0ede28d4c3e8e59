/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the measurements of 'fit'. */
#include "fit/fit.h"
#include "tables/csv_named.h"
#include <stdlib.h>

#define SPEED  "m/s", "m/s, cm/s, mm/s, ft/s", "m/s", "write a speed such as 1.3 m/s"
#define TIME   "s", "s, ms", "s", "write a time such as 0.12 s"
#define ANGLE  "rad", "deg, rad", "deg", "write an angle such as 12 deg"
#define PLAIN  "", "none", "", "write a plain number"
#define FRAMES "", "none", "", "write the number of frames per second, such as 240"

#define GAP_COLUMNS(traits)                                                                                  \
    {"gap", CSV_ONE_OF | (traits),     CSV_LENGTH, "write a length such as 9 mm", CSV_ABOVE_0,               \
     1e9,   "more than 0, up to 1e9 m"},                                                                     \
    {                                                                                                        \
        "pitch", CSV_ONE_OF, CSV_LENGTH, "write a length such as 16.5 mm", CSV_ABOVE_0, 1e9,                 \
            "more than 0, up to 1e9 m"                                                                       \
    }
#define ERROR_COLUMN(unit, highest, range)                                                                   \
    {                                                                                                        \
        "error", CSV_EMPTY, unit, CSV_ABOVE_0, highest, "more than 0, up to " range                          \
    }

/* The columns of files with hits or angles. TIMED_COLUMNS and ERROR are in both kinds of files, ANGLE_AT only
 * in files with angles. */
enum { DOMINO, TIME_AT, FRAME, RATE, RUN, GAP, PITCH, ERROR, ANGLE_AT };
#define TIMED_COLUMNS(domino_traits, time_traits)                                                            \
    [DOMINO] = {"domino", CSV_WHOLE | (domino_traits), PLAIN, 1, 1e6, "1 .. 1e6"},                           \
    [TIME_AT] = {"time", CSV_EMPTY | CSV_BARE | (time_traits), TIME, -1e9, 1e9, "-1e9 .. 1e9 s"},            \
    [FRAME] = {"frame", CSV_EMPTY, PLAIN, -1e12, 1e12, "-1e12 .. 1e12"},                                     \
    [RATE] = {"rate", 0, FRAMES, CSV_ABOVE_0, 1e9, "more than 0, up to 1e9"},                                \
    [RUN] = {"run", 0, PLAIN, -1e12, 1e12, "-1e12 .. 1e12"}, [GAP] = GAP_COLUMNS(0)

static const struct csv_column hit_columns[] = {
    TIMED_COLUMNS(CSV_REQUIRED | CSV_EMPTY, 0),
    [ERROR] = ERROR_COLUMN(TIME, 1e9, "1e9 s"),
};
static const struct csv_column angle_columns[] = {
    TIMED_COLUMNS(0, 0),
    [ERROR] = ERROR_COLUMN(ANGLE, 10, "10 rad"),
    [ANGLE_AT] = {"angle", CSV_REQUIRED | CSV_EMPTY, ANGLE, -10, 10, "-10 .. 10 rad"},
};
static const struct csv_column sound_columns[] = {
    TIMED_COLUMNS(0, CSV_REQUIRED),
    [ERROR] = ERROR_COLUMN(TIME, 1e9, "1e9 s"),
};

/* The columns of files in which each line is about a row. */
enum { R_GAP, R_PITCH, R_VALUE, R_ERROR, R_SHARE, R_DOMINOES };
#define SHARE_COLUMN                                                                                         \
    {                                                                                                        \
        "error %", CSV_EMPTY, "", "%", "%", "write a percentage such as 5 %", CSV_ABOVE_0, 1,                \
            "more than 0, up to 100 %"                                                                       \
    }
static const struct csv_column speed_columns[] = {
    [R_GAP] = GAP_COLUMNS(CSV_REQUIRED),
    [R_VALUE] = {"speed", CSV_REQUIRED | CSV_REPEATED, SPEED, CSV_ABOVE_0, 3e8, "more than 0, up to 3e8 m/s"},
    [R_ERROR] = ERROR_COLUMN(SPEED, 3e8, "3e8 m/s"),
    [R_SHARE] = SHARE_COLUMN,
};
static const struct csv_column total_columns[] = {
    [R_GAP] = GAP_COLUMNS(CSV_REQUIRED),
    [R_VALUE] = {"time", CSV_REQUIRED | CSV_REPEATED | CSV_BARE, TIME, CSV_ABOVE_0, 1e9,
                 "more than 0, up to 1e9 s"},
    [R_ERROR] = ERROR_COLUMN(TIME, 1e9, "1e9 s"),
    [R_SHARE] = SHARE_COLUMN,
    [R_DOMINOES] = {"dominoes", CSV_WHOLE, PLAIN, 2, 1e5, "2 .. 100000"},
};

#define COUNT_OF(array) (int)(sizeof(array) / sizeof *(array))

static const struct csv_kind sounds = {
    .column = sound_columns,
    .columns = COUNT_OF(sound_columns),
    .rows_most = FIT_POINTS,
    .item = "hit",
    .items = "hits",
    .names = "time (s), and, if needed, run, gap (mm), error (s)",
    .example = "time (s)",
};
static const struct csv_kind totals = {
    .column = total_columns,
    .columns = COUNT_OF(total_columns),
    .rows_most = FIT_POINTS,
    .item = "measured row",
    .items = "times",
    .names = "gap (mm) or pitch (mm), dominoes, time (s), and, if known, error (s) or error (%)",
    .example = "gap (mm), dominoes, time (s)",
    .otherwise = &sounds,
};
static const struct csv_kind hits = {
    .column = hit_columns,
    .columns = COUNT_OF(hit_columns),
    .rows_most = FIT_POINTS,
    .item = "measurement",
    .items = "measurements",
    .names = "domino, time (s) or frame, and, if needed, rate, run, gap (mm), error (s)",
    .example = "domino, time (s)",
    .otherwise = &totals,
};
static const struct csv_kind angles = {
    .column = angle_columns,
    .columns = COUNT_OF(angle_columns),
    .rows_most = FIT_POINTS,
    .item = "measurement",
    .items = "measurements",
    .names = "time (s) or frame, angle (deg), and, if needed, rate, domino, run, gap (mm), error (deg)",
    .example = "time (s), angle (deg)",
    .otherwise = &hits,
};
static const struct csv_kind speeds = {
    .column = speed_columns,
    .columns = COUNT_OF(speed_columns),
    .rows_most = FIT_POINTS,
    .item = "measured row",
    .items = "speeds",
    .names = "gap (mm), speed (m/s), and, if known, error (m/s)",
    .example = "gap (mm), speed (m/s)",
    .otherwise = &angles,
};

void fit_data_free(struct fit_data *data)
{
    free(data->point);
    free(data->run);
}

static bool point_add(struct fit_data *d, struct csv_table *csv, struct fit_point point, int error_column)
{
    const bool known = point.error > 0;
    if (d->points > 0 && known != d->has_errors)
        return csv_wrong(&csv->file, csv_cell(csv, error_column).at,
                         "some %s have an error and some have none; give an error to all of them, or to none",
                         csv->kind->items);
    struct fit_point *more = realloc(d->point, (d->points + 1) * sizeof *more);
    if (!more)
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    d->has_errors = known;
    d->point = more;
    point.run = d->runs - 1;
    point.line = csv->row.at.line;
    point.repeats = csv->repeated > 0 ? csv->repeated : 1;
    d->point[d->points++] = point;
    return true;
}

/* Adds the current row of the file to the last run. If the row has a different run number, begins a new run
 * with it. */
static bool run_follow(struct fit_data *d, struct csv_table *csv, double gap)
{
    const double number = !fit_has_rows(d) && csv->column[RUN] ? (double)csv->value[RUN] : 1;
    struct fit_run *last = d->run && d->runs > 0 ? &d->run[d->runs - 1] : NULL;
    if (last && last->number == number) {
        last->count++;
        return fit_has_rows(d) || !(last->gap != gap && !isnan(gap)) ||
               csv_wrong(&csv->file, csv_cell(csv, GAP).at,
                         "run %g has two gaps; give each run a single gap, or leave out the column and enter "
                         "the row with 'set row'",
                         number);
    }
    for (size_t k = 0; d->run && k < d->runs; k++)
        if (d->run[k].number == number)
            return csv_wrong(&csv->file, csv_cell(csv, RUN).at,
                             "the lines of run %g are interrupted by another run; put them together", number);
    struct fit_run *more = realloc(d->run, (d->runs + 1) * sizeof *more);
    if (!more)
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    d->run = more;
    d->run[d->runs++] = (struct fit_run){.number = number, .gap = gap, .first = d->points, .count = 1};
    return true;
}

/* Finds the time of the current row of the file. If the row has no time, divides its frame number by the
 * frame rate. If the row has no frame number either, sets *time to NaN. */
static bool time_find(struct csv_table *csv, double rate, double *time)
{
    const double frame = csv->column[FRAME] ? (double)csv->value[FRAME] : (double)NAN;
    *time = csv->column[TIME_AT] ? (double)csv->value[TIME_AT] : (double)NAN;
    if (csv->column[RATE])
        rate = (double)csv->value[RATE];
    if (!csv->column[TIME_AT] && !csv->column[FRAME])
        return csv_wrong(&csv->file, csv->head.at,
                         "there is neither a column 'time (s)' nor a column 'frame'");
    if (isnan(*time) && !isnan(frame) && isnan(rate))
        return csv_wrong(&csv->file, csv_cell(csv, FRAME).at,
                         "frames need a frame rate: enter 'fit ... FILE 240' for 240 frames per second, or "
                         "add a column 'rate'");
    *time = isnan(*time) ? frame / rate : *time;
    return true;
}

/* Finds the gap of the row that the current line of the file is about, from column `gap` or the next one,
 * which is the pitch. Sets *gap to NaN if the file has neither. */
static bool gap_find(const struct query *query, struct fit_data *d, struct csv_table *csv, int gap_column,
                     double *gap)
{
    const struct scene *scene = query->scene;
    const int pitch_column = gap_column + 1;
    const domq_real thickness = scene->train.d * scene->scale.h, pitch = csv->value[pitch_column];
    d->has_pitch = csv->column[pitch_column];
    *gap = (double)(d->has_pitch ? pitch - thickness : csv->value[gap_column]);
    return !d->has_pitch || pitch > thickness ||
           csv_wrong(
               &csv->file, csv_cell(csv, pitch_column).at,
               "the pitch %s must exceed the thickness of a domino, d h = %s; 'set d' changes the thickness",
               measured(pitch, "m", 6).text, measured(thickness, "m", 6).text);
}

/* Adds the measurement of a row: its speed, or how long it takes to fall. */
static bool measured_row_add(const struct query *query, struct fit_data *d, struct csv_table *csv)
{
    const domq_real *value = csv->value;
    const bool has_share = csv->column[R_SHARE];
    const int error_column = has_share ? R_SHARE : R_ERROR;
    const struct effect_state *row = &query->scene->effect[DOM_EFFECT_row];
    struct fit_point point = {.measured = (double)value[R_VALUE], .error = (double)value[R_ERROR]};
    const char *twice = has_share && csv->column[R_ERROR] ? "error and error %"
                        : csv->repeated > 0 && csv->column[error_column]
                            ? "repeated measurements, whose spread is their error, and a column of errors"
                            : NULL;
    if (twice)
        return csv_wrong(&csv->file, csv->head.cell[csv->column[error_column] - 1].at,
                         "both %s are given; leave one of them out", twice);
    if (has_share)
        point.error = (double)value[R_SHARE] * point.measured;
    if (d->kind == FIT_TOTALS)
        point.domino = csv->column[R_DOMINOES]                   ? (size_t)value[R_DOMINOES]
                       : row->on && !query->scene->listed.domino ? (size_t)row->value[0]
                                                                 : 0;
    if (d->kind == FIT_TOTALS && point.domino == 0)
        return csv_wrong(&csv->file, csv->head.at,
                         "how many dominoes fell in this time? Add a column 'dominoes', or enter, for "
                         "example, 'set row 28'");
    return gap_find(query, d, csv, R_GAP, &point.gap) && run_follow(d, csv, (double)NAN) &&
           point_add(d, csv, point, error_column);
}

/* Adds the measurement in the current row of the file, unless its value or its time is missing. */
static bool row_add(const struct query *query, struct fit_data *d, struct csv_table *csv, double rate)
{
    const domq_real *value = csv->value;
    double gap;
    if (fit_has_rows(d))
        return measured_row_add(query, d, csv);
    struct fit_point point = {.domino = d->kind == FIT_ANGLES, .error = (double)value[ERROR]};
    if (csv->column[DOMINO] && !isnan((double)value[DOMINO]))
        point.domino = (size_t)value[DOMINO];
    if (!gap_find(query, d, csv, GAP, &gap) || !time_find(csv, rate, &point.time))
        return false;
    point.measured = d->kind == FIT_HITS ? point.time : (double)value[ANGLE_AT];
    if (isnan(point.time) || isnan(point.measured))
        return true;
    if (!run_follow(d, csv, gap))
        return false;
    struct fit_run *run = &d->run[d->runs - 1];
    const struct fit_point *last = run->count > 1 ? &d->point[d->points - 1] : NULL;
    if (d->kind == FIT_HITS && last && point.domino > 0 && last->domino >= point.domino)
        return csv_wrong(
            &csv->file, csv_cell(csv, DOMINO).at,
            "domino %zu comes after domino %zu; list the dominoes of a run in the order in which "
            "they are hit, each once",
            point.domino, last->domino);
    if (last && (d->kind == FIT_HITS || last->domino == point.domino) && last->time >= point.time)
        return csv_wrong(&csv->file, csv->row.at,
                         "the time %g s is not later than %g s, the time on the line above", point.time,
                         last->time);
    if (point.domino > run->dominoes)
        run->dominoes = point.domino;
    return point_add(d, csv, point, ERROR);
}

/* The relative deviations of repeated measurements from their means. */
struct repeats {
    double squares;
    size_t freedom;
};

static void repeats_add(struct repeats *r, const struct csv_table *csv)
{
    if (csv->repeated > 1) {
        const double mean = (double)csv->value[R_VALUE];
        r->squares += (double)csv->squares / (mean * mean);
        r->freedom += (size_t)csv->repeated - 1;
    }
}

/* Gives each mean its error. Single lines have too few trials to tell how large their errors are, so all
 * lines share one relative spread. */
static void repeats_end(const struct repeats *r, struct fit_data *d)
{
    if (!(r->squares > 0))
        return;
    d->has_errors = true;
    d->spread = sqrt(r->squares / (double)r->freedom);
    for (size_t k = 0; k < d->points; k++)
        d->point[k].error = d->spread * d->point[k].measured / sqrt(d->point[k].repeats);
}

/* For qsort: by time, and then by domino. */
static int earlier(const void *one, const void *other)
{
    const struct fit_point *a = one, *b = other;
    return a->time < b->time ? -1 : a->time > b->time ? 1 : (a->domino > b->domino) - (a->domino < b->domino);
}

bool fit_read(const struct query *query, const char *name, double rate, struct fit_data *data,
              struct problem *problem)
{
    *data = (struct fit_data){.points = 0};
    struct csv_table *csv = csv_named(query->scene, query->run_context, name, false, &speeds, problem);
    if (csv)
        data->kind = csv->kind == &speeds   ? FIT_SPEEDS
                     : csv->kind == &totals ? FIT_TOTALS
                     : csv->kind == &angles ? FIT_ANGLES
                                            : FIT_HITS;
    struct repeats repeats = {0};
    while (csv && csv_next(csv) && row_add(query, data, csv, rate))
        repeats_add(&repeats, csv);
    repeats_end(&repeats, data);
    /* The file may list the angles of one domino after the angles of another. */
    for (size_t k = 0; k < data->runs && data->kind == FIT_ANGLES; k++)
        qsort(&data->point[data->run[k].first], data->run[k].count, sizeof *data->point, earlier);
    return csv_end(csv, problem);
}
