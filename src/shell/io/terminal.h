/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the terminal, the locale and the environment allow. */
#ifndef SHELL_TERMINAL_H
#define SHELL_TERMINAL_H

#include <stdbool.h>
#include <stdio.h>

/* Returns true for a terminal with colours, if NO_COLOR is not set. */
bool terminal_colour(FILE *stream);

/* Finds the columns and rows of the terminal of the stream. Returns false, and 0 for both, if there is
 * none. */
bool terminal_size(FILE *stream, int *width, int *height);

/* Returns the columns of the terminal of the stream; 0 if there is none. */
int terminal_width(FILE *stream);

/* Gives a stream, whose text comes to standard output later, the size and the colours of its terminal, or
 * takes them back. There are three such streams at most: of log, tee and pager. */
void terminal_lend(const FILE *stream, bool on);

/* Return true if the locale has UTF-8, and if LC_NUMERIC has decimal commas. */
bool terminal_utf8(void);
bool terminal_decimal_comma(void);

/* Returns the columns that UTF-8 text takes: its characters, of which none is wide. */
int terminal_columns(const char *text);

/*
 * Shows "3 s; ^C stops it" on standard error while a command works on, second by second, if that is a
 * terminal; progress_show replaces it.
 */
void ticker_start(void);
void ticker_stop(void);

struct progress {
    double begun, shown; /* seconds of the monotonic clock */
};

/* Returns the seconds of the monotonic clock. */
double terminal_clock(void);

/*
 * "12 %, 3 s left" on standard error, if that is a terminal and the work has taken more than a second;
 * fraction 1 wipes it away.
 */
void progress_show(struct progress *progress, double fraction);

/* Whether this thread shows none: its work is part of other work.  What it was before. */
bool progress_mute(bool mute);

#endif
