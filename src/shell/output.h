/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Answers: a command names its columns once, then gives rows of cells; how they look is the session's
 * output format.  Rows are written as they come, so a long curve streams.
 */
#ifndef SHELL_OUTPUT_H
#define SHELL_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

enum output { OUTPUT_TABLE, OUTPUT_CSV, OUTPUT_JSON };

struct column {
    const char *key;     /* name in csv and json, head of a table */
    const char *unit;    /* "" for a pure number */
    const char *meaning; /* one line, for people */
    int width;           /* in a table of rows; 0 for that of a number */
};

struct cell {
    enum { CELL_NONE, CELL_REAL, CELL_COUNT, CELL_FLAG, CELL_WORD } kind;
    double number;
    const char *word;
};

/* A number that does not exist (NaN, infinity) becomes CELL_NONE: null in json. */
struct cell cell_real(double value);
struct cell cell_count(double value);
struct cell cell_flag(bool value);
struct cell cell_word(const char *word);

struct answer {
    FILE *out;
    enum output format;
    const struct column *columns; /* ends with a NULL key */
    bool rows;                    /* a table with a head, rather than a line a column */
    bool begun;
    bool gap; /* set a blank line between this answer and the one before, for people */
};

/*
 * One row; reason, unless NULL, says why something does not exist: a line for people, a last column or
 * key "reason" for programs.
 */
void answer_row(struct answer *answer, const struct cell *cells, const char *reason);

/* Can the output not be written any more (full disk, closed pipe)?  Then more rows are in vain. */
bool answer_lost(const struct answer *answer);

/* A sentence that only people see. */
void answer_say(struct answer *answer, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
