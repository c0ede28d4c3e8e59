/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What an answer is: named columns, and how and where their rows are to be written. */
#ifndef SHELL_ANSWER_H
#define SHELL_ANSWER_H

#include "answer/cell.h"
#include <stdbool.h>
#include <stdio.h>

struct column {
    const char *key;     /* name in csv and json, head of a table */
    const char *unit;    /* "" for a pure number; "rad" and "rad/s" follow the style's angle */
    const char *meaning; /* one line, for people */
    int width;           /* of words, or of few digits, in a table of rows; 0 for a number */
};

enum { ANSWER_COLUMNS = 24 /* at most */, ANSWER_REASON = 160 };

struct answer {
    FILE *out; /* NULL: the answer is only kept */
    struct output_style style;
    const struct column *columns; /* ends with a NULL key */
    bool rows;                    /* a table with a head, rather than a line a column */
    bool units;                   /* csv names its columns with their units: it is read back */
    bool begun;
    bool prepared; /* nothing else stands before the next row any more */
    bool planned;  /* width, letters, bold and bounded are known */
    bool letters;  /* the field's letters can be shown */
    bool bold;
    int width;                  /* of the terminal; 0 for none */
    unsigned bounded;           /* bit i: csv and json have the bounds of column i behind it */
    bool gap;                   /* set a blank line between this answer and the one before, for people */
    int lost;                   /* errno of the first write that failed; 0 for none */
    struct cell *kept;          /* where the cells of the last row stay */
    bool reasoned;              /* the head of csv has a column for reasons */
    char unsaid[ANSWER_REASON]; /* why a number is missing in rows that had no place to say it; "" for none */
    /* Unless NULL, the answer is that of one point of a sweep, whose rows this function takes; swept is its
     * own, and like, unless NULL, a row of the kinds that most points have, for the head. */
    void (*point)(struct answer *answer, const struct cell *cells, const char *reason);
    struct swept *swept;
    const struct cell *like;
};

#endif
