/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

/* A column of a table, for an aggregate such as sum(chain(0).weight). */
struct column_cells {
    const struct tree *node; /* the name of the column */
    const char *key;
    struct quantity unit;
    bool is_missing; /* in this scene the table does not have this column */
    struct cell *cell;
    size_t count, room;
    enum dom_status status;
    struct column_cells *next;
};

/* The table over which an aggregate is being computed. */
struct rows {
    struct column_cells *columns; /* the columns computed so far, the latest first */
    size_t row, count;
    bool only_counts; /* the value of a column is its number of rows */
};

struct lookup {
    const struct query *query;
    struct rows *rows;               /* for the aggregate that is being evaluated */
    const struct quantity *argument; /* the arguments of the 'let' function that is being evaluated */
    struct problem *problem;         /* receives the reason why a command has no answer */
};

/* Finds the value of the node t: the number in column t->index of the row `cells`, which is an answer of the
 * command t->refers. If this cell is empty or contains a word, reports an error. `reason` is the reason why
 * the row has empty cells, or "". */
static bool cell_quantity(struct evaluation *e, const struct tree *t, const struct cell *cells,
                          const char *reason, struct quantity *result)
{
    const struct command *c = t->refers;
    const struct cell cell = cells[t->index];
    const char *key = c->columns[t->index].key;
    if (cell.kind == CELL_WORD)
        return expression_wrong(e->error, t->at, "%s.%s is the word '%s', not a number", t->name, key,
                                cell.word);
    if (cell.kind == CELL_NONE && *reason)
        return expression_no_value(e->error, t->at, "%s.%s has no value here: %s", t->name, key, reason);
    if (cell.kind == CELL_NONE)
        return expression_no_value(e->error, t->at, "%s.%s has no value here; enter '%s' to see why", t->name,
                                   key, c->name);
    *result = t->value;
    result->value *= cell.number;
    return true;
}

static bool arguments_evaluate(struct evaluation *e, const struct tree *t,
                               struct quantity argument[EXPRESSION_ARGUMENTS])
{
    const struct tree *child = t->child;
    for (int i = 0; i < t->count; i++, child = child->next)
        if (!expression_evaluate(e, child, &argument[i]))
            return false;
    return true;
}

/* A sink (answer.h) that keeps one column of the answer. */
static void column_take(struct answer *answer, const struct cell *cells, const char *reason)
{
    struct column_cells *column = answer->sink.context;
    int index = 0;
    (void)reason;
    while (answer->columns[index].key && strcmp(answer->columns[index].key, column->key) != 0)
        index++;
    column->is_missing = !answer->columns[index].key;
    if (column->is_missing || column->status != DOM_OK)
        return;
    if (column->count == column->room) {
        column->room = column->room ? 2 * column->room : 16;
        struct cell *more = realloc(column->cell, column->room * sizeof *more);
        column->status = more ? DOM_OK : DOM_NO_MEMORY;
        if (!more)
            return;
        column->cell = more;
    }
    column->unit = expression_unit(answer->columns[index].unit);
    column->cell[column->count++] = cells[index];
}

/* Runs a command in an expression. If `column` is not NULL, it receives this column of the answer. */
static bool command_run(struct evaluation *e, const struct tree *t, const struct quantity *argument,
                        struct answer *answer, struct column_cells *column)
{
    const struct lookup *lookup = e->context;
    const struct command *c = t->refers;
    struct arguments given = {.count = t->count};
    struct query query = *lookup->query;
    if (!command_allowed(query.run_context, c, lookup->problem))
        return false;
    for (int i = 0; i < t->count; i++)
        if (!argument_check(&query, &c->argument[i], argument[i], &given.number[i], lookup->problem))
            return false;
    query.given = &given;
    query.next = NULL;
    *answer = answer_kept(&query, c, answer->kept);
    answer->sink.take = column ? column_take : NULL;
    answer->sink.context = column;
    return command_compute(c, &query, answer, lookup->problem);
}

