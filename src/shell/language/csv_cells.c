/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines and cells of csv files; csv.c knows what they mean. */
#include "io/escape.h"
#include "language/csv.h"
#include "language/text.h"
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

bool csv_wrong(struct csv_table *csv, struct csv_place at, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(csv->problem.text, sizeof csv->problem.text, format, arguments);
    va_end(arguments);
    csv->problem.at = at;
    return false;
}

const char *csv_separator_name(const struct csv_table *csv)
{
    return csv->separator == ';' ? "';'" : csv->separator == ',' ? "','" : "tab";
}

/* Leaves out the byte order mark, and makes every line end '\n'. */
static void text_unify(char *text)
{
    char *to = text, before = '\0';
    for (const char *c = text + (strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0); *c; c++) {
        char now = *c;
        if (now != '\n' || before != '\r')
            *to++ = now == '\r' ? '\n' : now;
        before = now;
    }
    *to = '\0';
}

bool csv_load(struct csv_table *csv, FILE *in)
{
    enum { FIRST = 4096 };
    for (size_t n = 0, size = 0, got = 1; got > 0 && !csv->cut_short; n += got) {
        if (n + 1 >= size) {
            char *more = realloc(csv->text, size = size ? 2 * size : FIRST);
            if (!more)
                return csv_wrong(csv, csv->at, "out of memory");
            csv->text = more;
        }
        got = fread(csv->text + n, 1, size - 1 - n, in);
        csv->text[n + got] = '\0';
        if (ferror(in))
            return csv_wrong(csv, csv->at, "cannot read any further: %s", strerror(errno));
        csv->cut_short = strlen(csv->text + n) < got ? "the line has a NUL byte; a csv file is text in UTF-8"
                         : n + got >= CSV_FILE_MOST - 1 ? "the file is larger than 64 MB"
                                                        : NULL;
    }
    text_unify(csv->text);
    csv->next = csv->text;
    return true;
}

/* ---- Cells ---- */

/* Moves to the next character. */
static void step(struct csv_table *csv)
{
    char c = *csv->next++;
    csv->blank = isspace((unsigned char)c);
    csv->at.line += c == '\n';
    csv->at.column = c == '\n' ? 1 : csv->at.column + (((unsigned char)*csv->next & 0xc0) != 0x80);
}

/* Skips blanks, but not the separator, which may be a tab. */
static void skip(struct csv_table *csv)
{
    while (*csv->next && *csv->next != csv->separator && strchr(" \t\f\v", *csv->next))
        step(csv);
}

/* Returns true where a line ends, or a comment begins. */
static bool at_end(const struct csv_table *csv)
{
    return *csv->next == '\0' || *csv->next == '\n' || (*csv->next == '#' && csv->blank);
}

/* Reads a cell and what is after it: its separator, with *more, or the rest of the line. */
static bool cell_read(struct csv_table *csv, struct csv_cell *cell, bool *more)
{
    skip(csv);
    const struct csv_place open = csv->at;
    bool quoted = *csv->next == '"', closed = false, line = true;
    if (quoted) {
        step(csv);
        skip(csv);
    }
    char *to = csv->next;
    *cell = (struct csv_cell){to, csv->at, quoted};
    while (quoted ? *csv->next && !closed : !at_end(csv) && *csv->next != csv->separator) {
        bool quote = quoted && *csv->next == '"';
        if (quote)
            step(csv);
        closed = quote && *csv->next != '"';
        if (!closed) {
            *to++ = *csv->next;
            step(csv);
        }
    }
    skip(csv);
    *more = !at_end(csv);
    if (quoted && !closed)
        return csv_wrong(csv, open, "this '\"' is never closed; write another '\"' at the end of the cell");
    if (*more && *csv->next != csv->separator)
        return csv_wrong(csv, csv->at, "a %s is missing after the closing '\"'", csv_separator_name(csv));
    for (; line && *csv->next; step(csv)) /* a comment goes to the end of its line */
        line = !*more && *csv->next != '\n';
    while (to > cell->text && isspace((unsigned char)to[-1]))
        to--;
    *to = '\0';
    return true;
}

/*
 * Finds the separator: the one of "sep=;", which spreadsheets write above the first line, and which is
 * skipped; or ';' if the first line has one; or a comma, unless a tab comes directly between two names.
 */
static void separator_find(struct csv_table *csv)
{
    const char *name = csv->next + (*csv->next == '"'), *tab = text_end(csv->next, "\t\n");
    bool named = strncasecmp(name, "sep=", 4) == 0 && name[4] && strchr(",;\t", name[4]);
    bool tabs = *tab == '\t' && tab > csv->next && tab[-1] != ',' && !strchr(" \t,#\n", tab[1]);
    bool commas = *text_end(csv->next, ",\n") == ',';
    csv->separator = named                                ? name[4]
                     : *text_end(csv->next, ";\n") == ';' ? ';'
                     : commas && !tabs                    ? ','
                                                          : '\t';
    while (named && *csv->next && *csv->next != '\n')
        step(csv);
}

bool csv_read(struct csv_table *csv, struct csv_record *record)
{
    bool empty = true, good = true;
    while (good && empty && *csv->next) {
        const char *begin = csv->next;
        if (!csv->separator && !strchr("\n#", *skip_blanks(begin)))
            separator_find(csv);
        *record = (struct csv_record){.at = csv->at};
        for (bool more = true; good && more;) {
            struct csv_cell cell;
            good = cell_read(csv, &cell, &more);
            empty = empty && !*cell.text;
            if (record->cells < CSV_CELLS_MOST)
                record->cell[record->cells++] = cell;
            else if (good && *cell.text)
                good = csv_wrong(csv, cell.at, "the line has more than %d cells", CSV_CELLS_MOST);
        }
        if (good && csv->next - begin > CSV_LINE_MOST)
            return csv_wrong(csv, record->at, "the line is longer than %d bytes", CSV_LINE_MOST - 1);
    }
    if (*csv->next == '\0' && csv->cut_short)
        return csv_wrong(csv, csv->at, "%s", csv->cut_short);
    return good && !empty;
}

void csv_write(FILE *out, const char *text, const char *quoted)
{
    char piece[ESCAPE_PIECE];
    const char *quote = strpbrk(text, quoted) ? "\"" : "";
    fputs_unlocked(quote, out);
    for (size_t length; *text; text += length) {
        length = escape_next(text, piece);
        bool plain = *text == '\n' || *text == '\t';
        fputs_unlocked(*text == '"' ? "\"\"" : plain ? (char[]){*text, '\0'} : piece, out);
    }
    fputs_unlocked(quote, out);
}
