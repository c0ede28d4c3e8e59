/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cells of an answer: how their numbers are written, in which units, and with which errors. */
#pragma once

#include "precision/any.h"
#include <math.h>
#include <stdbool.h>

enum angle { ANGLE_RAD, ANGLE_DEG };

struct format;

/* The appearance of answers, according to the settings of the session. */
struct answer_style {
    unsigned output; /* the index of the format that was chosen with 'set output' */
    const struct format *format;
    enum angle angle;
    unsigned header;  /* a csv table begins with the column names */
    domq_real digits; /* the maximum number of digits in a table */
    enum precision precision;
    double tol;      /* the tolerance to which numbers are computed */
    int all_digits;  /* the number of digits needed for an exact round trip at this precision */
    unsigned errors; /* show errors, which the feature of this name finds */
};

struct cell {
    enum { CELL_NONE, CELL_REAL, CELL_COUNT, CELL_FLAG, CELL_WORD } kind;
    domq_real number;
    domq_real error; /* the error: 0 for an exact number, NaN if it is not known */
    const char *word;
    /* If this is not 0, tables show the number with at most this many digits and without its error,
     * whatever answer_style.digits is. */
    int digits;
    /* The number was computed to the tolerance of the style. If its error is not shown, a table shows
     * only the digits that this tolerance guarantees. */
    bool computed;
    bool in_double; /* the number was computed in double precision, whatever that of the style is */
    bool is_limit;  /* tables round the number down, because people build by it */
};

/* These functions make cells. NaN and infinity give an empty cell, which is null in json. */
struct cell cell_real(domq_real value);
struct cell cell_computed(domq_real value);

/* Makes a cell for a number that a search found only to within `uncertainty`. The error of the number is at
 * least as large. */
struct cell cell_uncertain(domq_real value, domq_real uncertainty);

/* Makes a cell for a number that a search has rounded. Its error is at most `error`, at every precision. */
struct cell cell_within(domq_real value, domq_real error);

/* Returns the cell of a limit, such as r_max, which tables round down. */
struct cell cell_limit(struct cell cell);

/* Makes a cell for a number whose error is not known, and is not computed either. */
struct cell cell_without_error(domq_real value);

struct cell cell_count(domq_real value);
struct cell cell_flag(bool value);
struct cell cell_word(const char *word);

/* Returns false if the number of a cell is too large for the precision of the style. */
bool cell_finite(const struct answer_style *style, struct cell cell);

enum { CELL_TEXT = 128 }; /* the size of a buffer for any cell except a word */

/* Returns the text of a cell in a table. A real number gets at most `digits` digits. If `errors` is true and
 * the error of the number is known, the text also shows the error. For a cell with digits of its own
 * (cell.digits), these two parameters have no effect. A count gets all its digits. */
const char *cell_text(struct cell cell, int digits, bool errors, char text[CELL_TEXT]);

/* Returns the text of a cell in csv and json, without its error. Numbers are written with few digits,
 * but with enough that reading the text gives the same number again. */
const char *cell_plain(const struct answer_style *style, struct cell cell, char text[CELL_TEXT]);

/* Returns the text of the cell's error in csv and json. If the error is not known, returns `none`. */
const char *cell_plain_error(const struct answer_style *style, struct cell cell, const char *none,
                             char text[CELL_TEXT]);

/* ---- Units ---- */

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
