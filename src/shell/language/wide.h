/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Numbers as people type them and as they are shown, in the widest arithmetic; and the functions of <math.h>
 * in it: wide(sqrt)(x) is the square root of a dom_real, as sqrt(x) is that of a double.
 */
#ifndef SHELL_WIDE_H
#define SHELL_WIDE_H

#include "domino.h"
#include <math.h>

#if defined DOM_REAL_FLOAT128
#define wide(function) function##f128
/* glibc has these whatever the compiler; its header declares them for gcc alone. */
extern dom_real wide(sqrt)(dom_real), wide(fabs)(dom_real), wide(sin)(dom_real), wide(cos)(dom_real),
    wide(tan)(dom_real), wide(asin)(dom_real), wide(acos)(dom_real), wide(atan)(dom_real),
    wide(exp)(dom_real), wide(log)(dom_real), wide(log10)(dom_real), wide(floor)(dom_real),
    wide(ceil)(dom_real), wide(round)(dom_real);
extern dom_real wide(atan2)(dom_real, dom_real), wide(hypot)(dom_real, dom_real),
    wide(pow)(dom_real, dom_real), wide(fmin)(dom_real, dom_real), wide(fmax)(dom_real, dom_real);
#else
#define wide(function) function##l
#endif

/* pi, as a sum of doubles: right to 49 digits. */
#define WIDE_PI                                                                                              \
    ((dom_real)3.141592653589793116 + (dom_real)1.2246467991473532072e-16 -                                  \
     (dom_real)2.9947698097183396659e-33)

static inline dom_real wide_larger(dom_real a, dom_real b)
{
    return a > b ? a : b;
}

static inline dom_real wide_smaller(dom_real a, dom_real b)
{
    return a < b ? a : b;
}

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
