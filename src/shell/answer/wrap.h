/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Breaks text into lines at blanks, but not within pieces such as "r = 1.5" or "7.5 cm". */
#ifndef SHELL_WRAP_H
#define SHELL_WRAP_H

#include <stddef.h>
#include <stdio.h>

/*
 * Returns the length in bytes of the first line of a text, if a line has this many columns.  A line also ends
 * at '\n', and within a piece that is longer than the line.
 */
size_t line_break(const char *text, int columns);

/*
 * Writes text whose lines begin at the column `left` and end before the column `right`, or do not end if
 * `right` is 0.  If a piece does not fit beside what is to the left, the whole text goes below that.  A piece
 * that is longer than a line is not broken, so that it can be copied.  Writes no '\n' at the end.
 */
void write_wrapped(FILE *out, const char *text, int left, int right);

#endif
