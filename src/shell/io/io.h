/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Files and streams whose waits can be interrupted. Otherwise a wait might never end, for example if no
 * program opens the other end of a FIFO. When the flag `interrupt` is raised (see dom_raised), a wait ends
 * with ECANCELED, even if the signal handler was installed with SA_RESTART. If `interrupt` is NULL, signals
 * have their usual effect. All functions set errno on failure.
 */
#ifndef SHELL_IO_H
#define SHELL_IO_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>
#include <time.h>

/*
 * Opens a file as open(2) does. Before a FIFO is opened for writing, waits until it has a reader. The
 * descriptor is non-blocking and close-on-exec. Returns -1 on failure.
 */
int io_open(const char *path, int flags, mode_t mode, const volatile sig_atomic_t *interrupt);

/* Locks an open file with flock(2) until the file is closed. This keeps out only programs that also lock the
 * file. Does nothing if the file system has no locks. Returns false if another program does not release its
 * lock within `seconds` seconds, or after an interrupt. */
bool io_lock(int file, double seconds, const volatile sig_atomic_t *interrupt);

/* Waits until a file can be read (or written, if `to_write` is true), but not longer than `longest`. If
 * `file` is -1, waits for this time. If `longest` is NULL, there is no time limit. A signal that arrives
 * between the check of the flag and the wait also ends the wait. Returns false if the flag is raised.
 */
bool io_wait(int file, bool to_write, const struct timespec *longest, const volatile sig_atomic_t *interrupt);

/* Writes all bytes. This function may be called in a signal handler. */
bool io_write(int file, const char *bytes, size_t count, const volatile sig_atomic_t *interrupt);

/* Blocks all signals. Returns the previous signal mask, for io_unblock. */
sigset_t io_block(void);
void io_unblock(const sigset_t *before);

/* If descriptor 0, 1 or 2 is closed, opens a placeholder that can be neither read nor written. Otherwise the
 * next file that is opened would become standard input, output or error. */
void io_begin(void);

/* ---- Streams ---- */

/* Makes a stream from an open file.  Closing the stream closes the file.  On failure, closes the file and
 * returns NULL. */
FILE *io_stream(int file, const char *mode, const volatile sig_atomic_t *interrupt);

/* Opens a file for reading.  A directory is an error.  Returns NULL on failure. */
FILE *io_read(const char *path, const volatile sig_atomic_t *interrupt);

/* Returns the stream for standard input. Every call returns the same stream, which must not be closed.
 * `interrupt` takes effect only in the first call. */
FILE *io_stdin(const volatile sig_atomic_t *interrupt);

/*
 * Returns the stream for standard output. Every call returns the same stream. On a terminal each line appears
 * immediately. Elsewhere the text is buffered, because a system call for each short answer would take longer
 * than the answer itself. A program that reads the output does not have to wait long: a timer writes flushed
 * text within 10 ms, even during a computation.
 */
FILE *io_stdout(const volatile sig_atomic_t *interrupt);

/* Writes all buffered text to standard output. */
void io_stdout_flush(void);

/* Returns the folder for temporary files: $TMPDIR, or /tmp. */
const char *io_temporary_folder(void);

/* Opens a temporary file without a name, which vanishes when it is closed or the program ends. If `folder` is
 * NULL, the file is in io_temporary_folder(). Returns NULL on failure. */
FILE *io_temporary(const char *folder);

/* Copies a stream from its beginning to its end. If the copy fails, the error flag of one of the streams is
 * set. */
void io_copy(FILE *from, FILE *to);

/* Makes a stream that writes into memory. After fclose, *text holds *size bytes without a terminating NUL
 * byte, and the caller frees *text. Unlike a stream of open_memstream, this stream sets its error flag if
 * memory runs out. Returns NULL on failure. */
FILE *io_memory(char **text, size_t *size);

#endif
