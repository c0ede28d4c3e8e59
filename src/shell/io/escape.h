/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Text that others have written (names of files, words of a script), as it may be shown: no control character
 * reaches a terminal, nothing turns the direction of writing, and what goes out is UTF-8.
 */
#ifndef SHELL_ESCAPE_H
#define SHELL_ESCAPE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { ESCAPE_PIECE = 12 }; /* of one character: itself, "\x1b", "\u202e", "\u{e0001}" */

/*
 * The next character of a text that has not ended, as people may read it; returns how many bytes it takes.
 * C0, DEL, C1, what sets the direction of writing or breaks lines, and invisible marks become \x.., \u.... or
 * \u{.....}, each byte that is not UTF-8 becomes \x...  Escaping twice changes nothing.
 */
size_t escape_next(const char *text, char piece[ESCAPE_PIECE]);

/* Returns true if a character of the text has to be escaped. */
bool escape_needed(const char *text);

/* Writes the whole text into size bytes, at least 16; "..." ends a text that is too long. */
const char *escape_text(const char *text, char *shown, size_t size);

/* Returns the whole text in memory that the caller frees; NULL if there is none. */
char *escape_copy(const char *text);

/*
 * A string of JSON with its quotes, always valid UTF-8: control characters and all that escape_next changes
 * become \u...., which a program reads as the same character; a byte that is not UTF-8 becomes U+FFFD.
 */
void escape_json(FILE *out, const char *text);

#endif
