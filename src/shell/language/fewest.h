/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A double in the fewest digits from which a program reads the same double. */
#ifndef SHELL_FEWEST_H
#define SHELL_FEWEST_H

enum { FEWEST_DIGITS = 15, FEWEST_TEXT = 32 };

/* Writes the first of printf's "%.15g", "%.16g" and "%.17g" that reads back to the value, which is finite. */
const char *fewest_text(double value, char text[FEWEST_TEXT]);

#endif
