/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/variables.h"
#include "language/quad.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct variable *find(const struct variables *variables, const char *name)
{
    for (size_t i = 0; i < variables->count; i++)
        if (strcmp(variables->list[i].name, name) == 0)
            return &variables->list[i];
    return NULL;
}

const struct variable *variable_find(const struct variables *variables, const char *name)
{
    return find(variables, name);
}

bool variable_put(struct variables *variables, const struct variable *variable)
{
    struct variable copy = *variable, *at = find(variables, variable->name);
    if (variable->body && !(copy.body = strdup(variable->body)))
        return false;
    if (!at) {
        struct variable *more = realloc(variables->list, (variables->count + 1) * sizeof *more);
        if (!more) {
            free(copy.body);
            return false;
        }
        variables->list = more;
        at = &more[variables->count++];
    } else
        free(at->body);
    *at = copy;
    return true;
}

void variable_drop(struct variables *variables, const char *name)
{
    struct variable *at = find(variables, name);
    if (!at)
        return;
    free(at->body);
    memmove(at, at + 1, (size_t)(variables->list + --variables->count - at) * sizeof *at);
}

bool variables_copy(struct variables *to, const struct variables *from)
{
    *to = (struct variables){.list = NULL};
    for (size_t i = 0; i < from->count; i++)
        if (!variable_put(to, &from->list[i])) {
            variables_free(to);
            return false;
        }
    return true;
}

static bool variable_equal(const struct variable *a, const struct variable *b)
{
    if (strcmp(a->name, b->name) != 0 || a->count != b->count || !a->body != !b->body)
        return false;
    for (int i = 0; i < a->count; i++)
        if (strcmp(a->argument[i], b->argument[i]) != 0)
            return false;
    return a->body ? strcmp(a->body, b->body) == 0
                   : a->value.value == b->value.value && quantity_alike(a->value, b->value);
}

bool variables_equal(const struct variables *a, const struct variables *b)
{
    bool equal = a->count == b->count;
    for (size_t i = 0; equal && i < a->count; i++)
        equal = variable_equal(&a->list[i], &b->list[i]);
    return equal;
}

void variables_free(struct variables *variables)
{
    for (size_t i = 0; i < variables->count; i++)
        free(variables->list[i].body);
    free(variables->list);
    *variables = (struct variables){.list = NULL};
}

const char *variable_head(const struct variable *v, char text[VARIABLE_HEAD])
{
    int n = snprintf(text, VARIABLE_HEAD, "%s%s", v->name, v->body ? "(" : "");
    for (int i = 0; i < v->count; i++)
        n += snprintf(text + n, (size_t)(VARIABLE_HEAD - n), "%s%s", i ? ", " : "", v->argument[i]);
    snprintf(text + n, (size_t)(VARIABLE_HEAD - n), "%s", v->body ? ")" : "");
    return text;
}

const char *variable_value(const struct variable *v, char text[VARIABLE_VALUE])
{
    char number[WIDE_TEXT], unit[VARIABLE_VALUE / 2];
    expression_unit_typed(v->value, unit, sizeof unit);
    snprintf(text, VARIABLE_VALUE, "%s%s%s", quad_exact(v->value.value, number), *unit ? " " : "", unit);
    return text;
}
