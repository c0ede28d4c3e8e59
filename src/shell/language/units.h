/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quantities: numbers with units, and variables, which store them. Units are checked: a length is an error
 * where an angle is needed. */
#pragma once

#include "language/quad.h"
#include <ctype.h>
#include <stdbool.h>
#include <stddef.h>

/* A value in SI units and radians, with its unit. The unit is given by the exponents of metre, second, radian
 * and kilogram: a speed has length = 1 and time = -1. */
struct quantity {
    domq_real value;
    int length, time, angle, mass;
};

/* Returns true if the unit contains no length, time or mass. This holds for plain numbers and angles. */
static inline bool quantity_is_dimensionless(struct quantity q)
{
    return q.length == 0 && q.time == 0 && q.mass == 0;
}

/* Returns true for a number without any unit. */
static inline bool quantity_is_number(struct quantity q)
{
    return quantity_is_dimensionless(q) && q.angle == 0;
}

/* Returns true if both quantities have the same unit. */
static inline bool quantity_alike(struct quantity a, struct quantity b)
{
    return a.length == b.length && a.time == b.time && a.angle == b.angle && a.mass == b.mass;
}

/* Multiplies *quantity by a power of `by`. */
void quantity_multiply(struct quantity *quantity, struct quantity by, int power);

/* Returns a unit such as "m/s^2" as a quantity. Some columns have a unit that cannot be typed, such as "h" or
 * "mgh/2". For such a unit, returns the plain number 1. */
struct quantity expression_unit(const char *unit);

/* Writes the unit of a quantity, or "" for a plain number. Returns `text`. The string `between` separates
 * base units. Messages use " ", which gives "m^2 s^-1". If the user must be able to type the unit, "*" gives
 * "m^2*s^-1". */
enum { UNIT_TEXT = 64 };
const char *unit_write(struct quantity quantity, const char *between, char text[UNIT_TEXT]);

/* Returns the unit of a quantity. The text lives until the end of the block that contains the call. */
#define expression_unit_text(quantity) unit_write(quantity, " ", (char[UNIT_TEXT]){""})

/* The largest exponent that can be typed in a unit. */
enum { UNIT_POWER_MOST = 9 };

/* Returns a phrase such as "a length", "a time" or "in m^2 s^-1". The phrase lives until the end of the block
 * that contains the call. */
#define expression_kind(quantity) kind_write(quantity, (char[UNIT_TEXT]){""})
const char *kind_write(struct quantity quantity, char text[UNIT_TEXT]);

/* Returns an example of a quantity with this unit, such as "10 g", or NULL. */
const char *expression_example(struct quantity quantity);

/* A names_list (see names.h) of the units. */
const char *expression_units(const void *context, int k);

/* Returns true if a name can begin with this character. A name consists of letters, digits and '_'. */
static inline bool name_start(char c)
{
    return isalpha((unsigned char)c) || c == '_';
}

/* Returns the number of letters, digits and '_' at the beginning of a string. They form a name if the first
 * of them is not a digit. */
size_t name_length(const char *text);

/* Copies a name of `length` bytes into the buffer `name`, which has `size` bytes. If the name does not fit,
 * copies as much as fits and returns false. */
bool name_copy(const char *text, size_t length, char *name, size_t size);

/* Reads the unit at the beginning of a string and multiplies *quantity by it. Returns the end of the unit, or
 * NULL if there is no unit or its exponent is too large. In "4.8 cm/h", the unit is only cm, because h is not
 * a unit; but "km/h" is one. */
const char *unit_scan(const char *text, struct quantity *quantity);

/* Writes a length with as few digits as it needs to be read back exactly, in the unit `typed`. If `typed` is
 * "", chooses m, cm or mm. */
enum { LENGTH_TEXT = WIDE_TEXT + 12 };
const char *length_write(domq_real m, const char *typed, char text[LENGTH_TEXT]);

/* ---- The variables and functions that 'let' defines ---- */

/* A function is stored as the text of its expression. */
enum { EXPRESSION_ARGUMENTS = 4, VARIABLE_NAME = 32, VARIABLES_MOST = 256 };

struct variable {
    char name[VARIABLE_NAME];
    struct quantity value; /* the value of a variable */
    char *body;            /* the text of a function; NULL for a variable */
    int count;             /* the number of arguments of a function */
    char argument[EXPRESSION_ARGUMENTS][VARIABLE_NAME];
};

struct variables {
    struct variable *list;
    size_t count;
};

const struct variable *variable_find(const struct variables *variables, const char *name);

/* Adds a copy of a variable, or replaces the variable of the same name. Returns false if memory runs out. */
bool variable_put(struct variables *variables, const struct variable *variable);

void variable_drop(struct variables *variables, const char *name);

/* Copies all variables. Returns false if memory runs out. */
bool variables_copy(struct variables *to, const struct variables *from);
bool variables_equal(const struct variables *a, const struct variables *b);
void variables_free(struct variables *variables);

/* Returns the left side of a definition, such as "f(s, d)". The text lives until the end of the block that
 * contains the call. */
enum { VARIABLE_HEAD = (EXPRESSION_ARGUMENTS + 1) * (VARIABLE_NAME + 2) };
#define variable_head(variable) variable_head_write(variable, (char[VARIABLE_HEAD]){""})
const char *variable_head_write(const struct variable *variable, char text[VARIABLE_HEAD]);
