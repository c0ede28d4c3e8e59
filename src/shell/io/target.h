/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The files that the session is writing.  No file is written by two levels of output at once. */
#ifndef SHELL_TARGET_H
#define SHELL_TARGET_H

#include <stdbool.h>
#include <sys/stat.h>

struct target {
    char *path; /* absolute; a symbolic link is replaced by what it points at, even if that does not exist */
    bool exists;
    struct stat status; /* the status of the file if it exists */
    struct target *next;
};

/*
 * Begins to write a file.  Returns NULL on success, or a message if the name contains characters that must be
 * escaped (see escape.h), or if the session is already writing the file under any of its names.  Then nothing
 * has begun.  The target `except`, which may be NULL, does not count, and standard output counts unless
 * `may_be_standard`.
 */
const char *target_begin(struct target *target, const char *path, bool may_be_standard,
                         const struct target *except);

/* Frees the target, so that its file may be written again. */
void target_end(struct target *target);

/* Returns true if standard output goes to the file. */
bool target_is_standard(const struct target *target);

/* Returns the message for an errno of a write that failed. */
const char *target_error(int reason);

#endif
