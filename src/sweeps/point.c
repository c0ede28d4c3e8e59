/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sweeps/point.h"
#include "answer/format.h"
#include "interpreter/question.h"
#include <string.h>

/* ---- Columns ---- */

static bool column_add(struct sweep_columns *c, int *n, struct column column, const char *key, bool is_fixed)
{
    if (*n + 1 >= ANSWER_COLUMNS)
        return false;
    c->is_fixed[*n] = is_fixed;
    c->column[*n] = column;
    c->key[(*n)++] = key;
    c->column[*n].key = NULL;
    return true;
}

/* Returns true if the unit of a column may change from point to point. */
static bool unit_varies(const struct question *q, int column)
{
    return q->command->is_print ||
           (q->command->in_joules && strcmp(q->command->columns[column].unit, "mgh/2") == 0);
}

/* Returns the unit of a column of the answer to a question. */
static const char *unit_at(const struct question *q, int column, const struct query *at)
{
    struct call call;
    struct problem ignored = {.kind = PROBLEM_NONE};
    if (!unit_varies(q, column))
        return q->command->columns[column].unit;
    bool good = question_bind(q, at, &call, &ignored);
    const char *unit = command_unit(q->command, column, good ? call.query.scene : at->scene);
    arena_free(&call.given.memory);
    return unit;
}

/* Makes a column for each question in a list. To find the unit of an expression, evaluates it at the first
 * point or, if it has no value there, with the parameters of the session. */
static void list_columns(struct sweeper *w, const struct query *at)
{
    struct sweep_columns *c = &w->columns;
    int n = 0;
    for (const struct point_question *s = w->question; s && n + 1 < ANSWER_COLUMNS; s = s->next, n++) {
        const struct question *q = &s->question;
        struct problem ignored = {.kind = PROBLEM_NONE};
        struct quantity value = {.value = 0};
        const char *unit;
        if (q->key >= 0)
            unit = unit_at(q, q->key, at);
        else if (question_measure(q, at, &value, c->unit[n], &ignored) ||
                 question_measure(q, w->query, &value, c->unit[n], &ignored))
            unit = c->unit[n];
        else
            unit = "";
        c->answer[n] = (struct column){q->name, unit, "", 0};
    }
}

/* Returns the columns of the answer at a point, without those for the parameters of the grid. */
static const struct column *answered_columns(const struct sweeper *w)
{
    return w->question->next ? w->columns.answer : w->question->question.command->columns;
}

/* Returns true if an argument of the question gives a value for the parameter command->sweep.echo, as 0.4
 * does for s in 'rmax 0.4'. */
static bool is_replaced(const struct question *q)
{
    for (int i = 0; q->command->sweep.echo && i < q->count; i++)
        if (q->command->argument[i].parameter &&
            strcmp(q->command->argument[i].parameter, q->command->sweep.echo) == 0)
            return true;
    return false;
}

void point_values(struct sweeper *w, size_t k)
{
    for (int i = w->grid->axes - 1; i >= 0; i--) {
        const struct axis *axis = &w->grid->axis[i];
        w->assigned[i] =
            (struct assigned){.parameter = axis->parameter, .value = axis_value(axis, k % axis->count)};
        w->value[i] = axis_cell(axis, w->assigned[i].value);
        k /= axis->count;
    }
}

/* Makes *at the query at point k. */
static bool point_query(struct sweeper *w, size_t k, struct state *state, struct query *at,
                        struct problem *problem)
{
    point_values(w, k);
    bool good = query_with(w->query, w->assigned, w->grid->axes, state, at, problem);
    at->run_context = &w->run_context;
    state->settings.threads = 1; /* a point uses one thread, because whole points are computed in parallel */
    return good;
}

