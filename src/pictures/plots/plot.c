/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'plot', which makes the chart of a plot from its rows. */
#include "interpreter/command.h"
#include "pictures/plots/plots.h"
#include <string.h>

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

double plot_number(const struct answer *a, int column, struct cell cell)
{
    if (cell.kind != CELL_REAL && cell.kind != CELL_COUNT)
        return (double)NAN;
    return (double)(column_is_angle(&a->columns[column]) ? style_angle(&a->style, cell.number) : cell.number);
}

/* What receives the rows of a plot, instead of the output format. */
struct curves {
    const struct plot *plot;
    struct chart *chart;
    double x, y; /* the largest numbers */
};

/* Adds a row to the curves that the table of the plot defines. */
static void row_draw(struct answer *a, const struct cell *cells, const char *reason)
{
    struct curves *c = a->sink.context;
    double x = 0;
    (void)reason;
    for (int i = 0; c->plot->x.key && a->columns[i].key; i++)
        if (strcmp(a->columns[i].key, c->plot->x.key) == 0)
            x = plot_number(a, i, cells[i]);
    c->x = fmax(c->x, x);
    for (int k = 0; k < PLOT_CURVES && c->plot->curve[k].title; k++)
        for (int i = 0; a->columns[i].key; i++)
            if (strcmp(a->columns[i].key, c->plot->curve[k].key) == 0) {
                const double y = plot_number(a, i, cells[i]);
                chart_point(c->chart, &c->chart->curve[k], x, y);
                c->y = fmax(c->y, y);
            }
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
    struct chart chart = chart_make();
    struct curves curves = {.plot = plot, .chart = &chart};
    struct answer answer = *a;
    answer.sink.take = row_draw;
    answer.sink.context = &curves;
    snprintf(chart.title, sizeof chart.title, "%s", plot->title);
    for (int k = 0; k < PLOT_CURVES && plot->curve[k].title; k++) {
        const struct plot_curve *c = &plot->curve[k];
        chart_curve(&chart, c->kind, c->ink, c->dash, "%s", c->title);
    }
    if (!plot->run(query, &answer, &chart, problem)) {
        chart_free(&chart);
        return false;
    }
    if (plot->x.key) {
        chart.x.unit = axis_label(&chart.x, &plot->x, a, curves.x);
        chart.y.unit = axis_label(&chart.y, &plot->y, a, curves.y);
    }
    return chart_show(&chart, a, problem);
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

static const struct first_line first[] = {
    {5, "draw", "a picture of the train; 'draw > train.svg' writes a file", false},
    {0, NULL, NULL, false},
};

const struct feature pictures_feature = {
    .name = "pictures", .groups = groups, .first = first, .plots = plots};
