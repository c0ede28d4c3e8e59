/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files that take what a stream takes, as it is written: for 'log' and 'tee'. */
#ifndef SHELL_RECORD_H
#define SHELL_RECORD_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

struct record {
    FILE *file;    /* NULL: nothing is recorded */
    bool comments; /* each line of an answer begins with "# ", so that the file is a script */
    bool within;   /* the last line has begun */
    /* The commands that were not written yet: as a comment if an error is the first that comes of them. */
    const char *pending;
    int pending_length;
    enum { RECORD_TEXT, RECORD_ESCAPE, RECORD_CONTROL, RECORD_STRING, RECORD_STRING_ESCAPE } state;
};

/* Opens the file of a record, which it appends to or begins anew.  NULL, or why the file cannot be written.
 */
const char *record_open(struct record *record, const char *path, bool append,
                        const volatile sig_atomic_t *interrupt);

/* Writes the pending commands, if there are any. Those that failed are a comment, so that the file runs. */
void record_commands(struct record *record, bool failed);

/* Writes bytes of an answer, without what sets colours and moves the cursor of a terminal. */
void record_write(struct record *record, const char *bytes, size_t count);

/* Writes all that is pending.  Returns NULL, or what went wrong: the record is closed then. */
const char *record_flush(struct record *record);

void record_close(struct record *record);

/* Makes a stream that writes to another one and to the records that are open.  NULL with errno. */
FILE *record_stream(FILE *out, struct record *log, struct record *tee);

#endif
