/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The destinations of output, as a stack of levels. Standard output is at the bottom. The levels above it are
 * those of 'log' and 'tee', which copy the text. While a command runs, the file after '>' or the pager is at
 * the top. When a file is popped, either its text is written completely, or the old file is not changed.
 */
#ifndef SHELL_OUTPUT_H
#define SHELL_OUTPUT_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

struct format;

enum { OUTPUT_HEAD = 1024 };

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
    bool (*is_head)(const char *line);
    /* Frees everything except the struct itself. If `keep` is true, first writes the text of a file to its
     * target. Returns NULL, or the reason why the text could not be written. */
    const char *(*pop)(struct output *output, bool keep);

    /* The members below describe the text. They are used only at the level that finally receives the text
     * (see OUTPUT_END). */
    char head[OUTPUT_HEAD]; /* the last line of column names, or "" */
    bool answered;          /* an answer was written, so the next one needs a blank line above it */
    int error;              /* errno of the first answer that could not be written, or 0 */
};

/* Pushes a level. The caller sets the members of the level except `below`. */
void output_push(struct output **top, struct output *output);

/* Ends and frees a level, which is usually the highest one. Returns the result of the level's pop
 * function. */
const char *output_pop(struct output **top, bool keep);

/* Writes all buffered text of the level. */
void output_flush(struct output *output);

/* OUTPUT_END: the kinds of level that finally receive text. OUTPUT_BASE: the kinds of level at the bottom of
 * the stack, below all files and pagers. */
enum { OUTPUT_END = OUTPUT_FILE | OUTPUT_STANDARD, OUTPUT_BASE = OUTPUT_STANDARD | OUTPUT_LOG | OUTPUT_TEE };

/* Returns the address of the pointer to the highest level whose kind is in `kinds`, or NULL if there is no
 * such level. */
struct output **output_find(struct output **top, unsigned kinds);

/* ---- The kinds of levels; an interrupt ends their waits (see io.h) ---- */

/* Pushes a file onto the stack, which may be empty.  Returns NULL, or the reason why the file cannot be
 * written. */
const char *file_push(struct output **top, const char *path, bool append,
                      const volatile sig_atomic_t *interrupt);

/*
 * Pushes a pager for a text that may be longer than the terminal. Returns false, and does nothing, unless
 * both standard input and the level below are the terminal itself. A text of at least `screens` screens is
 * piped through $PAGER, or through the program less, while it is written. If `may_run` is false, no program
 * is run, and the text is shown a page at a time. A shorter text, or one that arrives slowly, is shown
 * without a pager. Writing fails after the user has quit the pager, and after an interrupt. Popping the pager
 * waits until the user quits, and then shows the messages. The result of popping is not NULL if the user quit
 * before the end.
 */
bool pager_push(struct output **top, double screens, bool may_run, const volatile sig_atomic_t *interrupt);

/* Begins a log, which is appended to its file, or a tee, which replaces its file. Ends an earlier log or tee.
 * Returns NULL, or the reason why the file cannot be written. */
const char *record_push(struct output **top, enum output_kind kind, const char *path,
                        const volatile sig_atomic_t *interrupt);

/* Writes all buffered text of the log and the tee. If a file cannot be written, closes it and returns the
 * reason. Otherwise returns NULL. */
const char *records_flush(struct output **top);

/* Passes commands to the log, if there is one. Unless `at_once` is true, the log holds the commands until the
 * next answer or message shows whether they have failed. */
void log_commands(struct output **top, const char *commands, size_t length, bool at_once);

/* Writes an error or a note into the log, as a comment. If `failed` is true, the commands that the log holds
 * have failed. They also become comments, so that the log can be run as a script. */
void log_message(struct output **top, const char *text, bool failed);

#endif
