/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of files that the session is writing. Before an output opens its file, the list is searched,
 * because two outputs must not write the same file. For example, no answer can be redirected to the log. */
#ifndef SHELL_TARGET_H
#define SHELL_TARGET_H

#include <stdbool.h>
#include <sys/stat.h>

struct target {
    char *path;   /* the absolute path without symbolic links, even if the file does not exist */
    char *folder; /* the absolute path of its folder */
    bool exists;
    struct stat status; /* set if the file exists */
    struct target *next;
};

/*
 * Registers a file that will be written. Returns NULL, or a message on failure. Apart from system errors,
 * registering fails in these cases:
 * - The path contains characters that have to be escaped.
 * - The file is standard output, and `may_be_standard` is false.
 * - The session is already writing the file for another target. This is allowed, however, if the other
 *   target is `except` (which may be NULL), or if the file is a device or a FIFO.
 */
const char *target_begin(struct target *target, const char *path, bool may_be_standard,
                         const struct target *except);

/* Removes a target, so that its file may be written again. */
void target_end(struct target *target);

/* Returns true if standard output is redirected to the file. */
bool target_is_standard(const struct target *target);

/* Returns a message for a write that has failed. `reason` is the value of errno after this write, or 0 if
 * errno was not set. */
const char *target_error(int reason);

#endif
