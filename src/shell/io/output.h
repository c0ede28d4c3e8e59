/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where the answers go: to standard output or, while a command with '>' runs, into its file. Such commands
 * can be nested, so the outputs form a stack with standard output at the bottom.
 */
#pragma once

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
};

/* Pushes a file onto the stack, which may be empty. If the file cannot be written, returns the reason.
 * Otherwise returns NULL. */
const char *output_push(struct output **top, const char *path, bool append);

/* Removes a file from the stack. If `keep` is true, all text is written into the file; otherwise the file
 * stays as it was. Returns NULL, or an error message. */
const char *output_pop(struct output **top, bool keep);

/* Returns the folder of the file, which the caller frees, or NULL for a device, a FIFO or standard output. */
char *output_folder(const struct output *output);

/* Writes the buffered text of this output and of standard output. */
void output_flush(struct output *output);

/* ---- For a log of the session ---- */

/* The path of the log without symbolic links, or NULL. No output can be pushed that writes to this file. */
extern char *output_reserved;

/* Stores the path of a file without symbolic links in *target, which the caller frees, and the status of the
 * file in *status. If there is no such file yet, *status is zero. Returns NULL, or the reason why the file
 * cannot be written. */
const char *output_target(const char *path, char **target, struct stat *status);

/* Returns true if this file is standard output. */
bool output_is_standard(const struct stat *status);

extern const char output_in_use[]; /* the reason that a file is one of those that the session writes */
