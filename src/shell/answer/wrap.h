/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Breaks text into lines at blanks, but not within a piece such as "r = 1.5" or "7.5 cm". */
#ifndef SHELL_WRAP_H
#define SHELL_WRAP_H

#include <stddef.h>
#include <stdio.h>

/* Returns how many bytes of a text form a line of at most `columns` columns. A '\n' also ends the line. A
 * piece that is longer than a line is broken. */
size_t line_break(const char *text, int columns);

/* Writes text in lines from the column `left` to the column before `right`, without a '\n' at the end. If
 * `right` is 0, lines are not broken. Even a long piece, such as a path, is never broken, so that it can be
 * copied. */
void write_wrapped(FILE *out, const char *text, int left, int right);

#endif
