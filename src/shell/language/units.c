/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/units.h"
#include "language/names.h"
#include "language/quad.h"
#include "language/text.h"
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- The table ---- */

/* A unit as a quotient of integers, such as 254/10000 m for an inch. With one division at the end, 252 cm is
 * exactly the number that 2.52 m is. */
struct unit {
    const char *name;
    const char *words; /* what can be typed instead; completion does not offer these words */
    struct quantity is;
    domq_real over; /* the divisor */
};

static const struct unit units[] = {
    {"m", "meter metre", {.value = 1, .length = 1}, 1},
    {"mm", "millimeter millimetre", {.value = 1, .length = 1}, 1000},
    {"cm", "centimeter centimetre", {.value = 1, .length = 1}, 100},
    {"km", NULL, {.value = 1000, .length = 1}, 1},
    {"in", "inch inche", {.value = 254, .length = 1}, 10000},
    {"ft", "foot feet", {.value = 3048, .length = 1}, 10000},
    {"yd", "yard", {.value = 9144, .length = 1}, 10000},
    {"kg", "kilogram kilo", {.value = 1, .mass = 1}, 1},
    {"g", "gram", {.value = 1, .mass = 1}, 1000},
    {"t", "tonne", {.value = 1000, .mass = 1}, 1},
    {"lb", "pound lbs", {.value = 45359237, .mass = 1}, 100000000},
    {"oz", "ounce", {.value = 45359237, .mass = 1}, 1600000000},
    {"s", "second sec", {.value = 1, .time = 1}, 1},
    {"ms", NULL, {.value = 1, .time = 1}, 1000},
    {"min", "minute min", {.value = 60, .time = 1}, 1},
    {"hr", "hour hr", {.value = 3600, .time = 1}, 1},
    {"mph", NULL, {.value = 1609344, .length = 1, .time = -1}, 3600000},
    {"rad", "radian", {.value = 1, .angle = 1}, 1},
    {"deg", "degree", {.value = QUAD_PI / 180, .angle = 1}, 1},
    {NULL, NULL, {.value = 0}, 1},
};

const char *expression_units(const void *context, int k)
{
    (void)context;
    return units[k].name;
}

/* ---- What a quantity is ---- */

const char *unit_write(struct quantity q, const char *between, char text[UNIT_TEXT])
{
    static const char *const base[] = {"kg", "m", "s", "rad"};
    const int power[] = {q.mass, q.length, q.time, q.angle};
    text[0] = '\0';
    for (int i = 0; i < 4; i++)
        if (power[i] != 0)
            text_add(text, UNIT_TEXT, power[i] == 1 ? "%s%s" : "%s%s^%d", *text ? between : "", base[i],
                     power[i]);
    return text;
}

/* Kinds of quantities. If a kind has no name, messages show its unit. */
static const struct kind {
    struct quantity is;
    const char *name, *example;
} kinds[] = {
    {{.value = 1}, "a plain number", NULL},
    {{.angle = 1}, "an angle", "10 deg"},
    {{.length = 1}, "a length", "48 mm"},
    {{.time = 1}, "a time", "2 s"},
    {{.mass = 1}, "a mass", "10 g"},
    {{.mass = 1, .length = -3}, "a density", "600 kg/m^3"},
    {{.length = 1, .time = -1}, NULL, "2 m/s"},
    {{.angle = 1, .time = -1}, "in rad/s", NULL},
    {{.length = 1, .time = -2}, NULL, "9.81 m/s^2"},
};

static const struct kind *kind_of(struct quantity q)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (quantity_alike(kinds[i].is, q))
            return &kinds[i];
    return NULL;
}

const char *kind_write(struct quantity q, char text[UNIT_TEXT])
{
    const struct kind *kind = kind_of(q);
    if (kind && kind->name)
        return kind->name;
    snprintf(text, UNIT_TEXT, "in %s", expression_unit_text(q));
    return text;
}

const char *expression_example(struct quantity q)
{
    const struct kind *kind = kind_of(q);
    return kind ? kind->example : NULL;
}

/* ---- Scanning ---- */

size_t name_length(const char *c)
{
    size_t n = 0;
    while (name_start(c[n]) || isdigit((unsigned char)c[n]))
        n++;
    return n;
}

