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

/* The size of a picture in dots, unless it has another height; and the width of a text in it, in
 * characters. */
enum { PICTURE_WIDTH = 640, PICTURE_HEIGHT = 480, CAPTION_COLUMNS = 76 };

/* Returns true if the answer goes to a picture file, such as .png. */
bool picture_is_filed(const struct answer *a);

/* Returns true if a picture can be drawn to the destination of the answer. */
bool picture_ready(const struct answer *a, struct problem *problem);

/* Begins a picture of this height in the file of an answer; a .pdf file is `wide` cm wide. If the file is a
 * .gp script, the picture is only this script, which draws a .pdf file of the same name. For a film, `delay`
 * is the time between two frames in hundredths of a second, otherwise 0. */
bool picture_begin(struct picture *picture, const struct answer *answer, double height, double wide,
                   int delay, const volatile sig_atomic_t *interrupt, struct problem *problem);

/* Writes the first `length` bytes of a text as a gnuplot string. Every text in a script must go through this
 * function: gnuplot runs commands between backticks, but not in single quotes. Each '\n' begins a new line of
 * the picture. Other control characters and bytes that are not UTF-8 are escaped (see escape.h). */
void gnuplot_text_part(FILE *script, const char *text, size_t length);
void gnuplot_text(FILE *script, const char *text);

/* The unit of an axis or a ruler. */
struct axis_unit {
    const char *name;
    double size; /* in m */
};

/* Returns the unit for an axis or a ruler that shows lengths up to `longest` m. The unit is mm if `longest`
 * is below 0.2, cm if it is below 2, and otherwise m. So lengths in mm and cm need at most three digits
 * before the decimal point, and a ruler has no room for more. */
struct axis_unit measure_axis(double longest);

/* Ends a picture. Draws it if the script is complete (`whole`). Otherwise discards it and returns false. */
bool picture_end(struct picture *picture, bool whole, struct problem *problem);

#endif
