/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/quad.h"
#include <stdio.h>
#include <stdlib.h>

#if defined DOMQ_REAL_FLOAT128
/* glibc has these whatever the compiler; its header shows them to gcc alone. */
extern int strfromf128(char *restrict text, size_t size, const char *restrict format, domq_real value);
extern domq_real strtof128(const char *restrict text, char **restrict end);
#endif

const char *quad_text(domq_real value, int digits, char text[WIDE_TEXT])
{
    digits = digits < WIDE_DIGITS ? digits : WIDE_DIGITS;
#if defined DOMQ_REAL_FLOAT128
    if ((domq_real)(double)value != value) {
        char format[16];
        snprintf(format, sizeof format, "%%.%dg", digits);
        strfromf128(text, WIDE_TEXT, format, value);
    } else /* the same digits, sooner */
        snprintf(text, WIDE_TEXT, "%.*g", digits, (double)value);
#else
    snprintf(text, WIDE_TEXT, "%.*Lg", digits, value);
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
