/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/symbols.h"
#include "language/landmarks.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/parameters.h"
#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* Reports an error in a tree. The value of the macro is false. */
#define fail(r, t, ...) expression_wrong((r)->error, (t)->at, __VA_ARGS__)

/* Turns a node into a symbol. */
static bool symbol(struct tree *t, enum symbol kind, const void *refers, int index)
{
    t->kind = TREE_SYMBOL;
    t->symbol = (int)kind;
    t->refers = refers;
    t->index = index;
    return true;
}

static bool children_resolve(struct resolver *r, struct tree *t)
{
    bool good = true;
    for (struct tree *child = t->child; child && good; child = child->next)
        good = resolve(r, child);
    return good;
}

/* Goes down by `levels`. The caller goes up again, even after an error. */
static bool descend(struct resolver *r, const struct tree *t, int levels)
{
    r->depth += levels;
    r->deepest = r->depth > r->deepest ? r->depth : r->deepest;
    return r->depth <= NESTING_MOST || fail(r, t, NESTED_TOO_DEEPLY);
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
    struct parse p = {.text = f->body,
                      .error = r->error,
                      .arena = r->arena,
                      .with = r->with,
                      .context = r->context,
                      .depth = r->depth};
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
    const int deepest = r->deepest;
    const bool in_aggregate = r->in_aggregate;
    r->scope = f;
    r->in_aggregate = false;
    r->deepest = r->depth;
    const bool good = resolve(r, body);
    r->in_aggregate = in_aggregate;
    routine->height = r->deepest - r->depth;
    r->deepest = deepest > r->deepest ? deepest : r->deepest;
    r->scope = outer;
    routine->is_open = false;
    if (good)
        return routine;
    routine_wrong(r->error, t->at, f);
    return NULL;
}

