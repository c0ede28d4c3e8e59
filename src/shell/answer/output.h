/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Answers: a command names its columns once, then gives rows of cells; how they look is the session's
 * output style.  Rows are written as they come, so a long curve streams.
 */
#ifndef SHELL_OUTPUT_H
#define SHELL_OUTPUT_H

#include "answer/answer.h"

/* Returns true for a column of angles, which follow the style's unit. */
bool column_is_angle(const struct column *column);

/* Returns these columns as the answer's own copy, which may be changed before the first row. */
struct column *answer_columns(struct answer *answer, const struct column *columns);

/* Leaves the column with this key out of the answer, before the first row; a cell of a row has no place for
 * it. */
void answer_leave_out(struct answer *answer, const char *key);

/* Gives the column with this key another meaning, in this answer alone; before the first row. */
void answer_means(struct answer *answer, const char *key, const char *meaning);

/*
 * Gives the largest number that the column with this key will hold, before the first row and after the
 * columns are settled: the unit that people see in a table of rows follows from it.  Without it the first row
 * decides.
 */
void answer_largest(struct answer *answer, const char *key, domq_real largest);

/* Makes a column of words, in an answer's own columns, as wide as a word that it is to hold. */
void column_fit(struct column *column, const char *word);

/*
 * Writes a row; reason, unless NULL, says why something does not exist: a line for people, a last column or
 * key "reason" for programs; csv has that column where its first row has a reason.  Returns true, with which
 * a command ends that has answered.
 */
bool answer_row(struct answer *answer, const struct cell *cells, const char *reason);

/* Keeps the cells of a row, as 'ans', without writing them: people read the answer in sentences. */
void answer_keep(struct answer *answer, const struct cell *cells);

/* Writes a row of these cells, in which nothing is missing. */
#define answer_cells(answer, ...) answer_row(answer, (const struct cell[]){__VA_ARGS__}, NULL)

/*
 * Finds out now what the first row would, if it were like this one (NULL: no column has bounds).  Then copies
 * of the answer can write their rows elsewhere: answer_part gives one, whose next row is the first of all, or
 * not.
 */
void answer_plan(struct answer *answer, const struct cell *like);
struct answer answer_part(const struct answer *answer, FILE *out, bool first);

/*
 * Ends the answer.  Returns what its rows had no place for, which the caller reports, or NULL: people read it
 * below the answer.
 */
const char *answer_end(struct answer *answer);

/* Keeps what the command decides, for 'assert': a row falls, a train goes on. */
static inline void answer_holds(struct answer *answer, bool yes)
{
    answer->holds = yes ? ANSWER_YES : ANSWER_NO;
}

/* Returns true after a write error (full disk, closed pipe): stop producing rows. */
bool answer_lost(const struct answer *answer);

/* Returns true if the output is a table for a person. */
bool answer_for_people(const struct answer *answer);

/* Writes a sentence that only people see. */
void answer_say(struct answer *answer, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Writes a short text that only people see, as it is. */
void answer_line(struct answer *answer, const char *text);

/* Writes so many blanks; none for a number below 1. */
void output_blanks(FILE *out, int blanks);

/*
 * Returns the length in bytes of the first line of a text, if a line has this many columns. Lines are broken
 * at
 * '\n' and at blanks, but not within "r = 1.5" or "7.5 cm"; a piece that is longer than a line is broken,
 * too.
 */
size_t line_break(const char *text, int columns);

/*
 * Writes text whose lines begin at the column `left` and end before `right`, at blanks; right = 0 for no end.
 * Where a word would not fit, all of the text goes below, to column 4.  Adds no new line at the end.
 */
void output_wrapped(FILE *out, const char *text, int left, int right);

/* Return radians in the style's unit of angles, and the name of that unit. */
domq_real style_angle(const struct output_style *style, domq_real radians);
const char *style_angle_unit(const struct output_style *style);

#endif
