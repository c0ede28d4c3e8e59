/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/variables.h"
#include "language/quad.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct variable *variable_find(const struct variables *variables, const char *name)
{
    for (size_t i = 0; i < variables->count; i++)
        if (strcmp(variables->list[i].name, name) == 0)
            return &variables->list[i];
    return NULL;
}

bool variable_put(struct variables *variables, const struct variable *variable)
{
    size_t i = 0;
    struct variable kept = *variable;
    if (variable->body && !(kept.body = strdup(variable->body)))
        return false;
    while (i < variables->count && strcmp(variables->list[i].name, variable->name) != 0)
        i++;
    if (i == variables->count) {
        struct variable *more = realloc(variables->list, (i + 1) * sizeof *more);
        if (!more) {
            free(kept.body);
            return false;
        }
        variables->list = more;
        variables->list[variables->count++] = (struct variable){.body = NULL};
    }
    free(variables->list[i].body);
    variables->list[i] = kept;
    return true;
}

void variable_drop(struct variables *variables, const char *name)
{
    size_t i = 0;
    while (i < variables->count && strcmp(variables->list[i].name, name) != 0)
        i++;
    if (i == variables->count)
        return;
    free(variables->list[i].body);
    variables->count--;
    memmove(&variables->list[i], &variables->list[i + 1], (variables->count - i) * sizeof *variables->list);
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
    char number[WIDE_TEXT];
    expression_unit_typed(v->value, text, VARIABLE_VALUE);
    char unit[VARIABLE_VALUE / 2];
    snprintf(unit, sizeof unit, "%s", text);
    snprintf(text, VARIABLE_VALUE, "%s%s%s", quad_exact(v->value.value, number), *unit ? " " : "", unit);
    return text;
}
