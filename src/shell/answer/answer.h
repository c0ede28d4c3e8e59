/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A command passes its answer to these functions: first the columns, then rows of cells. The output format
 * writes each row immediately, so the beginning of a long curve appears while the rest is being computed. A
 * command can also write sentences. Sentences appear only in formats for people, not in formats for programs.
 */
#pragma once

#include "answer/cell.h"
#include "io/output.h"
#include "language/units.h"
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

struct rest;

enum { ANSWER_COLUMNS = 24, ANSWER_REASON = 240, ANSWER_HEADER = OUTPUT_HEADER };

struct column {
    const char *key;
    const char *unit;    /* "" for a pure number, "rad" or "rad/s" for angles, or a unit of units.h */
    const char *meaning; /* a one-line explanation */
    /* The width of the column in a table of rows, if the column holds words or short numbers. For other
     * numbers this width is 0, and the table chooses the width itself. */
    int width;
};

/* The appearance of the rows, which is fixed before the first row is written. */
struct layout {
    bool is_planned;
    bool on_terminal;
    bool letters; /* the terminal can show Greek letters */
    int width;    /* the width of the terminal in columns, or 0 if there is no terminal */
    /* Bit i is set if column i shows errors. In csv and json, the errors are written in an additional column.
     */
    unsigned errors;
    double largest[ANSWER_COLUMNS];         /* see answer_announce */
    struct measure measure[ANSWER_COLUMNS]; /* the unit of each column in a table of rows */
    /* Only for the table format: */
    int digits;
    int column[ANSWER_COLUMNS]; /* the widths of the columns */
    int words;                  /* where the last column begins, or -1 if its words are below each row */
    /* A typical row, for the header line. The alignment of each name in this line depends on the kind of cell
     * below it, and the first row may have unusual cells, such as empty ones. If `sample` is NULL, the first
     * row is used. */
    const struct cell *sample;
};

struct csv_layout {
    bool units;       /* column names include the units, so that the file can be read back */
    bool has_reasons; /* the rows have a column for reasons */
    /* A buffer that keeps the column names between answers, so that rows with the same columns do not repeat
     * the header. It contains "" if the output has no header yet. The pointer may be NULL. */
    char *last_header;
};

struct answer {
    FILE *out;        /* the stream; NULL if nothing is written and only the cells of the last row are kept */
    const char *path; /* the name of the output file after '>' or '>>', or NULL */
    char made[64];    /* what the file has, for a note such as "wrote a.gif: 249 frames, 10 s, 1.3 MB" */
    struct answer_style style;
    const char *command;          /* the name of the command, for programs that read the answer */
    const char *note;             /* a remark for programs that read the answer, or NULL */
    const struct column *columns; /* the columns of each row; the key of the last element is NULL */
    /* the answer's own copy of the columns, which can be changed (see answer_columns) */
    struct column copy[ANSWER_COLUMNS];
    unsigned left_out; /* bit i is set if cell i of each row is not shown (see answer_leave_out) */
    bool rows;         /* the answer is a table of rows, rather than a single row */
    bool in_double;    /* its numbers are computed in double precision, whatever `style` has */
    struct {
        /* In formats for people: the keys of the columns that the answer shows, or "*" for all. The others
         * are in its rest, which 'details' prints. NULL if the answer has no rest. */
        const char *brief;
        struct rest *rest; /* where the rest of the answer is kept, or NULL if it is not kept */
        bool has_rows;     /* the rest has rows */
    } details;
    struct csv_layout csv;
    struct {
        const volatile sig_atomic_t *interrupt; /* once it is raised, no more rows are written; may be NULL */
        bool blank_above;                       /* a blank line separates this answer from the previous one */
        bool is_open;    /* output has begun: the blank line has been written, if there is one */
        bool has_rows;   /* the first row and the lines above it have been written */
        bool wrote_text; /* a command without columns has written something */
    } progress;
    struct layout layout;

