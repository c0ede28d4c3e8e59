/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Answers.  A command names the columns of its answer, then gives rows of cells, which a format writes at
 * once, so that a long curve streams.  Sentences are for people only.
 */
#ifndef SHELL_ANSWER_H
#define SHELL_ANSWER_H

#include "answer/measure.h"
#include "io/output.h"
#include "language/units.h"
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

enum { ANSWER_COLUMNS = 24, ANSWER_REASON = 160, ANSWER_HEAD = OUTPUT_HEAD };

struct column {
    const char *key;     /* the name of the column */
    const char *unit;    /* "" for a pure number, "rad" or "rad/s" for angles, else see measure.h */
    const char *meaning; /* one line for people */
    int width;           /* the width of words, or of few digits, in a table of rows; 0 for a number */
};

/* How the rows look, which is known before the first one is written. */
struct layout {
    bool is_planned;  /* the layout is known */
    bool on_terminal; /* the answer goes to a terminal */
    bool letters;     /* the terminal has the letters of the field */
    bool bold;        /* the terminal has colours */
    int width;        /* the columns of the terminal, or 0 without one */
    unsigned bounded; /* bit i: column i has error bounds, which programs get in a column of their own */
    double largest[ANSWER_COLUMNS];         /* see answer_largest */
    struct measure measure[ANSWER_COLUMNS]; /* the units of a table of rows */
    const struct cell *sample; /* a row with the usual kinds of cells if the first row has others, or NULL */
};

struct csv_layout {
    bool units;        /* the head names the units, because the file can be read back */
    bool has_reasons;  /* there is a column for reasons */
    char *last_head;   /* the last head that was written to this file, or NULL */
    const char *extra; /* what is added to the head, then to each row, each with a NUL; may be NULL */
};

struct answer {
    FILE *out;        /* NULL if the answer is only kept */
    const char *path; /* the name of the file after '>', or NULL */
    bool appended;    /* the file comes after '>>' */
    struct answer_style style;
    const char *command;                /* the name of the command, for programs */
    const char *note;                   /* what programs should know about the answer, or NULL */
    const struct column *columns;       /* end with a NULL key */
    struct column copy[ANSWER_COLUMNS]; /* room for columns that differ from those of the command */
    unsigned left_out;                  /* bit i: cell i of each row has no column (see answer_leave_out) */
    bool rows;                          /* the answer is a table of rows, rather than a single row */
    struct csv_layout csv;
    bool blank_above; /* a blank line separates the answer from the one before */
    bool is_open;     /* that blank line is written */
    bool has_rows;    /* the first row is written, with what comes before it */
    struct layout layout;

    /* What the session keeps. */
    bool is_value; /* the answer is this value of an expression */
    struct quantity value;
    struct cell *kept;                                 /* takes the cells of the last row; may be NULL */
    enum { ANSWER_OPEN, ANSWER_YES, ANSWER_NO } holds; /* see answer_holds */
    bool told;                                         /* a person was told something without a row */
    int error;                                         /* errno of the first write that failed, or 0 */
    char late_reason[ANSWER_REASON];                   /* a reason for which the rows have no place, or "" */

    /* If not NULL, the answer is that of one point of a sweep, and this function takes its rows. */
    void (*sink)(struct answer *answer, const struct cell *cells, const char *reason);
    void *sink_context;
};

/* What went wrong, for programs that read answers. */
struct failure {
    const char *command; /* NULL if no command was recognised */
    const char *text, *source;
    long line;
    int column; /* counts from 1; 0 stands for the whole line */
};

/* How answers are written.  Functions that write nothing are NULL. */
struct format {
    bool for_people; /* rather than for programs: with sentences and units */
    bool escapes;    /* the format escapes control characters in a way that programs read back */
    /* Writes what comes before the first row, which is given. */
    void (*begin)(struct answer *answer, const struct cell *cells, const char *reason);
    void (*row)(struct answer *answer, const struct cell *cells, const char *reason);
    void (*sentence)(struct answer *answer, const char *format, va_list arguments);
    /* Writes that a command without an answer is done. */
    void (*done)(FILE *out, const char *command);
    /* Writes an error, which also goes to standard error. */
    void (*failed)(FILE *out, const struct failure *failure);
    /* Returns true for a line of column names. */
    bool (*is_head)(const char *line);
    /* Ends the answer, as answer_end does. */
    const char *(*end)(struct answer *answer);
};

/* ---- Columns, before the first row ---- */

/* Returns true for a column of angles, which are shown in the unit of the style. */
bool column_is_angle(const struct column *column);

/* Makes a column of words at least as wide as a word. */
void column_fit(struct column *column, const char *word);

/* Copies columns into the answer, where they may be changed, and returns the copy. */
struct column *answer_columns(struct answer *answer, const struct column *columns);

/* Removes a column from the answer.  Rows still have a cell for it. */
void answer_leave_out(struct answer *answer, const char *key);

/* Changes the meaning of a column in this answer. */
void answer_means(struct answer *answer, const char *key, const char *meaning);

/*
 * Announces a number that a column will contain, if the answer has this column.  In a table of rows the unit
 * of a column depends on the largest number that was announced or is in the first row.
 */
void answer_largest(struct answer *answer, const char *key, domq_real number);

/* ---- Rows ---- */

/*
 * Writes a row.  If something in it does not exist, `reason` says why: to people on a line below, to programs
 * in a column or key "reason", which csv has only if the first row has a reason.  Without a reason it is
 * NULL, or "" if other rows may have one.  Always returns true, so that a command can end with a row.
 */
bool answer_row(struct answer *answer, const struct cell *cells, const char *reason);

/* Writes a row in which nothing is missing. */
#define answer_cells(answer, ...) answer_row(answer, (const struct cell[]){__VA_ARGS__}, NULL)

/* Keeps the cells of a row for 'ans' without writing them, because people read the answer in sentences. */
void answer_keep(struct answer *answer, const struct cell *cells);

/*
 * answer_plan finds out what the first row would otherwise decide, if it were like `sample`.  If that is
 * NULL, no column has error bounds.  Then answer_part returns copies of the answer, which write their rows
 * elsewhere. Only the first part writes what comes before the first row.
 */
void answer_plan(struct answer *answer, const struct cell *sample);
struct answer answer_part(const struct answer *answer, FILE *out, bool first);

/* Returns true if rows cannot be written any more, because the disk is full or a pipe has no reader. */
bool answer_lost(const struct answer *answer);

/* Returns true if column i has error bounds. */
bool answer_bounded(const struct answer *answer, int i);

/* ---- Sentences, and the end ---- */

/* Returns true if the answer is a table for people. */
bool answer_for_people(const struct answer *answer);

/* Writes a sentence, which only people see. */
void answer_say(struct answer *answer, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Sets what the answer decides, such as that a row falls.  'assert' and 'solve' look at that. */
void answer_holds(struct answer *answer, bool yes);

/* Ends the answer.  Returns a text for which its rows had no place, for the caller to report, or NULL. */
const char *answer_end(struct answer *answer);

/* Return an angle in the unit of the style, and the name of that unit. */
domq_real style_angle(const struct answer_style *style, domq_real radians);
const char *style_angle_unit(const struct answer_style *style);

#endif
