/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/cell.h"
#include "language/quad.h"
#include <stdio.h>
#include <stdlib.h>

struct cell cell_real(domq_real value)
{
    return (struct cell){.kind = isfinite(value) ? CELL_REAL : CELL_NONE, .number = value};
}

struct cell cell_bound(domq_real value, domq_real error)
{
    struct cell cell = cell_real(value);
    cell.error = cell.kind == CELL_REAL ? error : 0;
    cell.computed = true;
    return cell;
}

struct cell cell_unbounded(domq_real value)
{
    struct cell cell = cell_real(value);
    cell.error = DOMQ_NAN;
    return cell;
}

struct cell cell_brief(double value)
{
    struct cell cell = cell_real((domq_real)value);
    cell.digits = 3;
    return cell;
}

struct cell cell_count(domq_real value)
{
    return (struct cell){.kind = isfinite(value) ? CELL_COUNT : CELL_NONE, .number = value};
}

struct cell cell_flag(bool value)
{
    return (struct cell){.kind = CELL_FLAG, .number = value};
}

struct cell cell_word(const char *word)
{
    return (struct cell){.kind = word ? CELL_WORD : CELL_NONE, .word = word};
}

/* ---- Text ---- */

/* Writes a bound in two digits, rounded up so that it stays a bound. */
static const char *bound_text(domq_real error, char text[WIDE_TEXT])
{
    if (!isfinite(error))
        return "-"; /* none is known */
    quad_text(error * (domq_real)1.06, 2, text);
    return text;
}

/* Returns how many digits an exact value needs: 0.4 has one, also where its text could have 36. */
static int exact_digits(struct cell cell, int all)
{
    char text[WIDE_TEXT];
    int digits = all < 15 ? all : 15;
    while (digits < all && quad_read(quad_text(cell.number, digits, text), NULL) != cell.number)
        digits++;
    return digits;
}

/* Returns how many digits of a value its bound leaves certain, so that the printed value is within the bound.
 */
static int bound_digits(struct cell cell, int all)
{
    domq_real ratio = quad(fabs)(cell.number) / cell.error;
    int digits = ratio > 1 ? (int)quad_smaller(quad(floor)(quad(log10)(ratio)), 40) + 3 : 2;
    return digits < all ? digits : all;
}

/* Returns the bound of the printed number: the digits that are left out are an error, too. */
static domq_real printed_error(struct cell cell, const char *number)
{
    return cell.error + quad(fabs)(quad_read(number, NULL) - cell.number);
}

static const char *real_text(struct cell cell, int digits, bool bounds, char text[CELL_TEXT])
{
    char number[WIDE_TEXT], bound[WIDE_TEXT];
    bool known = bounds && isfinite(cell.error) && cell.digits == 0;
    if (!known)
        return quad_text(cell.number, cell.digits ? cell.digits : digits, text);
    digits = cell.error != 0 ? bound_digits(cell, digits) : exact_digits(cell, digits);
    quad_text(cell.number, digits, number);
    domq_real error = printed_error(cell, number);
    if (error > 0)
        snprintf(text, CELL_TEXT, "%s +/- %s", number, bound_text(error, bound));
    else
        snprintf(text, CELL_TEXT, "%s", number);
    return text;
}

const char *cell_text(struct cell cell, int digits, bool bounds, char text[CELL_TEXT])
{
    switch (cell.kind) {
    case CELL_REAL:
        return real_text(cell, digits, bounds, text);
    case CELL_COUNT:
        return quad_text(cell.number, WIDE_DIGITS, text);
    case CELL_FLAG:
        return cell.number != 0 ? "yes" : "no";
    case CELL_WORD:
        return cell.word;
    case CELL_NONE:
        break;
    }
    return "-";
}

/* Returns the value rounded to the session's precision. */
static domq_real rounded(const struct answer_style *style, domq_real value)
{
    return style->precision == DOM_FLOAT    ? (domq_real)(float)value
           : style->precision == DOM_DOUBLE ? (domq_real)(double)value
                                            : value;
}

/* Reads a number as a program with the session's precision does. */
static domq_real read_back(const struct answer_style *style, const char *text)
{
    return style->precision == DOM_FLOAT    ? (domq_real)strtof(text, NULL)
           : style->precision == DOM_DOUBLE ? (domq_real)strtod(text, NULL)
                                            : quad_read(text, NULL);
}

/* What is brief is known in double at best, and a count is more than a float holds. */
static const struct answer_style *style_of(const struct answer_style *style, struct cell cell)
{
    static const struct answer_style in_double = {.precision = DOM_DOUBLE, .all_digits = 17};
    bool count = cell.kind == CELL_COUNT && style->precision == DOM_FLOAT;
    return cell.digits || count ? &in_double : style;
}

bool cell_finite(const struct answer_style *style, struct cell cell)
{
    bool number = cell.kind == CELL_REAL || cell.kind == CELL_COUNT;
    return !number || isfinite(rounded(style_of(style, cell), cell.number));
}

bool cell_vanishes(const struct answer_style *style, struct cell cell)
{
    return cell.kind == CELL_REAL && cell.number != 0 && rounded(style_of(style, cell), cell.number) == 0;
}

const char *cell_plain(const struct answer_style *style, struct cell cell, char text[CELL_TEXT])
{
    if (cell.kind == CELL_FLAG)
        return cell.number != 0 ? "true" : "false";
    style = style_of(style, cell);
    const int all = style->all_digits, few = all < 15 ? all - 2 : 15;
    cell.digits = 0;
    cell.number = cell.kind == CELL_REAL ? rounded(style, cell.number) : cell.number;
    const char *said = cell_text(cell, few, false, text);
    bool same = cell.kind != CELL_REAL || read_back(style, text) == cell.number;
    for (int n = all - 2 > few ? all - 2 : few + 1; !same && n <= all; n++) {
        said = cell_text(cell, n, false, text);
        same = n == all || read_back(style, text) == cell.number;
    }
    return said;
}

const char *cell_plain_bound(const struct answer_style *style, struct cell cell, const char *none,
                             char text[CELL_TEXT])
{
    char number[CELL_TEXT];
    /* In bound_text it grows by 6 %. */
    return cell.kind == CELL_REAL && isfinite(rounded(style, cell.error * 2))
               ? bound_text(printed_error(cell, cell_plain(style, cell, number)), text)
               : none;
}
