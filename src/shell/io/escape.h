/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes text from outside, such as file names and the words of a script, safe to show: no control character
 * reaches a terminal, no character changes the direction of writing, and the output is UTF-8. */
#ifndef SHELL_ESCAPE_H
#define SHELL_ESCAPE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The size of a buffer for one character, which may be escaped: "a", "\x1b", "\u202e" or "\u{e0001}". */
enum { ESCAPE_PIECE = 12 };

/*
 * Escapes the first character of a non-empty text into `piece`. Returns the number of bytes that the
 * character takes in the text. Control characters, invisible characters, and characters that break lines or
 * change the direction of writing become escapes such as \x1b, \u202e or \u{e0001}, and so do bytes that are
 * not UTF-8. Escaping a text twice gives the same result as escaping it once.
 */
size_t escape_next(const char *text, char piece[ESCAPE_PIECE]);

/* Returns true if a character of the text has to be escaped. */
bool escape_needed(const char *text);

/* Writes an escaped copy of a string into the buffer `shown` of `size` bytes. The size must be at least 16. A
 * copy that is too long ends in "...". Returns `shown`. */
const char *escape_text(const char *text, char *shown, size_t size);

/* Escapes a text of any length. Returns an allocated copy, or NULL if memory runs out. */
char *escape_copy(const char *text);

/* Writes a JSON string with its quotes.  Every character that escape_next escapes becomes \u...., which
 * programs decode to the same character.  A byte that is not UTF-8 becomes U+FFFD. */
void escape_json(FILE *out, const char *text);

/* Returns one character of a text, escaped if it has a special meaning in TeX. */
const char *escape_tex(char letter, char piece[ESCAPE_PIECE]);

#endif