/* Stores one number of the answer of a command, such as rmax(0.3). */
static __attribute__((noinline)) bool command_quantity(struct evaluation *e, const struct tree *t,
                                                       const struct quantity *argument,
                                                       struct quantity *result)
{
    struct cell cells[ANSWER_CELLS];
    struct answer answer = {.kept = cells};
    return command_run(e, t, argument, &answer, NULL) &&
           cell_quantity(e, t, cells, answer.late_reason, result);
}

/* ---- Columns of tables ---- */

/* Computes a column, unless it has been computed for an earlier row. All columns of an aggregate must have
 * the same number of rows. */
static __attribute__((noinline)) struct column_cells *column_compute(struct evaluation *e,
                                                                     const struct tree *t)
{
    struct quantity argument[EXPRESSION_ARGUMENTS];
    const struct lookup *lookup = e->context;
    struct rows *rows = lookup->rows;
    struct cell cells[ANSWER_CELLS];
    struct answer answer = {.kept = cells};
    struct column_cells *column = calloc(1, sizeof *column);
    if (!column) {
        query_status(lookup->query, lookup->problem, DOM_NO_MEMORY);
        return NULL;
    }
    *column = (struct column_cells){.node = t, .next = rows->columns};
    column->key = ((const struct command *)t->refers)->columns[t->index].key;
    rows->columns = column;
    if (!arguments_evaluate(e, t, argument) || !command_run(e, t, argument, &answer, column))
        return NULL;
    if (column->status != DOM_OK)
        query_status(lookup->query, lookup->problem, column->status);
    else if (column->is_missing)
        expression_report(e->error, t->at, true, "%s.%s is not in the table here; enter '%s' to see why",
                          t->name, column->key, t->name);
    else if (column->next && column->count != rows->count)
        expression_report(
            e->error, t->at, true, "%s.%s has %zu rows and %s.%s has %zu; take columns of the same length",
            t->name, column->key, column->count, column->next->node->name, column->next->key, rows->count);
    else {
        rows->count = column->count;
        return column;
    }
    return NULL;
}

static bool column_quantity(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    const struct lookup *lookup = e->context;
    struct rows *rows = lookup->rows;
    struct column_cells *column = rows->columns;
    while (column && column->node != t)
        column = column->next;
    if (!column && !(column = column_compute(e, t)))
        return false;
    *result = (struct quantity){.value = (domq_real)column->count};
    if (rows->only_counts)
        return true;
    *result = column->unit;
    if (column->count == 0)
        return expression_no_value(e->error, t->at, "the answer of '%s' has no rows here", t->name);
    const struct cell cell = column->cell[rows->row];
    if (cell.kind == CELL_WORD)
        return expression_wrong(e->error, t->at, "%s.%s consists of words, which only 'count' takes", t->name,
                                column->key);
    if (cell.kind == CELL_NONE)
        return expression_no_value(
            e->error, t->at, "%s.%s has no value in row %zu of %zu; 'if' can choose another value there",
            t->name, column->key, rows->row + 1, column->count);
    result->value *= cell.number;
    return true;
}

/* Evaluates the child of an aggregate in each row of a table. */
static __attribute__((noinline)) bool aggregate_quantity(struct evaluation *e, const struct tree *t,
                                                         struct quantity *result)
{
    struct lookup *lookup = e->context;
    struct rows rows = {.only_counts = t->index == AGGREGATE_COUNT}, *outer = lookup->rows;
    struct quantity value;
    bool good = true;
    lookup->rows = &rows;
    do {
        if (dom_raised(lookup->query->scene->compute.interrupt))
            good = query_status(lookup->query, lookup->problem, DOM_INTERRUPTED);
        else if (!(good = expression_evaluate(e, t->child, &value)))
            break;
        else if (rows.row == 0)
            *result = value;
        else if (!quantity_alike(value, *result))
            good = expression_wrong(e->error, t->at, "%s and %s are in different rows of the same column",
                                    expression_kind(*result), expression_kind(value));
        else
            result->value = t->index == AGGREGATE_SUM   ? result->value + value.value
                            : t->index == AGGREGATE_MIN ? quad_smaller(result->value, value.value)
                                                        : quad_larger(result->value, value.value);
    } while (good && !rows.only_counts && ++rows.row < rows.count);
    lookup->rows = outer;
    for (struct column_cells *column; (column = rows.columns) != NULL;) {
        rows.columns = column->next;
        free(column->cell);
        free(column);
    }
    return good;
}

