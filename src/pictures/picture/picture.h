/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes pictures by gnuplot. A function that fails sets *problem and returns false. */
#ifndef SHELL_PICTURE_H
#define SHELL_PICTURE_H

#include "answer/answer.h"
#include "session/problem.h"
#include <signal.h>

struct picture {
    FILE *script; /* commands for gnuplot; picture_begin has already written the terminal setting */
    const struct answer *answer; /* receives the picture */
    const volatile sig_atomic_t *interrupt;
};

/* Returns true if a picture can be drawn to the destination of the answer. */
bool picture_ready(const struct answer *a, struct problem *problem);

/* Returns true if gnuplot is installed. */
bool gnuplot_ready(struct problem *problem);

enum { TERMINAL_TEXT = 256 };

/* Begins a picture in the file of an answer, with a gnuplot terminal setting. If the file is a .gp script,
 * the picture is only this script, which draws a .pdf file of the same name. */
bool picture_begin(struct picture *picture, const struct answer *answer, const char *terminal,
                   const volatile sig_atomic_t *interrupt, struct problem *problem);

/* Writes the first `length` bytes of a text as a gnuplot string. Every text in a script must go through this
 * function: gnuplot runs commands between backticks, but not in single quotes. Each '\n' begins a new line of
 * the picture. Other control characters and bytes that are not UTF-8 are escaped (see escape.h). */
void gnuplot_text_part(FILE *script, const char *text, size_t length);
void gnuplot_text(FILE *script, const char *text);

/* Ends a picture. Draws it if the script is complete (`whole`). Otherwise discards it and returns false. */
bool picture_end(struct picture *picture, bool whole, struct problem *problem);

#endif