    /* Results that the session keeps: */
    bool is_value; /* the answer is the value of an expression, stored in `value` */
    struct quantity value;
    struct cell *kept;                                   /* receives the cells of the last row; may be NULL */
    enum { ANSWER_OPEN, ANSWER_YES, ANSWER_NO } verdict; /* see answer_set_verdict */
    /* The reason why a cell is empty, if the reason was not written in or below the row. It is reported at
     * the end of the answer. Only the first such reason is kept. "" if there is none. If nothing is written,
     * this is the reason of the last row. */
    char late_reason[ANSWER_REASON];

    /* If the answer is a part of another one, such as a point of a sweep, `take` receives its rows, and
     * nothing is written directly. Otherwise `take` is NULL. */
    struct sink {
        void (*take)(struct answer *answer, const struct cell *cells, const char *reason);
        void *context;
        size_t point; /* the number of the point, counted from 0 */
    } sink;
    struct {
        /* The feature 'errors' sees each row of all cells, and may set their errors. NULL if it does not. */
        void (*see)(const struct answer *answer, struct cell *cells, size_t count);
        void *context;
        bool has_unknown; /* a number was shown without its error, although errors are on */
        bool has_no_room; /* a column of a table has no room for its errors */
    } errors;
};

/* An output format. A member is NULL if its function would do nothing. */
struct format {
    bool for_people; /* the format is for people, with sentences and units; otherwise it is for programs */
    bool escapes;    /* the format escapes control characters itself, in a way that programs can decode */
    /* Writes the lines before the first row. `cells` and `reason` belong to the first row. */
    void (*begin)(struct answer *answer, const struct cell *cells, const char *reason);
    void (*row)(struct answer *answer, const struct cell *cells, const char *reason);
    void (*sentence)(struct answer *answer, const char *format, va_list arguments);
    /* Reports that a command without an answer has finished. */
    void (*done)(FILE *out, const char *command);
    /* Writes an error in a script into the output, in addition to the message on standard error. `command` is
     * NULL if no command was recognised; `column` is 0 if the error concerns the line as a whole. */
    void (*failed)(FILE *out, const char *command, const char *text, const char *source, long line,
                   int column);
    /* Returns true if the line consists of column names. */
    bool (*is_header)(const char *line);
};

/* The list of output formats. To add a format, write a struct format as in data.c and add its name. 'set
 * output', its help, its completion and the extensions of output files then include the new format. Only a
 * few help texts and messages name the formats themselves and must be changed by hand. The first format is
 * the default. */
#define FORMATS(EACH) EACH(table) EACH(csv) EACH(json)

#define FORMAT_EXTERN(name) extern const struct format format_##name;
FORMATS(FORMAT_EXTERN)

/* The formats, indexed by their position in the list. */
extern const struct format *const formats[];

/* ---- The extensions of the files to which answers can be written ---- */

enum extension_kind {
    EXTENSION_NONE,  /* no extension: the session's settings decide */
    EXTENSION_OTHER, /* an unknown extension, which is an error */
    EXTENSION_TEXT,  /* .txt, which has the same effect as no extension */
    EXTENSION_DATA,  /* the extension of an answer format, such as .csv */
    EXTENSION_FILM,  /* an extension for animations (.gif) */
    EXTENSION_SHEET, /* an extension for pictures, such as .png */
};

/* A file extension, and how files with this extension are written. */
struct extension {
    const char *text; /* the extension, such as ".csv"; NULL for EXTENSION_NONE and EXTENSION_OTHER */
    enum extension_kind kind;
    const struct format *format; /* for EXTENSION_DATA: the format of the answer */
    bool is_script;              /* the script of the picture is written instead of the picture */
    const char *terminal;        /* the name of the gnuplot terminal that draws the picture, or NULL */
};
const struct extension *extension_of(const char *path);

/* The smallest terminal, in characters, on which a picture is drawn. */
enum { PICTURE_LEAST_WIDTH = 31, PICTURE_LEAST_HEIGHT = 13 };

/* ---- Columns, before the first row ---- */

