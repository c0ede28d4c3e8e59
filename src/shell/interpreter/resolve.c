/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/parameters.h"
#include <stdio.h>
#include <string.h>

bool is_value_name(const struct state *state, const char *name)
{
    return names_exact(value_names, state, name) >= 0;
}

/* Reports an error in a tree. The value of the macro is false. */
#define fail(r, t, ...) expression_wrong((r)->problem, (t)->at, __VA_ARGS__)

/* Turns a node into a symbol. */
static bool symbol(struct tree *t, enum symbol kind, const void *refers, int index)
{
    t->kind = TREE_SYMBOL;
    t->symbol = (int)kind;
    t->refers = refers;
    t->index = index;
    return true;
}

/* ---- Columns of tables ---- */

const struct tree *column_in(const struct tree *t)
{
    const struct tree *found = t->kind == TREE_SYMBOL && t->symbol == SYMBOL_COLUMN ? t : NULL;
    if (t->kind == TREE_SYMBOL && t->symbol == SYMBOL_AGGREGATE)
        return NULL;
    for (const struct tree *child = t->child; child && !found; child = child->next)
        found = column_in(child);
    return found;
}

#define IS_TABLE                                                                                             \
    "'%s' has no value: its answer is a table; 'sum', 'min', 'max' and 'count' make a number of a column, "  \
    "as in 'sum(chain(0).weight)'"

bool is_single(struct problem *problem, const struct tree *tree)
{
    const struct tree *column = column_in(tree);
    return !column || expression_wrong(problem, column->at, IS_TABLE, column->name);
}

static const char *const aggregates[] = {"sum", "min", "max", "count", NULL};

/* Returns the number of an enum aggregate if the node is a call such as "sum(X)", or -1. */
static int aggregate_of(const struct tree *t)
{
    for (int k = 0; t->called && !t->key && t->count == 1 && aggregates[k]; k++)
        if (strcmp(aggregates[k], t->name) == 0)
            return k;
    return -1;
}

/* ---- Functions ---- */

bool routine_wrong(struct problem *problem, const char *at, const struct variable *function)
{
    char inside[PROBLEM_TEXT];
    if (!problem->at)
        return false;
    memcpy(inside, problem->text, sizeof inside);
    if (!problem->of_function)
        snprintf(problem->text, sizeof problem->text, "in '%s': %.180s", variable_head(function), inside);
    problem->of_function = true;
    problem->at = at;
    return false;
}

static bool routine_parse(struct reader *r, const struct tree *t, struct routine *routine)
{
    struct reader body = *r;
    body.at = routine->function->body;
    body.scope = routine->function;
    body.no_unit = NULL;
    body.deepest = r->depth;
    routine->is_open = true;
    routine->body = expression_parse(&body);
    routine->is_open = false;
    routine->height = body.deepest - r->depth;
    r->routines = body.routines;
    return (routine->body && is_single(r->problem, routine->body)) ||
           routine_wrong(r->problem, t->at, routine->function);
}

static bool routine_resolve(struct reader *r, struct tree *t, const struct variable *f)
{
    struct routine *routine = r->routines;
    if (t->count != f->count)
        return fail(r, t, "'%s' takes %d value%s", variable_head(f), f->count, f->count == 1 ? "" : "s");
    while (routine && routine->function != f)
        routine = routine->next;
    if (routine && routine->is_open)
        return fail(r, t, "'%s' uses itself", variable_head(f));
    if (!routine) {
        routine = arena_take(r->arena, sizeof *routine);
        if (!routine)
            return fail(r, t, "out of memory");
        *routine = (struct routine){.function = f, .next = r->routines};
        r->routines = routine;
        if (!routine_parse(r, t, routine))
            return false;
    }
    const int deepest = r->depth + routine->height;
    r->deepest = deepest > r->deepest ? deepest : r->deepest;
    return deepest <= NESTING_MOST ? symbol(t, SYMBOL_ROUTINE, routine, 0) : fail(r, t, NESTED_TOO_DEEPLY);
}

/* ---- Commands and their keys ---- */

/* Returns the index of the column that a name such as "ans.margin" or "rmax.r" stands for. A name without a
 * key, such as "rmax", stands for the principal column. Stores the unit of the column in the tree. Returns -1
 * after an error. */
static int column_resolve(struct reader *r, struct tree *t, const struct command *c)
{
    char message[NAMES_MESSAGE], what[64];
    snprintf(what, sizeof what, "key of %s", c->name);
    const bool is_ans = strcmp(t->name, "ans") == 0;
    if (!is_ans && t->key && c->sweep.slow_column && strcmp(t->key, c->sweep.slow_column) == 0)
        return fail(r, t,
                    "%s.%s is not available in expressions, because it takes a long time to compute; enter "
                    "'%s', and then 'ans.%s'",
                    c->name, t->key, c->name, t->key) -
               1;
    names_list *const list = is_ans ? answer_keys : command_keys;
    int index = t->key ? names_find(list, c, what, t->key, message) : command_principal(c);
    if (index == NAMES_UNKNOWN)
        return fail(r, t, "%s; its keys are %s", message, names_join(list, c, "", (char[NAMES_ALL]){""})) - 1;
    if (index < 0)
        return fail(r, t, "%s", message) - 1;
    t->value = expression_unit(c->columns[index].unit);
    return index;
}

