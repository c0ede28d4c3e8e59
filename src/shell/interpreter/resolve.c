/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/symbols.h"
#include "session/parameters.h"
#include <string.h>

/* Limits for the height of trees and for nested function calls. Each level uses stack space, and the whole
 * stack may be as small as 128 kB. */
enum { HEIGHT_MAX = 400, DEPTH_MAX = 62 };

/* Reports an error in a tree. The value of the macro is -1. */
#define fail(r, t, ...) (expression_wrong((r)->error, (t)->at, __VA_ARGS__) - 1)

/* Turns a node into a symbol. Returns 0, which is what the functions below return for a node without
 * children. */
static int symbol(struct tree *t, enum symbol kind, const void *refers, int index)
{
    t->kind = TREE_SYMBOL;
    t->symbol = (int)kind;
    t->refers = refers;
    t->index = index;
    return 0;
}

/* The functions below resolve the names in a node of a tree. They return the largest height of the node's
 * children, or 0 if it has none. After an error, they return -1. */

static int children_resolve(struct resolver *r, struct tree *t)
{
    int most = 0;
    for (struct tree *child = t->child; child && most >= 0; child = child->next) {
        int height = resolve(r, child);
        most = height < 0 || height > most ? height : most;
    }
    return most;
}

/* ---- Functions ---- */

void routine_wrong(struct expression_error *error, const char *at, const struct variable *function)
{
    char inside[EXPRESSION_MESSAGE];
    memcpy(inside, error->message, sizeof inside);
    if (*inside && !error->names_function)
        expression_report(error, at, error->of_value, "in '%s': %.180s", variable_head(function), inside);
    error->at = at;
    error->names_function = true;
}

static struct routine *routine_parse(struct resolver *r, const struct tree *t, const struct variable *f)
{
    struct parse p = {
        .text = f->body, .error = r->error, .arena = r->arena, .with = r->with, .context = r->context};
    struct routine *routine = arena_take(r->arena, sizeof *routine);
    struct tree *body = routine ? expression_parse(&p) : NULL;
    if (!routine)
        expression_report(r->error, t->at, false, "out of memory");
    if (!body) {
        r->error->at = t->at;
        return NULL;
    }
    const struct variable *outer = r->scope;
    *routine = (struct routine){.function = f, .body = body, .is_open = true, .next = r->routines};
    r->routines = routine;
    r->scope = f;
    r->depth++;
    routine->height = resolve(r, body);
    r->depth--;
    r->scope = outer;
    routine->is_open = false;
    if (routine->height >= 0)
        return routine;
    routine_wrong(r->error, t->at, f);
    return NULL;
}

static int routine_resolve(struct resolver *r, struct tree *t, const struct variable *f)
{
    struct routine *routine = r->routines;
    if (t->count != f->count)
        return fail(r, t, "'%s' takes %d value%s", variable_head(f), f->count, f->count == 1 ? "" : "s");
    while (routine && routine->function != f)
        routine = routine->next;
    if (routine && routine->is_open)
        return fail(r, t, "'%s' uses itself", variable_head(f));
    int height = children_resolve(r, t);
    if (height < 0 || (!routine && !(routine = routine_parse(r, t, f))))
        return -1;
    symbol(t, SYMBOL_ROUTINE, routine, 0);
    return height > routine->height ? height : routine->height;
}

/* ---- Commands and their keys ---- */

/* Returns the index of the column that a name such as "ans.margin" or "rmax.r" stands for. A name without a
 * key, such as "rmax", stands for the principal column. Stores the unit of the column in the tree. Returns -1
 * after an error. */
static int column_resolve(struct resolver *r, struct tree *t, const struct command *c)
{
    char message[NAMES_MESSAGE], what[64];
    snprintf(what, sizeof what, "key of %s", c->name);
    const bool is_ans = strcmp(t->name, "ans") == 0;
    if (!is_ans && t->key && c->slow_column && strcmp(t->key, c->slow_column) == 0)
        return fail(
            r, t,
            "%s.%s is not available in expressions, because it takes a long time to compute; enter '%s', "
            "and then 'ans.%s'",
            c->name, t->key, c->name, t->key);
    int index = t->key ? names_find(is_ans ? answer_keys : command_keys, c, what, t->key, message)
                       : command_principal(c);
    if (index < 0)
        return fail(r, t, "%s", message);
    t->value = expression_unit(c->columns[index].unit);
    return index;
}

