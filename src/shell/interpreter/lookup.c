/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"
#include "language/quad.h"
#include <string.h>

/* The table over which an aggregate such as sum(chain(0).weight) is computed, row by row. */
struct rows {
    struct evaluation *e;
    const struct tree *aggregate;
    const struct tree *column; /* the first column in the aggregate; all others must be of the same table */
    struct quantity argument[EXPRESSION_ARGUMENTS]; /* the arguments of the table's command */
    const struct column *columns;
    const struct cell *cells; /* the current row */
    size_t count;             /* the number of rows so far */
    struct quantity value;    /* the value of the aggregate over these rows */
    bool failed;
};

/* Finds the value of the node t, which is the number in a cell with this unit. If the cell is empty or
 * contains a word, reports an error. `row` is the number of the cell's row in a table, or 0. `reason` is the
 * reason why the cell is empty, or "". */
static bool cell_quantity(struct evaluation *e, const struct tree *t, struct cell cell, struct quantity unit,
                          size_t row, const char *reason, struct quantity *result)
{
    const struct command *c = t->refers;
    const char *key = c->columns[t->index].key;
    if (cell.kind == CELL_WORD)
        return expression_wrong(e->problem, t->at, "%s.%s is the word '%s', not a number%s", t->name, key,
                                cell.word, row ? "; only 'count' takes words" : "");
    *result = unit;
    result->value *= cell.number;
    if (cell.kind != CELL_NONE)
        return true;
    if (row)
        return expression_no_value(e->problem, t->at,
                                   "%s.%s has no value in row %zu; 'if' can choose another value there",
                                   t->name, key, row);
    return expression_no_value(e->problem, t->at,
                               *reason ? "%s.%s has no value here: %s"
                                       : "%s.%s has no value here; enter '%s' to see why",
                               t->name, key, *reason ? reason : c->name);
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

/* A sink (answer.h) that evaluates the child of an aggregate in each row. */
static void row_take(struct answer *answer, const struct cell *cells, const char *reason)
{
    struct rows *rows = answer->sink.context;
    const struct tree *t = rows->aggregate;
    struct quantity value;
    (void)reason;
    rows->columns = answer->columns;
    rows->cells = cells;
    rows->count++;
    if (rows->failed || t->index == AGGREGATE_COUNT)
        return;
    if (!expression_evaluate(rows->e, t->child, &value))
        rows->failed = true;
    else if (rows->count == 1)
        rows->value = value;
    else if (!quantity_alike(value, rows->value)) {
        (void)expression_wrong(rows->e->problem, t->at, "%s and %s are in different rows of the same column",
                               expression_kind(rows->value), expression_kind(value));
        rows->failed = true;
    } else
        rows->value.value = t->index == AGGREGATE_SUM   ? rows->value.value + value.value
                            : t->index == AGGREGATE_MIN ? quad_smaller(rows->value.value, value.value)
                                                        : quad_larger(rows->value.value, value.value);
}

/* Runs a command in an expression. `rows` receives the rows of a table; otherwise it is NULL. */
static bool command_run(struct evaluation *e, const struct tree *t, const struct quantity *argument,
                        struct answer *answer, struct rows *rows)
{
    const struct command *c = t->refers;
    static const struct question no_question;
    struct arguments given = {.count = t->count, .question = &no_question};
    struct query query = *e->query;
    if (!command_allowed(query.run_context, c, e->problem))
        return false;
    for (int i = 0; i < t->count; i++)
        if (!argument_check(&query, &c->argument[i], argument[i], &given.number[i], e->problem))
            return false;
    query.given = &given;
    query.next = NULL;
    *answer = answer_kept(&query, c, answer->kept);
    answer->sink.take = rows ? row_take : NULL;
    answer->sink.context = rows;
    return command_compute(c, &query, answer, e->problem);
}

/* Stores one number of the answer of a command, such as rmax(0.3). */
static __attribute__((noinline)) bool command_quantity(struct evaluation *e, const struct tree *t,
                                                       const struct quantity *argument,
                                                       struct quantity *result)
{
    struct cell cells[ANSWER_CELLS];
    struct answer answer = {.kept = cells};
    return command_run(e, t, argument, &answer, NULL) &&
           cell_quantity(e, t, cells[t->index], t->value, 0, answer.late_reason, result);
}

/* ---- Columns of tables ---- */

/* Finds the number of a column in the current row. All columns of an aggregate must be of the same table. */
static bool column_quantity(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    struct quantity argument[EXPRESSION_ARGUMENTS];
    const struct rows *rows = e->rows;
    const char *key = ((const struct command *)t->refers)->columns[t->index].key;
    int index = 0;
    bool is_same = t->refers == rows->column->refers;
    if (is_same && t != rows->column && !arguments_evaluate(e, t, argument))
        return false;
    for (int i = 0; is_same && t != rows->column && i < t->count; i++)
        is_same =
            quantity_alike(argument[i], rows->argument[i]) && argument[i].value == rows->argument[i].value;
    if (!is_same)
        return expression_wrong(e->problem, t->at, "'%s' is another table; all columns must be of one table",
                                t->name);
    while (rows->columns[index].key && strcmp(rows->columns[index].key, key) != 0)
        index++;
    if (!rows->columns[index].key)
        return expression_no_value(e->problem, t->at, "%s.%s is not in the table here; enter '%s' to see why",
                                   t->name, key, t->name);
    return cell_quantity(e, t, rows->cells[index], expression_unit(rows->columns[index].unit), rows->count,
                         "", result);
}

static __attribute__((noinline)) bool aggregate_quantity(struct evaluation *e, const struct tree *t,
                                                         struct quantity *result)
{
    struct rows rows = {.e = e, .aggregate = t, .column = column_in(t->child)}, *outer = e->rows;
    struct cell cells[ANSWER_CELLS];
    struct answer answer = {.kept = cells};
    e->rows = &rows;
    const bool good = arguments_evaluate(e, rows.column, rows.argument) &&
                      command_run(e, rows.column, rows.argument, &answer, &rows) && !rows.failed;
    e->rows = outer;
    *result = t->index == AGGREGATE_COUNT ? (struct quantity){.value = (domq_real)rows.count} : rows.value;
    if (good && rows.count == 0 && t->index != AGGREGATE_COUNT)
        return expression_no_value(e->problem, t->at, "the answer of '%s' has no rows here",
                                   rows.column->name);
    return good;
}

/* Evaluates a 'let' function. The body of the function sees only the arguments of this function. If another
 * function has called it, the body does not see the arguments of the caller. */
static bool routine_quantity(struct evaluation *e, const struct tree *t, const struct quantity *argument,
                             struct quantity *result)
{
    const struct routine *routine = t->refers;
    const struct quantity *outer = e->argument;
    if (dom_raised(e->query->scene->compute.interrupt))
        return problem_status(e->problem, e->query->scene, DOM_INTERRUPTED);
    e->argument = argument;
    bool good = expression_evaluate(e, routine->body, result);
    e->argument = outer;
    return good || routine_wrong(e->problem, t->at, routine->function);
}

/* ---- Values ---- */

bool item_wrong(struct problem *problem, const struct text *text, const char *name)
{
    char word[NAMES_SHOWN], reason[PROBLEM_TEXT / 4];
    const char *at = problem->at;
    if (!at)
        return false; /* a command in the expression has no answer */
    if (text)
        problem->column = text_column(text, at);
    snprintf(word, sizeof word, "%.*s", (int)strcspn(at, " \t;"), at);
    snprintf(reason, sizeof reason, "%.255s", problem->text);
    snprintf(problem->text, sizeof problem->text, *word ? "%s at '%s': %s" : "%s%s: %s", name,
             names_shown(word), reason);
    problem->at = NULL;
    return false;
}

static bool symbol_quantity(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    const struct last_answer *ans = e->query->ans;
    struct quantity argument[EXPRESSION_ARGUMENTS];
    switch ((enum symbol)t->symbol) {
    case SYMBOL_PARAMETER:
        *result = t->value;
        result->value *= parameter_get(e->query->state, t->refers);
        return true;
    case SYMBOL_ARGUMENT:
        *result = e->argument[t->index];
        return true;
    case SYMBOL_ANS:
        *result = ans->value;
        return !t->refers || cell_quantity(e, t, ans->cells[t->index], t->value, 0, "", result);
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

struct evaluation query_evaluation(const struct query *query, struct problem *problem)
{
    return (struct evaluation){
        .problem = problem,
        .query = query,
        .symbol = symbol_quantity,
        .angle = query->state->settings.style.angle == ANGLE_DEG ? QUAD_PI / 180 : 1,
    };
}

bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem)
{
    struct evaluation e = query_evaluation(query, problem);
    struct quantity own, *q = quantity ? quantity : &own;
    *q = (struct quantity){.value = item->number};
    if (item->at)
        problem->place = text_column(text, item->at);
    if (item->value && !expression_evaluate(&e, item->value, q))
        return item_wrong(problem, text, item->argument->name);
    *number = q->value;
    return !item->value || argument_check(query, item->argument, *q, number, problem);
}

/* ---- Questions ---- */

bool question_bind(const struct question *q, const struct query *query, struct call *call,
                   struct problem *problem)
{
    struct assigned assigned[ASSIGNED_MAX];
    int count = 0;
    call->given = (struct arguments){.count = q->count, .bound = q->parsed, .question = q};
    call->query = *query;
    if (!command_allowed(query->run_context, q->command, problem))
        return false;
    for (const struct assignment *with = q->with; with; with = with->next) {
        struct quantity typed;
        assigned[count] = (struct assigned){.parameter = with->parameter};
        if (!item_bind(&with->item, q->text, query, &typed, &assigned[count].value, problem))
            return false;
        assigned[count++].length = share_length(with->parameter, &typed);
    }
    if (count > 0 && !query_with(query, assigned, count, &call->state, &call->query, problem))
        return false;
    call->query.given = &call->given;
    for (int i = 0; i < q->count; i++) {
        const struct argument *a = &q->command->argument[i];
        const struct item *item = &q->item[i];
        call->given.word[i] = item->word;
        call->given.column[i] = item->at ? text_column(q->text, item->at) : 0;
        if (!item_bind(item, q->text, &call->query, &call->given.quantity[i], &call->given.number[i],
                       problem) ||
            (a->bind && !a->bind(q, &call->query, &call->given, problem)))
            return false;
    }
    return true;
}

void *arguments_take(struct arguments *given, size_t size, const struct query *query, struct problem *problem)
{
    given->bound = arena_take(&given->memory, size);
    if (!given->bound)
        problem_status(problem, query->scene, DOM_NO_MEMORY);
    return given->bound;
}
