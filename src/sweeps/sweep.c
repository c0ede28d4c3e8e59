/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'sweep', which prints the answers of a command at all points of a grid. */
#include "answer/answer.h"
#include "interpreter/question.h"
#include "language/text.h"
#include "parallel/workers.h"
#include "sweeps/sweeps.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { SWEEP_REASON = 256 };

/* Counts two kinds of points: points without any answer, and points with a reason why a value is missing. A
 * point without an answer also has a reason, so it is in both counts. */
struct tally {
    pthread_mutex_t lock;
    size_t without_answer, with_reason;
    size_t first; /* index of the first point that has a reason */
    char reason[SWEEP_REASON];
};

/* The columns of a sweep: the parameters of the grid, then the columns of the answer. */
struct sweep_columns {
    struct column column[ANSWER_COLUMNS];
    const char *key[ANSWER_COLUMNS]; /* key in the answer; NULL for a parameter of the grid */
    /* The unit may change from point to point. Cells whose unit is not that of the first point are empty. */
    bool is_fixed[ANSWER_COLUMNS];
    /* new names, such as "rmax.s", for columns of the answer whose key is also the name of a parameter of the
     * grid */
    char renamed[ASSIGNED_MAX][40];
    struct column answer[ANSWER_COLUMNS]; /* one column for each question in a list */
    char unit[ANSWER_COLUMNS][UNIT_TEXT]; /* the units of expressions in a list */
};

/* The data of one worker. All workers use the same grid, question and query, and do not change them. */
struct sweeper {
    const struct sweep *sweep;
    const struct grid *grid;   /* that of the sweep */
    const struct query *query; /* the state of the session, which each point copies and changes */
    const char *command;       /* the name of the command that does the sweep, for messages */
    bool styled;               /* true if the grid changes the precision or the tolerance */
    /* Receives this worker's part of the sweep. It is also the template from which the answer at each point
     * is made. */
    struct answer answer;
    struct sweep_columns columns;
    struct cell sample[ANSWER_COLUMNS]; /* a sample row of the sweep, set by sample_find */
    struct tally *tally;                /* of all workers */
    struct cell value[ASSIGNED_MAX];    /* of the parameters at the point that is being computed */
    struct answer *to;                  /* receives the rows: &answer, or NULL to discard them */
    bool answered;                      /* true if the answer at this point has at least one row */
    char reason[SWEEP_REASON];          /* why a value is missing, or "" */
    struct problem problem;
    bool failed; /* the question is wrong; `problem` says why */
};

/* ---- Columns ---- */

/* Adds a column unless there is no room for it; *n counts it in any case. A column with the name of a
 * parameter of the grid gets another name. */
static void column_add(struct sweeper *w, int *n, struct column column, const char *key, bool is_fixed)
{
    struct sweep_columns *c = &w->columns;
    const int k = (*n)++;
    if (k + 1 >= ANSWER_COLUMNS)
        return;
    for (int i = 0; key && i < w->grid->axes; i++)
        if (strcmp(key, c->column[i].key) == 0) {
            snprintf(c->renamed[i], sizeof *c->renamed, "%s.%s", w->sweep->answer->command->name, key);
            column.key = c->renamed[i];
        }
    c->is_fixed[k] = is_fixed;
    c->column[k] = column;
    c->key[k] = key;
    c->column[k + 1].key = NULL;
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
    const char *unit = q->command->columns[column].unit;
    if (!unit_varies(q, column) || !q->command->in_joules)
        return unit;
    bool good = question_bind(q, at, &call, &ignored);
    unit = q->command->in_joules(good ? call.query.scene : at->scene) ? "J" : unit;
    arena_free(&call.given.memory);
    return unit;
}

/* Returns the unit of the answer to a question of a list. An expression is evaluated at the first point or,
 * if it has no value there, with the parameters of the session. */
static const char *unit_measured(const struct sweeper *w, const struct question *q, const struct query *at,
                                 char unit[UNIT_TEXT])
{
    struct problem ignored = {.kind = PROBLEM_NONE};
    struct quantity value = {.value = 0};
    if (q->key >= 0)
        return unit_at(q, q->key, at);
    return question_measure(q, at, &value, unit, &ignored) ||
                   question_measure(q, w->query, &value, unit, &ignored)
               ? unit
               : "";
}

/* Makes *at the query at point k, and stores the values of the parameters there in w->value. */
static bool point_query(struct sweeper *w, size_t k, struct state *state, struct query *at,
                        struct problem *problem)
{
    struct assigned assigned[ASSIGNED_MAX];
    for (int i = w->grid->axes - 1; i >= 0; k /= w->grid->axis[i--].count) {
        const struct axis *axis = &w->grid->axis[i];
        assigned[i] =
            (struct assigned){.parameter = axis->parameter, .value = axis_value(axis, k % axis->count)};
        w->value[i] = axis_cell(axis, assigned[i].value);
    }
    bool good = query_with(w->query, assigned, w->grid->axes, state, at, problem);
    state->settings.threads = 1; /* a point uses one thread, because whole points are computed in parallel */
    return good;
}

