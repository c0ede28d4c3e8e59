/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The pictures of 'plot'. A plot is a function that writes rows, and a table of labels and curves. Programs
 * get the rows as csv or json; for people plot_draw reads the same rows, and draws a chart of them.
 */
#ifndef SHELL_PLOTS_H
#define SHELL_PLOTS_H

#include "interpreter/question.h"
#include "picture/show.h"

/*
 * Writes the rows of a plot. For people `chart` is the chart in which plot_draw will put the rows: the
 * function adds what only it knows, such as a note, and points of its own. For programs `chart` is NULL.
 * Returns false after describing a problem.
 */
typedef bool plot_run(const struct query *query, struct answer *a, struct chart *chart,
                      struct problem *problem);
plot_run plot_energy, plot_omega, plot_inertia, plot_chain;
plot_run plot_growth, plot_marginal;
plot_run plot_cost;
plot_run plot_fall, plot_speed, plot_gaps;
plot_run plot_placement;
plot_run plot_sweep_rows;

/* The rows of an answer as numbers. */
struct plot_rows {
    char key[ANSWER_COLUMNS][64]; /* names of the columns; "" after the last one */
    struct plot_row {
        double number[ANSWER_COLUMNS]; /* NaN for a word or a missing number; angles in the session's unit */
        char word[32];                 /* the first cell as csv would write it */
    } * row;
    size_t count;
};

/* Returns the index of the column with this key, or -1. */
int plot_column(const struct plot_rows *rows, const char *key);

struct plot_axis {
    const char *key;   /* the column with the unit of the axis, and with x; NULL for a pure number */
    const char *label; /* to which "in" and the unit are added */
    bool percent;
};

/* A curve through the column `key`. Ranges end at the columns "low" and "high". */
struct plot_curve {
    const char *key, *title;
    enum chart_kind kind;
    enum ink ink;
    int dash;
    int series; /* unless 0, the curve takes the rows whose first number is one less than this */
};

enum { PLOT_CURVES = 5 };

struct plot {
    const char *name;
    plot_run *run;
    const char *keys; /* the columns of its data */
    const char *title;
    struct plot_axis x, y;                /* without a key of x, the function makes the curves itself */
    struct plot_curve curve[PLOT_CURVES]; /* ends with a NULL title if there are fewer */
    /* Unless NULL, makes the chart of the rows in place of the axes and curves above. */
    bool (*draw)(const struct query *query, const struct plot_rows *rows, struct chart *chart,
                 struct problem *problem);
    const struct argument *argument; /* what may follow its name, or NULL */
};

/* Answers with the rows of a plot, or draws them for people. */
bool plot_draw(const struct plot *plot, const struct query *query, struct answer *a, struct problem *problem);

/* Draws a sweep. Its arguments are those of 'sweep' or of 'plot sweep'. */
bool plot_sweep(const struct query *query, struct answer *a, struct problem *problem);
bool plot_sweep_draw(const struct query *query, const struct plot_rows *rows, struct chart *chart,
                     struct problem *problem);

#endif
