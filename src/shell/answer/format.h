/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How answers are written.  To add a format, write one file like csv.c with its `struct format`, and name it
 * in FORMATS: 'set output', its help and its completion take it from there.
 */
#ifndef SHELL_FORMAT_H
#define SHELL_FORMAT_H

#include "answer/answer.h"
#include <stdarg.h>

/* What went wrong, and where, for programs that read answers. */
struct failure {
    const char *command; /* the one that ran; NULL where there was none */
    const char *text, *source;
    long line;
    int column; /* from 1; 0: the whole line */
};

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

/* All formats, the default first. */
#define FORMATS(EACH) EACH(table) EACH(csv) EACH(json)

#define FORMAT_EXTERN(name) extern const struct format format_##name;
FORMATS(FORMAT_EXTERN)

/* Returns a format by its number in the list. */
const struct format *format_at(unsigned number);

#endif
