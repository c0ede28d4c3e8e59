/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * plot sweep: one number of any answer over one or two parameters.  One parameter gives a curve, a second one
 * of few values a curve each, and of many a map.  The numbers are those that 'sweep' would write.
 */
#include "answer/format.h"
#include "commands/plots/plots.h"
#include "io/io.h"
#include "session/parameters.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { FAMILY = 6 /* curves at most */, CELLS = ANSWER_COLUMNS };

struct points {
    struct sweep_shape shape;
    size_t count;
    double *at[SWEEP_AXES], *value; /* of each point; NaN: no number */
    char (*word)[32];               /* of the axis that is a family, as it is written */
    size_t none;                    /* points without an answer */
    char key[64];                   /* of the column that is shown */
};

/* ---- The rows of the sweep ---- */

/* The names of the columns, and a row of numbers: which a sweep hands over without their text. */
struct head {
    char key[CELLS][64]; /* ends with an empty one */
};

struct row {
    double number[CELLS]; /* NaN where the cell is none */
    char word[32];        /* the value of the first parameter, as it is written */
};

static void handed_begin(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)cells, (void)reason;
    struct head head = {{""}};
    for (int i = 0; a->columns[i].key; i++)
        snprintf(head.key[i], sizeof head.key[i], "%s", a->columns[i].key);
    fwrite(&head, sizeof head, 1, a->out);
}

static void handed_row(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)reason;
    struct row row = {.word = ""};
    char text[CELL_TEXT];
    for (int i = 0; a->columns[i].key; i++) {
        bool number = cells[i].kind == CELL_REAL || cells[i].kind == CELL_COUNT;
        row.number[i] = number ? (double)cells[i].number : (double)NAN;
    }
    if (cells[0].kind != CELL_NONE)
        snprintf(row.word, sizeof row.word, "%s", cell_plain(&a->style, cells[0], text));
    fwrite(&row, sizeof row, 1, a->out);
}

static const struct format handed = {.begin = handed_begin, .row = handed_row};

/* Finds the column that is shown: what the command stands for in an expression, or its first. */
static int column_find(struct points *p, const struct head *head)
{
    const struct command *c = p->shape.command;
    char renamed[64];
    const char *key = c->principal ? c->principal : c->columns[0].key;
    int from = p->shape.axes;
    snprintf(p->key, sizeof p->key, "%s", key);
    snprintf(renamed, sizeof renamed, "%s.%s", c->name, key);
    for (int i = from; *head->key[i]; i++)
        if (strcmp(head->key[i], key) == 0 || strcmp(head->key[i], renamed) == 0)
            return i;
    return from;
}

/* Makes room for one more point. */
static bool points_grow(struct points *p, size_t *room)
{
    bool good = true;
    if (p->count < *room)
        return true;
    *room = 2 * *room + 64;
    for (int i = 0; i < SWEEP_AXES; i++) {
        double *more = realloc(p->at[i], *room * sizeof *more);
        p->at[i] = more ? more : p->at[i];
        good = good && more;
    }
    double *value = realloc(p->value, *room * sizeof *value);
    p->value = value ? value : p->value;
    void *word = realloc(p->word, *room * sizeof *p->word);
    p->word = word ? word : p->word;
    return good && value && word;
}

static bool points_read(FILE *rows, struct points *p)
{
    struct head head;
    struct row row;
    size_t room = 0;
    bool good = true;
    if (fread(&head, sizeof head, 1, rows) != 1)
        return true;
    int column = column_find(p, &head);
    while (good && fread(&row, sizeof row, 1, rows) == 1) {
        if (!(good = points_grow(p, &room)))
            break;
        for (int i = 0; i < SWEEP_AXES; i++)
            p->at[i][p->count] = i < p->shape.axes ? row.number[i] : (double)NAN;
        memcpy(p->word[p->count], row.word, sizeof row.word);
        p->value[p->count] = row.number[column];
        p->none += isnan(row.number[column]) != 0;
        p->count++;
    }
    return good;
}

