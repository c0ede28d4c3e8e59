/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plot 'sweep': a number from any answer against one or two parameters, as curves or as a map. */
#include "pictures/plots/plots.h"
#include "sweeps/sweeps.h"
#include <stdlib.h>
#include <string.h>

enum {
    FAMILY = 6,  /* the maximum number of curves in a chart */
    MARKED = 24, /* curves with more points have no markers */
    AXES = 2     /* the maximum number of parameters */
};

static const enum ink inks[FAMILY] = {INK_BLUE, INK_RED, INK_GREEN, INK_PURPLE, INK_ORANGE, INK_SKY};

/* The points of a sweep as numbers. */
struct plot_rows {
    char key[ANSWER_COLUMNS][64]; /* names of the columns; "" after the last one */
    char unit[ANSWER_COLUMNS][24];
    struct plot_row {
        /* Angles are in the session's unit. Words and missing numbers are NaN. */
        double number[ANSWER_COLUMNS];
        char word[32]; /* the first cell as text, in the form that csv uses */
    } * row;
    size_t count;
    const struct sweep *sweep;
    int column; /* index of the first plotted column */
};

/* Receives the rows of the sweep, instead of the output format. The points are computed in several threads.
 * They write to different elements of rows->row, and only point 0 writes the keys. */
static void row_keep(struct answer *a, const struct cell *cells, const char *reason)
{
    struct plot_rows *rows = a->sink.context;
    char text[CELL_TEXT];
    (void)reason;
    if (a->sink.point >= rows->count)
        return;
    struct plot_row *row = &rows->row[a->sink.point];
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        const bool angle = column_is_angle(c);
        row->number[i] = plot_number(a, i, cells[i]);
        if (a->sink.point > 0)
            continue;
        snprintf(rows->key[i], sizeof rows->key[i], "%s", c->key);
        snprintf(rows->unit[i], sizeof rows->unit[i], "%s%s", angle ? style_angle_unit(&a->style) : "",
                 c->unit + (angle ? strlen("rad") : 0));
    }
    if (cells[0].kind != CELL_NONE)
        snprintf(row->word, sizeof row->word, "%s", cell_plain(&a->style, cells[0], text));
}

/* Returns the index of the principal column of the answer or, if there is none, of the first column. */
static int column_find(const struct plot_rows *p)
{
    const struct command *c = p->sweep->answer->command;
    const char *key = c->principal ? c->principal : c->columns[0].key;
    char renamed[64];
    snprintf(renamed, sizeof renamed, "%s.%s", c->name, key);
    for (int i = p->sweep->grid.axes; i < ANSWER_COLUMNS && *p->key[i]; i++)
        if (strcmp(p->key[i], key) == 0 || strcmp(p->key[i], renamed) == 0)
            return i;
    return p->sweep->grid.axes;
}

static void axis_label(const struct axis *a, struct chart_axis *to)
{
    const char *unit = a->parameter->value->unit;
    /* The unit h is left out, because the label says that the parameter is divided by the height. */
    bool shown = *unit && strcmp(unit, "h") != 0;
    snprintf(to->label, sizeof to->label, "%s, %s%s%s", a->parameter->name, a->parameter->meaning,
             shown ? ", in " : "", shown ? unit : "");
    to->logarithmic = a->logarithmic;
}

/* Returns the name of the plotted number in a sweep of one answer: its expression, or the key of its column.
 */
static const char *value_name(const struct plot_rows *p)
{
    const struct command *c = p->sweep->answer->command;
    return c->is_print ? p->sweep->typed : c->principal ? c->principal : c->columns[0].key;
}

static void label(char *to, size_t size, const char *name, const char *unit)
{
    snprintf(to, size, "%s%s%s%s", name, *name && *unit ? " " : "", *unit ? "in " : "", unit);
}

