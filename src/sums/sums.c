/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sum, min, max and count of a column of a table, or of an expression in columns, as in sum(chain(0).weight).
 */
#include "interpreter/question.h"
#include <string.h>

#define MESSAGE_IS_TABLE                                                                                     \
    "'%s' has no value: its answer is a table; 'sum', 'min', 'max' and 'count' make a number of a column, "  \
    "as in 'sum(chain(0).weight)'"

enum aggregate { AGGREGATE_SUM, AGGREGATE_MIN, AGGREGATE_MAX, AGGREGATE_COUNT };
static const char *const names[] = {"sum", "min", "max", "count", NULL};

/* ---- Values ---- */

/* The table over which an aggregate is computed. */
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

/* Finds the number of a column in the current row. All columns of an aggregate must be of the same table. */
static bool column_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    struct quantity argument[EXPRESSION_ARGUMENTS];
    const struct rows *rows = e->rows;
    if (!rows)
        return expression_wrong(e->problem, t->at, MESSAGE_IS_TABLE, t->name);
    const struct column *c = rows->columns;
    const char *key = ((const struct command *)t->refers)->columns[t->index].key;
    bool is_same = t->refers == rows->column->refers;
    e->rows = NULL; /* the arguments of a table are the same for all its rows */
    const bool good = !is_same || t == rows->column || arguments_evaluate(e, t, argument);
    e->rows = (struct rows *)rows;
    if (!good)
        return false;
    for (int i = 0; is_same && t != rows->column && i < t->count; i++)
        is_same =
            quantity_alike(argument[i], rows->argument[i]) && argument[i].value == rows->argument[i].value;
    if (!is_same)
        return expression_wrong(e->problem, t->at, "'%s' is another table; all columns must be of one table",
                                t->name);
    while (c->key && strcmp(c->key, key) != 0)
        c++;
    if (!c->key)
        return expression_no_value(e->problem, t->at, "%s.%s is not in the table here; enter '%s' to see why",
                                   t->name, key, t->name);
    const struct cell *cell = &rows->cells[c - rows->columns];
    if (cell->kind == CELL_WORD)
        return expression_wrong(e->problem, t->at,
                                "%s.%s is the word '%s', not a number; only 'count' takes words", t->name,
                                key, cell->word);
    *result = expression_unit(c->unit);
    result->value *= cell->number;
    return cell->kind != CELL_NONE ||
           expression_no_value(e->problem, t->at,
                               "%s.%s has no value in row %zu; 'if' can choose another value there", t->name,
                               key, rows->count);
}

/* Takes a row (answer.h, sink) and evaluates the child of an aggregate in it. */
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

static bool aggregate_value(struct evaluation *e, const struct tree *t, struct quantity *result);

/* Returns the first column of a table in a tree that is not inside another aggregate, or NULL. */
static const struct tree *column_in(const struct tree *t)
{
    const struct tree *found = t->compute == column_value ? t : NULL;
    for (const struct tree *child = t->child; child && !found && t->compute != aggregate_value;
         child = child->next)
        found = column_in(child);
    return found;
}

static bool aggregate_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    struct rows rows = {.e = e, .aggregate = t, .column = column_in(t->child)}, *outer = e->rows;
    struct cell cells[ANSWER_CELLS];
    struct answer answer = {.kept = cells, .sink = {.take = row_take, .context = &rows}};
    e->rows = NULL;
    bool good = arguments_evaluate(e, rows.column, rows.argument);
    e->rows = &rows;
    good = good && command_run(e, rows.column, rows.argument, &answer) && !rows.failed;
    e->rows = outer;
    *result = t->index == AGGREGATE_COUNT ? (struct quantity){.value = (domq_real)rows.count} : rows.value;
    if (good && rows.count == 0 && t->index != AGGREGATE_COUNT)
        return expression_no_value(e->problem, t->at, "the answer of '%s' has no rows here",
                                   rows.column->name);
    return good;
}

/* ---- Names ---- */

static void aggregate_resolve(struct reader *r, struct tree *t, enum aggregate aggregate)
{
    if (!t->called || t->count != 1 || t->key || !column_in(t->child))
        (void)expression_wrong(r->problem, t->at,
                               "'%s' takes a column of a table, as in '%s(chain(0).weight)'%s", t->name,
                               t->name, aggregate == AGGREGATE_SUM ? "" : ", or two values");
    else if (aggregate == AGGREGATE_COUNT && t->child->compute != column_value)
        (void)expression_wrong(
            r->problem, t->at,
            "'count' counts the rows of a table and takes one of its columns; 'sum(CONDITION)' counts "
            "the rows for which a condition is true");
    else {
        t->compute = aggregate_value;
        t->index = (int)aggregate;
    }
}

static bool sums_resolve(struct reader *r, struct tree *t)
{
    const bool is_call = t->called && t->count == 1 && !t->key;
    /* 'count' is also a command; min and max of two values have been resolved already */
    for (int k = 0; names[k]; k++)
        if (strcmp(names[k], t->name) == 0 && (k == AGGREGATE_SUM || is_call) &&
            (k != AGGREGATE_COUNT || column_in(t->child))) {
            if (r->names)
                aggregate_resolve(r, t, (enum aggregate)k);
            return true;
        }
    const struct command *c = command_find(t->name);
    if (!command_is_table(c))
        return false;
    if (t->key)
        (void)command_resolve(r, t, c, column_value);
    else
        (void)expression_wrong(r->problem, t->at, MESSAGE_IS_TABLE, c->name);
    return true;
}

static const struct aggregates sums = {
    .name = "sum",
    .help =
        "'sum', 'min', 'max' and 'count' make a number of a table: sum(chain(0).weight^2) squares the column "
        "in each row and adds the squares.",
    .resolve = sums_resolve,
};
const struct feature sums_feature = {.name = "sums", .aggregates = &sums};