/* Evaluates a 'let' function. The body of the function sees only the arguments of this function. If another
 * function has called it, the body does not see the arguments of the caller. */
static bool routine_quantity(struct evaluation *e, const struct tree *t, const struct quantity *argument,
                             struct quantity *result)
{
    struct lookup *lookup = e->context;
    const struct routine *routine = t->refers;
    const struct quantity *outer = lookup->argument;
    if (dom_raised(lookup->query->scene->compute.interrupt))
        return problem_status(lookup->problem, lookup->query->scene, DOM_INTERRUPTED);
    lookup->argument = argument;
    bool good = expression_evaluate(e, routine->body, result);
    lookup->argument = outer;
    return good || routine_wrong(e->error, t->at, routine->function);
}

/* Evaluates "(VALUE with NAME VALUE ...)" in a copy of the state. */
static __attribute__((noinline)) bool with_quantity(struct evaluation *e, const struct tree *t,
                                                    struct quantity *result)
{
    struct lookup *lookup = e->context;
    const struct query *outer = lookup->query;
    struct state state;
    struct query changed;
    struct assigned assigned[ASSIGNED_MAX];
    int count = 0;
    for (const struct assignment *a = t->refers; a; a = a->next, count++) {
        struct quantity value;
        assigned[count] = (struct assigned){.parameter = a->parameter, .value = a->item.number};
        if (a->item.value &&
            (!expression_evaluate(e, a->item.value, &value) ||
             !argument_check(outer, a->item.argument, value, &assigned[count].value, lookup->problem)))
            return false;
        if (a->item.value)
            assigned[count].length = share_length(a->parameter, &value);
    }
    if (!query_with(outer, assigned, count, &state, &changed, lookup->problem))
        return false;
    lookup->query = &changed;
    bool good = expression_evaluate(e, t->child, result);
    lookup->query = outer;
    return good;
}

static bool symbol_quantity(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    const struct lookup *lookup = e->context;
    const struct last_answer *ans = lookup->query->ans;
    struct quantity argument[EXPRESSION_ARGUMENTS];
    switch ((enum symbol)t->symbol) {
    case SYMBOL_PARAMETER:
        *result = t->value;
        result->value *= parameter_get(lookup->query->state, t->refers);
        return true;
    case SYMBOL_ARGUMENT:
        *result = lookup->argument[t->index];
        return true;
    case SYMBOL_ANS:
        *result = ans->value;
        return !t->refers || cell_quantity(e, t, ans->cells, "", result);
    case SYMBOL_WITH:
        return with_quantity(e, t, result);
    case SYMBOL_COLUMN:
        return column_quantity(e, t, result);
    case SYMBOL_AGGREGATE:
        return aggregate_quantity(e, t, result);
    case SYMBOL_ROUTINE:
    case SYMBOL_COMMAND:
        break;
    }
    if (!arguments_evaluate(e, t, argument))
        return false;
    return t->symbol == SYMBOL_ROUTINE ? routine_quantity(e, t, argument, result)
                                       : command_quantity(e, t, argument, result);
}

bool query_evaluate(const struct query *query, const struct tree *tree, struct quantity *result,
                    struct expression_error *error, struct problem *problem)
{
    struct lookup lookup = {.query = query, .problem = problem};
    struct evaluation e = {
        .error = error,
        .symbol = symbol_quantity,
        .context = &lookup,
        .angle = query->state->settings.style.angle == ANGLE_DEG ? QUAD_PI / 180 : 1,
    };
    error->message[0] = '\0';
    return expression_evaluate(&e, tree, result);
}
