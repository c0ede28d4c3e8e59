/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names of a session in expressions. */
#include "interpreter/command.h"
#include "session/meant.h"
#include <string.h>

static bool cell_quantity(struct expression *e, const char *name, const struct command *c, int i,
                          const struct cell *cells, struct quantity *result)
{
    if (cells[i].kind == CELL_WORD)
        return expression_fail(e, "%s.%s is the word '%s', not a number", name, c->columns[i].key,
                               cells[i].word);
    if (cells[i].kind == CELL_NONE)
        return expression_no_value(e, "%s.%s does not exist here: '%s' says why", name, c->columns[i].key,
                                   c->name);
    *result = expression_unit(c->columns[i].unit);
    result->value *= cells[i].number;
    return true;
}

static bool key_quantity(struct expression *e, const char *name, const char *key, const struct command *c,
                         const struct cell *cells, struct quantity *result)
{
    char message[NAMES_MESSAGE], what[64];
    int i = command_principal(c);
    if (key) {
        snprintf(what, sizeof what, "key of %s", c->name);
        i = names_find(command_keys, c, what, key, message);
        if (i < 0)
            return expression_fail(e, "%s", message);
    }
    return cell_quantity(e, name, c, i, cells, result);
}

/* Runs a command such as rmax(0.3), and takes one number of its answer as the value. */
static bool command_quantity(struct expression *e, const struct command *c, const char *key,
                             const struct quantity *arguments, int count, struct quantity *result)
{
    const struct lookup *lookup = e->context;
    struct cell cells[ANSWER_CELLS];
    struct arguments given = {.count = count};
    struct query query = *lookup->query;
    char usage[USAGE_SIZE];
    int fewest, most = command_values(c, &fewest);
    if (most < 0)
        return expression_fail(e, "'%s' has no value in an expression: not all of its arguments are values",
                               command_usage(c, usage));
    if (count < fewest || count > most)
        return expression_fail(e, "%d value%s for '%s'", count, count == 1 ? "" : "s",
                               command_usage(c, usage));
    /* These report their own errors. */
    if (!command_allowed(query.means, c, lookup->problem))
        return false;
    for (int i = 0; i < count; i++)
        if (!argument_check(&query, &c->argument[i], arguments[i], &given.number[i], lookup->problem))
            return false;
    query.given = &given;
    query.next = NULL;
    return command_keep(&query, c, cells, lookup->problem) && key_quantity(e, c->name, key, c, cells, result);
}

const char *value_names(const void *context, int k)
{
    const struct state *state = context;
    for (int n = 0; expression_names(NULL, n); n++)
        if (k-- == 0)
            return expression_names(NULL, n);
    int own = state ? (int)state->variables.count : 0;
    return k == 0              ? "ans"
           : state && k <= own ? state->variables.list[k - 1].name
                               : topic_names(NULL, k - 1 - own);
}

/* Evaluates a function of the session; its own arguments are the only ones that its text knows. */
static bool function_quantity(struct expression *e, const struct variable *f,
                              const struct quantity *arguments, int count, struct quantity *result)
{
    const struct lookup *lookup = e->context;
    char head[VARIABLE_HEAD];
    if (count != f->count)
        return expression_fail(e, "'%s' takes %d value%s", variable_head(f, head), f->count,
                               f->count == 1 ? "" : "s");
    for (const struct scope *outer = lookup->scope; outer; outer = outer->outer)
        if (outer->function == f)
            return expression_fail(e, "'%s' uses itself", variable_head(f, head));
    if (dom_raised(lookup->query->scene->compute.interrupt))
        return problem_status(lookup->problem, lookup->query->scene, DOM_INTERRUPTED);
    const struct scope scope = {.function = f, .argument = arguments, .outer = lookup->scope};
    struct lookup inside = {.query = lookup->query, .scope = &scope, .problem = lookup->problem};
    struct expression body = {
        .text = f->body, .lookup = query_lookup, .context = &inside, .angle = e->angle, .depth = e->depth};
    bool good = expression_evaluate(&body, result);
    if (!good && body.named)
        expression_message(e, body.of_value, "%s", body.message);
    else if (!good && body.message[0]) /* else it was reported */
        expression_message(e, body.of_value, "in '%s': %.180s", variable_head(f, head), body.message);
    e->named = !good;
    return good;
}

/* Finds an argument of the function that is being evaluated. */
static bool scope_quantity(const struct scope *scope, const char *name, struct quantity *result)
{
    for (int i = 0; scope && i < scope->function->count; i++)
        if (strcmp(scope->function->argument[i], name) == 0) {
            *result = scope->argument[i];
            return true;
        }
    return false;
}

bool query_lookup(struct expression *e, const char *name, const char *key, const struct quantity *arguments,
                  int count, struct quantity *result)
{
    const struct lookup *lookup = e->context;
    const struct state *state = lookup->query->state;
    const struct ans *ans = lookup->query->ans;
    if (!key && count == 0 && scope_quantity(lookup->scope, name, result))
        return true;
    const struct variable *v = key ? NULL : variable_find(&state->variables, name);
    if (v && v->body)
        return function_quantity(e, v, arguments, count, result);
    if (v && count == 0) {
        *result = v->value;
        return true;
    }
    const struct parameter *p = parameter_find(name);
    if (p && parameter_is_number(p) && !key && count == 0) {
        *result = expression_unit(p->value->unit);
        result->value *= parameter_get(state, p);
        return true;
    }
    if (strcmp(name, "ans") == 0 && count == 0 && !key && ans->printed) {
        *result = ans->value;
        return true;
    }
    if (strcmp(name, "ans") == 0 && count == 0)
        return ans->command ? key_quantity(e, name, key, ans->command, ans->cells, result)
                            : expression_fail(e, "there is no earlier answer");
    const struct command *c = command_find(name);
    if (c && c->principal)
        return command_quantity(e, c, key, arguments, count, result);
    if (c)
        return expression_fail(e,
                               count > 0 ? "'%s' has no value; the command is entered without parentheses"
                                         : "'%s' has no value: its command answers in words or rows",
                               name);
    bool usual;
    const struct parameter *meant = parameter_meant(name, &usual);
    const char *close = names_closest(value_names, state, name);
    if (meant && (usual || !close) && names_exact(value_names, state, meant->name) >= 0)
        close = meant->name;
    return expression_fail(
        e, close && strcmp(close, name) != 0 ? "'%s' has no value; did you mean '%s'?" : "'%s' has no value",
        name, close);
}