bool sweeper_columns(struct sweeper *w, struct problem *problem)
{
    struct problem ignored = {.kind = PROBLEM_NONE};
    struct state state;
    struct query at;
    const bool is_list = w->question->next;
    if (!point_query(w, 0, &state, &at, &ignored))
        at = *w->query;
    const struct question *q = &w->question->question;
    struct sweep_columns *c = &w->columns;
    const char *repeated = q->command->sweep.echo && !is_replaced(q) ? q->command->sweep.echo : "";
    bool fits = true;
    int n = 0, renamed = 0;
    for (int i = 0; i < w->grid->axes; i++) {
        const struct parameter *p = w->grid->axis[i].parameter;
        fits = fits && column_add(c, &n, (struct column){p->name, p->value->unit, "", 0}, NULL, false);
    }
    if (is_list)
        list_columns(w, &at);
    const struct column *const columns = answered_columns(w);
    const struct point_question *asked = w->question;
    for (const struct column *from = columns; from->key; from++) {
        struct column column = *from;
        const int k = is_list ? asked->question.key : (int)(from - columns);
        const bool is_fixed = unit_varies(&asked->question, k) && (is_list || !q->command->is_print);
        if (is_fixed && !is_list)
            column.unit = unit_at(q, k, &at);
        asked = is_list ? asked->next : asked;
        bool is_parameter = false;
        for (int i = 0; i < w->grid->axes; i++)
            is_parameter = is_parameter || strcmp(from->key, w->grid->axis[i].parameter->name) == 0;
        const bool is_slow = !is_list && q->command->sweep.slow_column &&
                             strcmp(q->command->sweep.slow_column, from->key) == 0;
        if (is_slow || (is_parameter && strcmp(repeated, from->key) == 0))
            continue;
        if (is_parameter) {
            snprintf(c->renamed[renamed], sizeof *c->renamed, "%s.%s", q->command->name, from->key);
            column.key = c->renamed[renamed++];
        }
        fits = fits && column_add(c, &n, column, from->key, is_fixed);
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
 * the answer and their units may differ from point to point. A cell whose unit is not that of its column
 * stays empty. */
static void row_take(struct answer *a, const struct cell *cells, const char *reason)
{
    struct sweeper *w = a->sink.context;
    struct sweep_columns *c = &w->columns;
    struct cell row[ANSWER_COLUMNS];
    char other[SWEEP_REASON];
    const int values = w->grid->axes;
    memcpy(row, w->value, (size_t)values * sizeof *row);
    for (int j = values; c->column[j].key; j++) {
        int i = column_find(a->columns, c->key[j]);
        row[j] = (struct cell){.kind = CELL_NONE};
        if (i < 0)
            continue;
        const char *unit = a->columns[i].unit, *head = c->column[j].unit;
        if (!c->is_fixed[j])
            c->column[j].unit = unit;
        else if (cells[i].kind != CELL_NONE && strcmp(unit, head) != 0) {
            if (!reason)
                snprintf(other, sizeof other, "%s is %s%s here, but %s%s at the first point",
                         c->column[j].key, *unit ? "in " : "a plain number", unit,
                         *head ? "in " : "a plain number", head);
            reason = reason ? reason : other;
            continue;
        }
        row[j] = cells[i];
    }
    if (!w->to && !w->answered)
        memcpy(w->sample, row, sizeof row);
    w->answered = true;
    row_write(w, row, reason);
}

/* ---- Points ---- */

/* Asks all questions of a list at one point and writes the answers as one row. If a question has no answer at
 * this point, its cell is empty. If a question fails with an error, sets w->problem and returns false. */
static bool list_ask(struct sweeper *w, const struct query *at, struct answer *a)
{
    struct cell cells[ANSWER_COLUMNS];
    struct column columns[ANSWER_COLUMNS];
    char reason[sizeof w->reason] = "", unit[ANSWER_COLUMNS][UNIT_TEXT];
    int n = 0;
    memcpy(columns, w->columns.answer, sizeof columns);
    a->columns = columns;
    for (const struct point_question *q = w->question; q; q = q->next, n++) {
        struct quantity value;
        cells[n] = (struct cell){.kind = CELL_NONE};
        problem_begin(&w->problem, w->command);
        if (unit_varies(&q->question, q->question.key))
            columns[n].unit = strcpy(unit[n], "");
        if (question_measure(&q->question, at, &value, unit[n], &w->problem))
            cells[n] = cell_computed(value.value);
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
    w->answered = false;
    w->reason[0] = '\0';
    problem_begin(&w->problem, w->command);
    bool is_assigned = point_query(w, k, &state, &at, &w->problem);
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
    a.sink.take = row_take;
    a.sink.context = w;
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
    w->to->sink.point = k;
    w->to->columns = w->columns.column; /* row_take changes the units, so each worker has its own columns */
    if (k > 0)
        w->to->progress.has_rows = w->to->progress.is_open = true;
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