/* Draws curves along the axis with index `over`, one for each answer or each value of the other axis. */
static void curves_draw(struct chart *chart, const struct plot_rows *p, int over)
{
    const struct grid *grid = &p->sweep->grid;
    size_t second = grid->axes == 1 ? 1 : grid->axis[1].count, along = grid->axis[over].count;
    size_t values = grid->points / along, step = over == 0 ? second : 1, turn = over == 0 ? 1 : second;
    bool several = p->sweep->answers > 1, is_one = true;
    for (size_t k = 1; k < p->sweep->answers; k++)
        is_one = is_one && strcmp(p->unit[p->column + (int)k], p->unit[p->column]) == 0;
    axis_label(&grid->axis[over], &chart->x);
    label(chart->y.label, sizeof chart->y.label, several ? "" : value_name(p),
          is_one ? p->unit[p->column] : "");
    for (size_t k = 0; k < values * p->sweep->answers; k++) {
        const int column = p->column + (several ? (int)k : 0);
        const struct plot_row *row = &p->row[several ? 0 : k * turn];
        const char *name = p->key[column] + (strncmp(p->key[column], "print ", 6) == 0 ? 6 : 0);
        char word[64 + 24] = "";
        if (several)
            label(word, sizeof word, name, is_one ? "" : p->unit[column]);
        else if (grid->axes > 1 && over == 1)
            snprintf(word, sizeof word, "%s = %s", grid->axis[0].parameter->name, row->word);
        else if (grid->axes > 1)
            snprintf(word, sizeof word, "%s = %.6g", grid->axis[1].parameter->name, row->number[1]);
        struct chart_curve *curve =
            chart_curve(chart, along <= MARKED ? CHART_MARKED : CHART_LINE, inks[k], (int)k, "%s", word);
        for (size_t i = 0; i < along; i++)
            chart_point(chart, curve, row[i * step].number[over], row[i * step].number[column]);
    }
}

static void map_draw(struct chart *chart, const struct plot_rows *p)
{
    const struct grid *grid = &p->sweep->grid;
    const struct plot_row *first = p->row, *last = first + p->count - 1;
    struct chart_axis *axis[AXES] = {&chart->x, &chart->y};
    size_t cells[AXES] = {grid->axis[0].count, grid->axis[1].count};
    double *value = chart->map.value = malloc(p->count * sizeof *value);
    chart->failed = chart->failed || !value;
    for (size_t k = 0; k < p->count && value; k++) {
        size_t i = k / cells[1], j = k % cells[1];
        i = first->number[0] > last->number[0] ? cells[0] - 1 - i : i; /* values may descend */
        j = first->number[1] > last->number[1] ? cells[1] - 1 - j : j;
        value[j * cells[0] + i] = first[k].number[p->column];
    }
    label(chart->map.label, sizeof chart->map.label, value_name(p), p->unit[p->column]);
    chart->map.across = (int)cells[0];
    chart->map.down = (int)cells[1];
    for (int k = 0; k < AXES; k++) {
        axis_label(&grid->axis[k], axis[k]);
        axis[k]->low = fmin(first->number[k], last->number[k]);
        axis[k]->high = fmax(first->number[k], last->number[k]);
    }
}

