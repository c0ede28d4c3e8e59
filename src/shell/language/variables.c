/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/variables.h"
#include "language/quad.h"
#include "language/text.h"
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
    struct variable copy = *variable, *at = (struct variable *)variable_find(variables, variable->name);
    copy.body = variable->body ? strdup(variable->body) : NULL;
    struct variable *list =
        at ? variables->list : realloc(variables->list, (variables->count + 1) * sizeof *list);
    if (list)
        variables->list = list;
    if (!list || (variable->body && !copy.body)) {
        free(copy.body);
        return false;
    }
    if (at)
        free(at->body);
    *(at ? at : &list[variables->count++]) = copy;
    return true;
}

void variable_drop(struct variables *variables, const char *name)
{
    struct variable *at = (struct variable *)variable_find(variables, name);
    if (!at)
        return;
    free(at->body);
    memmove(at, at + 1, (size_t)(variables->list + --variables->count - at) * sizeof *at);
}

bool variables_copy(struct variables *to, const struct variables *from)
{
    bool good = true;
    *to = (struct variables){.list = NULL};
    for (size_t i = 0; i < from->count && good; i++)
        good = variable_put(to, &from->list[i]);
    return good;
}

bool variables_equal(const struct variables *one, const struct variables *other)
{
    bool equal = one->count == other->count;
    for (size_t i = 0; equal && i < one->count; i++) {
        const struct variable *a = &one->list[i], *b = &other->list[i];
        equal = strcmp(a->name, b->name) == 0 && a->count == b->count && !a->body == !b->body;
        for (int k = 0; equal && k < a->count; k++)
            equal = strcmp(a->argument[k], b->argument[k]) == 0;
        equal = equal && (a->body ? strcmp(a->body, b->body) == 0
                                  : a->value.value == b->value.value && quantity_alike(a->value, b->value));
    }
    return equal;
}

void variables_free(struct variables *variables)
{
    for (size_t i = 0; i < variables->count; i++)
        free(variables->list[i].body);
    free(variables->list);
    *variables = (struct variables){.list = NULL};
}

const char *variable_head_write(const struct variable *v, char text[VARIABLE_HEAD])
{
    snprintf(text, VARIABLE_HEAD, "%s%s", v->name, v->body ? "(" : "");
    for (int i = 0; i < v->count; i++)
        text_add(text, VARIABLE_HEAD, "%s%s", i ? ", " : "", v->argument[i]);
    text_add(text, VARIABLE_HEAD, "%s", v->body ? ")" : "");
    return text;
}

const char *variable_value(const struct variable *v, char text[VARIABLE_VALUE])
{
    char number[WIDE_TEXT], unit[UNIT_TEXT];
    unit_write(v->value, "*", unit);
    snprintf(text, VARIABLE_VALUE, "%s%s%s", quad_exact(v->value.value, WIDE_DIGITS, number),
             *unit ? " " : "", unit);
    return text;
}
