/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names of a session in expressions. */
#include "interpreter/command.h"
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
    struct session *session = e->context;
    struct cell cells[ANSWER_CELLS];
    struct call call = {.count = count};
    char usage[USAGE_SIZE];
    int fewest, most = command_values(c, &fewest);
    if (most < 0)
        return expression_fail(e, "'%s' has no value in an expression: not all of its arguments are values",
                               command_usage(c, usage));
    if (count < fewest || count > most)
        return expression_fail(e, "%d value%s for '%s'", count, count == 1 ? "" : "s",
                               command_usage(c, usage));
    /* These report their own errors. */
    if (!command_allowed(session, c))
        return false;
    for (int i = 0; i < count; i++)
        if (!argument_check(session, &c->argument[i], arguments[i], &call.number[i]))
            return false;
    return command_keep(session, c, &call, cells) && key_quantity(e, c->name, key, c, cells, result);
}

const char *value_names(const void *context, int k)
{
    for (int n = 0; expression_names(context, n); n++)
        if (k-- == 0)
            return expression_names(context, n);
    return k == 0 ? "ans" : topic_names(context, k - 1);
}

bool session_lookup(struct expression *e, const char *name, const char *key, const struct quantity *arguments,
                    int count, struct quantity *result)
{
    struct session *session = e->context;
    const struct parameter *p = parameter_find(name);
    if (p && parameter_is_number(p) && !key && count == 0) {
        *result = expression_unit(p->value->unit);
        result->value *= parameter_get(session, p);
        return true;
    }
    if (strcmp(name, "ans") == 0 && count == 0)
        return session->ans.command
                   ? key_quantity(e, name, key, session->ans.command, session->ans.cells, result)
                   : expression_fail(e, "there is no earlier answer");
    const struct command *c = command_find(name);
    if (c && c->principal)
        return command_quantity(e, c, key, arguments, count, result);
    const char *close = names_closest(value_names, NULL, name);
    return expression_fail(
        e, close && strcmp(close, name) != 0 ? "'%s' has no value; did you mean '%s'?" : "'%s' has no value",
        name, close);
}
