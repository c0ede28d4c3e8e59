/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/decimal.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined __SIZEOF_INT128__

__extension__ typedef unsigned __int128 quad_unsigned;
__extension__ typedef __int128 quad_signed;

enum { DIGITS = 17 };

/* clang-format off */
static const uint64_t ten_to[DIGITS + 1] = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000, 10000000000, 100000000000,
    1000000000000, 10000000000000, 100000000000000, 1000000000000000, 10000000000000000, 100000000000000000};
/* clang-format on */

/* A value in (0, inf) as whole + rest / 2^shift, of 17 digits before the point, times 10^(exponent - 16). */
struct decimal {
    uint64_t significand, whole;
    quad_unsigned rest;
    uint64_t five; /* 5^(16 - exponent): the step from one double to the next, over 2^-shift */
    int shift, exponent;
};

/* 5^k for k < 28, which fits. */
static uint64_t five_to(int k)
{
    static const uint64_t low[8] = {1, 5, 25, 125, 625, 3125, 15625, 78125};
    uint64_t power = low[k & 7];
    for (int eights = k >> 3; eights > 0; eights--)
        power *= 390625; /* 5^8 */
    return power;
}

static void decimal_at(struct decimal *d, int binary, int exponent)
{
    int k = DIGITS - 1 - exponent;
    d->exponent = exponent;
    d->five = five_to(k);
    d->shift = -(binary + k);
    quad_unsigned product = (quad_unsigned)d->significand * d->five;
    d->whole = (uint64_t)(product >> d->shift);
    d->rest = product & (((quad_unsigned)1 << d->shift) - 1);
}

/* Exact; false outside the range where it is. */
static bool decimal_of(double value, struct decimal *d)
{
    uint64_t bits;
    if (!(value >= 1.5e-11 && value < 1e15))
        return false;
    memcpy(&bits, &value, sizeof bits);
    int binary = (int)(bits >> 52) - 1075;
    d->significand = (bits & 0xfffffffffffff) | 0x10000000000000;
    /* log10(2) is a little less than 1233 / 4096: the exponent, or one less. */
    int exponent = (binary + 52) * 1233 >> 12;
    decimal_at(d, binary, exponent);
    if (d->whole >= ten_to[DIGITS])
        decimal_at(d, binary, exponent + 1);
    return true;
}

/* Rounded to so many digits, half to even as printf does: a number of them, or 10^digits. */
static uint64_t decimal_round(const struct decimal *d, int digits)
{
    uint64_t unit = ten_to[DIGITS - digits], q = d->whole / unit, over = d->whole % unit;
    quad_unsigned twice = (((quad_unsigned)over << d->shift) + d->rest) << 1,
                  tie = (quad_unsigned)unit << d->shift;
    return q + (twice > tie || (twice == tie && q % 2 == 1));
}

/* Is the rounding the same for all values as near as a double is to a wider number that it stands for? */
static bool decimal_sure(const struct decimal *d, int digits)
{
    enum { NEAR = 16 }; /* half a step between doubles is at most 2^-53 10^17 = 11.1 of whole */
    uint64_t unit = ten_to[DIGITS - digits], over = d->whole % unit, half = unit / 2;
    return unit > (uint64_t)4 * NEAR && (over > half ? over - half : half - over) > NEAR;
}

/* Does q, of so many digits, lie within half a step of the format with so many bits, or at its even end? */
static bool decimal_returns(const struct decimal *d, uint64_t q, int digits, int bits)
{
    quad_signed whole = (quad_signed)(q * ten_to[DIGITS - digits]) - (quad_signed)d->whole,
                off = whole * ((quad_signed)1 << d->shift) - (quad_signed)d->rest;
    quad_unsigned apart = (quad_unsigned)(off < 0 ? -off : off) << 1,
                  step = (quad_unsigned)d->five << (53 - bits);
    bool lowest = d->significand == 0x10000000000000; /* below a power of two steps are half as long */
    if (lowest && off < 0)
        apart <<= 1;
    bool even = (d->significand >> (53 - bits)) % 2 == 0;
    return apart < step || (apart == step && even);
}

/* q, of so many digits, the first of which stands for 10^exponent, without zeros at its end. */
static void decimal_write(uint64_t q, int digits, int exponent, char *text)
{
    static const char figures[] = "0123456789";
    char figure[DIGITS + 1] = "";
    if (q == ten_to[digits]) {
        q /= 10;
        exponent++;
    }
    int count = digits;
    for (int i = digits; i > 0; q /= 10)
        figure[--i] = figures[q % 10];
    while (count > 1 && figure[count - 1] == '0')
        count--;
    int point = exponent < -4 || exponent >= digits ? 1 : exponent + 1; /* figures before it */
    for (int i = point; i < 1; i++) {
        *text++ = '0';
        if (i == point)
            *text++ = '.';
    }
    for (int i = 0; i < count || i < point; i++) {
        if (i == point && i > 0)
            *text++ = '.';
        *text++ = (char)(i < count ? figure[i] : figures[0]);
    }
    if (exponent < -4 || exponent >= digits) {
        int size = exponent < 0 ? -exponent : exponent; /* two figures: it is at most 15 */
        *text++ = 'e';
        *text++ = exponent < 0 ? '-' : '+';
        *text++ = figures[size / 10];
        *text++ = figures[size % 10];
    }
    *text = '\0';
}

/* The sign, and what is too simple for the rest; NULL where all is written. */
static char *decimal_sign(double *value, char *text)
{
    if (signbit(*value)) {
        *text++ = '-';
        *value = -*value;
    }
    if (*value != 0)
        return text;
    memcpy(text, "0", 2);
    return NULL;
}

bool decimal_text(double value, int digits, char text[DECIMAL_TEXT])
{
    struct decimal d;
    char *at = decimal_sign(&value, text);
    if (!at)
        return true;
    if (!decimal_of(value, &d))
        return false;
    decimal_write(decimal_round(&d, digits), digits, d.exponent, at);
    return true;
}

bool decimal_near(double value, int digits, char text[DECIMAL_TEXT])
{
    struct decimal d;
    char *at = decimal_sign(&value, text);
    if (!at || !decimal_of(value, &d) || !decimal_sure(&d, digits))
        return false;
    decimal_write(decimal_round(&d, digits), digits, d.exponent, at);
    return true;
}

bool decimal_shortest(double value, int least, int bits, char text[DECIMAL_TEXT])
{
    struct decimal d;
    char *at = decimal_sign(&value, text);
    if (!at)
        return true;
    if (!decimal_of(value, &d))
        return false;
    int digits = least;
    uint64_t q = decimal_round(&d, digits);
    while (digits < least + 2 && !decimal_returns(&d, q, digits, bits))
        q = decimal_round(&d, ++digits);
    decimal_write(q, digits, d.exponent, at);
    return true;
}

#else

bool decimal_text(double value, int digits, char text[DECIMAL_TEXT])
{
    return (void)value, (void)digits, (void)text, false;
}

bool decimal_near(double value, int digits, char text[DECIMAL_TEXT])
{
    return (void)value, (void)digits, (void)text, false;
}

bool decimal_shortest(double value, int least, int bits, char text[DECIMAL_TEXT])
{
    return (void)value, (void)least, (void)bits, (void)text, false;
}

#endif
