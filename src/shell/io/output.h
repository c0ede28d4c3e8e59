/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The text that a command writes can have several destinations at the same time. They form a stack of levels.
 * Standard output is at the bottom. Above it may be a log, which copies the text into a file and passes it on
 * to the level below. While a command runs, the file after '>' or the pager may be at the top. When a file is
 * popped, all of its text is written, or the old file stays unchanged.
 */
#ifndef SHELL_OUTPUT_H
#define SHELL_OUTPUT_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

struct format;

enum { OUTPUT_HEADER = 1024 };

struct output {
    enum output_kind { OUTPUT_STANDARD = 1, OUTPUT_LOG = 2, OUTPUT_FILE = 4, OUTPUT_PAGER = 8 } kind;
    struct output *below; /* NULL at the bottom */
    FILE *out;            /* receives the answers */
    FILE *messages;       /* receives errors and notes: stderr, or memory while a pager runs */
    const char *path;     /* the name of the file as it was typed, or NULL */
    bool append;          /* text is appended to the file, because the command has '>>' */
    /* the format that the file extension selects, or NULL for the format of 'set output' */
    const struct format *format;
    /* returns true for a line of column names; NULL if the format has no such lines */
    bool (*is_header)(const char *line);
    /* Ends the level and frees everything except the struct itself. If the level is a file and `keep` is
     * true, the collected text is written into the file first. Returns NULL, or an error message. */
    const char *(*pop)(struct output *output, bool keep);

    /* The members below are used only at a level that does not pass its text on (see OUTPUT_SINKS). */
    char header[OUTPUT_HEADER]; /* the last line of column names, or "" */
    bool answered;              /* an answer was written, so the next one needs a blank line above it */
    int error;                  /* errno of the first answer that could not be written, or 0 */
};

/* Pushes a level. The caller sets the members of the level except `below`. If `messages` is NULL, it becomes
 * that of the level below, or stderr at the bottom. */
void output_push(struct output **top, struct output *output);

/* Ends and frees a level, usually the topmost one. Returns the result of the level's pop function. */
const char *output_pop(struct output **top, bool keep);

/* Writes the buffered text of this level and of standard output. */
void output_flush(struct output *output);

/* Tells that an answer is complete (see io_row). */
void output_answered(struct output *output);

/* OUTPUT_SINKS is the set of the kinds of levels that do not pass text on to the level below. OUTPUT_BASE is
 * the set of the kinds that are always below files and pagers. */
enum { OUTPUT_SINKS = OUTPUT_FILE | OUTPUT_STANDARD, OUTPUT_BASE = OUTPUT_STANDARD | OUTPUT_LOG };

/* Finds the topmost level whose kind is in `kinds`. Returns the address of the pointer to this level, so that
 * the level can be popped. Returns NULL if there is no such level. */
struct output **output_find(struct output **top, unsigned kinds);

/* ---- The kinds of levels; an interrupt ends their waits (see io.h) ---- */

/* Pushes a file onto the stack, which may be empty. If the file cannot be written, returns the reason.
 * Otherwise returns NULL. */
const char *file_push(struct output **top, const char *path, bool append,
                      const volatile sig_atomic_t *interrupt);

/* Pushes a pager (see pager.c) for text that may be longer than the terminal. `has_head` is true if the first
 * line of the text is the head of a table. If standard input or the level below is not the terminal, pushes
 * nothing and returns false. If the user quits before the end or interrupts the command, further writing
 * fails, and output_pop returns an error message. */
bool pager_push(struct output **top, bool has_head);

/* Begins a log, which is appended to its file. If `is_plain` is true, the file gets the answers alone. If
 * there is already a log, it ends. If the file cannot be written, returns the reason. Otherwise returns
 * NULL. */
const char *log_push(struct output **top, const char *path, bool is_plain,
                     const volatile sig_atomic_t *interrupt);

/* Writes the buffered text of the log into its file. If the file cannot be written, ends the log and returns
 * the reason. Otherwise returns NULL. */
const char *log_flush(struct output **top);

/* Writes commands into the log, if there is one. A command that fails must become a comment in the log, so
 * the log holds the commands back until the next answer, the next error or the next call of log_flush. If
 * `at_once` is true, the commands are written immediately. `commands` must stay valid while the log holds
 * them back. */
void log_commands(struct output **top, const char *commands, size_t length, bool at_once);

/* Writes an error or a note into the log, as a comment. If `failed` is true, the commands that the log has
 * held back have failed. They also become comments, so that the log can be run as a script. */
void log_message(struct output **top, const char *text, bool failed);

#endif
