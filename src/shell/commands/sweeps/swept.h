/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of one point of a sweep: its values, then the answer of a command, found by its keys. */
#ifndef SHELL_SWEPT_H
#define SHELL_SWEPT_H

#include "answer/answer.h"
#include "commands/sweeps/grid.h"
#include "interpreter/command.h"

enum { SWEPT_REASON = 256 };

struct swept {
    struct column column[ANSWER_COLUMNS]; /* the columns of the sweep; a NULL key ends them */
    const char *key[ANSWER_COLUMNS];      /* the key of each column in the command */
    char renamed[ASSIGNED_MAX][40];       /* "rmax.s" for a column that has the name of a parameter */
    struct column asked[ANSWER_COLUMNS];  /* of several answers, before they are joined with the parameters */
    char unit[ANSWER_COLUMNS][24];        /* of expressions among them */
    struct cell value[ANSWER_COLUMNS];    /* the values of the point: the first cells of its rows */
    int values;
    bool answered, reasoned;           /* the point has a row of an answer; it has a row with a reason */
    char reason[SWEPT_REASON];         /* the first reason */
    struct cell first[ANSWER_COLUMNS]; /* the first row of the answer */
    struct answer *to;                 /* the answer of the sweep; NULL: rows are not written */
};

/*
 * Makes the columns: parameters of the grid, then those of the answer, without one that only repeats a
 * parameter, unless it is echoed: an argument takes the parameter's place. Returns false if there are too
 * many.
 */
bool swept_columns(struct swept *swept, const struct grid *grid, const struct command *command,
                   const struct column *columns, bool echoed);

/* Begins a point, whose values are filled in. */
void swept_begin(struct swept *swept);

/* Writes a row of the command's answer; or the row of a point without an answer. */
void swept_row(struct answer *answer, const struct cell *cells, const char *reason);
void swept_none(struct swept *swept, const char *reason);

#endif