/* Makes the columns of the sweep. Two kinds of columns of the answer are left out: columns that only repeat a
 * parameter of the grid, and columns that take a long time to compute (sweep.echo and sweep.slow_column of
 * struct command). Fails if there are too many columns. */
static bool sweeper_columns(struct sweeper *w, struct problem *problem)
{
    struct problem ignored = {.kind = PROBLEM_NONE};
    struct state state;
    struct query at;
    if (!point_query(w, 0, &state, &at, &ignored))
        at = *w->query;
    const struct question *q = w->sweep->answer;
    struct sweep_columns *c = &w->columns;
    int n = 0;
    for (int i = 0; i < w->grid->axes; i++) {
        const struct parameter *p = w->grid->axis[i].parameter;
        column_add(w, &n, (struct column){p->name, p->value->unit, "", 0}, NULL, false);
    }
    for (size_t k = 0; k < w->sweep->answers && w->sweep->answers > 1; k++, q++) {
        c->answer[k] = (struct column){q->name, unit_measured(w, q, &at, c->unit[k]), "", 0};
        column_add(w, &n, c->answer[k], q->name, unit_varies(q, q->key));
    }
    for (int k = 0; w->sweep->answers == 1 && q->command->columns[k].key; k++) {
        struct column column = q->command->columns[k];
        const char *slow = q->command->sweep.slow_column, *repeated = q->command->sweep.echo;
        const bool is_fixed = unit_varies(q, k) && !q->command->is_print;
        bool is_left_out = slow && strcmp(slow, column.key) == 0;
        for (int i = 0; i < w->grid->axes; i++)
            is_left_out = is_left_out || (repeated && strcmp(column.key, repeated) == 0 &&
                                          strcmp(column.key, w->grid->axis[i].parameter->name) == 0);
        if (is_fixed)
            column.unit = unit_at(q, k, &at);
        if (!is_left_out)
            column_add(w, &n, column, column.key, is_fixed);
    }
    return n < ANSWER_COLUMNS ||
           problem_error(problem,
                         "a row of this sweep would have more than %d columns; sweep fewer parameters",
                         ANSWER_COLUMNS - 1);
}

/* ---- Rows ---- */

