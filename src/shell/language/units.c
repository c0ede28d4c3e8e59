/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/units.h"
#include "language/quad.h"
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- The table ---- */

struct unit {
    const char *name;
    struct quantity is;
};

#define DEGREE (QUAD_PI / 180)

/* As quotients of whole numbers, so that they are right in the widest arithmetic. */
#define PART(n, m) ((domq_real)(n) / (m))

static const struct unit units[] = {
    {"m", {1, 1, 0, 0}},
    {"mm", {PART(1, 1000), 1, 0, 0}},
    {"cm", {PART(1, 100), 1, 0, 0}},
    {"km", {1000, 1, 0, 0}},
    {"in", {PART(254, 10000), 1, 0, 0}},
    {"ft", {PART(3048, 10000), 1, 0, 0}},
    {"s", {1, 0, 1, 0}},
    {"ms", {PART(1, 1000), 0, 1, 0}},
    {"rad", {1, 0, 0, 1}},
    {"deg", {DEGREE, 0, 0, 1}},
    {NULL, {0, 0, 0, 0}},
};

const char *expression_units(const void *context, int k)
{
    (void)context;
    return units[k].name;
}

/* ---- What a quantity is ---- */

bool quantity_plain(struct quantity q)
{
    return q.length == 0 && q.time == 0;
}

const char *expression_unit_text(struct quantity q, char *text, size_t size)
{
    static const char *const base[] = {"m", "s", "rad"};
    const int power[] = {q.length, q.time, q.angle};
    text[0] = '\0';
    for (int i = 0; i < 3; i++) {
        size_t used = strlen(text);
        if (power[i] != 0)
            snprintf(text + used, size - used, power[i] == 1 ? "%s%s" : "%s%s^%d", used ? " " : "", base[i],
                     power[i]);
    }
    return text;
}

const char *expression_kind(struct quantity q, char *text, size_t size)
{
    char unit[48];
    if (quantity_plain(q) && (q.angle == 0 || q.angle == 1))
        return q.angle ? "an angle" : "a plain number";
    if (q.time == 0 && q.length == 1)
        return "a length";
    if (q.length == 0 && q.time == 1 && q.angle == 0)
        return "a time";
    snprintf(text, size, "in %s", expression_unit_text(q, unit, sizeof unit));
    return text;
}

/* ---- Scanning ---- */

bool name_start(char c)
{
    return isalpha((unsigned char)c) || c == '_';
}

size_t name_length(const char *c)
{
    size_t n = 0;
    while (name_start(c[n]) || isdigit((unsigned char)c[n]))
        n++;
    return n;
}

static const struct unit *unit_at(const char *c, size_t length)
{
    for (const struct unit *u = units; u->name; u++)
        if (strlen(u->name) == length && strncmp(u->name, c, length) == 0)
            return u;
    return NULL;
}

void quantity_multiply(struct quantity *q, struct quantity by, int power)
{
    q->value = power == 1    ? q->value * by.value
               : power == -1 ? q->value / by.value
                             : q->value * quad(pow)(by.value, (domq_real)power);
    q->length += power * by.length;
    q->time += power * by.time;
    q->angle += power * by.angle;
}

const char *unit_scan(const char *c, struct quantity *q)
{
    int sign = 1;
    for (;;) {
        size_t length = name_length(c);
        const struct unit *u = unit_at(c, length);
        if (!u)
            return NULL;
        c += length;
        long power = 1;
        if (c[0] == '^' && (isdigit((unsigned char)c[1]) || (c[1] == '-' && isdigit((unsigned char)c[2])))) {
            char *stop;
            power = strtol(c + 1, &stop, 10);
            if (power > 9 || power < -9)
                return NULL;
            c = stop;
        }
        quantity_multiply(q, u->is, sign * (int)power);
        if ((*c != '/' && *c != '*') || !unit_at(c + 1, name_length(c + 1)))
            return c;
        sign = *c == '/' ? -1 : 1;
        c++;
    }
}

struct quantity expression_unit(const char *unit)
{
    struct quantity q = {1, 0, 0, 0};
    const char *end = *unit ? unit_scan(unit, &q) : NULL;
    return end && *end == '\0' ? q : (struct quantity){1, 0, 0, 0};
}