static bool command_resolve(struct reader *r, struct tree *t, const struct command *c)
{
    int fewest, most = command_values(c, &fewest);
    const bool has_rows = command_is_table(c);
    if (has_rows && !t->key)
        return fail(r, t, IS_TABLE, c->name);
    if (most < 0 || (!c->principal && !has_rows))
        return fail(r, t, "'%s' has no value in an expression; enter the command alone", c->name);
    if (t->count == 0 && fewest == 1)
        return fail(r, t, "'%s' needs a value in parentheses: '%s(%s)%s%s'", c->name, c->name,
                    c->argument[0].name, t->key ? "." : "", t->key ? t->key : "");
    if (t->count < fewest || t->count > most)
        return fail(r, t, "'%s' does not take %d value%s", command_usage(c), t->count,
                    t->count == 1 ? "" : "s");
    for (const struct tree *child = t->child; child && has_rows; child = child->next)
        if (!is_single(r->problem, child)) /* the arguments of a table are the same for all its rows */
            return false;
    const int index = column_resolve(r, t, c);
    return index >= 0 && symbol(t, has_rows ? SYMBOL_COLUMN : SYMBOL_COMMAND, c, index);
}

/* ---- Names ---- */

static bool unknown(struct reader *r, const struct tree *t)
{
    const struct state *state = r->query->state;
    char message[NAMES_MESSAGE];
    if (parameter_by_value(t->name, message))
        return fail(r, t, "%s", message);
    const char *close = names_closest(value_names, state, t->name);
    const struct parameter *suggested = parameter_by_synonym(t->name, !close);
    if (suggested && is_value_name(state, suggested->name))
        close = suggested->name;
    return fail(r, t,
                close && strcmp(close, t->name) != 0 ? "'%s' has no value; did you mean '%s'?"
                                                     : "'%s' has no value",
                t->name, close);
}

static bool number(struct tree *t, struct quantity value)
{
    t->kind = TREE_NUMBER;
    t->value = value;
    return true;
}

bool name_resolve(struct reader *r, struct tree *t)
{
    const bool is_bare = t->count == 0 && !t->key;
    for (int i = 0; is_bare && r->scope && i < r->scope->count; i++)
        if (strcmp(r->scope->argument[i], t->name) == 0)
            return symbol(t, SYMBOL_ARGUMENT, NULL, i);
    const struct variable *v = t->key ? NULL : variable_find(&r->query->state->variables, t->name);
    if (v && v->body)
        return routine_resolve(r, t, v);
    if (v && is_bare)
        return number(t, v->value);
    const int aggregate = aggregate_of(t);
    if (aggregate >= 0 && column_in(t->child)) {
        if (aggregate != AGGREGATE_COUNT || t->child->symbol == SYMBOL_COLUMN)
            return symbol(t, SYMBOL_AGGREGATE, NULL, aggregate);
        return fail(
            r, t,
            "'count' counts the rows of a table and takes one of its columns; 'sum(CONDITION)' counts "
            "the rows for which a condition is true");
    }
    if (aggregate != AGGREGATE_COUNT && (aggregate >= 0 || strcmp(t->name, "sum") == 0))
        return fail(r, t, "'%s' takes a column of a table, as in '%s(chain(0).weight)'%s", t->name, t->name,
                    strcmp(t->name, "sum") == 0 ? "" : ", or two values");
    const struct parameter *parameter = is_bare ? parameter_find(t->name) : NULL;
    if (parameter && parameter_is_number(parameter)) {
        t->value = expression_unit(parameter->value->unit);
        return symbol(t, SYMBOL_PARAMETER, parameter, 0);
    }
    if (t->count == 0 && strcmp(t->name, "ans") == 0) {
        if (r->query->ans->printed && !t->key)
            return symbol(t, SYMBOL_ANS, NULL, 0);
        if (!r->query->ans->command)
            return fail(r, t, "there is no earlier answer");
        const int index = column_resolve(r, t, r->query->ans->command);
        return index >= 0 && symbol(t, SYMBOL_ANS, r->query->ans->command, index);
    }
    const struct command *c = command_find(t->name);
    struct quantity value;
    const char *end, *name;
    if (!c && is_bare && feature_value(t->name, &name, &end, &value) && !*end)
        return number(t, value);
    return c ? command_resolve(r, t, c) : unknown(r, t);
}