/* Returns true for a column of angles, which are shown in the unit that the user has chosen. */
static inline bool column_is_angle(const struct column *column)
{
    return strncmp(column->unit, "rad", 3) == 0;
}

/* Widens a column of words, if necessary, so that the word fits. */
void column_fit(struct column *column, const char *word);

/* Copies columns into the answer, where they may be changed, and returns the copy. */
struct column *answer_columns(struct answer *answer, const struct column *columns);

/* Leaves columns out of the answer. `keys` lists the keys of these columns, separated by blanks. The rows
 * that are passed to answer_row must still have a cell for each of them. */
void answer_leave_out(struct answer *answer, const char *keys);

/* Changes the unit and the explanation of a column in this answer. If `unit` is NULL, the column keeps its
 * unit. If `meaning` is NULL, the column keeps its explanation. */
void answer_describe(struct answer *answer, const char *key, const char *unit, const char *meaning);

/* Announces a number that a column will contain. In a table of rows, each column has one unit, which must be
 * chosen before the first row is written. The unit suits the largest number that was announced or is in the
 * first row. If no column has this key, nothing happens. */
void answer_announce(struct answer *answer, const char *key, domq_real number);

/* ---- Rows ---- */

/* Writes a row and returns true. `reason` explains why a cell has no value, or is NULL. In a format for
 * people, the reason is written below the row. In csv and json, the reasons have a column of their own,
 * "reason". If this row has no reason but other rows of the answer may have one, pass "" in these two
 * formats, so that the row also has this column. */
bool answer_row(struct answer *answer, const struct cell *cells, const char *reason);

/* Writes a row in which no value is missing. */
#define answer_cells(answer, ...) answer_row(answer, (const struct cell[]){__VA_ARGS__}, NULL)

/* Fixes the layout before the first row is known. The layout becomes what it would be if the first row were
 * `sample`. If `sample` is NULL, no column shows errors. */
void answer_plan(struct answer *answer, const struct cell *sample);

/* Returns true if no more rows can be written, because the disk is full or a pipe has no reader, or if no
 * more are wanted, because the user has interrupted the command. Every loop over rows asks this function. */
bool answer_lost(const struct answer *answer);

/* Returns true if column i shows errors. */
static inline bool answer_has_error(const struct answer *answer, int i)
{
    return (answer->layout.errors >> i & 1) != 0;
}

/* ---- Sentences, and the end ---- */

/* Returns true if the answer is written for people, not for a program. */
static inline bool answer_for_people(const struct answer *answer)
{
    return answer->out && answer->style.format->for_people && !answer->sink.take;
}

/* Writes a sentence, if the answer is for people. */
void answer_say(struct answer *answer, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* ---- The rest of an answer, which 'details' prints ---- */

/* An answer for people is short. What else it has to say goes into its rest: sentences of answer_detail, and
 * rows with all columns if answer.details.brief leaves some out. The rest is formatted at once, so it stays
 * as it was when the scene changes. */
struct rest {
    FILE *out; /* writes into `text`; NULL if the answer has no rest so far */
    char *text;
    size_t size;
    struct answer answer; /* the answer that writes into `out`; not set before */
};

/* Writes a sentence into the rest of the answer. */
void answer_detail(struct answer *answer, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Returns a stream for text that is part of the rest, or NULL if no rest is kept. */
FILE *answer_rest(struct answer *answer);

/* Ends the rest and returns its text, which the caller frees. Returns NULL if there is no rest, or if memory
 * has run out. */
char *rest_end(struct rest *rest);

/* Stores the answer to a yes-or-no question, such as whether a row falls, for 'assert' and 'solve'. */
void answer_set_verdict(struct answer *answer, bool yes);

/* Returns the number of digits, from 1 to `most`, that the tolerance justifies. */
int style_tol_digits(const struct answer_style *style, int most);

/* Converts an angle to the unit that the user has chosen, and returns the name of this unit. */
domq_real style_angle(const struct answer_style *style, domq_real radians);
const char *style_angle_unit(const struct answer_style *style);
