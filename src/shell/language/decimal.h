/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Doubles as printf's "%.*g" writes them, digit for digit, several times as fast: for rows by the ten
 * thousand.  Exact in integers of 128 bits; each function returns false, having written nothing, where those
 * do not do (beyond 1.5e-11 .. 1e15, NaN, a compiler without them), and printf has to.
 */
#ifndef SHELL_DECIMAL_H
#define SHELL_DECIMAL_H

#include <stdbool.h>

enum { DECIMAL_TEXT = 32 };

/* "%.*g" with 1 .. 17 digits. */
bool decimal_text(double value, int digits, char text[DECIMAL_TEXT]);

/* The same of a wider number, of which value is the nearest double; false also where that is too little. */
bool decimal_near(double value, int digits, char text[DECIMAL_TEXT]);

/*
 * Of the forms with least, least + 1 and least + 2 digits the first that reads back to the same number; the
 * last of them surely does.  bits = 53 and least = 15 for doubles, 24 and 7 for floats.
 */
bool decimal_shortest(double value, int least, int bits, char text[DECIMAL_TEXT]);

#endif
