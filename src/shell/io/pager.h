/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Long texts at a terminal, a page at a time. */
#ifndef SHELL_PAGER_H
#define SHELL_PAGER_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

struct pager;

/*
 * Returns the stream to write a text to, and sets *pager: to NULL if standard input and `out` are not both
 * the terminal, and the stream is `out` itself.  The stream has the terminal's width and colours.  What is
 * longer than the terminal goes through $PAGER, or else less, if programs may be run, while it is written;
 * without these it is shown a page at a time.  A text that fits, or that comes slowly, goes to `out` as it
 * is. Writing fails after the reader has left, and after an interrupt.
 */
FILE *pager_begin(struct pager **pager, FILE *out, bool programs, const volatile sig_atomic_t *interrupt);

/* Ends the text, and waits until it is read.  The terminal is left as it was. */
void pager_end(struct pager *pager);

/* Returns the stream for messages: standard error, or what goes there once the text is read. */
FILE *pager_messages(void);

#endif
