/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table format: tables that fit a terminal of 80 columns or more, in characters that it can show. */
#define _GNU_SOURCE /* fputs_unlocked */
#include "answer/answer.h"
#include "io/escape.h"
#include "io/terminal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    NUMBER_MARGIN = 6, /* the width that a number needs besides its digits, for "-0." or "e-300" */
    ERROR_MARGIN = 12, /* the width of " +/- 1.2e-15" */
    TEXT_LINE = 512,
    WORDS_LEAST = 30, /* if the last column has less room, its words are below each row */
    WORDS_SHORT = 12, /* a last column of words that is no wider than this needs only its own width */
    WORDS_INDENT = 8, /* the indentation of the words below a row */
    DIGITS_LEAST = 3
};

/* ---- Text ---- */

/* Returns the unit to show for a column. For angles, the user chooses the unit. */
static const char *column_unit(const struct answer *a, const struct column *c, struct measure measure,
                               char text[CELL_TEXT])
{
    if (!column_is_angle(c))
        return measure.unit;
    snprintf(text, CELL_TEXT, "%s%s", style_angle_unit(&a->style), c->unit + strlen("rad"));
    return text;
}

/* Returns the maximum width of a number with `digits` digits, in columns of the terminal. */
static int number_width(const struct answer *a, int digits)
{
    return digits + NUMBER_MARGIN + (a->style.errors ? ERROR_MARGIN : 0);
}

/* Returns the maximum number of digits to show. If errors are shown, the error of each number determines its
 * digits, so 'set digits' is ignored here. */
static int table_digits(const struct answer *a)
{
    return a->style.errors ? a->style.all_digits : (int)a->style.digits;
}

/* Returns the text of a cell, with its number converted to the unit `measure`. If the error of the
 * number is known and shown, it determines the digits. Otherwise, the digits are limited by 'set
 * digits' and, for a computed number, also by the tolerance. */
static const char *table_text(const struct answer *a, struct measure measure, struct cell cell, int digits,
                              char text[CELL_TEXT])
{
    bool has_error = a->style.errors && isfinite(cell.error);
    int most = (int)a->style.digits;
    if (cell.computed)
        most = style_tol_digits(&a->style, most);
    if (cell.kind == CELL_REAL && measure.power != 0) {
        cell.number = measure_number(measure, cell.number);
        cell.error = isfinite(cell.error) ? measure_number(measure, cell.error) : cell.error;
    }
    return cell_text(cell, !has_error && digits > most ? most : digits, a->style.errors, text);
}

/* Writes text as printf("%*s") does, but counts columns rather than bytes. */
static void field(FILE *out, const char *text, int width)
{
    int blanks = abs(width) - utf8_columns(text);
    for (int i = 0; i < blanks && width > 0; i++)
        putc_unlocked(' ', out);
    fputs_unlocked(text, out);
    for (int i = 0; i < blanks && width < 0; i++)
        putc_unlocked(' ', out);
}

/* ---- A table of rows ---- */

/* Chooses digits and column widths so that all columns fit into the terminal if possible. */
static void rows_measure(struct answer *a)
{
    struct layout *l = &a->layout;
    int fixed = 0, numbers = 0, at = 0, i = 0;
    for (const struct column *c = a->columns; c->key; c++) {
        fixed += c->width + (c > a->columns ? 2 : 0);
        numbers += c->width == 0;
    }
    l->digits = table_digits(a);
    int room = numbers ? (l->width - fixed) / numbers - number_width(a, 0) : l->digits;
    if (l->width && room < l->digits)
        l->digits = room < DIGITS_LEAST ? DIGITS_LEAST : room;
    for (const struct column *c = a->columns; c->key; c++, i++) {
        /* The key may be wider than numbers with few digits. */
        int number = number_width(a, l->digits), key = utf8_columns(c->key);
        l->column[i] = c->width ? c->width : number > key ? number : key;
        at += c[1].key ? l->column[i] + 2 : 0;
    }
    const int last = a->columns[i - 1].width;
    int least = last && last <= WORDS_SHORT ? last : WORDS_LEAST;
    l->words = l->width && l->width - at < least ? -1 : at;
}

enum line { KEYS, UNITS, VALUES };

