/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Opens, reads and writes files so that every wait can be ended: the other end of a FIFO may never be opened.
 * Unless `interrupt` is NULL, a wait ends with ECANCELED when the flag is raised (see dom_raised), also if
 * the handler of the signal has SA_RESTART; with NULL the signals of the program act as usual.
 */
#ifndef SHELL_IO_H
#define SHELL_IO_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>
#include <time.h>

/*
 * Opens a file as open(2) does; a FIFO to write waits for its reader.  The file does not block, and is closed
 * in programs that this one starts.  -1 with errno.
 */
int io_open(const char *path, int flags, mode_t mode, const volatile sig_atomic_t *interrupt);

/* Makes a stream of an open file, which belongs to the stream.  NULL with errno: the file is closed. */
FILE *io_stream(int file, const char *mode, const volatile sig_atomic_t *interrupt);

/* Opens a file to read; a directory is an error.  NULL with errno. */
FILE *io_read(const char *path, const volatile sig_atomic_t *interrupt);

/*
 * Returns standard input as the one stream that all read: stdin where it is a regular file, else a stream
 * whose waits an interrupt ends.  The interrupt of the first call counts.  Not to be closed.  NULL with
 * errno.
 */
FILE *io_stdin(const volatile sig_atomic_t *interrupt);

/* Opens a temporary file without a name in a folder, or, for NULL, where the environment has such files.
 * Nothing is left of it when it is closed or the program ends.  NULL with errno. */
FILE *io_temporary(const char *folder);

/*
 * Makes a stream that writes into memory: *size bytes at *text, which is to be freed, once the stream is
 * closed. That of open_memstream loses without an error what it finds no memory for.  NULL with errno.
 */
FILE *io_memory(char **text, size_t *size);

/*
 * Locks an open file against other programs that lock it, until it is closed.  Where the file system has no
 * locks it does nothing.  False with errno: another program kept its lock for so many seconds, or an
 * interrupt came.
 */
bool io_lock(int file, double seconds, const volatile sig_atomic_t *interrupt);

/*
 * Waits until the file is ready for the events of poll(2), or for the longest time (NULL: without end); file
 * -1 for the time alone.  A signal between the look at the flag and the wait is not lost: it comes when the
 * wait begins.  False with ECANCELED: the flag is raised.
 */
bool io_wait(int file, short events, const struct timespec *longest, const volatile sig_atomic_t *interrupt);

/* Blocks all signals, and returns those that were blocked before, for io_unblock. */
sigset_t io_block(void);
void io_unblock(const sigset_t *before);

/* Writes all bytes; false with errno. */
bool io_write(int file, const char *bytes, size_t count);

/* Opens what is missing of the descriptors 0, 1 and 2, so that no file takes their numbers: what is read from
 * them or written to them fails as before. */
void io_begin(void);

#endif
