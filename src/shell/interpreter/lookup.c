/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/compute.h"
#include "interpreter/symbols.h"
#include "language/quad.h"
#include <string.h>

struct lookup {
    const struct query *query;
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

/* Runs a command in an expression, such as rmax(0.3), and stores one number of its answer. */
static __attribute__((noinline)) bool command_quantity(struct evaluation *e, const struct tree *t,
                                                       const struct quantity *argument,
                                                       struct quantity *result)
{
    const struct lookup *lookup = e->context;
    const struct command *c = t->refers;
    struct cell cells[ANSWER_CELLS];
    struct arguments given = {.count = t->count};
    struct query query = *lookup->query;
    if (!command_allowed(query.run_context, c, lookup->problem))
        return false;
    for (int i = 0; i < t->count; i++)
        if (!argument_check(&query, &c->argument[i], argument[i], &given.number[i], lookup->problem))
            return false;
    query.given = &given;
    query.next = NULL;
    struct answer answer = answer_kept(&query, c, cells);
    return command_compute(c, &query, &answer, lookup->problem) &&
           cell_quantity(e, t, cells, answer.late_reason, result);
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
    if (!good)
        routine_wrong(e->error, t->at, routine->function);
    return good;
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
    const struct tree *child = t->child;
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
    case SYMBOL_ROUTINE:
    case SYMBOL_COMMAND:
        break;
    }
    for (int i = 0; i < t->count; i++, child = child->next)
        if (!expression_evaluate(e, child, &argument[i]))
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
