/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/quad.h"
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>

#if defined DOMQ_REAL_FLOAT128
/* glibc has these whatever the compiler; its header shows them to gcc alone. */
extern int strfromf128(char *restrict text, size_t size, const char *restrict format, domq_real value);
extern domq_real strtof128(const char *restrict text, char **restrict end);
extern int strfromd(char *restrict text, size_t size, const char *restrict format, double value);

/* Writes "%.17g" for 17. */
static const char *format_write(int digits, char format[8])
{
    char *to = format;
    *to++ = '%';
    *to++ = '.';
    if (digits > 9)
        *to++ = (char)('0' + digits / 10);
    *to++ = (char)('0' + digits % 10);
    *to++ = 'g';
    *to = '\0';
    return format;
}
#endif

/* Writes a whole number of so few digits, as many are; returns false for any other number. */
static bool whole_text(double value, int digits, char text[WIDE_TEXT])
{
    const double most = 1e15;
    char last[16];
    int n = 0;
    if (!(value >= 0 && value < most) || signbit(value) || value != (double)(long)value)
        return false;
    long rest = (long)value;
    do
        last[n++] = (char)('0' + rest % 10);
    while ((rest /= 10) > 0);
    for (int i = 0; i < n && n <= digits; i++)
        text[i] = last[n - 1 - i];
    text[n] = '\0';
    return n <= digits;
}

/*
 * Reads a decimal number without an exponent of so few digits that they are exact, and the power of ten that
 * divides them, too: their quotient is the nearest number, as strtod gives it (W. D. Clinger, 1990).  Returns
 * NULL for any other text, else where it ends.
 */
static const char *short_read(const char *text, domq_real *value)
{
    enum { DIGITS = 15 };
    long number = 0, power = 1;
    const char *c = text;
    while (isdigit((unsigned char)*c) && c - text < DIGITS)
        number = 10 * number + (*c++ - '0');
    if (c > text && *c == '.')
        for (c++; isdigit((unsigned char)*c) && c - text <= DIGITS; power *= 10)
            number = 10 * number + (*c++ - '0');
    if (c == text || isalnum((unsigned char)*c) || *c == '.')
        return NULL;
    *value = power > 1 ? (domq_real)number / (domq_real)power : (domq_real)number;
    return c;
}

const char *quad_text(domq_real value, int digits, char text[WIDE_TEXT])
{
    digits = digits < WIDE_DIGITS ? digits : WIDE_DIGITS;
    if ((domq_real)(double)value == value && whole_text((double)value, digits, text))
        return text;
#if defined DOMQ_REAL_FLOAT128
    char format[8];
    format_write(digits > 0 ? digits : 1, format);
    if ((domq_real)(double)value != value)
        strfromf128(text, WIDE_TEXT, format, value);
    else /* the same digits, sooner */
        strfromd(text, WIDE_TEXT, format, (double)value);
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
    domq_real value;
    const char *stop = short_read(text, &value);
    if (stop && end)
        *end = (char *)stop;
    if (stop)
        return value;
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
