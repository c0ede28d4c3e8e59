/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions for domq_real, the quad-precision type. quad(sqrt)(x) is the square root of a domq_real. */
#pragma once

#include "domino_quad.h"
#include <math.h>

#if defined DOMQ_REAL_FLOAT128
#define quad(function) function##f128
/* glibc defines these functions for every compiler, but its header declares them only for gcc. The same holds
 * for strfromf128 and strtof128 in quad.c. */
extern domq_real quad(sqrt)(domq_real), quad(fabs)(domq_real), quad(sin)(domq_real), quad(cos)(domq_real),
    quad(tan)(domq_real), quad(asin)(domq_real), quad(acos)(domq_real), quad(atan)(domq_real),
    quad(exp)(domq_real), quad(log)(domq_real), quad(log10)(domq_real), quad(floor)(domq_real),
    quad(ceil)(domq_real), quad(round)(domq_real);
extern domq_real quad(atan2)(domq_real, domq_real), quad(hypot)(domq_real, domq_real),
    quad(pow)(domq_real, domq_real), quad(fmin)(domq_real, domq_real), quad(fmax)(domq_real, domq_real);
#else
#define quad(function) function##l
#endif

/* pi to 49 digits, as a sum of doubles */
#define QUAD_PI                                                                                              \
    ((domq_real)3.141592653589793116 + (domq_real)1.2246467991473532072e-16 -                                \
     (domq_real)2.9947698097183396659e-33)

static inline domq_real quad_larger(domq_real a, domq_real b)
{
    return a > b ? a : b;
}

static inline domq_real quad_smaller(domq_real a, domq_real b)
{
    return a < b ? a : b;
}

/* A number that is written with WIDE_DIGITS digits can be read back without any change. A buffer of WIDE_TEXT
 * bytes is large enough for any number. */
enum { WIDE_DIGITS = 36, WIDE_TEXT = 48 };

/* Writes a number as the format "%.*g" does, and returns `text`. Messages use 10 digits. quad_text needs no
 * buffer: its result lives until the end of the block that contains the call. */
const char *quad_write(domq_real value, int digits, char text[WIDE_TEXT]);
#define quad_text(value, digits) quad_write(value, digits, (char[WIDE_TEXT]){""})

/* Writes the growth of a train as quad_write does. If the growth is not 1 but would be rounded to 1, writes
 * more digits. */
const char *quad_growth_write(domq_real growth, int digits, char text[WIDE_TEXT]);
#define quad_growth(growth, digits) quad_growth_write(growth, digits, (char[WIDE_TEXT]){""})

/* Writes a positive number as quad_write does, but rounds it down, for limits that people build by. A number
 * that is less than 1e-13 of its size below a decimal, as 1/s may be, counts as this decimal. */
const char *quad_limit_write(domq_real limit, int digits, char text[WIDE_TEXT]);
#define quad_limit(limit, digits) quad_limit_write(limit, digits, (char[WIDE_TEXT]){""})

/* Writes a number with as many digits as an exact round trip needs: at least 15 and at most `most`. Omits
 * trailing zeros. Returns `text`. */
const char *quad_exact(domq_real value, int most, char text[WIDE_TEXT]);

/* Converts a result that was computed in double to quad. The result has the same 15 digits, so that 0.024
 * does not become 0.0240000000000000005. */
domq_real quad_decimal(double value);

/* Reads a number as strtod does. Sets errno to ERANGE if the number is out of range. */
domq_real quad_read(const char *text, char **end);