static int command_resolve(struct resolver *r, struct tree *t, const struct command *c)
{
    int fewest, most = command_arity(c, &fewest);
    if (!c->principal)
        return fail(r, t,
                    t->count > 0 ? "'%s' has no value; enter the command without parentheses"
                                 : "'%s' has no value: the answer of this command consists of words or rows",
                    t->name);
    if (most < 0)
        return fail(r, t, "'%s' cannot be used in an expression: it needs an argument that is not a number",
                    command_usage(c));
    if (t->count < fewest || t->count > most)
        return fail(r, t, "'%s' does not take %d value%s", command_usage(c), t->count,
                    t->count == 1 ? "" : "s");
    int index = column_resolve(r, t, c);
    if (index < 0)
        return -1;
    symbol(t, SYMBOL_COMMAND, c, index);
    return children_resolve(r, t);
}

static int ans_resolve(struct resolver *r, struct tree *t)
{
    const struct command *c = r->ans->command;
    if (r->ans->printed && !t->key)
        return symbol(t, SYMBOL_ANS, NULL, 0);
    if (!c)
        return fail(r, t, "there is no earlier answer");
    int index = column_resolve(r, t, c);
    return index < 0 ? -1 : symbol(t, SYMBOL_ANS, c, index);
}

/* ---- Names ---- */

static int unknown(struct resolver *r, const struct tree *t)
{
    const char *close = names_closest(value_names, r->state, t->name);
    const struct parameter *suggested = parameter_by_synonym(t->name, !close);
    if (suggested && names_exact(value_names, r->state, suggested->name) >= 0)
        close = suggested->name;
    return fail(r, t,
                close && strcmp(close, t->name) != 0 ? "'%s' has no value; did you mean '%s'?"
                                                     : "'%s' has no value",
                t->name, close);
}

static int name_resolve(struct resolver *r, struct tree *t)
{
    bool is_bare = t->count == 0 && !t->key;
    for (int i = 0; is_bare && r->scope && i < r->scope->count; i++)
        if (strcmp(r->scope->argument[i], t->name) == 0)
            return symbol(t, SYMBOL_ARGUMENT, NULL, i);
    const struct variable *v = t->key ? NULL : variable_find(&r->state->variables, t->name);
    if (v && v->body)
        return routine_resolve(r, t, v);
    if (v && is_bare) {
        t->kind = TREE_NUMBER;
        t->value = v->value;
        return 0;
    }
    const struct parameter *p = is_bare ? parameter_find(t->name) : NULL;
    if (p && parameter_is_number(p)) {
        t->value = expression_unit(p->value->unit);
        return symbol(t, SYMBOL_PARAMETER, p, 0);
    }
    if (t->count == 0 && strcmp(t->name, "ans") == 0)
        return ans_resolve(r, t);
    const struct command *c = command_find(t->name);
    return c ? command_resolve(r, t, c) : unknown(r, t);
}

static int with_resolve(struct resolver *r, struct tree *t)
{
    int most = children_resolve(r, t);
    for (const struct assignment *a = t->refers; a && most >= 0; a = a->next)
        if (a->item.value) {
            int height = resolve(r, (struct tree *)a->item.value);
            most = height < 0 || height > most ? height : most;
        }
    return most;
}

int resolve(struct resolver *r, struct tree *t)
{
    int height = t->kind == TREE_NAME                                 ? name_resolve(r, t)
                 : t->kind == TREE_SYMBOL && t->symbol == SYMBOL_WITH ? with_resolve(r, t)
                                                                      : children_resolve(r, t);
    if (height >= HEIGHT_MAX || r->depth > DEPTH_MAX)
        return fail(r, t, "the expression is nested too deeply");
    return height < 0 ? -1 : height + 1;
}
