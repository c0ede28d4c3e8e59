/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Only the 17 digits that always read back are asked of the C library, since they take most of the time of a
 * row of csv. Fewer digits are rounded from these, except where they end in exactly half of the last digit:
 * there they do not say on which side the value is.
 */
#include "language/fewest.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ALL = 17, LEAST_POWER = -4 /* of "%g" without an exponent */ };

/* A number 0.ddd times ten to its power; digits are characters. */
struct decimal {
    bool negative;
    char digit[ALL];
    int power;
};

static struct decimal decimal_make(double value)
{
    char text[FEWEST_TEXT];
    struct decimal d = {.negative = false};
#if defined __GLIBC__
    strfromd(text, sizeof text, "%.16e", value);
#else
    snprintf(text, sizeof text, "%.16e", value);
#endif
    d.negative = *text == '-';
    const char *from = text + d.negative;
    d.digit[0] = from[0];
    memcpy(d.digit + 1, from + 2, ALL - 1);
    d.power = (int)strtol(from + 2 + ALL, NULL, 10) + 1;
    return d;
}

/*
 * Returns true if the number with n of its digits is so far from the value that it is another double: by more
 * than half of the distance between doubles, 2^-53 of the value, and half of the last of all digits.
 */
static bool decimal_leaves(const struct decimal *d, int n)
{
    int whole = 1, tail = 0, lead = 100 * (d->digit[0] - '0') + 10 * (d->digit[1] - '0') + d->digit[2] - '0';
    for (int i = n; i < ALL; i++, whole *= 10)
        tail = 10 * tail + d->digit[i] - '0';
    int distance = tail < whole - tail ? tail : whole - tail; /* in the last of all digits */
    return distance > 0.0112 * (lead + 1) + 0.5;
}

/* Keeps n digits. Returns false if the others are exactly half of the last one. */
static bool decimal_round(struct decimal *d, int n)
{
    bool more = false;
    for (int i = n + 1; i < ALL; i++)
        more = more || d->digit[i] != '0';
    bool half = n < ALL && d->digit[n] == '5' && !more, up = n < ALL && d->digit[n] >= '5';
    int last = n - 1;
    memset(d->digit + n, '0', (size_t)(ALL - n));
    for (; up && last >= 0 && d->digit[last] == '9'; last--)
        d->digit[last] = '0';
    if (up && last >= 0) {
        d->digit[last] = (char)(d->digit[last] + 1);
    } else if (up) { /* 999 is 1000 */
        d->digit[0] = '1';
        d->power++;
    }
    return !half;
}

/* Writes the number as "%.*g" with n digits does. */
static void decimal_write(const struct decimal *d, int n, char text[FEWEST_TEXT])
{
    char *to = text;
    int used = ALL;
    while (used > 1 && d->digit[used - 1] == '0')
        used--;
    if (d->negative)
        *to++ = '-';
    bool exponent = d->power - 1 < LEAST_POWER || d->power > n;
    int whole = exponent ? 1 : d->power; /* digits before the point */
    for (int i = 0; i < whole; i++)
        *to++ = d->digit[i];
    if (whole <= 0)
        *to++ = '0';
    if (used > whole)
        *to++ = '.';
    for (int i = whole; i < 0; i++)
        *to++ = '0';
    for (int i = whole > 0 ? whole : 0; i < used; i++)
        *to++ = d->digit[i];
    if (exponent)
        snprintf(to, (size_t)(text + FEWEST_TEXT - to), "e%+03d", d->power - 1);
    else
        *to = '\0';
}

const char *fewest_text(double value, char text[FEWEST_TEXT])
{
    const struct decimal all = decimal_make(value);
    bool normal = fabs(value) >= DBL_MIN; /* below it the distance between doubles is larger */
    for (int n = FEWEST_DIGITS; n <= ALL; n++) {
        if (n < ALL && normal && decimal_leaves(&all, n))
            continue;
        struct decimal d = all;
        if (decimal_round(&d, n))
            decimal_write(&d, n, text);
        else
            snprintf(text, FEWEST_TEXT, "%.*g", n, value);
        if (n == ALL || strtod(text, NULL) == value)
            break;
    }
    return text;
}
