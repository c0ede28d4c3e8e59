/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables for people: in the width of their terminal, with the letters that it has. */
#include "answer/answer.h"
#include "answer/wrap.h"
#include "io/escape.h"
#include "io/terminal.h"
#include <math.h>
#include <string.h>

enum {
    NUMBER_MARGIN = 6, /* what a number needs beside its digits: "-0." and "e-300" */
    BOUND_MARGIN = 12, /* " +/- 1.2e-15" */
    TEXT_LINE = 512,
    WORDS_ROOM = 30,
    WORDS_SHORT = 12, /* a column of these needs no more room than it takes */
    WORDS_INDENT = 8,
    MEANING_ROOM = 20 /* less room beside a number, and its meaning goes below */
};

/* ---- Text ---- */

/* Returns the unit that people see: for angles that of the style, else that of the measure. */
static const char *column_unit(const struct answer *a, const struct column *c, struct measure measure,
                               char text[CELL_TEXT])
{
    if (!column_is_angle(c))
        return measure.unit;
    snprintf(text, CELL_TEXT, "%s%s", style_angle_unit(&a->style), c->unit + strlen("rad"));
    return text;
}

/* Returns how many columns a number takes in a table. */
static int number_width(const struct answer *a, int digits)
{
    return digits + NUMBER_MARGIN + (a->style.errors ? BOUND_MARGIN : 0);
}

/* Returns how many digits a table has room for; with bounds, as many as the bounds leave. */
static int table_digits(const struct answer *a)
{
    return a->style.errors ? a->style.all_digits : (int)a->style.digits;
}

/* Returns the cell as a number of the measure. */
static struct cell measured_cell(struct measure measure, struct cell cell)
{
    if (cell.kind != CELL_REAL || measure.power == 0)
        return cell;
    cell.number = measure_number(measure, cell.number);
    cell.error = isfinite(cell.error) ? measure_number(measure, cell.error) : cell.error;
    return cell;
}

/* Returns the text of a cell: with a bound all digits that the bound leaves, else those of the style, or of
 * the tolerance. */
static const char *table_text(const struct answer *a, struct cell cell, int digits, char text[CELL_TEXT])
{
    int most = (int)a->style.digits;
    if (cell.computed && most > a->style.tol_digits)
        most = a->style.tol_digits;
    bool bounded = a->style.errors && isfinite(cell.error);
    return cell_text(cell, !bounded && digits > most ? most : digits, a->style.errors, text);
}

/* Returns the text with Greek letters and signs, on a terminal with UTF-8. */
static const char *pretty(const struct answer *a, const char *text, char line[TEXT_LINE])
{
    enum { LETTER = 4 }; /* bytes of one with its end: ">=" becomes longer */
    static const char *const letters[][2] = {{"theta", "θ"}, {"omega", "ω"}, {"tau", "τ"}, {"sqrt", "√"},
                                             {">=", "≥"},    {"<=", "≤"},    {"+/-", "±"}};
    if (!a->letters || strlen(text) >= TEXT_LINE)
        return text;
    size_t n = 0;
    while (*text && n + LETTER < TEXT_LINE) {
        const char *with = NULL;
        for (size_t k = 0; k < sizeof letters / sizeof *letters && !with; k++) {
            size_t length = strlen(letters[k][0]);
            if (strncmp(text, letters[k][0], length) == 0) {
                with = letters[k][1];
                text += length;
            }
        }
        if (with)
            n += (size_t)snprintf(line + n, LETTER, "%s", with);
        else
            line[n++] = *text++;
    }
    line[n] = '\0';
    return line;
}

/* Writes text in a field, by columns rather than bytes; negative widths set it to the left. */
static void field(FILE *out, const char *text, int width)
{
    int blanks = (width < 0 ? -width : width) - terminal_columns(text);
    write_blanks(out, width > 0 ? blanks : 0);
    fputs(text, out);
    write_blanks(out, width < 0 ? blanks : 0);
}

/* Writes the key of a column, which has a colour of its own where the terminal has colours. */
static void key_field(const struct answer *a, const char *key, int width)
{
    fputs(a->bold ? "\033[36m" : "", a->out);
    field(a->out, key, width);
    fputs(a->bold ? "\033[m" : "", a->out);
}

