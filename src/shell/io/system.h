/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions that differ between operating systems. If the build has found a suitable feature of the system
 * (see the file `features`), the function uses it. Otherwise the function uses only POSIX. 'make portable'
 * builds and tests the POSIX versions. */
#ifndef SHELL_SYSTEM_H
#define SHELL_SYSTEM_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

/* The functions that do the work of a stream. A function that the stream does not need may be NULL. `write`
 * must write all bytes. If it returns a smaller number, the stream treats this as an error. */
struct system_stream {
    ssize_t (*read)(void *cookie, char *bytes, size_t size);
    ssize_t (*write)(void *cookie, const char *bytes, size_t size);
    int (*close)(void *cookie);
};

/* Opens a stream that calls these functions. Returns NULL and sets errno on failure. */
FILE *system_stream(void *cookie, const char *mode, struct system_stream functions);

/* Reserves disk space for a part of a file, from the byte `from` to the byte before `to`. The file then has
 * at least `to` bytes. If the file system cannot reserve space, does nothing. Returns 0, or an error number.
 * Even on failure, the file may have become longer. */
int system_reserve(int file, off_t from, off_t to);

/* Creates and opens an unnamed file in a folder. Returns -1 if this is not supported. */
int system_unnamed(const char *folder);

/* Gives a name to a file of system_unnamed. Fails if the name exists. */
bool system_name(int file, const char *path);

/* Makes this process end when its parent ends, if the system allows it. */
void system_end_with_parent(void);

/* Returns the number of processors that this process may use. */
unsigned system_processors(void);

#endif
