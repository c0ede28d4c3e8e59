/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The files that the session is writing. Two output levels must not write the same file at the same time. */
#ifndef SHELL_TARGET_H
#define SHELL_TARGET_H

#include <stdbool.h>
#include <sys/stat.h>

struct target {
    /* the absolute path, in which a symbolic link is replaced by its target, even if the target does not
     * exist */
    char *path;
    bool exists;
    struct stat status; /* the result of stat(2), if the file exists */
    struct target *next;
};

/*
 * Registers a file that is going to be written. Returns NULL on success. On failure, registers nothing and
 * returns a message. This happens if the name contains characters that must be escaped (see escape.h), or if
 * the session is already writing the file, perhaps under another name. The target `except`, which may be
 * NULL, is not checked. Standard output is also checked, unless `may_be_standard` is true.
 */
const char *target_begin(struct target *target, const char *path, bool may_be_standard,
                         const struct target *except);

/* Removes a target, so that its file may be written again. */
void target_end(struct target *target);

/* Returns true if standard output is redirected to the file. */
bool target_is_standard(const struct target *target);

/* Returns a message for the errno of a failed write. A reason of 0 means that errno was not set. */
const char *target_error(int reason);

#endif