static bool points_find(const struct query *query, struct answer *a, struct problem *problem,
                        struct points *p)
{
    FILE *rows = io_temporary(NULL);
    if (!rows) {
        problem_error(problem, "cannot draw: %s", strerror(errno));
        return false;
    }
    struct answer answer = {.out = rows, .style = a->style, .rows = true};
    answer.style.format = &handed;
    answer.style.errors = false;
    bool done = run_sweep(query, &answer, problem);
    rewind(rows);
    if (done && !points_read(rows, p))
        done = problem_status(problem, query->scene, DOM_NO_MEMORY);
    fclose(rows);
    if (done && p->count == 0)
        problem_no_answer(problem, "the sweep has no points to draw");
    return done && p->count > 0;
}

static void points_free(struct points *p)
{
    for (int i = 0; i < SWEEP_AXES; i++)
        free(p->at[i]);
    free(p->value);
    free(p->word);
}

/* ---- The picture ---- */

static void axis_label(const struct sweep_axis *a, char label[128])
{
    /* Meanings say what is over the height; the unit h would say it again. */
    bool unit = *a->unit && strcmp(a->unit, "h") != 0;
    snprintf(label, 128, "%s, %s%s%s", a->name, parameter_meaning(a->parameter), unit ? ", in " : "",
             unit ? a->unit : "");
}

static void value_label(const struct query *query, const struct points *p, char *label, size_t size)
{
    const struct column *c = p->shape.command->columns;
    while (c->key && strcmp(c->key, p->key) != 0)
        c++;
    bool angle = c->key && column_is_angle(c);
    const char *unit = angle ? style_angle_unit(&query->state->settings.style) : c->key ? c->unit : "";
    snprintf(label, size, "%s%s%s", p->shape.expression ? p->shape.asked : p->key, *unit ? " in " : "", unit);
}

/* Returns true if the values of an axis, or their logarithms, are evenly spaced, as a map needs them. */
static bool is_even(const double *at, size_t count, size_t stride, bool logarithmic)
{
    for (size_t i = 2; i < count; i++) {
        double a = at[(i - 2) * stride], b = at[(i - 1) * stride], c = at[i * stride];
        double d = logarithmic ? log(b / a) : b - a, e = logarithmic ? log(c / b) : c - b;
        if (!(fabs(d - e) <= 1e-6 * fabs(e)))
            return false;
    }
    return count > 1 && isfinite(at[0]);
}

/* Draws a curve over axis `over` for each value of the other axis, the slower one if it is 1. */
static void curves_draw(struct chart *chart, const struct points *p, int over)
{
    static const enum ink inks[FAMILY] = {INK_BLUE, INK_RED, INK_GREEN, INK_PURPLE, INK_ORANGE, INK_SKY};
    const struct sweep_shape *s = &p->shape;
    size_t family = s->axes == 1 ? 1 : s->axis[1 - over].count, along = s->axis[over].count;
    size_t step = s->axes == 1 || over == 1 ? 1 : s->axis[1].count, turn = over == 1 ? s->axis[1].count : 1;
    char word[64];
    for (size_t k = 0; k < family; k++) {
        size_t first = k * turn;
        word[0] = '\0'; /* of one curve alone nothing is said */
        if (s->axes > 1 && over == 1)
            snprintf(word, sizeof word, "%s = %s", s->axis[0].name, p->word[first]);
        else if (s->axes > 1)
            snprintf(word, sizeof word, "%s = %.6g", s->axis[1].name, p->at[1][first]);
        bool few = along <= 24;
        struct chart_curve *curve =
            chart_curve(chart, few ? CHART_MARKED : CHART_LINE, inks[k], (int)k, "%s", word);
        for (size_t i = 0; i < along; i++)
            chart_point(chart, curve, p->at[over][first + i * step], p->value[first + i * step]);
    }
    chart->x.logarithmic = s->axis[over].logarithmic;
    axis_label(&s->axis[over], chart->x.label);
}

