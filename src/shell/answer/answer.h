/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers.  A command names the columns of its answer, and then passes rows of cells.  A format writes each
 * row at once, so that a long curve is streamed.  Sentences are written only for people. */
#ifndef SHELL_ANSWER_H
#define SHELL_ANSWER_H

#include "answer/measure.h"
#include "io/output.h"
#include "language/units.h"
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { ANSWER_COLUMNS = 24, ANSWER_REASON = 160, ANSWER_HEAD = OUTPUT_HEAD };

struct column {
    const char *key;  /* the name of the column */
    const char *unit; /* "" for a pure number, "rad" or "rad/s" for angles, otherwise a unit of measure.h */
    const char *meaning; /* an explanation for people, one line long */
    /* the width of a column in a table of rows, for words or for numbers with few digits; 0 for other
     * numbers */
    int width;
};

/* The appearance of the rows, which is fixed before the first one is written. */
struct layout {
    bool is_planned;  /* the layout has been fixed */
    bool on_terminal; /* the answer goes to a terminal */
    bool letters;     /* the terminal can show the Greek letters of the field */
    bool bold;        /* the terminal has colours */
    int width;        /* the columns of the terminal, or 0 without one */
    unsigned bounded; /* bit i: column i has error bounds, which programs get in a separate column */
    double largest[ANSWER_COLUMNS];         /* see answer_largest */
    struct measure measure[ANSWER_COLUMNS]; /* the units of a table of rows */
    /* In a table for people: the digits of its numbers, the widths of its columns, and where a last column of
     * words begins, or -1 if the words go below their row. If the terminal is too narrow even then, each row
     * is stacked, with a line for each column. */
    int digits, column[ANSWER_COLUMNS], words;
    bool is_stacked;
    /* If not NULL, a row with the usual kinds of cells, because the first row may have other kinds. */
    const struct cell *sample;
};

struct csv_layout {
    bool units;       /* the column names include the units, because the file can be read back */
    bool has_reasons; /* the rows have a column for reasons */
    char *last_head;  /* the last header line that was written to this file, or NULL */
    /* Texts to append, first to the header line and then to each row; each ends with a NUL.  May be NULL. */
    const char *extra;
};

struct answer {
    FILE *out;        /* NULL if the answer is only kept */
    const char *path; /* the name of the output file after '>' or '>>', or NULL */
    bool appended;    /* the file is appended to, because it comes after '>>' */
    struct answer_style style;
    const char *command;                /* the name of the command, for programs */
    const char *note;                   /* what programs should know about the answer, or NULL */
    const struct column *columns;       /* the columns of each row; the last one has a NULL key */
    struct column copy[ANSWER_COLUMNS]; /* memory for columns that differ from those of the command */
    unsigned left_out;                  /* bit i: cell i of each row has no column (see answer_leave_out) */
    bool rows;                          /* the answer is a table of rows, rather than a single row */
    struct csv_layout csv;
    bool blank_above; /* a blank line separates the answer from the previous one */
    bool is_open;     /* the output has begun: the blank line, if any, is written */
    bool has_rows;    /* the first row is written, with the lines that come before it */
    struct layout layout;

    /* The results that the session keeps. */
    bool is_value; /* the answer is this value of an expression */
    struct quantity value;
    struct cell *kept;                                 /* receives the cells of the last row; may be NULL */
    enum { ANSWER_OPEN, ANSWER_YES, ANSWER_NO } holds; /* see answer_holds */
    bool wrote_text;                                   /* text for people was written without a row */
    int error;                                         /* errno of the first write that failed, or 0 */
    char late_reason[ANSWER_REASON]; /* the reason that could not be written with its row, or "" */

    /* If not NULL, the answer belongs to one point of a sweep, and this function receives its rows. */
    void (*sink)(struct answer *answer, const struct cell *cells, const char *reason);
    void *sink_context;
};

/* An error, as reported to programs that read answers. */
struct failure {
    const char *command; /* NULL if no command was recognised */
    const char *text, *source;
    long line;
    int column; /* counted from 1, or 0 for an error in the line as a whole */
};

