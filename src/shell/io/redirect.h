/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files are written whole or not at all: a new one appears only when it is complete. */
#ifndef SHELL_REDIRECT_H
#define SHELL_REDIRECT_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

struct redirect {
    FILE *file;
    char *path, *draft; /* draft: the file that takes the place of path; NULL if none does */
    bool copy, append;  /* copy: file is a draft without a name, to be copied into path */
    const volatile sig_atomic_t *interrupt;
    struct redirect *outer; /* has a draft, too, and was opened before */
    struct redirect *below; /* was opened before, and appears when it is complete */
};

/* Opens a file to write; an interrupt ends its waits, see io.h.  NULL, or why the file cannot be written:
 * also where its name is not shown as it is (escape.h). */
const char *redirect_open(struct redirect *redirect, const char *path, bool append,
                          const volatile sig_atomic_t *interrupt);

/* Keeps or drops what was written; NULL, or what went wrong. */
const char *redirect_close(struct redirect *redirect, bool keep);

#endif
