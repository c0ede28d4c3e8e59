/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'plot', which makes the chart of a plot from its rows. */
#include "interpreter/feature.h"
#include "pictures/plots/plots.h"
#include <stdlib.h>
#include <string.h>

/* ---- The rows as numbers ---- */

static bool rows_grow(struct plot_rows *rows, size_t room)
{
    struct plot_row *more = realloc(rows->row, room * sizeof *more);
    rows->failed = rows->failed || !more;
    if (!more)
        return false;
    rows->row = more;
    rows->room = room;
    return true;
}

void plot_rows_by_point(struct plot_rows *rows, size_t points)
{
    rows->is_by_point = true;
    rows->count = rows_grow(rows, points) ? points : 0;
    for (size_t k = 0; k < rows->count; k++)
        for (int i = 0; i < ANSWER_COLUMNS; i++)
            rows->row[k].number[i] = (double)NAN;
}

/* A callback that receives the rows of a plot, instead of the output format. The points of a sweep are
 * computed in several threads. They write to different elements of rows->row, and only point 0 writes the
 * keys. */
static void row_keep(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)reason;
    struct plot_rows *rows = a->sink.context;
    const size_t at = rows->is_by_point ? a->sink.point : rows->count;
    char text[CELL_TEXT];
    if (rows->is_by_point ? at >= rows->count : at == rows->room && !rows_grow(rows, 2 * at + 64))
        return;
    struct plot_row *row = &rows->row[at];
    *row = (struct plot_row){.word = ""};
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        const bool angle = column_is_angle(c),
                   number = cells[i].kind == CELL_REAL || cells[i].kind == CELL_COUNT;
        const domq_real value = angle ? style_angle(&a->style, cells[i].number) : cells[i].number;
        row->number[i] = number ? (double)value : (double)NAN;
        if (at > 0)
            continue;
        snprintf(rows->key[i], sizeof rows->key[i], "%s", c->key);
        snprintf(rows->unit[i], sizeof rows->unit[i], "%s%s", angle ? style_angle_unit(&a->style) : "",
                 c->unit + (angle ? strlen("rad") : 0));
    }
    if (cells[0].kind != CELL_NONE)
        snprintf(row->word, sizeof row->word, "%s", cell_plain(&a->style, cells[0], text));
    rows->count += !rows->is_by_point;
}

int plot_column(const struct plot_rows *rows, const char *key)
{
    for (int i = 0; key && i < ANSWER_COLUMNS && *rows->key[i]; i++)
        if (strcmp(rows->key[i], key) == 0)
            return i;
    return -1;
}

/* ---- Axes and curves ---- */

/* Chooses a unit that suits the largest number of an axis. Returns this unit as a multiple of the column's
 * own unit. Writes the label of the axis, unless the plot has already written it. */
static double axis_label(struct chart_axis *to, const struct plot_axis *axis, const struct answer *a,
                         double largest)
{
    const struct column *c = a->columns;
    while (axis->key && c->key && strcmp(c->key, axis->key) != 0)
        c++;
    const char *unit = axis->key && c->key ? c->unit : "", *over = "";
    double size = 1;
    if (axis->percent || strcmp(unit, "m") == 0) {
        struct axis_unit chosen = axis->percent ? (struct axis_unit){"%", 0.01} : measure_axis(largest);
        unit = chosen.name;
        size = chosen.size;
    } else if (*unit && column_is_angle(c)) { /* the numbers are already in the session's unit of angles */
        over = unit + strlen("rad");
        unit = style_angle_unit(&a->style);
    }
    if (!*to->label)
        snprintf(to->label, sizeof to->label, "%s%s%s%s", axis->label, *unit ? " in " : "", unit, over);
    return size;
}

/* Adds the points of the rows to the curves that the table of the plot defines, and labels the axes. */
static void curves_fill(const struct plot *plot, const struct plot_rows *rows, const struct answer *a,
                        struct chart *chart)
{
    for (int k = 0; k < PLOT_CURVES && plot->curve[k].title; k++) {
        const struct plot_curve *from = &plot->curve[k];
        int x = plot_column(rows, plot->x.key), y = plot_column(rows, from->key);
        for (size_t i = 0; i < rows->count && y >= 0; i++)
            chart_point(chart, &chart->curve[k], rows->row[i].number[x], rows->row[i].number[y]);
    }
    double x = 0, y = 0;
    for (int k = 0; k < chart->curves; k++)
        for (size_t i = 0; i < chart->curve[k].count; i++) {
            const struct chart_point *p = &chart->curve[k].point[i];
            x = fmax(x, isfinite(p->x) ? p->x : 0);
            y = fmax(y, p->y);
        }
    chart->x.unit = axis_label(&chart->x, &plot->x, a, x);
    chart->y.unit = axis_label(&chart->y, &plot->y, a, y);
}

