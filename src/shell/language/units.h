/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Units, and quantities that have one: a quantity knows its dimension, so that a length where an angle
 * belongs is an error and not a number.
 */
#ifndef SHELL_UNITS_H
#define SHELL_UNITS_H

#include "domino_quad.h"
#include <stdbool.h>
#include <stddef.h>

/* In SI units and radians; exponents of metre, second and radian. */
struct quantity {
    domq_real value;
    int length, time, angle;
};

/* Returns true for a number or a power of an angle: neither a length nor a time. */
bool quantity_plain(struct quantity quantity);

/* Multiplies a quantity by a power of another one. */
void quantity_multiply(struct quantity *quantity, struct quantity by, int power);

/* Returns the unit "m/s^2" as a quantity; a unit that the language does not have ("h", "mgh/2") is a plain 1.
 */
struct quantity expression_unit(const char *unit);

/* Writes the unit, "m^2 s^-1", or "" for a plain number. */
const char *expression_unit_text(struct quantity quantity, char *text, size_t size);

/* Writes what a quantity is, for messages: "a length", "a time", "m^2 s^-1". */
const char *expression_kind(struct quantity quantity, char *text, size_t size);

/* Lists for names.h the units. */
const char *expression_units(const void *context, int k);

/* Return true if a name can begin with the character; and the length of the name: letters, digits and '_'. */
bool name_start(char c);
size_t name_length(const char *text);

/*
 * "cm", "m/s^2" at the beginning of text, multiplied into the quantity: units joined without blanks; the part
 * that begins with something else is not taken, so that 4.8 cm/h divides by the parameter h.  Where it ends,
 * or NULL.
 */
const char *unit_scan(const char *text, struct quantity *quantity);

#endif
