/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Files and streams whose waits can be interrupted, such as the wait for the other end of a FIFO. When the
 * flag `interrupt` is raised (see dom_raised), a wait ends with ECANCELED, even if the signal handler was
 * installed with SA_RESTART. If `interrupt` is NULL, signals have their usual effect. All functions set errno
 * on failure.
 */
#ifndef SHELL_IO_H
#define SHELL_IO_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>
#include <time.h>

/* Opens a file as open(2) does. If the file is a FIFO that is opened for writing, first waits until a program
 * reads from it. The descriptor is non-blocking and close-on-exec. Returns -1 on failure. */
int io_open(const char *path, int flags, mode_t mode, const volatile sig_atomic_t *interrupt);

/* Locks a file with flock(2) until it is closed. Only programs that also use flock(2) are kept out. Returns
 * false if `seconds` seconds were not enough, or after an interrupt. If the file system does not support
 * locks, returns true without a lock. */
bool io_lock(int file, double seconds, const volatile sig_atomic_t *interrupt);

/* Waits until a file can be read, or written if `to_write` is true. If `file` is -1, waits for the time
 * `longest`. If `longest` is NULL, there is no limit. Returns false if the flag is raised. */
bool io_wait(int file, bool to_write, const struct timespec *longest, const volatile sig_atomic_t *interrupt);

/* Writes all bytes. This function may be called in a signal handler. */
bool io_write(int file, const char *bytes, size_t count, const volatile sig_atomic_t *interrupt);

/* Blocks all signals. Returns the previous signal mask, for io_unblock. */
sigset_t io_block(void);
void io_unblock(const sigset_t *before);

/* Opens a placeholder for each of the descriptors 0, 1 and 2 that is closed. Otherwise the next file that
 * is opened would become a standard stream. */
void io_begin(void);

/* ---- Streams ---- */

/* Makes a stream from an open file. Closing the stream also closes the file. On failure, closes the file and
 * returns NULL. */
FILE *io_stream(int file, const char *mode, const volatile sig_atomic_t *interrupt);

/* Opens a file for reading. A directory is an error. Returns NULL on failure. */
FILE *io_open_read(const char *path, const volatile sig_atomic_t *interrupt);

/* Returns the stream for standard input, which must not be closed. Only the `interrupt` of the first call
 * takes effect. */
FILE *io_stdin(const volatile sig_atomic_t *interrupt);

/*
 * Returns the stream for standard output. On a terminal, each line appears immediately. In a pipe or file,
 * text is delayed even after fflush, because a system call for each answer would be slow. A timer writes the
 * text within 10 ms, even during a computation.
 */
FILE *io_stdout(const volatile sig_atomic_t *interrupt);

/* Writes all buffered text to standard output. */
void io_stdout_flush(void);

/* Returns the folder for temporary files: $TMPDIR, or /tmp. */
const char *io_temporary_folder(void);

/* Creates an unnamed file, which vanishes when it is closed or the program ends. If `folder` is NULL,
 * uses io_temporary_folder(). Returns NULL on failure. */
FILE *io_temporary(const char *folder);

/* Copies a whole stream. On failure, one of the streams has its error flag set. */
void io_copy(FILE *from, FILE *to);

/* Opens a stream that writes to memory. After fflush or fclose, *text holds *size bytes, without a NUL byte
 * at the end. The caller frees *text. Unlike open_memstream, sets the error flag if memory runs out. Returns
 * NULL on failure. */
FILE *io_memory(char **text, size_t *size);

#endif