/* ---- The command ---- */

/* Returns plot number k of all features, counted from 0, or NULL if there are no more. */
static const struct plot *plot_at(int k)
{
    const struct feature *f;
    for (int i = 0; (f = feature_at(i)) != NULL; i++)
        for (const struct plot *const *table = f->plots; table && *table; table++)
            for (const struct plot *plot = *table; plot->name; plot++)
                if (k-- == 0)
                    return plot;
    return NULL;
}

static const char *plot_names(const void *context, int k)
{
    (void)context;
    const struct plot *plot = plot_at(k);
    return plot ? plot->name : NULL;
}

static const struct column *plot_columns(int k, const char **name, const char **summary)
{
    const struct plot *plot = plot_at(k);
    if (!plot)
        return NULL;
    *name = plot->name;
    *summary = plot->summary;
    return plot->columns;
}

/* The argument of the plot is parsed and bound as that of a command. */
static bool more_parse(struct reader *r, struct question *q)
{
    const struct plot *plot = plot_at((int)q->item[0].number);
    return plot->argument ? plot->argument->parse(r, q)
                          : problem_error(r->problem, "'plot %s' takes no arguments", plot->name);
}

static bool more_bind(const struct question *q, const struct query *query, struct arguments *given,
                      struct problem *problem)
{
    const struct plot *plot = plot_at((int)q->item[0].number);
    return !plot->argument->bind || plot->argument->bind(q, query, given, problem);
}

/* As csv or json, a plot is its rows. */
static bool run_plot(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct plot *plot = plot_at((int)query->given->number[0]);
    a->columns = plot->columns;
    a->style.errors = 0; /* a picture shows no errors */
    if (!answer_for_people(a))
        return plot->run(query, a, NULL, problem);
    if (!picture_ready(a, problem))
        return false;
    struct plot_rows rows = {.count = 0};
    struct chart chart = chart_make();
    struct answer answer = *a;
    answer.sink.take = row_keep;
    answer.sink.context = &rows;
    snprintf(chart.title, sizeof chart.title, "%s", plot->title);
    for (int k = 0; k < PLOT_CURVES && plot->curve[k].title; k++) {
        const struct plot_curve *c = &plot->curve[k];
        chart_curve(&chart, c->kind, c->ink, c->dash, "%s", c->title);
    }
    bool done = plot->run(query, &answer, &chart, problem) &&
                (!rows.failed || problem_status(problem, query->scene, DOM_NO_MEMORY));
    if (done && plot->draw)
        done = plot->draw(query, &rows, &chart, problem);
    else if (done && plot->x.key)
        curves_fill(plot, &rows, a, &chart);
    free(rows.row);
    if (done)
        return chart_show(&chart, a, query->scene->compute.interrupt, problem);
    chart_free(&chart);
    return false;
}

/* Each plot has its own columns. */
static const struct column no_columns[] = {{NULL, NULL, NULL, 0}};

static const struct command plot_commands[] = {
    {.name = "plot",
     .synonyms = "picture image graph figure chart diagram svg png pdf gnuplot",
     .argument =
         {{.name = "WHAT", .kind = ARGUMENT_CHOICE, .noun = "picture", .choices = plot_names},
          {.name = "MORE", .kind = ARGUMENT_GRID, .optional = true, .parse = more_parse, .bind = more_bind}},
     .summary = "a chart of the row, of limits, of a cycle, or of any sweep",
     .help =
         "The picture appears in the terminal. 'plot fall > fall.svg' makes a file with gnuplot: "
         ".svg, .png or .pdf. The extensions .csv and .json give the data. The extension .gp gives gnuplot's "
         "script with the data, for you to change: its title, the ranges and scales of its axes, its size "
         "and its fonts.",
     .equation = "(19; c1) (20; c2) (21; c3) (27; A2), figures 'growth' and 'marginal'",
     .example = "plot growth",
     .see = "fall sweep curve fit draw",
     .sweep.refusal = "it draws",
     .writes = WRITES_PICTURES,
     .rows = true,
     .columns = no_columns,
     .parts = plot_columns,
     .run = run_plot},
    {.name = NULL},
};

/* ---- The feature ---- */

extern const struct command draw_commands[];

static const struct command_group groups[] = {
    {"The train in pictures", "pictures", draw_commands},
    {"Curves", "pictures", plot_commands},
    {NULL, NULL, NULL},
};

extern const struct plot train_plots[];

static const struct plot *const plots[] = {train_plots, NULL};

const struct feature pictures_feature = {.name = "pictures", .groups = groups, .plots = plots};
