/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/sweeps/point.h"
#include "answer/format.h"
#include "interpreter/symbols.h"
#include <string.h>

/* ---- Columns ---- */

static bool column_add(struct sweep_columns *c, int *n, struct column column, const char *key)
{
    if (*n + 1 >= ANSWER_COLUMNS)
        return false;
    c->column[*n] = column;
    c->key[(*n)++] = key;
    c->column[*n].key = NULL;
    return true;
}

/* Makes a column for each question in a list. To find the unit of an expression, evaluates it with the
 * parameters of the session. */
static void list_columns(struct sweeper *w)
{
    struct sweep_columns *c = &w->columns;
    int n = 0;
    for (const struct point_question *s = w->question; s && n + 1 < ANSWER_COLUMNS; s = s->next, n++) {
        const struct question *q = &s->question;
        struct problem ignored = {.kind = PROBLEM_NONE};
        struct quantity value = {.value = 0};
        const char *unit;
        if (q->key >= 0) {
            unit = q->command->columns[q->key].unit;
        } else {
            question_value(q, w->query, &value, &ignored);
            unit = unit_write(value, " ", c->unit[n]);
        }
        c->answer[n] = (struct column){q->name, unit, "", 0};
    }
}

/* Returns the columns of the answer at a point, without those for the parameters of the grid. */
static const struct column *answered_columns(const struct sweeper *w)
{
    return w->question->next ? w->columns.answer : w->question->question.command->columns;
}

/* Returns true if an argument of the question gives a value for the parameter command->echo, as 0.4 does for
 * s in 'rmax 0.4'. */
static bool is_replaced(const struct question *q)
{
    for (int i = 0; q->command->echo && i < q->count; i++)
        if (q->command->argument[i].parameter &&
            strcmp(q->command->argument[i].parameter, q->command->echo) == 0)
            return true;
    return false;
}

bool sweeper_columns(struct sweeper *w, struct problem *problem)
{
    const struct question *q = &w->question->question;
    struct sweep_columns *c = &w->columns;
    const char *repeated = q->command->echo && !is_replaced(q) ? q->command->echo : "";
    bool fits = true;
    int n = 0, renamed = 0;
    for (int i = 0; i < w->grid->axes; i++) {
        const struct parameter *p = w->grid->axis[i].parameter;
        fits = fits && column_add(c, &n, (struct column){p->name, p->value->unit, "", 0}, NULL);
    }
    if (w->question->next)
        list_columns(w);
    for (const struct column *from = answered_columns(w); from->key; from++) {
        struct column column = *from;
        bool is_parameter = false;
        for (int i = 0; i < w->grid->axes; i++)
            is_parameter = is_parameter || strcmp(from->key, w->grid->axis[i].parameter->name) == 0;
        const bool is_slow =
            !w->question->next && q->command->slow_column && strcmp(q->command->slow_column, from->key) == 0;
        if (is_slow || (is_parameter && strcmp(repeated, from->key) == 0))
            continue;
        if (is_parameter) {
            snprintf(c->renamed[renamed], sizeof *c->renamed, "%s.%s", q->command->name, from->key);
            column.key = c->renamed[renamed++];
        }
        fits = fits && column_add(c, &n, column, from->key);
    }
    return fits || problem_error(
                       problem, "a row of this sweep would have more than %d columns; sweep fewer parameters",
                       ANSWER_COLUMNS - 1);
}

/* ---- Rows ---- */

/* Stores the reason for a missing value, unless the point already has a reason. */
static void reason_keep(struct sweeper *w, const char *reason)
{
    if (reason && !*w->reason)
        snprintf(w->reason, sizeof w->reason, "%.*s", (int)sizeof w->reason - 1, reason);
}

static void row_write(struct sweeper *w, const struct cell *row, const char *reason)
{
    reason_keep(w, reason);
    if (!w->to)
        return;
    /* In csv and json every row has a reason, which may be "". */
    answer_row(w->to, row, w->to->style.format->for_people ? NULL : reason ? reason : "");
    if (*w->to->late_reason)
        reason_keep(w, w->to->late_reason);
    w->to->late_reason[0] = '\0'; /* the sweep reports the reason itself */
}

/* Returns the column with this key, or -1. */
static int column_find(const struct column *columns, const char *key)
{
    for (int i = 0; columns[i].key; i++)
        if (strcmp(columns[i].key, key) == 0)
            return i;
    return -1;
}

/* A callback that receives a row of the answer at a point and writes it as a row of the sweep. The columns of
 * the answer and their units may differ from point to point. */
