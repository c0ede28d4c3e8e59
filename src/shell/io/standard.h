/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Standard output.  What is written to a terminal is there at the end of each line.  Elsewhere a system call
 * for each short answer would take longer than the answer, so that text is held until there is enough of it;
 * but the program that reads it does not wait: what was flushed is written a moment later, whatever the
 * program does then.
 */
#ifndef SHELL_STANDARD_H
#define SHELL_STANDARD_H

#include <signal.h>
#include <stdio.h>

/* Returns the stream, the same for each call.  A raised interrupt ends a write that waits for its reader. */
FILE *standard_stream(const volatile sig_atomic_t *interrupt);

/* Writes all that is held, now. */
void standard_flush(void);

#endif
