/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A line of input for the interpreter, and the memory of what is parsed from it. Greek letters such as θ are
 * replaced by their names, and typographic signs such as × by ASCII. Other characters stay as they are. Users
 * see only the line that they have typed, so error messages count columns in that line. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <sys/types.h>

struct text {
    const char *typed;
    char *line;
    /* For each byte of `line`, including the terminating NUL byte: the typed character that the byte comes
     * from. If all characters are ASCII, nothing has been converted, and the pointer is NULL. */
    struct origin {
        int column; /* the column of the character in `typed`, counted from 1 */
        int offset; /* the offset of the character in `typed`, in bytes */
    } * origin;
};

enum { TEXT_MOST = 4 << 20 }; /* the maximum length of a line in bytes */

/* Converts the first `length` bytes of `typed`, which must outlive the text. Returns false if memory runs
 * out. Free the text with text_free. */
bool text_make(struct text *text, const char *typed, size_t length);
void text_free(struct text *text);

/*
 * Reads the next line, without its newline, into the buffer *line of *size bytes. As with getline, the buffer
 * grows if necessary, and the caller frees it. Returns the length of the line, or -1 at the end of the file.
 * If there is an error, returns -1 and sets errno.
 * If a line is longer than TEXT_MOST bytes, only its first TEXT_MOST + 1 bytes are kept. The caller can tell
 * by the length that the line was too long.
 */
ssize_t text_read(char **line, size_t *size, FILE *in);

/* Appends formatted text to `text`, as far as there is room in its buffer of `size` bytes. */
void text_add(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Returns the first character at or after c that is not a blank. A newline is not a blank. */
const char *skip_blanks(const char *c);

/* `c` is the opening quote of a quoted text. Returns the character after its closing quote, or NULL if the
 * quote is never closed. Inside the text, '""' stands for one quote and does not close it. */
const char *text_quote(const char *c);

/* Finds the first character at or after c that is in the list `ends`, or that begins a comment. Characters
 * within quotes are skipped. Returns the end of the text if there is no such character, or if a quote is
 * never closed. */
const char *text_end(const char *c, const char *ends);

/* Converts a position in text->line to its column in the line as it was typed. Columns count from 1. */
static inline int text_column(const struct text *text, const char *place)
{
    return text->origin ? text->origin[place - text->line].column : (int)(place - text->line) + 1;
}

/* Converts a position in text->line to the corresponding position in the line as it was typed. */
const char *text_typed(const struct text *text, const char *place);

/* ---- Memory for what is parsed ---- */

/* An arena hands out pieces of memory and frees all of them at once. A parsed command lives in an arena until
 * the command has run. `struct arena arena = {.block = NULL}` is an empty arena. */
struct arena {
    struct arena_block *block; /* a linked list, whose first block is the current one */
    size_t used, size;         /* the number of bytes used in the current block, and the size of this block */
};

/* Returns zeroed memory that is aligned for any type, or NULL if memory runs out. */
void *arena_take(struct arena *arena, size_t size);

/* Frees all memory of the arena. The arena is then empty and can be used again. */
void arena_free(struct arena *arena);
