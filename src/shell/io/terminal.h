/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The capabilities of the terminal and the locale, and the progress of a long command. */
#ifndef SHELL_TERMINAL_H
#define SHELL_TERMINAL_H

#include <stdbool.h>
#include <stdio.h>

/* Returns true if text written to the stream appears on a terminal. */
bool terminal_shows(FILE *stream);

/* Returns true if text written to the stream appears on a terminal with colours, and NO_COLOR is not set. */
bool terminal_colour(FILE *stream);

/* Stores the columns and rows of the stream's terminal. Without a terminal, stores 0 in both and returns
 * false. */
bool terminal_size(FILE *stream, int *width, int *height);

/* Returns the number of columns of the stream's terminal, or 0 without a terminal. */
int terminal_width(FILE *stream);

/* Makes the functions above treat the stream `to` like standard output, in place of the stream `from`. Does
 * nothing if they treat a third stream like standard output. 'log', 'tee' and the pager need this function,
 * because they pass text on to standard output. */
void terminal_pass(const FILE *from, const FILE *to);

/* Returns true if the character set of the locale is UTF-8. */
bool terminal_utf8(void);

/* Returns true if the locale uses a comma as the decimal separator. */
bool terminal_decimal_comma(void);

/* Returns the number of terminal columns of a UTF-8 text. Wide characters count as one column. */
int utf8_columns(const char *text);

/* Returns the time of a monotonic clock in seconds. */
double terminal_clock(void);

/* If standard error is a terminal, shows the elapsed time there every second, as in "3 s; ^C stops it". */
void progress_begin(void);

/* Clears the line that progress_begin has shown. */
void progress_end(void);

/* Sets the fraction of the work that is done. The progress line then reads "12 %, 3 s left". With a fraction
 * of 1, it shows only the elapsed time. */
void progress_show(double fraction);

/* A callback of type dom_progress, which calls progress_show with done / of. */
void progress_count(size_t done, size_t of, void *context);

/* If `mute` is true, this thread ignores progress_show from now on. A thread that computes only part of the
 * work is muted, because it knows only the progress of this part. Returns the previous setting. */
bool progress_mute(bool mute);

#endif
