/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Units for people.  Cells, csv and json hold base units: m, kg, and shares as plain numbers.  A table shows
 * a column by the unit that it names:
 *
 *   "m"      mm below 1 cm, cm below 1 m, else m
 *   "kg"     g below 1 kg, else kg
 *   "share"  % of 1
 *
 * and every other unit as it is.  A command does nothing for this but name the unit of its column.  In a
 * table of rows one unit holds for the whole column, that of the first row; where later rows are larger, call
 * answer_largest (answer/output.h) before the first row.  Sentences take measured(value, "m", 4).text.
 */
#ifndef SHELL_MEASURE_H
#define SHELL_MEASURE_H

#include "answer/cell.h"

/* A unit for people: the number of a column times 10^power is in this unit. */
struct measure {
    const char *unit;
    int power;
};

/* Returns the measure of a column of this unit whose largest number is this one, of any sign. */
struct measure measure_of(const char *unit, domq_real largest);

/* Returns true for a unit whose measure depends on the numbers. */
bool measure_varies(const char *unit);

/* Returns value times 10^power, correctly rounded: 0.048 m is 4.8 cm in all digits. */
domq_real measure_number(struct measure measure, domq_real value);

/*
 * Returns "4.8 cm" or "11 %" for sentences: the value with so many significant digits, and its unit.  A
 * number keeps all digits before the point: 1234 %, not 1.23e+03 %.
 */
struct measured {
    char text[CELL_TEXT];
};
struct measured measured(domq_real value, const char *unit, int digits);

/* Returns the same with as many digits as keep the value apart from 1: "99.97 %" is not "100 %". */
struct measured measured_share(domq_real value, int digits);

/* The unit of an axis or a ruler, and its size in m. */
struct axis_unit {
    const char *name;
    double size;
};

/* Returns the unit for lengths up to `longest` m: mm below 0.2 m, cm below 2 m, else m. A column of numbers
 * changes to the next unit earlier, since a ruler has room for three digits before the point. */
struct axis_unit measure_axis(double longest);

#endif
