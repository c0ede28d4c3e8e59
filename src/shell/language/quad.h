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
#define quad(function) function##f128
/* glibc has these whatever the compiler; its header declares them for gcc alone. */
extern dom_real quad(sqrt)(dom_real), quad(fabs)(dom_real), quad(sin)(dom_real), quad(cos)(dom_real),
    quad(tan)(dom_real), quad(asin)(dom_real), quad(acos)(dom_real), quad(atan)(dom_real),
    quad(exp)(dom_real), quad(log)(dom_real), quad(log10)(dom_real), quad(floor)(dom_real),
    quad(ceil)(dom_real), quad(round)(dom_real);
extern dom_real quad(atan2)(dom_real, dom_real), quad(hypot)(dom_real, dom_real),
    quad(pow)(dom_real, dom_real), quad(fmin)(dom_real, dom_real), quad(fmax)(dom_real, dom_real);
#else
#define quad(function) function##l
#endif

/* pi, as a sum of doubles: right to 49 digits. */
#define QUAD_PI                                                                                              \
    ((dom_real)3.141592653589793116 + (dom_real)1.2246467991473532072e-16 -                                  \
     (dom_real)2.9947698097183396659e-33)

static inline dom_real quad_larger(dom_real a, dom_real b)
{
    return a > b ? a : b;
}

static inline dom_real quad_smaller(dom_real a, dom_real b)
{
    return a < b ? a : b;
}

enum { WIDE_DIGITS = 36, WIDE_TEXT = 48 }; /* digits that read back to the same number; room for any */

/* printf's "%.*g". */
const char *quad_text(dom_real value, int digits, char text[WIDE_TEXT]);

/* The same with 10 digits for messages: quad_shown(x).text. */
struct quad_shown {
    char text[WIDE_TEXT];
};
struct quad_shown quad_shown(dom_real value);

/* The fewest digits that read back to the same number. */
const char *quad_exact(dom_real value, char text[WIDE_TEXT]);

/* strtod: out of range is errno = ERANGE. */
dom_real quad_read(const char *text, char **end);

#endif