/* ---- A table of rows ---- */

/* Returns the width of a column in a table of rows; with few digits the head may be the widest. */
static int column_width(const struct answer *a, const struct column *c, int digits)
{
    int number = number_width(a, digits), head = terminal_columns(c->key);
    return c->width ? c->width : number > head ? number : head;
}

/* Returns how many digits leave room for every column of a table of rows in the width of the terminal. */
static int row_digits(const struct answer *a)
{
    int width = a->width, digits = table_digits(a), fixed = 0, numbers = 0;
    for (const struct column *c = a->columns; c->key; c++) {
        fixed += c->width + (c > a->columns ? 2 : 0);
        numbers += c->width == 0;
    }
    int room = numbers ? (width - fixed) / numbers - number_width(a, 0) : digits;
    return width == 0 || room >= digits ? digits : room < 3 ? 3 : room;
}

/* Returns the column where the last column of words begins; -1 if there is too little room, so that the words
 * go below their row. */
static int row_words(const struct answer *a, int digits)
{
    int at = 0;
    const struct column *c = a->columns;
    for (; c[1].key; c++)
        at += column_width(a, c, digits) + 2;
    int room = c->width && c->width <= WORDS_SHORT ? c->width : WORDS_ROOM;
    return a->width && a->width - at < room ? -1 : at;
}

/* Returns true if the columns of a table of rows fit into the terminal; a last one of long words may go
 * below. */
static bool rows_fit(const struct answer *a)
{
    int wide = -2, digits = row_digits(a);
    for (const struct column *c = a->columns; c->key; c++)
        if (c[1].key || c->width <= WORDS_SHORT)
            wide += column_width(a, c, digits) + 2;
    return a->width == 0 || wide <= a->width;
}

/* Writes a row for which the terminal is too narrow, a line a column. */
static void row_stacked(struct answer *a, const struct cell *cells)
{
    char text[CELL_TEXT], letters[TEXT_LINE], unit[CELL_TEXT];
    int key_width = 0;
    for (const struct column *c = a->columns; c->key; c++) {
        int key = terminal_columns(c->key);
        key_width = key > key_width ? key : key_width;
    }
    if (a->begun)
        putc('\n', a->out);
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        const char *said = table_text(a, measured_cell(a->measure[i], cells[i]), table_digits(a), text);
        if (*said == '\0')
            continue;
        key_field(a, c->key, -key_width);
        fputs("  ", a->out);
        write_wrapped(a->out, pretty(a, said, letters), key_width + 2, a->width);
        said = cells[i].kind == CELL_NONE ? "" : column_unit(a, c, a->measure[i], unit);
        fprintf(a->out, "%s%s\n", *said ? " " : "", said);
    }
}

enum line { KEYS, UNITS, VALUES };

/* Writes one line of a table of rows with such cells; of units only if there are any. */
static void row_line(struct answer *a, const struct cell *cells, enum line line)
{
    char text[ANSWER_COLUMNS][CELL_TEXT], letters[TEXT_LINE];
    const char *said[ANSWER_COLUMNS];
    int digits = row_digits(a), words = row_words(a, digits), end = 0;
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        said[i] = line == KEYS    ? c->key
                  : line == UNITS ? column_unit(a, c, a->measure[i], text[i])
                                  : table_text(a, measured_cell(a->measure[i], cells[i]), digits, text[i]);
        end = *said[i] ? i + 1 : end; /* no blanks after the last unit */
    }
    if (line == UNITS && end == 0)
        return;
    for (int i = 0; i < end; i++) {
        const struct column *c = &a->columns[i];
        const char *shown = line == UNITS ? said[i] : pretty(a, said[i], letters);
        bool last = !a->columns[i + 1].key, left = cells[i].kind == CELL_WORD && (c->width || last);
        int wide = column_width(a, c, digits);
        if (left && last && words >= 0) {
            fputs("  ", a->out);
            write_wrapped(a->out, shown, words, a->width);
        } else if (left && last) {
            if (line == VALUES) {
                fprintf(a->out, "\n%*s", WORDS_INDENT, "");
                write_wrapped(a->out, shown, WORDS_INDENT, a->width);
            }
        } else {
            bool open = left && !a->columns[i + 2].key && words < 0; /* no blanks at the end of the line */
            fputs(i ? "  " : "", a->out);
            int width = open ? 0 : left ? -wide : wide;
            if (line == KEYS)
                key_field(a, shown, width);
            else
                field(a->out, shown, width);
        }
    }
    putc('\n', a->out);
}