static bool plot_sweep_draw(struct plot_rows *rows, struct chart *chart, struct problem *problem)
{
    const struct sweep *sweep = rows->sweep;
    const struct grid *grid = &sweep->grid;
    const struct axis *axis = grid->axis;
    if (rows->count == 0)
        return problem_no_answer(problem, "the sweep has no points to draw");
    const bool several = sweep->answers > 1;
    size_t missing = 0, none = 0; /* missing values, and points where a value is missing */
    rows->column = several ? grid->axes : column_find(rows);
    for (size_t k = 0; k < rows->count; k++) {
        const size_t before = missing;
        for (size_t i = 0; i < sweep->answers; i++)
            missing += isnan(rows->row[k].number[rows->column + (int)i]) != 0;
        none += missing > before;
    }
    bool two = grid->axes > 1, numbers = isfinite(rows->row[0].number[0]);
    int over = !two                                                          ? 0
               : isfinite(rows->row[0].number[1]) && axis[0].count <= FAMILY ? 1
               : numbers && axis[1].count <= FAMILY                          ? 0
                                                                             : -1;
    if (!two && !numbers)
        return problem_error(problem,
                             "the values of '%s' are words, but a curve needs numbers along its axis",
                             axis[0].parameter->name);
    if (over < 0 && (axis[0].list || axis[1].list))
        return problem_error(problem,
                             "a map needs evenly spaced numbers on both axes, as in 's 0.1 0.9 9'; to get "
                             "curves instead, enter at most %d values for one of the parameters",
                             FAMILY);
    if (missing == rows->count * sweep->answers)
        return problem_no_answer(problem, "none of the %zu points has a number to show; 'sweep' says why",
                                 rows->count);
    snprintf(chart->title, sizeof chart->title, "%.95s against %s%s%s", sweep->typed, axis[0].parameter->name,
             two ? " and " : "", two ? axis[1].parameter->name : "");
    if (none > 0)
        snprintf(chart->note, sizeof chart->note, "No answer at %zu of %zu points.", none, rows->count);
    if (over >= 0)
        curves_draw(chart, rows, over);
    else
        map_draw(chart, rows);
    return true;
}

static bool plot_sweep_rows(const struct query *query, struct answer *a, struct chart *chart,
                            struct problem *problem)
{
    if (query->given->count < 2 || !query->given->bound)
        return problem_error(
            problem, "'plot sweep' needs a grid and an answer, such as 'plot sweep s 0.1 0.9 33 : rmax'");
    const struct sweep *sweep = query->given->bound;
    if (chart && sweep->grid.axes > AXES)
        return problem_error(problem, "a picture can show one or two parameters, but this grid has %d",
                             sweep->grid.axes);
    if (chart && sweep->answers > 1 && (sweep->grid.axes > 1 || sweep->answers > FAMILY))
        return problem_error(
            problem, "a picture can show up to %d answers against one parameter, or one answer against two",
            FAMILY);
    if (chart && sweep->answer->command->rows)
        return problem_error(problem,
                             "'%s' answers with a table, but a picture needs one number for each point; use "
                             "a command such as 'verdict', or 'print EXPRESSION'",
                             sweep->answer->command->name);
    if (!chart)
        return run_sweep(query, a, problem);
    struct plot_rows rows = {.row = malloc((sweep->grid.points + 1) * sizeof *rows.row), .sweep = sweep};
    if (!rows.row)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    for (; rows.count < sweep->grid.points; rows.count++)
        for (int i = 0; i < ANSWER_COLUMNS; i++) {
            rows.row[rows.count].number[i] = (double)NAN;
            rows.row[rows.count].word[0] = '\0';
        }
    a->sink.take = row_keep;
    a->sink.context = &rows;
    const bool done = run_sweep(query, a, problem) && plot_sweep_draw(&rows, chart, problem);
    free(rows.row);
    return done;
}

static const struct column sweep_columns[] = {{NULL, NULL, NULL, 0}};

static bool whole_parse(struct reader *r, struct question *q)
{
    return sweep_parse_grid(r, q) && sweep_parse_answers(r, q);
}

static const struct argument grid_argument = {
    .name = "GRID", .kind = ARGUMENT_GRID, .parse = whole_parse, .bind = sweep_bind};

const struct plot sweep_plots[] = {
    {"sweep", plot_sweep_rows,
     "any sweep over one or two parameters, as in 'plot sweep s 0.1 0.9 33 : rmax'; 'plot sweep s 0.1 0.9 33 "
     ": rmax, pair' shows the curves of several answers; the columns are those of the sweep",
     sweep_columns, .title = "", .argument = &grid_argument},
    {.name = NULL},
};
