/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Breaks text into lines. */
#ifndef SHELL_WRAP_H
#define SHELL_WRAP_H

#include <stddef.h>
#include <stdio.h>

/* Writes so many blanks; none for a number below 1. */
void write_blanks(FILE *out, int blanks);

/*
 * Returns the length in bytes of the first line of a text, if a line has this many columns. Lines are broken
 * at
 * '\n' and at blanks, but not within "r = 1.5" or "7.5 cm"; a piece that is longer than a line is broken,
 * too.
 */
size_t line_break(const char *text, int columns);

/*
 * Writes text whose lines begin at the column `left` and end before `right`, at blanks; right = 0 for no end.
 * Where a word would not fit, all of the text goes below, to column 4.  Adds no new line at the end.
 */
void write_wrapped(FILE *out, const char *text, int left, int right);

#endif
