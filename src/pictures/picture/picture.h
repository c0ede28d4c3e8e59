/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs gnuplot, and other programs that make pictures, films or documents. A function that fails sets
 * *problem and returns false or NULL. */
#ifndef SHELL_PICTURE_H
#define SHELL_PICTURE_H

#include "session/problem.h"
#include <signal.h>
#include <stdio.h>

struct picture {
    FILE *script; /* commands for gnuplot; picture_begin has already written the terminal setting */
    FILE *out;    /* receives the picture */
    const volatile sig_atomic_t *interrupt;
};

bool gnuplot_ready(struct problem *problem);

/* Begins a picture for `out`, with a gnuplot terminal setting. */
bool picture_begin(struct picture *picture, FILE *out, const char *terminal,
                   const volatile sig_atomic_t *interrupt, struct problem *problem);

/* Writes the first `length` bytes of a text as a gnuplot string. Every text in a script must go through this
 * function: gnuplot runs commands between backticks, but not in single quotes. Each '\n' begins a new line of
 * the picture. Other control characters and bytes that are not UTF-8 are escaped (see escape.h). */
void gnuplot_text_part(FILE *script, const char *text, size_t length);
void gnuplot_text(FILE *script, const char *text);

/* Writes the command that makes gnuplot draw into a file in its working directory. A plain name could be a
 * command: gnuplot runs a name that begins with '|'. */
void gnuplot_output(FILE *script, const char *name);

/* Ends a picture. Draws it if the script is complete (`whole`). Otherwise discards it and returns false. */
bool picture_end(struct picture *picture, bool whole, struct problem *problem);

/* Returns true if a program with this name is in one of the directories in PATH. */
bool program_exists(const char *name);

/* Opens a temporary file, which is deleted when it is closed. */
FILE *temporary_open(struct problem *problem);

/* Runs a program that reads `in` from its beginning and writes to `out`. If the program fails, the message is
 * "PROGRAM did not WHAT: REASON", where WHAT is the string `what`. */
bool program_run(char *const argv[], FILE *in, FILE *out, const char *what,
                 const volatile sig_atomic_t *interrupt, struct problem *problem);

#endif
