/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/cell.h"
#include "language/quad.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Making cells ---- */

struct cell cell_real(domq_real value)
{
    return (struct cell){.kind = isfinite(value) ? CELL_REAL : CELL_NONE, .number = value};
}

struct cell cell_computed(domq_real value)
{
    struct cell cell = cell_without_error(value);
    cell.computed = true;
    return cell;
}

struct cell cell_uncertain(domq_real value, domq_real uncertainty)
{
    struct cell cell = cell_computed(value);
    cell.error = uncertainty;
    return cell;
}

struct cell cell_within(domq_real value, domq_real error)
{
    struct cell cell = cell_real(value);
    cell.error = error;
    return cell;
}

struct cell cell_limit(struct cell cell)
{
    cell.is_limit = true;
    return cell;
}

struct cell cell_without_error(domq_real value)
{
    struct cell cell = cell_real(value);
    cell.error = DOMQ_NAN;
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

/* Writes an error with two digits, rounded up. */
static const char *error_text(domq_real error, char text[WIDE_TEXT])
{
    return quad_write(error * (domq_real)1.06, 2, text);
}

/* Returns the error of the printed number, including its rounding error. */
static domq_real printed_error(struct cell cell, const char *text)
{
    return cell.error + quad(fabs)(quad_read(text, NULL) - cell.number);
}

/* The number of decimal digits that a double represents reliably. */
enum { DOUBLE_DIGITS = 15 };

static const char *real_text(struct cell cell, int digits, bool errors, char text[CELL_TEXT])
{
    char number[WIDE_TEXT], shown[WIDE_TEXT];
    digits = cell.in_double && digits > DOUBLE_DIGITS ? DOUBLE_DIGITS : digits;
    bool with_error = errors && isfinite(cell.error) && cell.digits == 0;
    if (!with_error)
        return (cell.is_limit ? quad_limit_write : quad_write)(cell.number,
                                                               cell.digits ? cell.digits : digits, text);
    if (cell.error == 0)
        quad_exact(cell.number, digits, number);
    else { /* rounding to so many digits adds little to the error */
        const domq_real ratio = quad(fabs)(cell.number) / cell.error;
        const int most = ratio > 1 ? (int)quad_smaller(quad(floor)(quad(log10)(ratio)), 40) + 3 : 2;
        quad_write(cell.number, most < digits ? most : digits, number);
    }
    domq_real error = printed_error(cell, number);
    if (error > 0)
        snprintf(text, CELL_TEXT, "%s +/- %s", number, error_text(error, shown));
    else
        snprintf(text, CELL_TEXT, "%s", number);
    return text;
}

const char *cell_text(struct cell cell, int digits, bool errors, char text[CELL_TEXT])
{
    switch (cell.kind) {
    case CELL_REAL:
        return real_text(cell, digits, errors, text);
    case CELL_COUNT:
        return quad_write(cell.number, WIDE_DIGITS, text);
    case CELL_FLAG:
        return cell.number != 0 ? "yes" : "no";
    case CELL_WORD:
        return cell.word;
    case CELL_NONE:
        break;
    }
    return "-";
}

/* ---- At the precision of the session ---- */

static domq_real rounded(const struct answer_style *style, domq_real value)
{
    return style->precision == IN_FLOAT    ? (domq_real)(float)value
           : style->precision == IN_DOUBLE ? (domq_real)(double)value
                                           : value;
}

static domq_real read_back(const struct answer_style *style, const char *text)
{
    return style->precision == IN_FLOAT    ? (domq_real)strtof(text, NULL)
           : style->precision == IN_DOUBLE ? (domq_real)strtod(text, NULL)
                                           : quad_read(text, NULL);
}

/*
 * Returns the style in which csv and json write a cell. Most numbers are written at the precision of the
 * session, and a number that was computed in double is written in double. At float precision, so is a count,
 * because a large count does not fit into float.
 */
static const struct answer_style *cell_style(const struct answer_style *style, struct cell cell)
{
    static const struct answer_style in_double = {.precision = IN_DOUBLE, .all_digits = 17};
    bool is_large = cell.kind == CELL_COUNT && style->precision == IN_FLOAT;
    return is_large || cell.in_double ? &in_double : style;
}

bool cell_finite(const struct answer_style *style, struct cell cell)
{
    bool is_number = cell.kind == CELL_REAL || cell.kind == CELL_COUNT;
    return !is_number || isfinite(rounded(cell_style(style, cell), cell.number));
}

const char *cell_plain(const struct answer_style *style, struct cell cell, char text[CELL_TEXT])
{
    if (cell.kind == CELL_FLAG)
        return cell.number != 0 ? "true" : "false";
    style = cell_style(style, cell);
    const int all = style->all_digits;
    cell.digits = 0;
    if (cell.kind != CELL_REAL)
        return cell_text(cell, all, false, text);
    cell.number = rounded(style, cell.number);
    /* About half of the computed numbers need `all` digits, and most others need one digit fewer. */
    if (read_back(style, quad_write(cell.number, all - 1, text)) != cell.number)
        return quad_write(cell.number, all, text);
    char fewer[CELL_TEXT];
    /* If trailing zeros have been removed, the text is already short. */
    for (int n = all < 15 ? all - 2 : 15; n < all - 1 && strlen(text) + 1 >= (size_t)all;
         n = n < all - 2 ? all - 2 : all)
        if (read_back(style, quad_write(cell.number, n, fewer)) == cell.number)
            return memcpy(text, fewer, strlen(fewer) + 1);
    return text;
}

const char *cell_plain_error(const struct answer_style *style, struct cell cell, const char *none,
                             char text[CELL_TEXT])
{
    char number[CELL_TEXT];
    bool has_error =
        /* the factor of 2 allows for error_text, which rounds up */
        cell.kind == CELL_REAL && isfinite(rounded(style, cell.error * 2));
    return has_error ? error_text(printed_error(cell, cell_plain(style, cell, number)), text) : none;
}

/* ---- Units ---- */

/* The units for display, such as mm, so that 0.005 m is shown as 5 mm. A number in the unit `base` is shown
 * in the first unit of the list that has this base and a limit `below` larger than the number. For example,
 * 0.5 m is shown as 50 cm, because 0.5 is below 1 but not below 1/100. If the list has no such unit, the
 * number is shown in `base`. */
static const struct {
    const char *base;
    domq_real below;
    struct measure measure;
} measures[] = {{"m", (domq_real)1 / 100, {"mm", 3}},
                {"m", 1, {"cm", 2}},
                {"kg", 1, {"g", 3}},
                {"kg", 10000, {"kg", 0}},
                {"kg", (domq_real)1e30, {"t", -3}}, /* otherwise, as for unknown numbers: kg */
                {"share", (domq_real)HUGE_VAL, {"%", 2}}};

struct measure measure_of(const char *unit, domq_real largest)
{
    /* With this factor, 10 mm is shown as 1 cm in spite of rounding errors. */
    const domq_real almost = 1 + (domq_real)1e-12;
    for (size_t i = 0; *unit && i < sizeof measures / sizeof *measures; i++)
        if (strcmp(unit, measures[i].base) == 0 && quad(fabs)(largest) * almost < measures[i].below)
            return measures[i].measure;
    return (struct measure){unit, 0};
}

domq_real measure_number(struct measure measure, domq_real value)
{
    char text[2 * WIDE_TEXT];
    if (measure.power == 0 || !isfinite(value))
        return value;
    quad_exact(value, WIDE_DIGITS, text);
    char *exponent = strchr(text, 'e');
    int power = measure.power + (exponent ? atoi(exponent + 1) : 0);
    char *end = exponent ? exponent : text + strlen(text);
    snprintf(end, sizeof text - (size_t)(end - text), "e%d", power);
    return quad_read(text, NULL);
}

struct measured measured(domq_real value, const char *unit, int digits)
{
    struct measured result;
    struct measure measure = measure_of(unit, value);
    domq_real shown = measure_number(measure, value), limit = 1;
    for (int n = 0; n < digits; n++)
        limit *= 10;
    /* With only two digits, for example, printf would write 100 as 1e+02. */
    for (; digits < 15 && quad(fabs)(shown) >= limit - (domq_real)0.5; limit *= 10)
        digits++;
    snprintf(result.text, sizeof result.text, "%s%s%s", quad_text(shown, digits), *measure.unit ? " " : "",
             measure.unit);
    return result;
}
