/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_ROW_TEXT_H
#define SHELL_ROW_TEXT_H

#include "commands/falling_row.h"

/* What the marked dominoes are made of. */
#define ROW_MARK_WEAKEST '*'
#define ROW_MARK_ENDS    'X'

/*
 * Draws a row in characters, in so many columns and at most so many lines, up to the place `right` in m; tilt
 * NULL: as it stands. False: out of memory.
 */
bool row_text(const struct falling_row *row, const double *tilt, double right, int width, int height,
              FILE *out);

#endif