/* Writes the keys, the units or the values. If no column has a unit, the line of units is omitted. */
static void row_line(struct answer *a, const struct cell *cells, enum line line)
{
    char text[ANSWER_COLUMNS][CELL_TEXT];
    const char *shown[ANSWER_COLUMNS];
    int words = a->layout.words, end = 0;
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        shown[i] = line == KEYS    ? c->key
                   : line == UNITS ? column_unit(a, c, a->layout.measure[i], text[i])
                                   : table_text(a, a->layout.measure[i], cells[i], a->layout.digits, text[i]);
        end = *shown[i] ? i + 1 : end; /* no blanks follow the last unit in the line of units */
    }
    if (line == UNITS && end == 0)
        return;
    for (int i = 0; i < end; i++) {
        const struct column *c = &a->columns[i];
        bool is_last = !c[1].key, is_left = cells[i].kind == CELL_WORD && (c->width || is_last);
        if (is_left && is_last) {
            if (words < 0 && line == VALUES)
                fprintf(a->out, "\n%*s", WORDS_INDENT - 2, "");
            if (words >= 0 || line == VALUES) {
                fputs("  ", a->out);
                write_wrapped(a->out, shown[i], words >= 0 ? words : WORDS_INDENT, a->layout.width);
            }
            continue;
        }
        bool ends_line = is_left && !c[2].key && words < 0; /* no blanks follow the last word */
        int wide = a->layout.column[i], width = ends_line ? 0 : is_left ? -wide : wide;
        fputs(i ? "  " : "", a->out);
        field(a->out, shown[i], width);
    }
    putc('\n', a->out);
}

/* ---- A single row: a line for each column that has a value ---- */

static void row_lines(struct answer *a, const struct cell *cells)
{
    char text[CELL_TEXT];
    int key_width = 0, unit_width = 0, digits = table_digits(a), number = number_width(a, digits);
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        if (cells[i].kind == CELL_NONE)
            continue;
        int key = utf8_columns(c->key);
        int unit = (int)strlen(column_unit(a, c, measure_of(c->unit, cells[i].number), text));
        key_width = key > key_width ? key : key_width;
        unit_width = unit > unit_width ? unit : unit_width;
    }
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        struct measure measure = measure_of(c->unit, cells[i].number);
        if (cells[i].kind == CELL_NONE)
            continue;
        field(a->out, c->key, -key_width);
        fputs("  ", a->out);
        const char *value = table_text(a, measure, cells[i], digits, text);
        const int columns = utf8_columns(value), width = columns > number ? columns : number;
        field(a->out, value, width);
        const char *unit = column_unit(a, c, measure, text);
        fputs(*unit || *c->meaning ? " " : "", a->out); /* no blanks end the line */
        field(a->out, unit, *c->meaning ? -unit_width - 2 : 0);
        write_wrapped(a->out, c->meaning, key_width + width + unit_width + 5, a->layout.width);
        putc('\n', a->out);
    }
}

/* ---- The format ---- */

static void table_begin(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)reason;
    if (!a->rows)
        return;
    rows_measure(a);
    row_line(a, a->layout.sample ? a->layout.sample : cells, KEYS);
    row_line(a, a->layout.sample ? a->layout.sample : cells, UNITS);
}

static void table_row(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)reason;                     /* answer_row writes the reason below the row */
    if (a->rows && !a->layout.digits) /* another part of the answer wrote the first row */
        rows_measure(a);
    if (a->rows)
        row_line(a, cells, VALUES);
    else
        row_lines(a, cells);
}

/* Writes a sentence. A '\n' at the beginning of the format adds a blank line above the sentence, and a '\n'
 * at the end adds a blank line below it. A '\n' at either end of an argument adds no blank line. */
static void table_sentence(struct answer *a, const char *format, va_list arguments)
{
    char text[TEXT_LINE], shown[TEXT_LINE];
    vsnprintf(text, sizeof text, format, arguments);
    size_t length = strlen(text);
    bool above = *format == '\n',
         below = length > 1 && format[strlen(format) - 1] == '\n' && text[length - 1] == '\n';
    text[length - below] = '\0';
    escape_text(text + above, shown, sizeof shown);
    int indent = (int)strspn(shown, " ");
    if (above)
        putc('\n', a->out);
    field(a->out, "", indent);
    write_wrapped(a->out, shown + indent, indent, a->layout.width);
    fputs(below ? "\n\n" : "\n", a->out);
}

const struct format format_table = {
    .for_people = true, .begin = table_begin, .row = table_row, .sentence = table_sentence};
