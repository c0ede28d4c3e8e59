/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where output goes, as a stack of levels.  Standard output is at the bottom.  Above it 'log' and 'tee' copy
 * what is written, and on top, while a command runs, is the file after '>' or the pager.  Popping a file
 * either writes it as a whole or leaves the old one.
 */
#ifndef SHELL_OUTPUT_H
#define SHELL_OUTPUT_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

struct format;

enum { OUTPUT_HEAD = 1024 };

struct output {
    enum output_kind { OUTPUT_STANDARD, OUTPUT_LOG, OUTPUT_TEE, OUTPUT_FILE, OUTPUT_PAGER } kind;
    struct output *below;              /* NULL at the bottom */
    FILE *out;                         /* takes the answers */
    FILE *messages;                    /* takes errors and notes: stderr, or memory while a pager runs */
    const char *path;                  /* the name of the file as it was typed, or NULL */
    bool append;                       /* the file comes after '>>' */
    const struct format *format;       /* the format that the file name asks for, or NULL for 'set output' */
    bool (*is_head)(const char *line); /* returns true for a line of column names; NULL without such lines */
    /* Frees everything but the struct.  Returns NULL, or why what `keep` asks for cannot be written. */
    const char *(*pop)(struct output *output, bool keep);

    /* State of the text itself, at the level where it ends (see output_end). */
    char head[OUTPUT_HEAD]; /* the last line of column names, or "" */
    bool answered;          /* an answer was written, so the next one needs a blank line above it */
    int error;              /* errno of the first answer that could not be written, or 0 */
};

/* Pushes a level, whose other members are set. */
void output_push(struct output **top, struct output *output);

/* Ends and frees a level, usually the top one.  Returns what its pop function returns. */
const char *output_pop(struct output **top, bool keep);

/* Writes all buffered text of the level. */
void output_flush(struct output *output);

/* Returns the link to the highest level of this kind, or NULL. */
struct output **output_find(struct output **top, enum output_kind kind);

/* Returns the level where text ends that is written to this one: a file, or standard output. */
struct output *output_end(struct output *output);

/* Returns the highest level below all files and pagers: standard output, or the log or tee above it. */
struct output *output_base(struct output *output);

/* ---- The levels; an interrupt ends their waits (see io.h) ---- */

/* Pushes a file, even on an empty stack.  Returns NULL, or why the file cannot be written. */
const char *file_push(struct output **top, const char *path, bool append,
                      const volatile sig_atomic_t *interrupt);

/*
 * Pushes a pager for a text that may be longer than the terminal.  Returns false, and does nothing, unless
 * standard input and the level below are the terminal itself.  A text of more than this many screens goes
 * through $PAGER or less while it is written, or is shown a page at a time if no program may be run.  A
 * shorter text, or one that comes slowly, is shown as it is.  Writing fails after the reader has quit, and
 * after an interrupt.  Popping waits for the reader, then shows the messages.  Its result is not NULL if the
 * reader quit early.
 */
bool pager_push(struct output **top, double screens, bool may_run, const volatile sig_atomic_t *interrupt);

/* Begins a log, which is appended to its file, or a tee, which replaces its file.  An earlier log or tee
 * ends. Returns NULL, or why the file cannot be written. */
const char *record_push(struct output **top, enum output_kind kind, const char *path,
                        const volatile sig_atomic_t *interrupt);

/* Writes all buffered text of log and tee.  Returns NULL, or why one of them had to end. */
const char *records_flush(struct output **top);

/* Gives commands to the log, if there is one.  Unless `at_once`, they are written before the next answer or
 * message, when it is known whether they have failed. */
void log_commands(struct output **top, const char *commands, size_t length, bool at_once);

/* Writes an error or a note into the log, as a comment.  If the commands that the log still holds have
 * failed, they become a comment, too, so that the log can be run as a script. */
void log_message(struct output **top, const char *text, bool failed);

#endif