/* An output format.  A member function that has nothing to write is NULL. */
struct format {
    bool for_people; /* the format is for people, with sentences and units, rather than for programs */
    bool escapes;    /* the format itself escapes control characters, in a way that programs can decode */
    /* Writes the lines before the first row.  The arguments are those of the first row. */
    void (*begin)(struct answer *answer, const struct cell *cells, const char *reason);
    void (*row)(struct answer *answer, const struct cell *cells, const char *reason);
    void (*sentence)(struct answer *answer, const char *format, va_list arguments);
    /* Reports that a command without an answer is done. */
    void (*done)(FILE *out, const char *command);
    /* Writes an error to the output.  The error is also reported on standard error. */
    void (*failed)(FILE *out, const struct failure *failure);
    /* Returns true if the line consists of column names. */
    bool (*is_head)(const char *line);
    /* Ends the answer.  Returns a reason that could not be written with its row, for the caller to report, or
     * NULL. */
    const char *(*end)(struct answer *answer);
};

/* ---- Columns, before the first row ---- */

/* Returns true for a column of angles, which are shown in the unit of the style. */
static inline bool column_is_angle(const struct column *column)
{
    return strncmp(column->unit, "rad", 3) == 0;
}

/* Makes a column of words at least as wide as a word. */
void column_fit(struct column *column, const char *word);

/* Copies columns into the answer, where they may be changed, and returns the copy. */
struct column *answer_columns(struct answer *answer, const struct column *columns);

/* Removes a column from the answer.  Rows still have a cell for it. */
void answer_leave_out(struct answer *answer, const char *key);

/* Changes the explanation of a column in this answer. */
void answer_means(struct answer *answer, const char *key, const char *meaning);

/* Changes the unit of a column in this answer. */
void answer_unit(struct answer *answer, const char *key, const char *unit);

/*
 * Announces a number that a column will contain, if the answer has this column.  In a table of rows the unit
 * of a column depends on the largest number that was announced or is in the first row.
 */
void answer_largest(struct answer *answer, const char *key, domq_real number);

/* ---- Rows ---- */

/*
 * Writes a row.  If some cell of the row has no value, `reason` explains why.  People read the reason on a
 * line below the row, and programs in a column or key "reason", which csv has only if the first row has a
 * reason.  For a row without a reason, `reason` is NULL, or "" if other rows may have one.  Always returns
 * true, so that a command can end with `return answer_row(...)`.
 */
bool answer_row(struct answer *answer, const struct cell *cells, const char *reason);

/* Writes a row in which nothing is missing. */
#define answer_cells(answer, ...) answer_row(answer, (const struct cell[]){__VA_ARGS__}, NULL)

/* Keeps the cells of a row for 'ans' without writing them, for answers that people read as sentences. */
void answer_keep(struct answer *answer, const struct cell *cells);

/* answer_plan fixes the layout before the first row, as if the first row were like `sample`.  If `sample` is
 * NULL, no column has error bounds.  After that, answer_part returns copies of the answer that write their
 * rows to other streams.  Only the first part writes the lines that come before the first row. */
void answer_plan(struct answer *answer, const struct cell *sample);
struct answer answer_part(const struct answer *answer, FILE *out, bool first);

/* Returns true if rows cannot be written any more, because the disk is full or a pipe has no reader. */
bool answer_lost(const struct answer *answer);

/* Returns true if column i has error bounds. */
bool answer_bounded(const struct answer *answer, int i);

/* ---- Sentences, and the end ---- */

/* Returns true if the answer is a table for people. */
static inline bool answer_for_people(const struct answer *answer)
{
    return answer->out && answer->style.format->for_people && !answer->sink;
}

/* Writes a sentence, which only people see. */
void answer_say(struct answer *answer, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Sets the answer to a yes-or-no question, such as whether a row falls.  'assert' and 'solve' use it. */
void answer_holds(struct answer *answer, bool yes);

/* Returns the number of digits that the tolerance guarantees, at least 1. */
int style_tol_digits(const struct answer_style *style);

/* Return an angle in the unit of the style, and the name of that unit. */
domq_real style_angle(const struct answer_style *style, domq_real radians);
const char *style_angle_unit(const struct answer_style *style);

#endif
