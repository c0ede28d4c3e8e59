/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes text from outside, such as file names, safe to show. Some characters could confuse the terminal or
 * the reader: control characters, invisible characters, and characters that break lines or change the
 * direction of writing. They are replaced by escape sequences. Bytes that are not UTF-8 are also replaced. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The size of a buffer for one character, which may be escaped: "a", "\x1b", "\u202e" or "\u{e0001}". */
enum { ESCAPE_PIECE = 16 };

/* Writes the first character of a string into `piece`, or an escape sequence if the character needs one. If
 * `json` is true, the sequences are those of JSON. The string must not be empty. Returns the length of this
 * character in the string, in bytes. Escaping an escaped string again does not change it, because backslashes
 * are not escaped. */
size_t escape_next(const char *text, bool json, char piece[ESCAPE_PIECE]);

bool escape_is_utf8(const char *text);

bool escape_needed(const char *text);

/* Writes an escaped copy of a string into the buffer `shown` and returns `shown`. The buffer has `size`
 * bytes, which must be at least 16. If the copy does not fit into the buffer, it is cut off and ends in
 * "...". */
const char *escape_text(const char *text, char *shown, size_t size);

/* Escapes a string of any length. Returns an allocated copy, or NULL if memory runs out. */
char *escape_copy(const char *text);

/* Writes a string as a JSON string in double quotes. A JSON parser then gets the original string back. There
 * is one exception: each byte that is not UTF-8 becomes the character U+FFFD. */
void escape_json(FILE *out, const char *text);
