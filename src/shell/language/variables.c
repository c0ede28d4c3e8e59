/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/variables.h"
#include "language/quad.h"
#include "language/text.h"
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The text of a function with its reference count. Each step of 'undo' has a copy of every variable. To save
 * memory, all copies of a function share one text. */
struct body {
    atomic_size_t users;
    char text[];
};

static struct body *body_of(char *text)
{
    return (struct body *)(void *)(text - offsetof(struct body, text));
}

static void body_drop(char *text)
{
    if (text && atomic_fetch_sub(&body_of(text)->users, 1) == 1)
        free(body_of(text));
}

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
    const size_t size = copy.body ? strlen(copy.body) + 1 : 0;
    struct body *body = size ? malloc(sizeof *body + size) : NULL;
    if (size && !body)
        return false;
    if (body) {
        atomic_init(&body->users, 1);
        copy.body = memcpy(body->text, copy.body, size);
    }
    if (!at) {
        struct variable *more = realloc(variables->list, (variables->count + 1) * sizeof *more);
        if (!more) {
            free(body);
            return false;
        }
        variables->list = more;
        at = &more[variables->count++];
    } else
        body_drop(at->body);
    *at = copy;
    return true;
}

void variable_drop(struct variables *variables, const char *name)
{
    struct variable *at = (struct variable *)variable_find(variables, name);
    if (!at)
        return;
    body_drop(at->body);
    memmove(at, at + 1, (size_t)(variables->list + --variables->count - at) * sizeof *at);
}

bool variables_copy(struct variables *to, const struct variables *from)
{
    const size_t size = from->count * sizeof *from->list;
    *to = (struct variables){.list = size ? malloc(size) : NULL};
    if (!to->list)
        return size == 0;
    memcpy(to->list, from->list, size);
    to->count = from->count;
    for (size_t i = 0; i < to->count; i++)
        if (to->list[i].body)
            body_of(to->list[i].body)->users++;
    return true;
}

bool variables_equal(const struct variables *one, const struct variables *other)
{
    bool equal = one->count == other->count;
    for (size_t i = 0; equal && i < one->count; i++) {
        const struct variable *a = &one->list[i], *b = &other->list[i];
        equal = strcmp(a->name, b->name) == 0 && a->count == b->count && !a->body == !b->body;
        for (int k = 0; equal && k < a->count; k++)
            equal = strcmp(a->argument[k], b->argument[k]) == 0;
        equal = equal && (a->body ? a->body == b->body || strcmp(a->body, b->body) == 0
                                  : a->value.value == b->value.value && quantity_alike(a->value, b->value));
    }
    return equal;
}

void variables_free(struct variables *variables)
{
    for (size_t i = 0; i < variables->count; i++)
        body_drop(variables->list[i].body);
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