static bool map_draw(struct chart *chart, const struct points *p)
{
    const struct sweep_shape *s = &p->shape;
    struct chart_map *m = &chart->map;
    size_t across = s->axis[0].count, down = s->axis[1].count;
    const double *x = p->at[0], *y = p->at[1];
    m->value = malloc(p->count * sizeof *m->value);
    if (!m->value)
        return false;
    for (size_t k = 0; k < p->count; k++)
        m->value[k % down * across + k / down] = p->value[k];
    m->across = (int)across;
    m->down = (int)down;
    chart->x.logarithmic = s->axis[0].logarithmic;
    chart->y.logarithmic = s->axis[1].logarithmic;
    m->x0 = chart->x.logarithmic ? log10(x[0]) : x[0];
    m->x1 = chart->x.logarithmic ? log10(x[p->count - 1]) : x[p->count - 1];
    m->y0 = chart->y.logarithmic ? log10(y[0]) : y[0];
    m->y1 = chart->y.logarithmic ? log10(y[down - 1]) : y[down - 1];
    axis_label(&s->axis[0], chart->x.label);
    axis_label(&s->axis[1], chart->y.label);
    return true;
}

/* Chooses how to show the points, and draws them. */
static bool points_draw(const struct query *query, struct answer *a, struct problem *problem,
                        const struct points *p)
{
    struct chart chart = chart_make();
    const struct sweep_shape *s = &p->shape;
    bool numbers[SWEEP_AXES] = {isfinite(p->at[0][0]), s->axes > 1 && isfinite(p->at[1][0])};
    bool few[SWEEP_AXES] = {s->axis[0].count <= FAMILY, s->axis[1].count <= FAMILY};
    int over = s->axes == 1 ? 0 : numbers[1] && few[0] ? 1 : numbers[0] && few[1] ? 0 : -1;
    bool even = s->axes == 2 &&
                is_even(p->at[0], s->axis[0].count, s->axis[1].count, s->axis[0].logarithmic) &&
                is_even(p->at[1], s->axis[1].count, 1, s->axis[1].logarithmic);
    if (s->axes == 1 && !numbers[0])
        return problem_error(problem, "'%s' has words here, and a curve needs numbers along its axis",
                             s->axis[0].name);
    if (over < 0 && !even)
        return problem_error(problem,
                             "a map needs evenly spaced numbers on both axes; with at most %d values of one "
                             "of them there is a curve each",
                             FAMILY);
    if (p->none == p->count)
        return problem_no_answer(problem, "none of the %zu points has a number to show; 'sweep' says why",
                                 p->count);
    snprintf(chart.title, sizeof chart.title, "%s over %s%s%s", s->asked, s->axis[0].name,
             s->axes > 1 ? " and " : "", s->axes > 1 ? s->axis[1].name : "");
    if (p->none > 0)
        snprintf(chart.note, sizeof chart.note, "%zu of %zu points have no answer.", p->none, p->count);
    if (over >= 0) {
        curves_draw(&chart, p, over);
        value_label(query, p, chart.y.label, sizeof chart.y.label);
    } else if (map_draw(&chart, p)) {
        value_label(query, p, chart.map.label, sizeof chart.map.label);
    } else {
        chart.failed = true;
    }
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

bool plot_sweep(const struct query *query, struct answer *a, struct problem *problem)
{
    if (query->given->count < 2 || !query->given->own)
        return problem_error(problem,
                             "'plot sweep' needs a grid and an answer, such as 'plot sweep s 0.1 0.9 33 : "
                             "rmax'");
    struct points p = {.shape = sweep_shape(query->given)};
    if (!answer_for_people(a))
        return run_sweep(query, a, problem);
    if (p.shape.axes > SWEEP_AXES)
        return problem_error(problem, "a picture has one or two parameters, and this grid has %d",
                             p.shape.axes);
    if (p.shape.command->rows)
        return problem_error(problem,
                             "'%s' answers in rows, and a picture needs one number a point, such as "
                             "'verdict' or 'print EXPRESSION'",
                             p.shape.command->name);
    bool shown =
        picture_ready(a, problem) && points_find(query, a, problem, &p) && points_draw(query, a, problem, &p);
    points_free(&p);
    return shown;
}
