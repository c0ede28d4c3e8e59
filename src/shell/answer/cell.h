/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cells of an answer, and how their numbers are written. */
#ifndef SHELL_CELL_H
#define SHELL_CELL_H

#include "domino_quad.h"
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
    enum dom_precision precision;
    double tol;      /* the tolerance to which numbers are computed */
    int all_digits;  /* the number of digits needed for an exact round trip at this precision */
    unsigned errors; /* show error bounds */
};

struct cell {
    enum { CELL_NONE, CELL_REAL, CELL_COUNT, CELL_FLAG, CELL_WORD } kind;
    domq_real number;
    domq_real error; /* an upper bound on the error: 0 for an exact number, NaN if no bound is known */
    const char *word;
    /* If this is not 0, tables show the number with at most this many digits and without its error bound,
     * whatever answer_style.digits is. */
    int digits;
    /* The number was computed to the tolerance of the style. If its error bound is not shown, a table shows
     * only the digits that this tolerance guarantees. */
    bool computed;
};

/* These functions make cells. NaN and infinity give an empty cell, which is null in json. */
struct cell cell_real(domq_real value);
struct cell cell_bound(domq_real value, domq_real error);

struct cell cell_without_bound(domq_real value);

/* Makes a cell for a number that is known to only three digits. */
struct cell cell_brief(double value);

struct cell cell_count(domq_real value);
struct cell cell_flag(bool value);
struct cell cell_word(const char *word);

/* Returns false if the number of a cell is too large for the precision of the style. */
bool cell_finite(const struct answer_style *style, struct cell cell);

/* Returns true if a number other than 0 becomes 0 in csv and json at this precision. */
bool cell_vanishes(const struct answer_style *style, struct cell cell);

enum { CELL_TEXT = 128 }; /* the size of a buffer for any cell except a word */

/* Returns the text of a cell in a table. A real number gets at most `digits` digits. If `bounds` is true and
 * the error bound of the number is known, the text also shows the bound. For a cell with digits of its own
 * (cell.digits), these two parameters have no effect. A count gets all its digits. */
const char *cell_text(struct cell cell, int digits, bool bounds, char text[CELL_TEXT]);

/* Returns the text of a cell in csv and json, without its error bound. Numbers are written with few digits,
 * but with enough that reading the text gives the same number again. */
const char *cell_plain(const struct answer_style *style, struct cell cell, char text[CELL_TEXT]);

/* Returns the text of the cell's error bound in csv and json. If no bound is known, returns `none`. */
const char *cell_plain_bound(const struct answer_style *style, struct cell cell, const char *none,
                             char text[CELL_TEXT]);

#endif
