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

/* In SI units and radians; exponents of metre, second, radian and kilogram. */
struct quantity {
    domq_real value;
    int length, time, angle, mass;
};

/* Returns true for a number or a power of an angle: neither a length, nor a time, nor a mass. */
bool quantity_plain(struct quantity quantity);

/* Return true for a number that has no unit, not even that of angles; and for two that have the same. */
bool quantity_bare(struct quantity quantity);
bool quantity_alike(struct quantity a, struct quantity b);

/* Multiplies a quantity by a power of another one. */
void quantity_multiply(struct quantity *quantity, struct quantity by, int power);

/* Returns the unit "m/s^2" as a quantity; a unit that the language does not have ("h", "mgh/2") is a plain 1.
 */
struct quantity expression_unit(const char *unit);

/* Writes the unit, "m^2 s^-1", or "" for a plain number. */
const char *expression_unit_text(struct quantity quantity, char *text, size_t size);

/* Writes the unit as an expression reads it after a number, "kg*m^-3"; its exponents are at most 9. */
const char *expression_unit_typed(struct quantity quantity, char *text, size_t size);
enum { UNIT_POWER_MOST = 9 };

/* Writes what a quantity is, for messages: "a length", "a time", "in m^2 s^-1". */
const char *expression_kind(struct quantity quantity, char *text, size_t size);

/* Returns how people write such a quantity, "10 g"; NULL if it has no usual unit. */
const char *expression_example(struct quantity quantity);

/* Lists for names.h the units. */
const char *expression_units(const void *context, int k);

/* Return true if a name can begin with the character; and the length of the name: letters, digits and '_'. */
bool name_start(char c);
size_t name_length(const char *text);

/* Copies a name of this length; returns false, with as much as there is room for, if it is longer. */
bool name_copy(const char *text, size_t length, char *name, size_t size);

/*
 * "cm", "m/s^2" at the beginning of text, multiplied into the quantity: units joined without blanks; the part
 * that begins with something else is not taken, so that 4.8 cm/h divides by the parameter h.  The gram and
 * the tonne are units only at the beginning: 10 g is a mass, 4.8 cm/g divides by gravity.  Where it ends, or
 * NULL.
 */
const char *unit_scan(const char *text, struct quantity *quantity);

#endif
