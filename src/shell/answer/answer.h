/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What an answer is: named columns, and how and where their rows are to be written. */
#ifndef SHELL_ANSWER_H
#define SHELL_ANSWER_H

#include "answer/measure.h"
#include "io/output.h"
#include "language/units.h"
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

struct column {
    const char *key;     /* name in csv and json, head of a table */
    const char *unit;    /* "" for a pure number; "rad" and "rad/s" follow the style's angle; see measure.h */
    const char *meaning; /* one line, for people */
    int width;           /* of words, or of few digits, in a table of rows; 0 for a number */
};

enum { ANSWER_COLUMNS = 24 /* at most */, ANSWER_REASON = 160, ANSWER_HEAD = OUTPUT_HEAD };

struct answer {
    FILE *out;        /* NULL: the answer is only kept */
    const char *path; /* the name of the file that out writes after a '>'; NULL: none */
    bool appended;    /* that file comes after '>>' */
    bool printed;     /* the answer is the value of an expression, which follows */
    struct quantity value;
    struct answer_style style;
    const char *command; /* its name, for programs */
    const char *note;    /* unless NULL and not of_row, what programs should know about the whole answer */
    char *head; /* the last head that csv wrote into this file, ANSWER_HEAD bytes; NULL: none is kept */
    const char *others;           /* what csv writes at the end of its head and of each row, each ended by
                                     a NUL; NULL for nothing */
    const struct column *columns; /* ends with a NULL key */
    struct column own[ANSWER_COLUMNS]; /* room for columns that this one answer has: see answer_columns */
    bool rows;                         /* a table with a head, rather than a line a column */
    bool of_row;                       /* about the row, also of a command that else is about the train */
    bool units;                        /* csv names its columns with their units: it is read back */
    bool begun;
    bool prepared; /* what comes before the next row has been written */
    bool planned;  /* width, letters, bold and bounded are known */
    bool letters;  /* the field's letters can be shown */
    bool bold;
    bool on_terminal;
    int width;                      /* of the terminal; 0 for none */
    unsigned left_out;              /* bit i: cell i of each row has no column, see answer_leave_out */
    unsigned bounded;               /* bit i: see answer_bounded */
    double largest[ANSWER_COLUMNS]; /* the largest number that answer_largest has announced */
    struct measure measure[ANSWER_COLUMNS]; /* of each column in a table of rows, from its first row on */
    bool told;                              /* a person was told something, though no row was written */
    bool gap;                   /* set a blank line between this answer and the one before, for people */
    int lost;                   /* errno of the first write that failed; 0 for none */
    struct cell *kept;          /* the cells of the last row, or NULL */
    bool reasoned;              /* every row has a place for a reason */
    char unsaid[ANSWER_REASON]; /* the reason of a missing number in rows without a place for reasons; "" for
                                   none */
    const struct cell *like; /* unless NULL, a row of the kinds of cells that most rows have, for the head */
    /* Unless NULL, the answer is that of one point of a sweep: this takes its rows, and swept is its own. */
    void (*point)(struct answer *answer, const struct cell *cells, const char *reason);
    struct swept *swept;
    enum { ANSWER_OPEN, ANSWER_YES, ANSWER_NO } holds; /* see answer_holds */
};

/* What went wrong, and where, for programs that read answers. */
struct failure {
    const char *command; /* the one that ran; NULL where there was none */
    const char *text, *source;
    long line;
    int column; /* from 1; 0: the whole line */
};

/* A way to write answers. */
struct format {
    bool for_people; /* sentences, headings and units stand around the rows; else programs read them */
    bool escapes;    /* the format has its own way to write control characters, which a program reads back */
    /* Writes the beginning, before the first row, whose cells and reason are given; NULL: nothing. */
    void (*begin)(struct answer *answer, const struct cell *cells, const char *reason);
    /* Writes a row; reason, unless NULL, says why a value is missing, "" that there is nothing to say. */
    void (*row)(struct answer *answer, const struct cell *cells, const char *reason);
    /* Writes a short text as it is, in lines of its own; NULL where note is. */
    void (*line)(struct answer *answer, const char *text);
    /* Writes a sentence; NULL: the format has no place for one. */
    void (*note)(struct answer *answer, const char *format, va_list arguments);
    /* Writes that a command without an answer is done; NULL: nothing. */
    void (*done)(FILE *out, const char *command);
    /* Writes an error, beside that on standard error; NULL: nothing. */
    void (*failed)(FILE *out, const struct failure *failure);
    /* Returns true if a line of a file names columns; NULL: no line does. */
    bool (*is_head)(const char *line);
    /* Writes the end, after the last row. Returns the text for which the format has no place, or NULL. */
    const char *(*end)(struct answer *answer);
};

/* Returns true if programs get the bounds of column i in a column after it. */
static inline bool answer_bounded(const struct answer *answer, int i)
{
    return (answer->bounded >> i & 1) != 0;
}

/* Returns the note that programs get, or NULL. */
static inline const char *answer_note(const struct answer *answer)
{
    return answer->of_row ? NULL : answer->note;
}

/* Returns true for a column of angles, which follow the style's unit. */
bool column_is_angle(const struct column *column);

/* Returns these columns as the answer's own copy, which may be changed before the first row. */
struct column *answer_columns(struct answer *answer, const struct column *columns);

/* Leaves the column with this key out of the answer, before the first row. Rows still have a cell for it. */
void answer_leave_out(struct answer *answer, const char *key);

/* Gives the column with this key another meaning, in this answer alone; before the first row. */
void answer_means(struct answer *answer, const char *key, const char *meaning);

/*
 * Announces a number of the column with this key, before the first row and after columns are left out. In a
 * table of rows the largest number that was announced decides the unit of the column; otherwise the first row
 * does. An answer without this column ignores the call.
 */
void answer_largest(struct answer *answer, const char *key, domq_real number);

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

/* Return radians in the style's unit of angles, and the name of that unit. */
domq_real style_angle(const struct answer_style *style, domq_real radians);
const char *style_angle_unit(const struct answer_style *style);

#endif
