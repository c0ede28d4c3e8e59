/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_ROW_TEXT_H
#define SHELL_ROW_TEXT_H

#include "commands/drawing/falling_row.h"

/* Letters that the marked dominoes are made of, where there is no braille. */
#define ROW_MARK_WEAKEST "*"
#define ROW_MARK_ENDS    "X"

/* Returns how captions name the marks of a picture in characters on this stream. */
const char *row_text_weakest(FILE *out);
const char *row_text_end(FILE *out);

/*
 * Draws a row in characters, in so many columns and at most so many lines, up to the place `right` in m; tilt
 * NULL: as it stands; head: the domino that was hit last, or 0. In braille, dominoes are outlines, and marked
 * ones are filled. False: out of memory.
 */
bool row_text(const struct falling_row *row, const double *tilt, size_t head, double right, int width,
              int height, FILE *out);

#endif