static void row_take(struct answer *a, const struct cell *cells, const char *reason)
{
    struct sweeper *w = a->sink_context;
    struct sweep_columns *c = &w->columns;
    struct cell row[ANSWER_COLUMNS];
    const int values = w->grid->axes;
    memcpy(row, w->value, (size_t)values * sizeof *row);
    for (int j = values; c->column[j].key; j++) {
        int i = column_find(a->columns, c->key[j]);
        row[j] = (struct cell){.kind = CELL_NONE};
        if (i < 0)
            continue;
        row[j] = cells[i];
        c->column[j].unit = a->columns[i].unit;
    }
    if (!w->to && !w->answered)
        memcpy(w->sample, row, sizeof row);
    w->answered = true;
    row_write(w, row, reason);
}

/* ---- Points ---- */

void point_values(struct sweeper *w, size_t k)
{
    for (int i = w->grid->axes - 1; i >= 0; i--) {
        const struct axis *axis = &w->grid->axis[i];
        w->assigned[i] = (struct assigned){axis->parameter, axis_value(axis, k % axis->count), NULL};
        w->value[i] = axis_cell(axis, w->assigned[i].value);
        k /= axis->count;
    }
}

/* Asks all questions of a list at one point and writes the answers as one row. If a question has no answer at
 * this point, its cell is empty. If a question fails with an error, sets w->problem and returns false. */
static bool list_ask(struct sweeper *w, const struct query *at, struct answer *a)
{
    struct cell cells[ANSWER_COLUMNS];
    char reason[sizeof w->reason] = "";
    int n = 0;
    for (const struct point_question *q = w->question; q; q = q->next, n++) {
        struct quantity value;
        cells[n] = (struct cell){.kind = CELL_NONE};
        problem_begin(&w->problem, w->command);
        if (question_value(&q->question, at, &value, &w->problem))
            cells[n] = cell_bound(value.value, DOMQ_NAN);
        else if (w->problem.kind != PROBLEM_NO_ANSWER)
            return false;
        else if (!*reason)
            snprintf(reason, sizeof reason, "%.*s", (int)sizeof reason - 1, w->problem.text);
    }
    return answer_row(a, cells, *reason ? reason : NULL);
}

/* Evaluates the question at point k. Writes the rows of the answer to w->to, unless this pointer is NULL. If
 * the question fails with an error, sets w->problem and returns false. */
static bool point_answer(struct sweeper *w, size_t k)
{
    struct state state;
    struct query at;
    struct answer a = w->answer;
    point_values(w, k);
    w->answered = false;
    w->reason[0] = '\0';
    problem_begin(&w->problem, w->command);
    bool is_assigned = query_with(w->query, w->assigned, w->grid->axes, &state, &at, &w->problem);
    at.run_context = &w->run_context;
    state.settings.threads = 1; /* a point uses one thread, because whole points are computed in parallel */
    if (w->styled) {
        struct answer_style style = state_style(&state);
        style.digits = a.style.digits; /* otherwise the width of a column would change from point to point */
        style.format = a.style.format; /* a plot chooses the format itself */
        a.style = style;
    }
    if (w->to)
        w->to->style = a.style;
    else
        a.out = NULL;
    a.columns = answered_columns(w);
    a.sink = row_take;
    a.sink_context = w;
    bool done =
        is_assigned && (w->question->next ? list_ask(w, &at, &a)
                                          : question_ask(&w->question->question, &at, &a, &w->problem));
    if (!done && w->problem.kind != PROBLEM_NO_ANSWER)
        return false;
    if (!done || !w->answered) {
        struct cell row[ANSWER_COLUMNS] = {{.kind = CELL_NONE}};
        memcpy(row, w->value, (size_t)w->grid->axes * sizeof *row);
        row_write(w, row, done ? "there is no answer at this point" : w->problem.text);
    }
    return true;
}

bool point_probe(struct sweeper *w)
{
    enum { TRIED = 256 };
    w->answered = false;
    for (size_t k = 0; k < w->grid->points && k < TRIED && !w->answered; k++)
        if (!point_answer(w, k))
            return false;
    return true;
}

bool point_write(void *sweeper, size_t k, FILE *out)
{
    struct sweeper *w = sweeper;
    w->to = &w->answer;
    w->to->out = out;
    w->to->columns = w->columns.column; /* row_take changes the units, so each worker has its own columns */
    if (k > 0)
        w->to->has_rows = w->to->is_open = true;
    if (!point_answer(w, k))
        return false;
    w->tally.without_answer += !w->answered;
    if (*w->reason && w->tally.with_reason++ == 0) {
        w->tally.first = k;
        memcpy(w->tally.reason, w->reason, sizeof w->reason);
    }
    return true;
}

void sweeper_merge(void *sweeper, const void *worker)
{
    struct tally *all = &((struct sweeper *)sweeper)->tally;
    const struct tally *t = &((const struct sweeper *)worker)->tally;
    if (t->with_reason > 0 && (all->with_reason == 0 || t->first < all->first)) {
        all->first = t->first;
        memcpy(all->reason, t->reason, sizeof all->reason);
    }
    all->with_reason += t->with_reason;
    all->without_answer += t->without_answer;
}
