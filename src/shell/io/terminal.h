/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The terminal and the locale, text that is broken into lines, and the progress of a long command. */
#pragma once

#include <stdbool.h>
#include <stdio.h>

/* Returns true if text written to the stream appears on a terminal. */
bool terminal_shows(FILE *stream);

/* Stores the number of columns and the number of rows of the stream's terminal. If the stream is not shown on
 * a terminal, stores 0 in both and returns false. */
bool terminal_size(FILE *stream, int *width, int *height);

/* Returns the number of columns of the stream's terminal, or 0 without a terminal. */
int terminal_width(FILE *stream);

/* The functions above treat this stream like standard output. */
void terminal_standard(const FILE *stream);

/* Returns true if the character set of the locale is UTF-8. */
bool terminal_utf8(void);

/* Returns the number of terminal columns of a UTF-8 text. Wide characters count as one column. */
int utf8_columns(const char *text);

/* ---- Lines: text is broken at blanks ---- */

/* Returns how many bytes of a string go into the first line, which has room for `columns` columns. The line
 * ends between two words, but not beside a '=', or at a '\n'. If the first word is longer than a line, the
 * line ends within it. */
size_t line_break(const char *text, int columns);

/* Writes text in lines between two columns of the terminal. Each line begins at the column `left` and ends
 * before the column `right`. If `right` is 0, lines are not broken. A word that is longer than a line, such
 * as a path, is not broken either, so that the user can copy it. No '\n' is written at the end. */
void write_wrapped(FILE *out, const char *text, int left, int right);

/* ---- Time and progress ---- */

/* Returns the time of a monotonic clock in seconds. */
double terminal_clock(void);

/* A feature can show the progress of long commands on standard error, if it is a terminal. */
void progress_begin(void);
void progress_end(void); /* clears the line that shows it */

/* The function of the feature for both. NULL without such a feature. */
extern void (*progress_hook)(bool begins);
