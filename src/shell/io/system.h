/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Functions that differ between operating systems. Each of them uses a function that the build has found on
 * this system (see the script `features`), or otherwise functions of POSIX. 'make portable' tests the
 * versions that use only POSIX.
 */
#ifndef SHELL_SYSTEM_H
#define SHELL_SYSTEM_H

#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>
#include <time.h>

/* The functions of a stream; those that are NULL do nothing.  `write` writes all bytes.  If it returns less,
 * the stream has an error. */
struct system_stream {
    ssize_t (*read)(void *cookie, char *bytes, size_t size);
    ssize_t (*write)(void *cookie, const char *bytes, size_t size);
    int (*close)(void *cookie);
};

/* Opens a stream that calls these functions.  Returns NULL with errno on failure. */
FILE *system_stream(void *cookie, const char *mode, struct system_stream functions);

/* Waits as poll(2) does, with the signal mask `mask` while it waits.  The members `revents` are not set. */
void system_poll(const struct pollfd *file, const struct timespec *longest, const sigset_t *mask);

/* Makes a pipe whose ends are closed in programs that are started.  Returns false on failure. */
bool system_pipe(int ends[2]);

/* Reserves space on the disk for the bytes `from` to `to` of a file, which then is at least that long.
 * Returns 0, or an error number.  On failure the file may be longer than before. */
int system_reserve(int file, off_t from, off_t to);

/* Opens a new file without a name in a folder.  Returns -1 if the system or the file system has no such
 * files. */
int system_unnamed(const char *folder);

/* Returns the value of an environment variable that names a folder, or NULL.  Where possible, a program with
 * more rights than its user has ignores it. */
const char *system_environment(const char *name);

/* Where possible, makes this process end when its parent ends. */
void system_end_with_parent(void);

/* Returns the number of processors that this process may use. */
unsigned system_processors(void);

/* Installs a handler of a timer that system_timer_start starts.  Returns false if there is no such timer. */
bool system_timer(void (*handler)(int));
void system_timer_start(long nanoseconds);

#endif
