/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The destinations of output are a stack of levels. Standard output is at the bottom. Above it are 'log' and
 * 'tee', which copy the text. While a command runs, the file after '>' or the pager is at the top. Popping a
 * file writes all of its text, or leaves the old file unchanged.
 */
#ifndef SHELL_OUTPUT_H
#define SHELL_OUTPUT_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

struct format;

enum { OUTPUT_HEADER = 1024 };

struct output {
    enum output_kind {
        OUTPUT_STANDARD = 1,
        OUTPUT_LOG = 2,
        OUTPUT_TEE = 4,
        OUTPUT_FILE = 8,
        OUTPUT_PAGER = 16
    } kind;
    struct output *below; /* NULL at the bottom */
    FILE *out;            /* receives the answers */
    FILE *messages;       /* receives errors and notes: stderr, or memory while a pager runs */
    const char *path;     /* the name of the file as it was typed, or NULL */
    bool append;          /* text is appended to the file, because the command has '>>' */
    /* the format that the file extension selects, or NULL for the format of 'set output' */
    const struct format *format;
    /* returns true for a line of column names; NULL if the format has no such lines */
    bool (*is_header)(const char *line);
    /* Frees everything except the struct itself. For a file, first writes the collected text if `keep` is
     * true. Returns NULL or an error message. */
    const char *(*pop)(struct output *output, bool keep);

    /* The members below are only used at the level that does not pass the text on (see OUTPUT_SINKS). */
    char header[OUTPUT_HEADER]; /* the last line of column names, or "" */
    bool answered;              /* an answer was written, so the next one needs a blank line above it */
    int error;                  /* errno of the first answer that could not be written, or 0 */
};

/* Pushes a level. The caller sets the members of the level except `below`. */
void output_push(struct output **top, struct output *output);

/* Ends and frees a level, usually the topmost one. Returns the result of the level's pop function. */
const char *output_pop(struct output **top, bool keep);

/* Writes all buffered text of the level. */
void output_flush(struct output *output);

/* OUTPUT_SINKS: the kinds that do not pass their text on to the level below. OUTPUT_BASE: the kinds that are
 * always below files and pagers. */
enum {
    OUTPUT_SINKS = OUTPUT_FILE | OUTPUT_STANDARD,
    OUTPUT_BASE = OUTPUT_STANDARD | OUTPUT_LOG | OUTPUT_TEE
};

/* Returns the address of the pointer to the topmost level that has one of these kinds. Returns NULL if there
 * is none. */
struct output **output_find(struct output **top, unsigned kinds);

/* ---- The kinds of levels; an interrupt ends their waits (see io.h) ---- */

/* Pushes a file onto the stack, which may be empty. Returns NULL, or why the file cannot be written. */
const char *file_push(struct output **top, const char *path, bool append,
                      const volatile sig_atomic_t *interrupt);

/*
 * Pushes a pager for text that may be longer than the terminal. Returns false if standard input or the level
 * below is not the terminal.
 * - Text of at least `screens` screens goes through the pager, unless it arrives slowly.
 * - The pager is $PAGER or 'less'. If `may_run` is false, pages are shown without a program.
 * - After an interrupt, or when the user has quit early, writing fails. Popping then does not return NULL.
 */
bool pager_push(struct output **top, double screens, bool may_run, const volatile sig_atomic_t *interrupt);

/* Begins a log, which appends to its file, or a tee, which replaces its file. Ends an earlier log or tee.
 * Returns NULL, or why the file cannot be written. */
const char *record_push(struct output **top, enum output_kind kind, const char *path,
                        const volatile sig_atomic_t *interrupt);

/* Writes all buffered text of the log and the tee. Closes a file that cannot be written, and returns the
 * reason. Otherwise returns NULL. */
const char *records_flush(struct output **top);

/* Writes commands into the log, if there is one. Unless `at_once` is true, the log holds the commands back
 * until the next answer or error, because failed commands become comments. */
void log_commands(struct output **top, const char *commands, size_t length, bool at_once);

/* Writes an error or a note into the log, as a comment. If `failed` is true, the commands that the log holds
 * back also become comments, so that the log can be run. */
void log_message(struct output **top, const char *text, bool failed);

#endif
