/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Long texts at a terminal, a page at a time. */
#ifndef SHELL_PAGER_H
#define SHELL_PAGER_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

/* A text that is collected before it is shown. */
struct pager {
    FILE *out, *memory; /* memory: NULL if the text goes to out at once */
    char *text;
    size_t size;
};

/*
 * Returns the stream to write a text to: memory if standard input and `out` are the terminal, else `out`
 * itself.  The memory has the terminal's width and colours.
 */
FILE *pager_begin(struct pager *pager, FILE *out);

/*
 * Shows what was collected.  A text that is longer than the terminal goes through $PAGER, or else less, if
 * programs may be run; without these it is shown a page at a time.  A raised interrupt ends that.  The
 * terminal is left as it was.
 */
void pager_end(struct pager *pager, bool programs, const volatile sig_atomic_t *interrupt);

#endif
