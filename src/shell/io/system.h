/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions that differ between operating systems. They use the features that the build has found (see
 * `features`), and otherwise only POSIX. 'make portable' tests the versions for POSIX. */
#ifndef SHELL_SYSTEM_H
#define SHELL_SYSTEM_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

/* The functions of a stream. A NULL function does nothing. `write` must write all bytes; a smaller result
 * means an error. */
struct system_stream {
    ssize_t (*read)(void *cookie, char *bytes, size_t size);
    ssize_t (*write)(void *cookie, const char *bytes, size_t size);
    int (*close)(void *cookie);
};

/* Opens a stream that calls these functions. Returns NULL and sets errno on failure. */
FILE *system_stream(void *cookie, const char *mode, struct system_stream functions);

/* Reserves disk space for the bytes `from` to `to` of a file, which may grow even on failure. On success, the
 * file has at least `to` bytes. Returns 0 or an error number. */
int system_reserve(int file, off_t from, off_t to);

/* Creates and opens an unnamed file in a folder. Returns -1 if this is not supported. */
int system_unnamed(const char *folder);

/* Makes this process end when its parent ends, if the system allows it. */
void system_end_with_parent(void);

/* Returns the number of processors that this process may use. */
unsigned system_processors(void);

/* Installs the handler of the timer that system_timer_start starts. Returns false if the system has no such
 * timer. */
bool system_timer(void (*handler)(int));
void system_timer_start(long nanoseconds);

#endif
