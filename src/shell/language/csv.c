/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines and cells of csv files; csv_table.c knows what they mean. */
#include "language/csv.h"
#include "io/escape.h"
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

/* ---- The file ---- */

/* Leaves out the byte order mark, and makes every line end '\n'. */
static void text_unify(char *text)
{
    char *to = text, before = '\0';
    for (const char *c = text + (strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0); *c; before = *c++)
        if (*c != '\n' || before != '\r')
            *to++ = *c;
    *to = '\0';
    for (to = text; (to = strchr(to, '\r')) != NULL;)
        *to = '\n';
}

bool csv_load(struct csv_table *csv, FILE *in)
{
    enum { FIRST = 4096 };
    csv->at = (struct csv_place){1, 1};
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

/* Moves to the next character. */
static void step(struct csv_table *csv)
{
    bool ends = *csv->next++ == '\n';
    csv->at.line += ends;
    csv->at.column = ends ? 1 : csv->at.column + (((unsigned char)*csv->next & 0xc0) != 0x80);
}

/* Returns true where a line ends, or a comment begins: the line above may have been ended by a NUL. */
static bool ends(const struct csv_table *csv, const char *c)
{
    return *c == '\0' || *c == '\n' ||
           (*c == '#' && (c == csv->text || c[-1] == '\0' || isspace((unsigned char)c[-1])));
}

/* ---- Cells ---- */

/* Skips blanks, but not the separator, which may be a tab. */
static void skip(struct csv_table *csv)
{
    while (*csv->next && *csv->next != csv->separator && strchr(" \t\f\v", *csv->next))
        step(csv);
}

/*
 * Reads a cell and the separator after it.  The text stays where it is, and is to be ended at *end when the
 * record has been read, since the character there may still matter.
 */
static bool cell_read(struct csv_table *csv, struct csv_cell *cell, char **end, bool *more)
{
    skip(csv);
    const struct csv_place open = csv->at;
    bool quoted = *csv->next == '"', closed = false;
    if (quoted) {
        step(csv);
        skip(csv);
    }
    char *to = csv->next;
    *cell = (struct csv_cell){to, csv->at, quoted};
    while (quoted ? *csv->next && !closed : !ends(csv, csv->next) && *csv->next != csv->separator) {
        bool quote = quoted && *csv->next == '"';
        if (quote)
            step(csv);
        closed = quote && *csv->next != '"';
        if (!closed) {
            *to++ = *csv->next;
            step(csv);
        }
    }
    while (to > cell->text && isspace((unsigned char)to[-1]))
        to--;
    *end = to;
    skip(csv);
    *more = !ends(csv, csv->next);
    if (quoted && !closed)
        return csv_wrong(csv, open, "this '\"' is never closed; write another '\"' at the end of the cell");
    if (*more && *csv->next != csv->separator)
        return csv_wrong(csv, csv->at, "a %s is missing after the closing '\"'", csv_separator_name(csv));
    if (*more)
        step(csv);
    return true;
}

/* Reads the cells of a line, and sets *empty if there is nothing in them. */
static bool record_read(struct csv_table *csv, struct csv_record *record, bool *empty)
{
    char *end[CSV_CELLS_MOST], *last;
    struct csv_cell cell;
    bool good = true, more = true;
    *record = (struct csv_record){.at = csv->at};
    while (good && more) {
        good = cell_read(csv, &cell, &last, &more);
        bool nothing = last == cell.text;
        *empty = *empty && nothing;
        if (good && !nothing && record->cells == CSV_CELLS_MOST)
            good = csv_wrong(csv, cell.at, "the line has more than %d cells", CSV_CELLS_MOST);
        if (record->cells == CSV_CELLS_MOST)
            continue;
        end[record->cells] = last;
        record->cell[record->cells++] = cell;
    }
    while (good && *csv->next && *csv->next != '\n') /* a comment */
        step(csv);
    if (good && *csv->next)
        step(csv);
    for (int i = 0; i < record->cells; i++)
        *end[i] = '\0';
    return good;
}

/*
 * Finds the separator by the first line that is not empty: the one of "sep=;", which spreadsheets write above
 * the others and which is skipped; or ';' if there is one; or a tab, unless tabs only align what commas
 * separate; or a comma.
 */
static void separator_find(struct csv_table *csv)
{
    char found = ',', before = '\0'; /* before: the last character that is not a blank */
    bool tab = false;                /* there is a tab after it */
    const char *c = csv->next;
    for (; !ends(csv, c) && found != ';'; c++) {
        bool begins = before == '\0' || before == ',' || tab;
        tab = tab || *c == '\t';
        if (*c == '\t' || *c == ' ')
            continue;
        found = *c == ';' ? ';' : tab && before && before != ',' && *c != ',' ? '\t' : found;
        tab = false;
        before = *c;
        const char *close = begins && *c == '"' ? text_quote(c) : NULL;
        c = close ? close - 1 : c;
    }
    size_t quote = *csv->next == '"';
    const char *name = csv->next + quote;
    bool named = strncasecmp(name, "sep=", 4) == 0 && name[4] && strchr(",;\t", name[4]) &&
                 ends(csv, skip_blanks(name + 5 + (quote && name[5] == '"')));
    csv->separator = named ? name[4] : before ? found : '\0';
    while (named && *csv->next && *csv->next != '\n')
        step(csv);
}

bool csv_read(struct csv_table *csv, struct csv_record *record)
{
    bool empty = true, good = true;
    while (good && empty && *csv->next) {
        const char *begin = csv->next;
        if (!csv->separator)
            separator_find(csv);
        good = record_read(csv, record, &empty);
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
        length = *text == '\n' || *text == '\t' ? 0 : escape_next(text, piece);
        if (length > 0)
            fputs_unlocked(piece, out);
        if (length == 0 || *text == '"') /* a quote is doubled */
            putc_unlocked(*text, out);
        length += length == 0;
    }
    fputs_unlocked(quote, out);
}
