/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of one point of a sweep: its values, then what a command answers there, found by its keys. */
#ifndef SHELL_SWEPT_H
#define SHELL_SWEPT_H

#include "answer/output.h"

enum { SWEPT_REASON = 256 };

struct swept {
    struct column column[ANSWER_COLUMNS]; /* of the sweep; ends with a NULL key */
    const char *key[ANSWER_COLUMNS];      /* what the command calls it */
    struct cell value[ANSWER_COLUMNS];    /* of the point: the first cells of its rows */
    int values;
    bool answered, reasoned;           /* has it a row of an answer, and one with a reason? */
    char reason[SWEPT_REASON];         /* the first */
    struct cell first[ANSWER_COLUMNS]; /* its first row of an answer */
    struct answer *to; /* the answer of the sweep, which has its columns; NULL: rows are not read */
};

/* For the next point, of which value is filled in. */
void swept_begin(struct swept *swept);

/* Writes a row of the command's answer; or the row of a point that has none. */
void swept_row(struct answer *answer, const struct cell *cells, const char *reason);
void swept_none(struct swept *swept, const char *reason);

#endif
