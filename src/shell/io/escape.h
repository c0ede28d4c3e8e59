/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes text from outside, such as file names, safe to show. Escape sequences replace control and
 * invisible characters, characters that break lines or change the direction of writing, and bytes that are
 * not UTF-8. */
#ifndef SHELL_ESCAPE_H
#define SHELL_ESCAPE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The size of a buffer for one character, which may be escaped: "a", "\x1b", "\u202e" or "\u{e0001}". */
enum { ESCAPE_PIECE = 12 };

/* Escapes the first character of a text into `piece`. The text must not be empty. Returns the length of this
 * character in bytes. Escaping a text twice is the same as escaping it once. */
size_t escape_next(const char *text, char piece[ESCAPE_PIECE]);

/* Returns true if any character of the text has to be escaped. */
bool escape_needed(const char *text);

/* Writes an escaped copy of a string into `shown`, a buffer of `size` bytes, at least 16. A copy that is too
 * long ends in "...". Returns `shown`. */
const char *escape_text(const char *text, char *shown, size_t size);

/* Escapes a text of any length. Returns an allocated copy, or NULL if memory runs out. */
char *escape_copy(const char *text);

/* Writes a text as a JSON string in double quotes. A JSON parser restores the original text, except that a
 * byte that is not UTF-8 becomes U+FFFD. */
void escape_json(FILE *out, const char *text);

/* Returns one character of a text, escaped if it has a special meaning in TeX. */
const char *escape_tex(char letter, char piece[ESCAPE_PIECE]);

#endif
