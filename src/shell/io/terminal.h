/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the terminal and the locale allow, and how far a long command is. */
#ifndef SHELL_TERMINAL_H
#define SHELL_TERMINAL_H

#include <stdbool.h>
#include <stdio.h>

/* Returns true if a terminal shows what is written to the stream. */
bool terminal_shows(FILE *stream);

/* Returns true if the stream is shown on a terminal with colours, and NO_COLOR is not set. */
bool terminal_colour(FILE *stream);

/* Gets the number of columns and rows of the stream's terminal.  Without a terminal returns false, and both
 * are 0. */
bool terminal_size(FILE *stream, int *width, int *height);

/* Returns the number of columns of the stream's terminal, or 0 without a terminal. */
int terminal_width(FILE *stream);

/*
 * Makes stream `to` stand for standard output, whose terminal it has from now on, if stream `from` stood for
 * it until now.  'log', 'tee' and the pager are such streams: they pass their text on.
 */
void terminal_pass(const FILE *from, const FILE *to);

/* Returns true if the character set of the locale is UTF-8. */
bool terminal_utf8(void);

/* Returns true if the locale writes a comma as the decimal point. */
bool terminal_decimal_comma(void);

/* Returns the number of columns that UTF-8 text takes.  Wide characters count as one column. */
int terminal_columns(const char *text);

/* Returns the seconds of the monotonic clock. */
double terminal_clock(void);

/*
 * progress_begin makes standard error show "3 s; ^C stops it" every second, if it is a terminal, and
 * progress_end clears that line.  After progress_show it shows "12 %, 3 s left" instead; a fraction of 1 ends
 * that.
 */
void progress_begin(void);
void progress_end(void);
void progress_show(double fraction);

/* Shows the same as progress_show(done / of), as the progress function that the library wants. */
void progress_count(size_t done, size_t of, void *context);

/* Makes this thread ignore progress_show, or not, since its work is only a part of what is shown.  Returns
 * whether it was ignored before. */
bool progress_mute(bool mute);

#endif
