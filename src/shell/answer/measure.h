/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Units that are easy to read. Cells, csv and json contain base units: m, kg, and fractions of 1. Tables and
 * sentences convert values to other units:
 *
 *   "m"      mm below 1 cm, cm below 1 m, otherwise m
 *   "kg"     g below 1 kg, kg below 10,000 kg, otherwise t
 *   "share"  %
 *
 * A column of a table has one unit in all rows (see answer_announce). In a sentence, measured(value, "m",
 * 4).text is a value with its unit.
 */
#ifndef SHELL_MEASURE_H
#define SHELL_MEASURE_H

#include "answer/cell.h"

/* A unit for display. A number in the base unit is multiplied by 10^power. */
struct measure {
    const char *unit;
    int power;
};

/* Returns the unit for a column whose largest absolute value is `largest`. */
struct measure measure_of(const char *unit, domq_real largest);

/* Returns value * 10^power, correctly rounded, so that 4.8 cm has the same digits as 0.048 m. */
domq_real measure_number(struct measure measure, domq_real value);

/* Formats a value with its unit, as in "4.8 cm" or "11 %". The result has at most `digits` significant
 * digits. If the value has more digits than this before the decimal point, as in 1234 %, all of them are
 * shown. */
struct measured {
    char text[CELL_TEXT];
};
struct measured measured(domq_real value, const char *unit, int digits);

/* Returns a fraction in percent, with enough digits to differ from 100 %, as in "99.97 %". */
struct measured measured_share(domq_real value, int digits);

/* The unit of an axis or a ruler. */
struct axis_unit {
    const char *name;
    double size; /* in m */
};

/* Returns the unit for an axis or a ruler that shows lengths up to `longest` m. The unit is mm if `longest`
 * is below 0.2, cm if it is below 2, and otherwise m. So lengths in mm and cm need at most three digits
 * before the decimal point, and a ruler has no room for more. */
struct axis_unit measure_axis(double longest);

#endif