static bool routine_resolve(struct resolver *r, struct tree *t, const struct variable *f)
{
    struct routine *routine = r->routines;
    if (t->count != f->count)
        return fail(r, t, "'%s' takes %d value%s", variable_head(f), f->count, f->count == 1 ? "" : "s");
    while (routine && routine->function != f)
        routine = routine->next;
    if (routine && routine->is_open)
        return fail(r, t, "'%s' uses itself", variable_head(f));
    if (!children_resolve(r, t))
        return false;
    bool good = true;
    if (routine) { /* the body has been resolved at another level */
        good = descend(r, t, routine->height);
        r->depth -= routine->height;
    } else
        routine = routine_parse(r, t, f);
    return good && routine && symbol(t, SYMBOL_ROUTINE, routine, 0);
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

static bool command_resolve(struct resolver *r, struct tree *t, const struct command *c)
{
    int fewest, most = command_values(c, &fewest);
    const bool has_rows = command_is_table(c);
    if (has_rows && (!r->in_aggregate || !t->key))
        return fail(
            r, t,
            "'%s' has no value: its answer is a table; 'sum', 'min', 'max' and 'count' make a number of a "
            "column, as in 'sum(chain(0).weight)'",
            c->name);
    if (!c->principal && !has_rows)
        return fail(r, t,
                    t->count > 0 ? "'%s' has no value; enter the command without parentheses"
                                 : "'%s' has no value: the answer of this command consists of words or rows",
                    t->name);
    if (most < 0)
        return fail(r, t, "'%s' cannot be used in an expression: it needs an argument that is not a number",
                    command_usage(c));
    const char *next = skip_blanks(t->at + name_length(t->at));
    if (!t->called && !t->key && fewest == 1 && isdigit((unsigned char)next[*next == '.']))
        return fail(r, t, "in an expression, the argument of '%s' stands in parentheses: '%s(%.*s)'", c->name,
                    c->name, (int)strcspn(next, " \t;,)"), next);
    if (t->count == 0 && fewest == 1)
        return fail(r, t, "'%s' needs a value in parentheses: '%s(%s)%s%s'", c->name, c->name,
                    c->argument[0].name, t->key ? "." : "", t->key ? t->key : "");
    if (t->count < fewest || t->count > most)
        return fail(r, t, "'%s' does not take %d value%s", command_usage(c), t->count,
                    t->count == 1 ? "" : "s");
    int index = column_resolve(r, t, c);
    if (index < 0)
        return false;
    symbol(t, has_rows ? SYMBOL_COLUMN : SYMBOL_COMMAND, c, index);
    const bool outer = r->in_aggregate;
    r->in_aggregate = outer && !has_rows; /* the arguments of a table are the same for all its rows */
    const bool good = children_resolve(r, t);
    r->in_aggregate = outer;
    return good;
}

static bool ans_resolve(struct resolver *r, struct tree *t)
{
    const struct command *c = r->ans->command;
    if (r->ans->printed && !t->key)
        return symbol(t, SYMBOL_ANS, NULL, 0);
    if (!c)
        return fail(r, t, "there is no earlier answer");
    int index = column_resolve(r, t, c);
    return index >= 0 && symbol(t, SYMBOL_ANS, c, index);
}

/* ---- Aggregates ---- */

static const char *const aggregates[] = {"sum", "min", "max", "count", NULL};

/* Returns the number of an enum aggregate if the node is a call such as "sum(X)", or -1. */
static int aggregate_of(const struct tree *t)
{
    for (int k = 0; t->kind == TREE_NAME && t->called && !t->key && t->count == 1 && aggregates[k]; k++)
        if (strcmp(aggregates[k], t->name) == 0)
            return k;
    return -1;
}

/* Returns true if the value of the tree depends on the row of a table. */
static bool has_column(const struct tree *t)
{
    if (t->kind == TREE_NAME && command_is_table(command_find(t->name)))
        return true;
    bool has = false;
    for (const struct tree *child = t->child; child && !has; child = child->next)
        has = aggregate_of(child) < 0 ? has_column(child) : false;
    return has;
}

static bool aggregate_resolve(struct resolver *r, struct tree *t, enum aggregate kind)
{
    const bool outer = r->in_aggregate;
    if (kind == AGGREGATE_COUNT && t->child->kind != TREE_NAME)
        return fail(
            r, t,
            "'count' counts the rows of a table and takes one of its columns; 'sum(CONDITION)' counts "
            "the rows for which a condition is true");
    r->in_aggregate = true;
    const bool good = children_resolve(r, t);
    r->in_aggregate = outer;
    return good && symbol(t, SYMBOL_AGGREGATE, NULL, (int)kind);
}

/* ---- Names ---- */

static bool unknown(struct resolver *r, const struct tree *t)
{
    const struct parameter *p = parameter_by_value(t->name);
    if (p)
        return fail(r, t, "'%s' is a value of %s; enter 'set %s %s', or write 'with %s %s' at the end",
                    t->name, p->name, p->name, t->name, p->name, t->name);
    const char *close = names_closest(value_names, r->state, t->name);
    for (int k = 0; !close && t->name[1] && landmark_names(NULL, k); k++)
        if (strncmp(landmark_names(NULL, k), t->name, strlen(t->name)) == 0)
            close = landmark_names(NULL, k);
    const struct parameter *suggested = parameter_by_synonym(t->name, !close);
    if (suggested && names_exact(value_names, r->state, suggested->name) >= 0)
        close = suggested->name;
    return fail(r, t,
                close && strcmp(close, t->name) != 0 ? "'%s' has no value; did you mean '%s'?"
                                                     : "'%s' has no value",
                t->name, close);
}

static bool name_resolve(struct resolver *r, struct tree *t)
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
        return true;
    }
    const int aggregate = aggregate_of(t);
    if (aggregate >= 0 && has_column(t))
        return aggregate_resolve(r, t, (enum aggregate)aggregate);
    if (aggregate != AGGREGATE_COUNT && (aggregate >= 0 || strcmp(t->name, "sum") == 0))
        return fail(r, t, "'%s' takes a column of a table, as in '%s(chain(0).weight)'%s", t->name, t->name,
                    strcmp(t->name, "sum") == 0 ? "" : ", or two values");
    const struct parameter *p = is_bare ? parameter_find(t->name) : NULL;
    if (p && parameter_is_number(p)) {
        t->value = expression_unit(p->value->unit);
        return symbol(t, SYMBOL_PARAMETER, p, 0);
    }
    if (t->count == 0 && strcmp(t->name, "ans") == 0)
        return ans_resolve(r, t);
    const struct command *c = command_find(t->name);
    const struct landmark *l = c || !is_bare ? NULL : landmark_find(t->name);
    if (l) {
        t->kind = TREE_NUMBER;
        t->value = expression_unit("m");
        t->value.value = quad_read(l->height, NULL);
        return true;
    }
    return c ? command_resolve(r, t, c) : unknown(r, t);
}

static bool with_resolve(struct resolver *r, struct tree *t)
{
    bool good = descend(r, t, NESTING_WITH) && children_resolve(r, t);
    const bool outer = r->in_aggregate;
    r->in_aggregate = false; /* the assignments are the same for all rows of a table */
    for (const struct assignment *a = t->refers; a && good; a = a->next)
        good = !a->item.value || resolve(r, (struct tree *)a->item.value);
    r->in_aggregate = outer;
    r->depth -= NESTING_WITH;
    return good;
}

bool resolve(struct resolver *r, struct tree *t)
{
    bool good =
        descend(r, t, 1) && (t->kind == TREE_NAME                                 ? name_resolve(r, t)
                             : t->kind == TREE_SYMBOL && t->symbol == SYMBOL_WITH ? with_resolve(r, t)
                                                                                  : children_resolve(r, t));
    r->depth--;
    return good;
}
