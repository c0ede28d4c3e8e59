/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* strfromd */
#include "language/quad.h"
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined DOMQ_REAL_FLOAT128
extern int strfromf128(char *restrict text, size_t size, const char *restrict format, domq_real value);
extern domq_real strtof128(const char *restrict text, char **restrict end);
#endif

/* Writes a non-negative whole number and returns the number of its digits. */
static int whole_text(long long number, char *text)
{
    char digits[WIDE_TEXT], *first = digits + sizeof digits - 1;
    *first = '\0';
    do
        *--first = (char)('0' + number % 10);
    while ((number /= 10) > 0);
    int count = (int)(digits + sizeof digits - 1 - first);
    memcpy(text, first, (size_t)count + 1);
    return count;
}

const char *quad_write(domq_real value, int digits, char text[WIDE_TEXT])
{
    const double near = (double)value;
    digits = digits < WIDE_DIGITS ? digits : WIDE_DIGITS;
    /* Whole numbers are common, so they have faster code. */
    if (near >= 1 && near < 1e15 && (domq_real)(long long)near == value &&
        whole_text((long long)near, text) <= digits)
        return text;
#if defined DOMQ_REAL_FLOAT128
    const char format[] = {'%', '.', (char)('0' + digits / 10), (char)('0' + digits % 10), 'g', '\0'};
    if ((domq_real)near == value)
        strfromd(text, WIDE_TEXT, format, near);
    else
        strfromf128(text, WIDE_TEXT, format, value);
#else
    snprintf(text, WIDE_TEXT, "%.*Lg", digits, value);
#endif
    return text;
}

const char *quad_growth_write(domq_real growth, int digits, char text[WIDE_TEXT])
{
    while (strcmp(quad_write(growth, digits, text), "1") == 0 && growth != 1)
        digits++;
    return text;
}

const char *quad_limit_write(domq_real limit, int digits, char text[WIDE_TEXT])
{
    quad_write(limit, digits, text);
    if (limit > 0 && quad_read(text, NULL) > limit * (1 + (domq_real)1e-13)) {
        char half[24]; /* half a unit of the last digit; powers in quad would take most of the time of a sweep
                        */
        snprintf(half, sizeof half, "5e%d", (int)floor(log10((double)limit)) - digits);
        quad_write(limit - quad_read(half, NULL), digits, text);
    }
    return text;
}

domq_real quad_read(const char *text, char **end)
{
    const char *stop = text;
    long long whole = 0;
    while (isdigit((unsigned char)*stop) && stop - text < 16)
        whole = 10 * whole + (*stop++ - '0');
    if (stop > text && stop - text < 16 && (*stop == '\0' || !strchr(".eEpPxX", *stop))) {
        if (end)
            *end = (char *)stop;
        return (domq_real)whole;
    }
#if defined DOMQ_REAL_FLOAT128
    return strtof128(text, end);
#else
    return strtold(text, end);
#endif
}

const char *quad_exact(domq_real value, int most, char text[WIDE_TEXT])
{
    int digits = most < 15 ? most : 15;
    while (quad_read(quad_write(value, digits, text), NULL) != value && digits < most)
        digits++;
    return text;
}

domq_real quad_decimal(double value)
{
    char text[WIDE_TEXT];
    return isfinite(value) ? quad_read(quad_write((domq_real)value, 15, text), NULL) : (domq_real)value;
}