bool name_copy(const char *text, size_t length, char *name, size_t size)
{
    size_t n = length < size ? length : size - 1;
    memcpy(name, text, n);
    name[n] = '\0';
    return n == length;
}

void quantity_multiply(struct quantity *q, struct quantity by, int power)
{
    q->value = power == 1    ? q->value * by.value
               : power == -1 ? q->value / by.value
                             : q->value * quad(pow)(by.value, (domq_real)power);
    q->length += power * by.length;
    q->time += power * by.time;
    q->angle += power * by.angle;
    q->mass += power * by.mass;
}

/* Returns the unit of `length` letters at c in a text that begins at `begin`, or NULL. */
static const struct unit *unit_in(const char *begin, const char *c, size_t length)
{
    char word[16];
    const struct unit *u = units;
    /* The letters g and t are units only at the beginning of a unit, as in "5 g". In "2 m/g", g is the
     * acceleration of gravity. In km/h, h is an hour. Elsewhere, h is not a unit but the height. */
    if (c > begin && length == 1 && (*c == 'g' || *c == 't'))
        return NULL;
    if (length == 1 && *c == 'h' && c == begin + 3 && strncmp(begin, "km/", 3) == 0)
        return unit_in("hr", "hr", 2);
    while (u->name && (*u->name != *c || strlen(u->name) != length || strncmp(u->name, c, length) != 0))
        u++;
    if (u->name || !name_copy(c, length, word, sizeof word))
        return u->name ? u : NULL;
    /* a word, or its plural, such as "metres" */
    for (int plural = 0; plural < 2; plural++) {
        for (u = units; u->name; u++)
            if (names_index(u->words, ' ', word) >= 0)
                return u;
        if (length < 2 || word[length - 1] != 's')
            break;
        word[length - 1] = '\0';
    }
    return NULL;
}

const char *unit_scan(const char *begin, struct quantity *q)
{
    const char *c = begin;
    int sign = 1;
    if (strncmp(c, "min(", 4) == 0) /* the function */
        return NULL;
    for (;;) {
        size_t length = name_length(c);
        const struct unit *u = unit_in(begin, c, length);
        if (!u)
            return NULL;
        c += length;
        long power = 1;
        if (c[0] == '^' && (isdigit((unsigned char)c[1]) || (c[1] == '-' && isdigit((unsigned char)c[2])))) {
            char *stop;
            power = strtol(c + 1, &stop, 10);
            if (power > UNIT_POWER_MOST || power < -UNIT_POWER_MOST)
                return NULL;
            c = stop;
        }
        quantity_multiply(q, u->is, sign * (int)power);
        quantity_multiply(q, (struct quantity){.value = u->over}, -sign * (int)power);
        if ((*c != '/' && *c != '*') || !unit_in(begin, c + 1, name_length(c + 1)))
            return c;
        sign = *c == '/' ? -1 : 1;
        c++;
    }
}

struct quantity expression_unit(const char *unit)
{
    struct quantity q = {.value = 1};
    const char *end = *unit ? unit_scan(unit, &q) : NULL;
    return end && *end == '\0' ? q : (struct quantity){.value = 1};
}

const char *length_write(domq_real m, const char *typed, char text[LENGTH_TEXT])
{
    static const char *const lengths[] = {"m", "cm", "mm"};
    const int first = *typed ? -1 : 0, last = *typed ? -1 : 2;
    size_t shortest = LENGTH_TEXT;
    for (int k = first; k <= last; k++) {
        const char *unit = k < 0 ? typed : lengths[k];
        char number[WIDE_TEXT];
        struct quantity q;
        int digits = 5;
        do {
            quad_write(m / expression_unit(unit).value, digits, number);
            q = (struct quantity){.value = quad_read(number, NULL)};
            unit_scan(unit, &q);
        } while (q.value != m && ++digits <= WIDE_DIGITS);
        if (k == first || strlen(number) + 3 < shortest) { /* m, unless another unit is much shorter */
            shortest = strlen(number);
            snprintf(text, LENGTH_TEXT, "%s %s", number, unit);
        }
    }
    return text;
}

/* ---- Variables and functions ---- */

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
