/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output.h"
#include <math.h>
#include <stdarg.h>
#include <string.h>

/* Enough for any cell that is not a word. */
enum { TEXT_SIZE = 32, NUMBER_WIDTH = 14, TABLE_DIGITS = 10 };

struct cell cell_real(double value)
{
    return (struct cell){.kind = isfinite(value) ? CELL_REAL : CELL_NONE, .number = value};
}

struct cell cell_count(double value)
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

static const char *cell_text(struct cell cell, int digits, char text[TEXT_SIZE])
{
    switch (cell.kind) {
    case CELL_REAL:
        snprintf(text, TEXT_SIZE, "%.*g", digits, cell.number);
        return text;
    case CELL_COUNT:
        snprintf(text, TEXT_SIZE, "%.0f", cell.number);
        return text;
    case CELL_FLAG:
        return cell.number != 0 ? "yes" : "no";
    case CELL_WORD:
        return cell.word;
    case CELL_NONE:
        break;
    }
    return "-";
}

/* A string between quotes, as both JSON and (with "" for ") CSV want it. */
static void quoted(FILE *out, const char *text, const char *escaped_quote)
{
    putc('"', out);
    for (const char *c = text; *c; c++) {
        if (*c == '"')
            fputs(escaped_quote, out);
        else if (*c == '\\' && *escaped_quote == '\\')
            fputs("\\\\", out);
        else
            putc(*c, out);
    }
    putc('"', out);
}

static void cell_json(FILE *out, struct cell cell)
{
    char text[TEXT_SIZE];
    if (cell.kind == CELL_NONE)
        fputs("null", out);
    else if (cell.kind == CELL_FLAG)
        fputs(cell.number != 0 ? "true" : "false", out);
    else if (cell.kind == CELL_WORD)
        quoted(out, cell.word, "\\\"");
    else
        fputs(cell_text(cell, 17, text), out);
}

static void row_json(struct answer *a, const struct cell *cells, const char *reason)
{
    for (int i = 0; a->columns[i].key; i++) {
        fprintf(a->out, "%s\"%s\":", i ? "," : "{", a->columns[i].key);
        cell_json(a->out, cells[i]);
    }
    if (reason)
        fputs(",\"reason\":", a->out);
    if (reason)
        quoted(a->out, reason, "\\\"");
    fputs("}\n", a->out);
}

static void cell_csv(FILE *out, struct cell cell)
{
    char text[TEXT_SIZE];
    if (cell.kind == CELL_FLAG)
        fputs(cell.number != 0 ? "true" : "false", out);
    else if (cell.kind == CELL_WORD && strpbrk(cell.word, ",\"\n"))
        quoted(out, cell.word, "\"\"");
    else if (cell.kind != CELL_NONE)
        fputs(cell_text(cell, 17, text), out);
}

static void row_csv(struct answer *a, const struct cell *cells, const char *reason)
{
    if (!a->begun) {
        for (int i = 0; a->columns[i].key; i++)
            fprintf(a->out, "%s%s", i ? "," : "", a->columns[i].key);
        fputs(reason ? ",reason\n" : "\n", a->out);
    }
    for (int i = 0; a->columns[i].key; i++) {
        if (i)
            putc(',', a->out);
        cell_csv(a->out, cells[i]);
    }
    if (reason)
        putc(',', a->out);
    if (reason)
        cell_csv(a->out, cell_word(reason));
    putc('\n', a->out);
}

/* Words stand to the left, numbers to the right; the last column has no blanks behind it. */
static void row_field(struct answer *a, int i, const char *text, bool left)
{
    const struct column *c = &a->columns[i];
    int width = c->width ? c->width : NUMBER_WIDTH;
    const char *gap = i ? "  " : "";
    if (!a->columns[i + 1].key && left)
        fprintf(a->out, "%s%s\n", gap, text);
    else
        fprintf(a->out, "%s%*s%s", gap, left ? -width : width, text, a->columns[i + 1].key ? "" : "\n");
}

static void row_table(struct answer *a, const struct cell *cells)
{
    char text[TEXT_SIZE];
    for (int i = 0; !a->begun && a->columns[i].key; i++)
        row_field(a, i, a->columns[i].key, a->columns[i].width > NUMBER_WIDTH || cells[i].kind == CELL_WORD);
    for (int i = 0; a->columns[i].key; i++)
        row_field(a, i, cell_text(cells[i], TABLE_DIGITS, text),
                  a->columns[i].width > NUMBER_WIDTH || cells[i].kind == CELL_WORD);
}

/* One line a column: key, value, unit, what it is. */
static void row_lines(struct answer *a, const struct cell *cells)
{
    char text[TEXT_SIZE];
    int width = 0, unit_width = 0;
    for (const struct column *c = a->columns; c->key; c++) {
        width = (int)strlen(c->key) > width ? (int)strlen(c->key) : width;
        unit_width = (int)strlen(c->unit) > unit_width ? (int)strlen(c->unit) : unit_width;
    }
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        fprintf(a->out, "%-*s  %*s %-*s  %s\n", width, c->key, NUMBER_WIDTH + 2,
                cell_text(cells[i], TABLE_DIGITS, text), unit_width, c->unit, c->meaning);
    }
}

static void answer_gap(struct answer *a)
{
    if (a->gap && a->format == OUTPUT_TABLE)
        putc('\n', a->out);
    a->gap = false;
}

void answer_row(struct answer *a, const struct cell *cells, const char *reason)
{
    answer_gap(a);
    if (a->format == OUTPUT_JSON)
        row_json(a, cells, reason);
    else if (a->format == OUTPUT_CSV)
        row_csv(a, cells, reason);
    else if (a->rows)
        row_table(a, cells);
    else
        row_lines(a, cells);
    a->begun = true;
    if (reason)
        answer_say(a, "%s", reason);
}

bool answer_lost(const struct answer *a)
{
    return ferror(a->out) != 0;
}

void answer_say(struct answer *a, const char *format, ...)
{
    if (a->format != OUTPUT_TABLE)
        return;
    answer_gap(a);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(a->out, format, arguments);
    va_end(arguments);
    putc('\n', a->out);
}
