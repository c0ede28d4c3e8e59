/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Functions for files and streams. The user can interrupt them while they wait, for example for the other end
 * of a FIFO. A signal handler then raises a flag, and the function fails with errno ECANCELED. This also
 * works if the signal handler was installed with SA_RESTART. All functions set errno on failure.
 */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>
#include <time.h>

/* The flag (see dom_raised). If it is NULL, signals have their usual effect. */
extern const volatile sig_atomic_t *io_interrupt;

/* Opens a file as open(2) does. If the file is a FIFO and is opened for writing, the function first waits
 * until a program reads from the FIFO. The descriptor is non-blocking and close-on-exec. Returns -1 on
 * failure. */
int io_open(const char *path, int flags, mode_t mode);

/* Waits until a file can be read or, if `to_write` is true, until it can be written. Waits no longer than
 * `longest`, or without limit if `longest` is NULL. If `file` is -1, there is no file to wait for, so the
 * function waits for the whole time. Returns false if `interrupt` is raised. */
bool io_wait(int file, bool to_write, const struct timespec *longest, const volatile sig_atomic_t *interrupt);

/* Writes all bytes. If another program has made the file non-blocking, waits until its reader has taken
 * enough of the bytes. Returns false if not all bytes could be written. */
bool io_write(int file, const char *bytes, size_t count, const volatile sig_atomic_t *interrupt);

/* Returns true if a regular file ends in the middle of a line, so that the next text needs a new one. */
bool io_ends_in_line(const char *path);

/* Blocks all signals. Returns the previous signal mask, for io_unblock. */
sigset_t io_block(void);
void io_unblock(const sigset_t *before);

/* A program can be started with some of the descriptors 0, 1 and 2 closed. The next file that is opened would
 * then become a standard stream. To prevent this, opens a placeholder for each of these descriptors that is
 * closed. */
void io_begin(void);

/* ---- Streams ---- */

/* Makes a stream from an open file. When the stream is closed, the file is closed too. On failure, closes the
 * file and returns NULL. */
FILE *io_stream(int file, const char *mode);

/* Opens a file for reading. A directory is an error. Returns NULL on failure. */
FILE *io_open_read(const char *path);

/* Returns the stream for standard input. This stream must not be closed. */
FILE *io_stdin(void);

/* Returns the stream for standard output. On a terminal, each line appears immediately. Elsewhere, a system
 * call for each answer would be slow, so the stream keeps its text until its buffer is full or it is flushed.
 * That happens before a read that blocks, and in io_row. Only the flag `interrupt` of the first call
 * interrupts it. */
FILE *io_stdout(const volatile sig_atomic_t *interrupt);

void io_stdout_flush(void);

/* If this is not NULL, a log gets a copy of standard output. */
extern void (*io_copy)(const char *bytes, size_t count);

/* Tells that a row or an answer in `out` is complete. If 0.2 s have passed since standard output was last
 * flushed, flushes `out` and standard output. A program that is killed after minutes has then written all but
 * its last rows. */
void io_row(FILE *out);

/* In this thread, answers are still in memory, and io_row does nothing. */
extern _Thread_local bool io_is_worker;

/* Opens a stream that writes to memory. After fflush or fclose, the text is in *text, and its length in bytes
 * is in *size. A NUL byte follows; *text is NULL if nothing was written. The caller frees *text. If memory
 * runs out, the error flag of the stream is set, which open_memstream does not ensure. Returns NULL on
 * failure. */
FILE *io_memory(char **text, size_t *size);
