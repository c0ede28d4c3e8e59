/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers as people type them and as they are shown, in the widest arithmetic; sqrt() and its kind too. */
#ifndef SHELL_WIDE_H
#define SHELL_WIDE_H

#define REAL_QUAD
#include "numerics/real.h"

enum { WIDE_DIGITS = 36, WIDE_TEXT = 48 }; /* digits that read back to the same number; room for any */

/* printf's "%.*g". */
const char *wide_text(dom_real value, int digits, char text[WIDE_TEXT]);

/* The same with 10 digits for messages: wide_shown(x).text. */
struct wide_shown {
    char text[WIDE_TEXT];
};
struct wide_shown wide_shown(dom_real value);

/* The fewest digits that read back to the same number. */
const char *wide_exact(dom_real value, char text[WIDE_TEXT]);

/* strtod: out of range is errno = ERANGE. */
dom_real wide_read(const char *text, char **end);

#endif
