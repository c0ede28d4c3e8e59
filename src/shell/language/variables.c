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

/* Allocates a body with a reference count of 1. Returns its text, or NULL if memory runs out. */
static char *body_make(const char *text)
{
    const size_t size = strlen(text) + 1;
    struct body *body = malloc(sizeof *body + size);
    if (!body)
        return NULL;
    atomic_init(&body->users, 1);
    return memcpy(body->text, text, size);
}

static void body_drop(char *text)
{
    if (text && atomic_fetch_sub(&body_of(text)->users, 1) == 1)
        free(body_of(text));
}

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
    if (copy.body && !(copy.body = body_make(copy.body)))
        return false;
    if (!at) {
        struct variable *more = realloc(variables->list, (variables->count + 1) * sizeof *more);
        if (!more) {
            body_drop(copy.body);
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
    struct variable *at = find(variables, name);
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

static bool variable_equal(const struct variable *a, const struct variable *b)
{
    if (strcmp(a->name, b->name) != 0 || a->count != b->count || !a->body != !b->body)
        return false;
    for (int i = 0; i < a->count; i++)
        if (strcmp(a->argument[i], b->argument[i]) != 0)
            return false;
    return a->body ? a->body == b->body || strcmp(a->body, b->body) == 0
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
