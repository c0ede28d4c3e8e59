/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A line as it was typed, made plain: the field's letters, typographic signs and blanks become the ASCII
 * that the interpreter reads; columns are still those of the characters that were typed.
 */
#ifndef SHELL_TEXT_H
#define SHELL_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <sys/types.h>

enum { TEXT_SHORT = 128 };

/* It may not be copied: the pointers of a short line are into the text itself. */
struct text {
    char *line;
    int *column; /* of each byte of line, and of its end; NULL: the line is as it was typed, in ASCII */
    int *from;   /* where in typed each of them comes from; NULL: in the same place */
    const char *typed;
    char own[TEXT_SHORT]; /* a short line in ASCII, as most are, needs no memory */
};

enum { TEXT_MOST = 4 << 20 }; /* bytes of a line: far above what people and programs write */

/* Makes a text; returns false without memory.  typed outlives the text; it is at most INT_MAX bytes long. */
bool text_make(struct text *text, const char *typed, size_t length);
void text_free(struct text *text);

/*
 * Reads the next line of a stream, without its end, as getline does: in *line, of *size bytes, which the
 * caller frees.  Returns its length, -1 at the end of the stream, after an error or without memory (errno).
 * No more than TEXT_MOST bytes are kept, and one more says that it was longer: the rest is read and dropped.
 * After a NUL byte it is left: a device may have such bytes without end.
 */
ssize_t text_read(char **line, size_t *size, FILE *in);

/* Returns the first place from c on that is not a blank. */
const char *skip_blanks(const char *c);

/* Returns the place after the '"' that closes the one at c, NULL if none does; '""' in between is one '"'. */
const char *text_quote(const char *c);

/*
 * Returns the first place from c on, outside of quotes, with one of these characters or with a '#' that
 * begins a comment: at c itself or after a blank. Returns the end of the text if there is none, or if a '"'
 * is never closed.
 */
const char *text_end(const char *c, const char *ends);

/* Returns true if the line goes on below: its last letter is a '\\' outside of comments, which is removed. */
bool text_continues(char *line);

/* Returns the column of a place in the line, from 1. */
int text_column(const struct text *text, const char *place);

/* Returns where in the line as it was typed a place of the plain line comes from. */
const char *text_typed(const struct text *text, const char *place);

#endif
