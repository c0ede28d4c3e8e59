/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Breaks text into lines at blanks, but not within a piece such as "r = 1.5" or "7.5 cm", which stays on one
 * line. */
#ifndef SHELL_WRAP_H
#define SHELL_WRAP_H

#include <stddef.h>
#include <stdio.h>

/* Returns the length in bytes of the first line, if a text is broken into lines of `columns` columns. A line
 * also ends at
 * '\n'. A piece that is longer than a line is broken. */
size_t line_break(const char *text, int columns);

/*
 * Writes text in lines that begin at the column `left` and end before the column `right`. If `right` is 0,
 * lines are not broken. If a piece does not fit between the two columns, the whole text goes on the lines
 * below, with less indentation. A piece that is longer than a line is not broken, so that it can be copied.
 * Writes no '\n' at the end.
 */
void write_wrapped(FILE *out, const char *text, int left, int right);

#endif
