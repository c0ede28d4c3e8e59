/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The files that this program is writing, so that none is written twice at once. */
#ifndef SHELL_FILE_H
#define SHELL_FILE_H

#include <stdbool.h>
#include <sys/stat.h>

struct target {
    char *path; /* the file's path after all links are followed; the last may point at nothing */
    bool exists;
    struct stat status;  /* of the file, if it exists */
    struct target *next; /* the target that was begun before */
};

/*
 * Begins to write a file, unless its name cannot be shown as it is (escape.h) or the program is writing it
 * already, under any of its names: for another target than `except`, or as standard output where that may not
 * be. Returns NULL, or why not.
 */
const char *target_begin(struct target *target, const char *path, bool may_be_standard,
                         const struct target *except);

/* Returns true if standard output goes to the file. */
bool target_is_standard(const struct target *target);

/* Ends it, and frees what it holds. */
void target_end(struct target *target);

#endif
