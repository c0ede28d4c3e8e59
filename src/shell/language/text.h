/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A line of input, converted to the ASCII that the interpreter reads: Greek letters become their names, and
 * typographic signs and spaces become plain ones. Error messages still count the columns of the line as it
 * was typed.
 */
#ifndef SHELL_TEXT_H
#define SHELL_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <sys/types.h>

struct text {
    const char *typed;
    char *line;
    struct origin {
        int column; /* the column of the character in `typed`, from 1 */
        int offset; /* its offset in `typed`, in bytes */
    } * origin;     /* for each byte of `line`, and for its end */
};

enum { TEXT_MOST = 4 << 20 }; /* the longest line, in bytes */

/*
 * Converts the first `length` bytes of `typed`, which must outlive the text. Returns false if there is no
 * memory. Free the text with text_free.
 */
bool text_make(struct text *text, const char *typed, size_t length);
void text_free(struct text *text);

/*
 * Reads the next line of a stream without its line end, as getline does: into *line, a buffer of *size bytes
 * that the caller frees. Returns the length of the line. Returns -1 at the end of the stream, and with errno
 * after an error or without memory.
 *
 * A longer line than TEXT_MOST is read to its end, but only its first TEXT_MOST + 1 bytes are kept. Once a
 * NUL byte has been read, such a line is not read to its end, since a device may have no end.
 */
ssize_t text_read(char **line, size_t *size, FILE *in);

/* Returns the first place from c on that is not a blank. A line end is not a blank. */
const char *skip_blanks(const char *c);

/* Returns the place after the quote that closes the quote at c, or NULL if there is none. '""' between quotes
 * stands for one quote. */
const char *text_quote(const char *c);

/*
 * Returns the first place from c on that has one of the characters `ends`, or a '#' that begins a comment: at
 * c itself, or after a blank. Characters between quotes do not count. Returns the end of the text if there is
 * no such place, or if a quote is never closed.
 */
const char *text_end(const char *c, const char *ends);

/* Returns true if the line ends with a backslash, and so continues on the next line. Removes the backslash.
 */
bool text_continues(char *line);

/* Returns the column, from 1, that a place of text->line had in the line as it was typed. */
int text_column(const struct text *text, const char *place);

/* Returns the place in the line as it was typed that a place of text->line comes from. */
const char *text_typed(const struct text *text, const char *place);

#endif
