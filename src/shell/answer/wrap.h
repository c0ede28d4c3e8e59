/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Breaks text into lines at blanks. Some words stay together on a line, such as "r = 1.5" or "7.5 cm". Such a
 * group of words, or a single word, is called a piece. */
#ifndef SHELL_WRAP_H
#define SHELL_WRAP_H

#include <stddef.h>
#include <stdio.h>

/* Returns how many bytes of a string go into the first line, which has room for `columns` columns. The line
 * ends between two pieces or at a '\n'. If the first piece is longer than a line, the line ends within this
 * piece. */
size_t line_break(const char *text, int columns);

/* Writes text in lines between two columns of the terminal. Each line begins at the column `left` and ends
 * before the column `right`. If `right` is 0, lines are not broken. A piece that is longer than a line, such
 * as a path, is not broken either, so that the user can copy it. No '\n' is written at the end. */
void write_wrapped(FILE *out, const char *text, int left, int right);

#endif