/* Writes a row. Keeps the first reason for a missing value at this point. */
static void row_write(struct sweeper *w, const struct cell *row, const char *reason)
{
    const char *late = "";
    if (w->to) {
        /* In csv and json every row has a reason, which may be "". */
        answer_row(w->to, row, w->to->style.format->for_people ? NULL : reason ? reason : "");
        late = w->to->late_reason;
    }
    if (!*w->reason)
        snprintf(w->reason, sizeof w->reason, "%.*s", (int)sizeof w->reason - 1, reason ? reason : late);
    if (w->to)
        w->to->late_reason[0] = '\0'; /* the sweep reports the reason itself */
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
        int i = 0;
        while (a->columns[i].key && strcmp(a->columns[i].key, c->key[j]) != 0)
            i++;
        row[j] = (struct cell){.kind = CELL_NONE};
        if (!a->columns[i].key)
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
    size_t n = 0;
    memcpy(columns, w->columns.answer, sizeof columns);
    a->columns = columns;
    for (; n < w->sweep->answers; n++) {
        const struct question *q = &w->sweep->answer[n];
        struct quantity value;
        cells[n] = (struct cell){.kind = CELL_NONE};
        problem_begin(&w->problem, w->command);
        if (unit_varies(q, q->key))
            columns[n].unit = strcpy(unit[n], "");
        if (question_measure(q, at, &value, unit[n], &w->problem))
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
    a.columns = w->sweep->answers > 1 ? w->columns.answer : w->sweep->answer->command->columns;
    a.sink.take = row_take;
    a.sink.context = w;
    bool done = is_assigned && (w->sweep->answers > 1 ? list_ask(w, &at, &a)
                                                      : question_ask(w->sweep->answer, &at, &a, &w->problem));
    if (!done && w->problem.kind != PROBLEM_NO_ANSWER)
        return false;
    if (!done || !w->answered) {
        struct cell row[ANSWER_COLUMNS] = {{.kind = CELL_NONE}};
        memcpy(row, w->value, (size_t)w->grid->axes * sizeof *row);
        row_write(w, row, done ? "there is no answer at this point" : w->problem.text);
    }
    return true;
}

/* Looks for a point with an answer among the first 256 points. If there is one, stores its first row in
 * w->sample, and sets w->answered. If the question has an error, sets w->problem and returns false. */
static bool sample_find(struct sweeper *w)
{
    enum { TRIED = 256 };
    w->answered = false;
    for (size_t k = 0; k < w->grid->points && k < TRIED && !w->answered; k++)
        if (!point_answer(w, k))
            return false;
    return true;
}

/* Is workers.point. On an error, stores it in w->problem and returns false. */
static bool point_write(void *sweeper, size_t k, FILE *out)
{
    struct sweeper *w = sweeper;
    w->to = &w->answer;
    w->to->out = out;
    w->to->sink.point = k;
    w->to->columns = w->columns.column; /* row_take changes the units, so each worker has its own columns */
    if (k > 0)
        w->to->progress.has_rows = w->to->progress.is_open = true;
    w->failed = !point_answer(w, k);
    struct tally *t = w->tally;
    pthread_mutex_lock(&t->lock);
    t->without_answer += !w->answered;
    if (*w->reason && (t->with_reason++ == 0 || k < t->first)) {
        t->first = k;
        memcpy(t->reason, w->reason, sizeof w->reason);
    }
    pthread_mutex_unlock(&t->lock);
    return !w->failed;
}

/* ---- The answer ---- */

/* Passes the values of the grid to the answer, which chooses units for the grid's columns. */
static void values_announce(struct answer *a, const struct grid *grid)
{
    for (int i = 0; i < grid->axes; i++) {
        const struct axis *axis = &grid->axis[i];
        /* The unit of a column must suit its largest number. If the values run from FROM to TO, the largest
         * one is the first or the last, so only these two are passed. A list can have its largest value
         * anywhere, so all its values are passed. */
        size_t step = axis->list || axis->count < 3 ? 1 : axis->count - 1;
        for (size_t k = 0; k < axis->count; k += step)
            answer_announce(a, axis->parameter->name, axis_value(axis, k));
    }
}

/* Copies the problem of the failed point to *problem or, after ^C, reports the interrupt there. Returns
 * false. */
static bool point_failed(const struct sweeper *w, struct problem *problem)
{
    if (dom_raised(w->query->scene->compute.interrupt))
        return problem_status(problem, w->query->scene, DOM_INTERRUPTED);
    *problem = w->problem;
    return false;
}

static bool rows_write(struct sweeper *w, struct answer *a, struct problem *problem)
{
    if ((a->style.errors || a->style.format->for_people) && !sample_find(w))
        return point_failed(w, problem);
    a->columns = w->columns.column;
    a->csv.has_reasons = true;
    /* The columns must be laid out in the same way in every part of a sweep. The first row that is written
     * cannot decide their layout, because it depends on the workers. */
    a->layout.sample = w->answered ? w->sample : NULL;
    values_announce(a, w->grid);
    answer_plan(a, w->sample);
    w->answer = *a;
    w->answer.kept = NULL;
    const enum dom_status status = points_answer(
        w->query, a,
        &(struct workers){.points = w->grid->points, .point = point_write, .context = w, .size = sizeof *w});
    return status == DOM_OK ? !w->failed || point_failed(w, problem)
                            : query_status(w->query, problem, status);
}

/* Prints the number of points at which a value is missing, and the reason at the first of these points. */
static void tally_say(struct sweeper *w, struct answer *a)
{
    const struct tally *t = w->tally;
    char where[256] = "", number[CELL_TEXT];
    struct state state;
    struct query at;
    (void)point_query(w, t->first, &state, &at, &(struct problem){.kind = PROBLEM_NONE});
    for (int i = 0; i < w->grid->axes; i++)
        text_add(where, sizeof where, "%s%s = %s", i ? ", " : "", w->grid->axis[i].parameter->name,
                 cell_text(w->value[i], 6, false, number));
    answer_say(a, "%zu of %zu points %s %s. The first is %s: %s.%s", t->with_reason, w->grid->points,
               t->with_reason == 1 ? "has" : "have",
               t->without_answer == t->with_reason ? "no answer" : "a missing value", where, t->reason,
               t->with_reason == 1 ? "" : " csv and json give the reason for each of them.");
}

bool run_sweep(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct sweep *s = query->given->bound;
    struct tally tally = {.lock = PTHREAD_MUTEX_INITIALIZER};
    struct sweeper *w = calloc(1, sizeof *w);
    if (!w)
        return query_status(query, problem, DOM_NO_MEMORY);
    w->sweep = s;
    w->grid = &s->grid;
    w->query = query;
    w->command = problem->command;
    w->tally = &tally;
    w->answer = *a;
    for (int i = 0; i < s->grid.axes; i++) {
        const struct parameter *p = s->grid.axis[i].parameter;
        w->styled = w->styled || p->of_precision || p->moves;
    }
    bool done = sweeper_columns(w, problem) && rows_write(w, a, problem);
    if (done && tally.with_reason > 0) {
        tally_say(w, a);
        snprintf(a->made, sizeof a->made, "%zu of %zu points have a missing value", tally.with_reason,
                 w->grid->points);
    }
    a->layout.sample = NULL;
    free(w);
    return done;
}
