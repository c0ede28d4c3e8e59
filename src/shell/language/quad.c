/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/quad.h"
#include "language/decimal.h"
#include <stdio.h>
#include <stdlib.h>

#if defined DOMQ_REAL_FLOAT128
/* glibc has these whatever the compiler; its header shows them to gcc alone. */
extern int strfromf128(char *restrict text, size_t size, const char *restrict format, domq_real value);
extern domq_real strtof128(const char *restrict text, char **restrict end);
#endif

/* The same digits sooner, where the value is a double, or one decides. */
static bool quick_text(domq_real value, int digits, char text[WIDE_TEXT])
{
    enum { LONGEST = 17, SURE = 14 };
    double near = (double)value;
    if ((domq_real)near != value)
        return digits > 0 && digits <= SURE && decimal_near(near, digits, text);
    bool whole = near > -1e15 && near < 1e15 && near == (double)(long long)near;
    return digits > 0 && (digits <= LONGEST || whole) &&
           decimal_text(near, digits < LONGEST ? digits : LONGEST, text);
}

const char *quad_text(domq_real value, int digits, char text[WIDE_TEXT])
{
    if (quick_text(value, digits, text))
        return text;
#if defined DOMQ_REAL_FLOAT128
    char format[16];
    snprintf(format, sizeof format, "%%.%dg", digits < WIDE_DIGITS ? digits : WIDE_DIGITS);
    strfromf128(text, WIDE_TEXT, format, value);
#else
    snprintf(text, WIDE_TEXT, "%.*Lg", digits < WIDE_DIGITS ? digits : WIDE_DIGITS, value);
#endif
    return text;
}

struct quad_shown quad_shown(domq_real value)
{
    struct quad_shown shown = {""};
    quad_text(value, 10, shown.text);
    return shown;
}

domq_real quad_read(const char *text, char **end)
{
#if defined DOMQ_REAL_FLOAT128
    return strtof128(text, end);
#else
    return strtold(text, end);
#endif
}

const char *quad_exact(domq_real value, char text[WIDE_TEXT])
{
    int digits = 15;
    quad_text(value, digits, text);
    while (digits < WIDE_DIGITS && quad_read(text, NULL) != value)
        quad_text(value, ++digits, text);
    return text;
}
