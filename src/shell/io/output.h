/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where answers go, as a stack of levels.  Standard output is at the bottom; above it 'log' and 'tee' copy
 * what is written; on top is the file after '>' or the pager, while its command runs.  Pushing begins a
 * level, and popping ends it: a file is then committed or taken back.
 */
#ifndef SHELL_IO_OUTPUT_H
#define SHELL_IO_OUTPUT_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

struct format;

enum { OUTPUT_HEAD = 1024 };

struct output {
    enum output_kind { OUTPUT_STANDARD, OUTPUT_LOG, OUTPUT_TEE, OUTPUT_FILE, OUTPUT_PAGER } kind;
    struct output *below; /* NULL at the bottom */
    FILE *out;            /* takes the answers */
    FILE *messages;       /* takes errors and notes: standard error, or memory until the pager has ended */
    const char *path;     /* the name of the file after '>' as it was typed; NULL where there is none */
    bool append;          /* the file comes after '>>' */
    const struct format *format;       /* named by the ending of the file; NULL: 'set output' chooses */
    bool (*is_head)(const char *line); /* whether a line of the file names columns; NULL: no line does */
    /* Ends the level, of which only the memory of *output is left, to be freed.  Returns why what was to be
     * kept cannot be written, or NULL. */
    const char *(*pop)(struct output *output, bool keep);

    /* What was written, on the levels where text ends: see output_end. */
    char head[OUTPUT_HEAD]; /* the last line that names columns; "" for none */
    bool answered;          /* there is an answer, below which a blank line follows */
    int error;              /* errno of the first answer that could not be written; 0 for none */
};

/* Makes the bottom of a stack. */
struct output output_standard(FILE *out);

/* Puts a level, whose members are set, on the stack. */
void output_push(struct output **top, struct output *output);

/* Ends the level on top, or any other that the pointer to it is given of, and frees it.  Returns as its pop.
 */
const char *output_pop(struct output **top, bool keep);

/* Writes what waits on its way down the stack, now. */
void output_flush(struct output *output);

/* Returns the pointer to the highest level of this kind, NULL if there is none. */
struct output **output_find(struct output **top, enum output_kind kind);

/* Returns the level in which text ends that is written to this one: a file, or standard output. */
struct output *output_end(struct output *output);

/* Returns the level that stands for standard output: with 'log' and 'tee', below all files. */
struct output *output_base(struct output *output);

/* ---- The levels: an interrupt ends their waits, see io.h ---- */

/* Begins a file, on a stack that may be empty.  Returns NULL, or why the file cannot be written: also where
 * its name cannot be shown as it is (escape.h). */
const char *file_push(struct output **top, const char *path, bool append,
                      const volatile sig_atomic_t *interrupt);

/*
 * Begins a text that may be longer than the terminal; returns false, and does nothing, if standard input and
 * the level below are not both the terminal.  The stream has the terminal's width and colours.  What is
 * longer than so many screens goes through $PAGER, or else less, if programs may be run, while it is written;
 * without these it is shown a page at a time.  A shorter text, or one that comes slowly, goes to the terminal
 * as it is.  Writing fails after the reader has left, and after an interrupt.  The end of the level waits
 * until the text is read, shows the messages, and leaves the terminal as it was; it returns NULL unless the
 * reader has left.
 */
bool pager_push(struct output **top, double screens, bool programs, const volatile sig_atomic_t *interrupt);

/* Begins a log, which is appended to, or a tee, which begins anew, in the place of an earlier one.  Returns
 * NULL, or why the file cannot be written. */
const char *record_push(struct output **top, enum output_kind kind, const char *path,
                        const volatile sig_atomic_t *interrupt);

/* Writes what waits on its way through log and tee.  Returns NULL, or why one of them has ended: its file
 * cannot be written. */
const char *records_flush(struct output **top);

/* Writes commands into the log, if there is one: at once, or else in log_decide or before the next answer. */
void log_commands(struct output **top, const char *commands, size_t length, bool at_once);

/* Writes the commands that wait: as a comment if they have failed, so that the log can be run as a script. */
void log_decide(struct output **top, bool failed);

/* Writes an error or a note into the log, as a comment. */
void log_message(struct output **top, const char *text);

#endif
