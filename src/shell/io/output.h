/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where the answers go: to standard output or, while a command with '>' runs, into its file. Such commands
 * can be nested, so the outputs form a stack with standard output at the bottom. A log can get a copy of the
 * text for standard output.
 */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/stat.h>

struct format;

enum { OUTPUT_HEADER = 1024 };

struct output {
    struct output *below; /* NULL at the bottom */
    FILE *out;            /* receives the answers */
    const char *path;     /* the name of the file as it was typed, or NULL for standard output */
    bool append;          /* text is appended to the file, because the command has '>>' */
    /* the format that the file extension selects, or NULL for the format of 'set output' */
    const struct format *format;
    /* returns true for a line of column names; NULL if the format has no such lines */
    bool (*is_header)(const char *line);
    char header[OUTPUT_HEADER]; /* the last line of column names, or "" */
    bool answered;              /* an answer was written, so the next one needs a blank line above it */

    /* Only for files: */
    char *target;       /* its path without symbolic links, except for a pipe such as /dev/stdout */
    struct stat status; /* zero if the file does not exist */
    bool is_regular;    /* `out` writes into `text`; otherwise it writes the target, such as a FIFO */
    char *text;
    size_t size;
    const volatile sig_atomic_t *interrupt;
};

/* Pushes a file onto the stack, which may be empty. If the file cannot be written, returns the reason.
 * Otherwise returns NULL. */
const char *output_push(struct output **top, const char *path, bool append,
                        const volatile sig_atomic_t *interrupt);

/* Removes a file from the stack. If `keep` is true, all text is written into the file; otherwise the file
 * stays as it was. Returns NULL, or an error message. */
const char *output_pop(struct output **top, bool keep);

/* Returns the folder of the file, which the caller frees, or NULL for a device, a FIFO or standard output. */
char *output_folder(const struct output *output);

/* Writes the buffered text of this output and of standard output. */
void output_flush(struct output *output);

/* ---- The log ---- */

/* Begins a log, which is appended to its file. If there is already a log, it ends. If the file cannot be
 * written, returns the reason. Otherwise returns NULL. */
const char *log_begin(const char *path, const volatile sig_atomic_t *interrupt);

/* Writes the buffered text of the log into its file. If the file cannot be written, ends the log and returns
 * the reason. Otherwise returns NULL. */
const char *log_flush(void);

/* Ends the log, if there is one. Returns NULL, or the reason why the file could not be written. */
const char *log_end(void);

/* Writes a command into the log, which must be open. */
void log_command(const char *text, size_t length);

/* Writes an error or a note into the log, if there is one, as a comment. */
void log_message(const char *text);
