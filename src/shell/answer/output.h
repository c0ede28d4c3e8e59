/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Answers: a command names its columns once, then gives rows of cells; how they look is the session's
 * output style.  Rows are written as they come, so a long curve streams.
 */
#ifndef SHELL_OUTPUT_H
#define SHELL_OUTPUT_H

#include "answer/cell.h"
#include "domino.h"
#include <stdbool.h>
#include <stdio.h>

struct column {
    const char *key;     /* name in csv and json, head of a table */
    const char *unit;    /* "" for a pure number; "rad" and "rad/s" follow the style's angle */
    const char *meaning; /* one line, for people */
    int width;           /* of words, or of few digits, in a table of rows; 0 for a number */
};

enum { ANSWER_COLUMNS = 24 }; /* at most */

struct answer {
    FILE *out; /* NULL: the answer is only kept */
    struct output_style style;
    const struct column *columns; /* ends with a NULL key */
    bool rows;                    /* a table with a head, rather than a line a column */
    bool begun;
    bool prepared; /* nothing else stands before the next row any more */
    bool planned;  /* width, letters, bold and bounded are known */
    bool letters;  /* the field's letters can be shown */
    bool bold;
    int width;         /* of the terminal; 0 for none */
    unsigned bounded;  /* bit i: csv and json have the bounds of column i behind it */
    bool gap;          /* set a blank line between this answer and the one before, for people */
    int lost;          /* errno of the first write that failed; 0 for none */
    struct cell *kept; /* where the cells of the last row stay */
    /* Unless NULL, the answer is that of one point of a sweep, whose rows this function takes; swept is its
     * own, and like, unless NULL, a row of the kinds that most points have, for the head. */
    void (*point)(struct answer *answer, const struct cell *cells, const char *reason);
    struct swept *swept;
    const struct cell *like;
};

/*
 * One row; reason, unless NULL, says why something does not exist: a line for people, a last column or
 * key "reason" for programs.
 */
void answer_row(struct answer *answer, const struct cell *cells, const char *reason);

/*
 * Finds out now what the first row would, if it were like this one (NULL: no column has bounds).  Then copies
 * of the answer can write their rows elsewhere: answer_part gives one, whose next row is the first of all, or
 * not.
 */
void answer_plan(struct answer *answer, const struct cell *like);
struct answer answer_part(const struct answer *answer, FILE *out, bool first);

/* The row as it is: what answer_row does where somebody reads it, and no point of a sweep is behind it. */
void answer_write(struct answer *answer, const struct cell *cells, const char *reason);

/* Can the output not be written any more (full disk, closed pipe)?  Then more rows are in vain. */
bool answer_lost(const struct answer *answer);

/* Is somebody there to read sentences? */
bool answer_for_people(const struct answer *answer);

/* A sentence that only people see. */
void answer_say(struct answer *answer, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Text whose lines begin at the column `left` and end before `right`, at blanks; right = 0 for no end.
 * Nothing stands behind it, and no new line. */
void output_wrapped(FILE *out, const char *text, int left, int right);

/* Radians in the style's unit of angles, and the name of that. */
dom_real style_angle(const struct output_style *style, dom_real radians);
const char *style_angle_unit(const struct output_style *style);

#endif
