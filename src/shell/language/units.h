/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quantities: numbers with a unit, so that a length in the place of an angle is an error. */
#ifndef SHELL_UNITS_H
#define SHELL_UNITS_H

#include "domino_quad.h"
#include <stdbool.h>
#include <stddef.h>

/* A value in SI units and radians, and the exponents of metre, second, radian and kilogram in its unit. */
struct quantity {
    domq_real value;
    int length, time, angle, mass;
};

/* Returns true if the unit is at most a power of an angle: neither lengths, nor times, nor masses. */
bool quantity_plain(struct quantity quantity);

/* Returns true for a number without any unit. */
bool quantity_bare(struct quantity quantity);

/* Returns true if both quantities have the same unit. */
bool quantity_alike(struct quantity a, struct quantity b);

/* Multiplies a quantity by a power of another one. */
void quantity_multiply(struct quantity *quantity, struct quantity by, int power);

/* Returns a unit such as "m/s^2" as a quantity. Units of columns that are no units of the language, such as
 * "h" or "mgh/2", become the number 1. */
struct quantity expression_unit(const char *unit);

/* Writes the unit of a quantity: "m^2 s^-1", or "" for a plain number. */
const char *expression_unit_text(struct quantity quantity, char *text, size_t size);

/* The largest exponent of a unit that can be typed. */
enum { UNIT_POWER_MOST = 9 };

/* Writes the unit as it is typed after a number: "kg*m^-3". */
const char *expression_unit_typed(struct quantity quantity, char *text, size_t size);

/* Writes what a quantity is, for messages: "a length", "a time", "in m^2 s^-1". */
const char *expression_kind(struct quantity quantity, char *text, size_t size);

/* Returns an example of such a quantity, "10 g", or NULL if it has no usual unit. */
const char *expression_example(struct quantity quantity);

/* The list of the units, for names.h. */
const char *expression_units(const void *context, int k);

/* Returns true if a name can begin with the character. A name has letters, digits and '_'. */
bool name_start(char c);

/* Returns the length of the name at the beginning of a text; 0 if there is none. */
size_t name_length(const char *text);

/* Copies a name of this length. Returns false, after copying what fits, if the name is too long. */
bool name_copy(const char *text, size_t length, char *name, size_t size);

/*
 * Scans a unit such as "cm" or "m/s^2" at the beginning of a text, and multiplies the quantity by it. Returns
 * the end of the unit, or NULL if there is none. The scan stops before a factor that is not a unit: in 4.8
 * cm/h, the unit is cm. Gram and tonne are units only as the first factor: in 4.8 cm/g, the g is gravity.
 */
const char *unit_scan(const char *text, struct quantity *quantity);

#endif
