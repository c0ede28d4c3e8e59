/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The plots of the command 'plot'. A plot computes rows. They are written as csv or json, or drawn as a
 * chart.
 *
 * To add a plot, write its plot_run and its columns, and add an entry to the table at the end of its file.
 */
#pragma once

#include "interpreter/question.h"
#include "pictures/picture/chart.h"

/* Computes the rows of a plot and writes them to the answer `a`. For csv and json, nothing else is needed,
 * and `chart` is NULL. Otherwise the function also adds notes and marks to the chart. Unless plot.x.key is
 * NULL, the command then adds the curves that struct plot lists. On failure, plot_run sets *problem and
 * returns false. */
typedef bool plot_run(const struct query *query, struct answer *a, struct chart *chart,
                      struct problem *problem);

/* Returns the number in a cell of a column, or NaN if the cell has none. Angles are in the session's unit. */
double plot_number(const struct answer *a, int column, struct cell cell);

struct plot_axis {
    /* Key of the column that belongs to the axis. It gives the unit of the axis, and for an x axis also the
     * values. NULL for a y axis that has no unit. */
    const char *key;
    const char *label; /* without a unit; if the axis has a unit, " in m" or the like is appended */
    bool percent;      /* show the numbers as percentages */
};

/* A curve that shows the column `key`. */
struct plot_curve {
    const char *key, *title;
    enum chart_kind kind;
    enum ink ink;
    int dash;
};

enum { PLOT_CURVES = 5 };

struct plot {
    const char *name;
    plot_run *run;
    const char *summary; /* for 'help plot' */
    const struct column *columns;
    const char *title;
    struct plot_axis x, y;                /* if x.key is NULL, `run` makes the curves */
    struct plot_curve curve[PLOT_CURVES]; /* if there are fewer curves, a NULL title ends the list */
    const struct argument *argument;      /* the argument that may follow the plot's name, or NULL */
};

/* Checks that the train moves, and that its head reaches the tilt theta. */
bool train_comes_to(const struct query *query, struct problem *problem, domq_real theta);

/* The entries of plots leave out members. */
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
