/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One value of an answer, and its text: digits that its tolerance and the bound of its error leave. */
#ifndef SHELL_CELL_H
#define SHELL_CELL_H

#include "domino_quad.h"
#include <stdbool.h>

enum angle { ANGLE_RAD, ANGLE_DEG };

struct format;

struct answer_style {
    unsigned output; /* which of the formats, as the session has it; session_style finds the format */
    const struct format *format;
    enum angle angle;
    unsigned header;  /* csv begins with the names of its columns */
    domq_real digits; /* in a table */
    enum dom_precision precision;
    int tol_digits;  /* that the session's tolerance promises */
    int all_digits;  /* that read back to the same number of the session's precision: csv and json */
    unsigned errors; /* every number with the bound of its error */
};

struct cell {
    enum { CELL_NONE, CELL_REAL, CELL_COUNT, CELL_FLAG, CELL_WORD } kind;
    domq_real number;
    domq_real error; /* bound of it; 0: exact, or not asked for */
    const char *word;
    int digits;    /* in a table; 0: as the style says */
    bool computed; /* to the session's tolerance: more digits than it promises are not shown */
};

/* Makes a cell of a number; NaN and infinity become CELL_NONE, which is null in json. */
struct cell cell_real(domq_real value);
struct cell cell_bound(domq_real value, domq_real error);
struct cell cell_unbounded(domq_real value); /* no error bound is known */
struct cell cell_brief(double value);        /* three digits in a table: for what is not known better */
struct cell cell_count(domq_real value);
struct cell cell_flag(bool value);
struct cell cell_word(const char *word);

/* Returns true unless the number is none, or too large, in the arithmetic in which csv and json write it. */
bool cell_finite(const struct answer_style *style, struct cell cell);

/* Returns true for a number that is not 0, and is 0 in that arithmetic. */
bool cell_vanishes(const struct answer_style *style, struct cell cell);

enum { CELL_TEXT = 128 }; /* enough for any cell that is not a word */

/* Writes a cell of a table, in so many digits at most, with its bound if bounds are shown. */
const char *cell_text(struct cell cell, int digits, bool bounds, char text[CELL_TEXT]);

/* Writes a cell for programs: the fewest digits that read back to the same number, without a bound. */
const char *cell_plain(const struct answer_style *style, struct cell cell, char text[CELL_TEXT]);

/* Writes the bound of a number as cell_plain does; nothing where no bound is known. */
const char *cell_plain_bound(const struct answer_style *style, struct cell cell, const char *none,
                             char text[CELL_TEXT]);

#endif