/* ---- A line a column ---- */

/* Writes key, value, unit and meaning of each column. */
static void row_lines(struct answer *a, const struct cell *cells)
{
    char text[CELL_TEXT], line[TEXT_LINE], unit[CELL_TEXT];
    int key_width = 0, unit_width = 0, digits = table_digits(a), number = number_width(a, digits);
    const char *bold = a->bold ? "\033[1m" : "", *end = *bold ? "\033[m" : "";
    for (const struct column *c = a->columns; c->key; c++) {
        int key = terminal_columns(pretty(a, c->key, line));
        int wide = (int)strlen(column_unit(a, c, measure_of(c->unit, cells[c - a->columns].number), unit));
        key_width = key > key_width ? key : key_width;
        unit_width = wide > unit_width ? wide : unit_width;
    }
    if (a->width && key_width + number + unit_width + 4 > a->width)
        number = a->width - key_width - unit_width - 4;
    int left = key_width + number + unit_width + 5;
    bool below = a->width && a->width - left < MEANING_ROOM; /* for all columns alike */
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        struct measure measure = measure_of(c->unit, cells[i].number);
        key_field(a, pretty(a, c->key, line), -key_width);
        const char *said = table_text(a, measured_cell(measure, cells[i]), digits, text);
        if (a->width && terminal_columns(said) > number) /* too long beside its key, so below it */
            fprintf(a->out, "\n%*s%s", WORDS_INDENT / 2, "", bold);
        else
            fputs(*bold ? "  \033[1m" : "  ", a->out);
        field(a->out, pretty(a, said, line), number);
        said = cells[i].kind == CELL_NONE ? "" : column_unit(a, c, measure, unit);
        if (below || !*c->meaning) /* no blanks at the end of the line */
            fprintf(a->out, "%s%s%s", end, *said ? " " : "", said);
        else {
            fputs(*end ? "\033[m " : " ", a->out);
            field(a->out, said, -unit_width - 2);
        }
        if (below && *c->meaning)
            fprintf(a->out, "\n%*s", WORDS_INDENT / 2, "");
        write_wrapped(a->out, pretty(a, c->meaning, line), below ? WORDS_INDENT / 2 : left, a->width);
        putc('\n', a->out);
    }
}

/* ---- The format ---- */

static void table_begin(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)reason;
    for (enum line line = KEYS; a->rows && rows_fit(a) && line <= UNITS; line++)
        row_line(a, a->like ? a->like : cells, line);
}

static void table_row(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)reason; /* answer_row says it below the table */
    if (a->rows && !rows_fit(a))
        row_stacked(a, cells);
    else if (a->rows)
        row_line(a, cells, VALUES);
    else
        row_lines(a, cells);
}

/* Writes a text between the margins, as one line where there is no terminal. */
static void table_line(struct answer *a, const char *said)
{
    char text[TEXT_LINE], line[TEXT_LINE];
    escape_text(said, text, sizeof text);
    int indent = (int)strspn(text, " ");
    write_blanks(a->out, indent);
    write_wrapped(a->out, pretty(a, text + indent, line), indent, a->width);
    putc('\n', a->out);
}

static void table_note(struct answer *a, const char *format, va_list arguments)
{
    char said[TEXT_LINE];
    vsnprintf(said, sizeof said, format, arguments);
    /* The blank lines that the format asks for, above and below; a name has no new lines. */
    size_t length = strlen(said);
    bool above = *format == '\n',
         below = length > 1 && format[strlen(format) - 1] == '\n' && said[length - 1] == '\n';
    said[length - below] = '\0';
    if (above)
        putc('\n', a->out);
    table_line(a, said + above);
    if (below)
        putc('\n', a->out);
}

static const char *table_end(struct answer *a)
{
    if (*a->unsaid)
        answer_say(a, "%s", a->unsaid);
    return NULL;
}

const struct format format_table = {.for_people = true,
                                    .begin = table_begin,
                                    .row = table_row,
                                    .line = table_line,
                                    .note = table_note,
                                    .end = table_end};
