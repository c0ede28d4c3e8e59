/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "value.h"
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* strtod reads more than we promise (hexadecimal, "inf", blanks): only these may begin or be in it. */
static const char *decimal(const char *text, const char **end, double *value)
{
    size_t length = strspn(text, "0123456789.eE+-");
    char *stop;
    errno = 0;
    *value = strtod(text, &stop);
    *end = stop;
    if (length == 0 || stop == text || (size_t)(stop - text) > length)
        return "is no number";
    if (errno == ERANGE || !isfinite(*value))
        return fabs(*value) > 1 ? "is too large for a number" : "is too small for a number";
    return NULL;
}

const char *value_parse(const char *text, double *value)
{
    const char *end, *wrong = decimal(text, &end, value);
    if (!wrong && *end == '/') {
        double divisor;
        wrong = decimal(end + 1, &end, &divisor);
        if (!wrong && divisor == 0)
            return "divides by zero";
        *value /= divisor;
        if (!wrong && !isfinite(*value))
            return "is too large for a number";
    }
    return wrong ? wrong : *end ? "is no number" : NULL;
}

const char *value_shown(const char *text, char shown[VALUE_SHOWN])
{
    size_t n = 0;
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (n + 8 > VALUE_SHOWN) {
            memcpy(shown + n, "...", 4);
            return shown;
        }
        bool plain = *c >= ' ' && *c != 0x7f; /* bytes above are UTF-8 */
        n += (size_t)snprintf(shown + n, VALUE_SHOWN - n, plain ? "%c" : "\\x%02x", *c);
    }
    shown[n] = '\0';
    return shown;
}
