/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tables/csv.h"
#include "io/escape.h"
#include "language/text.h"
#include "language/units.h"
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

bool csv_wrong(struct csv_file *file, struct csv_place at, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(file->problem.text, sizeof file->problem.text, format, arguments);
    va_end(arguments);
    /* An error in an empty file has no position, so it is reported at the first character. */
    file->problem.at = at.line > 0 ? at : (struct csv_place){1, 1};
    return false;
}

const char *csv_separator_name(const struct csv_file *file)
{
    return file->separator == ';' ? "';'" : file->separator == ',' ? "','" : "tab";
}

/* Removes a byte order mark and replaces all line endings by '\n'. */
static void text_unify(char *text)
{
    char *to = text, before = '\0';
    for (const char *c = text + (strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0); *c; c++) {
        char now = *c;
        if (now != '\n' || before != '\r')
            *to++ = (char)(now == '\r' ? '\n' : now);
        before = now;
    }
    *to = '\0';
}

bool csv_load(struct csv_file *file, FILE *in)
{
    enum { FIRST = 4096 };
    for (size_t n = 0, size = 0, got = 1; got > 0 && !file->cut_short; n += got) {
        if (n + 1 >= size) {
            char *more = realloc(file->text, size = size ? 2 * size : FIRST);
            if (!more)
                return csv_wrong(file, file->at, "out of memory");
            file->text = more;
        }
        got = fread(file->text + n, 1, size - 1 - n, in);
        file->text[n + got] = '\0';
        if (ferror(in))
            return csv_wrong(file, file->at, "cannot read the rest of the file: %s", strerror(errno));
        file->cut_short = strlen(file->text + n) < got
                              ? "the line contains a NUL byte; a csv file is text in UTF-8"
                          : n + got >= CSV_FILE_MOST - 1 ? "the file is larger than 64 MB"
                                                         : NULL;
    }
    text_unify(file->text);
    file->next = file->text;
    return true;
}

/* ---- Cells ---- */

static void advance(struct csv_file *file)
{
    char c = *file->next++;
    file->at.line += c == '\n';
    file->at.column = c == '\n' ? 1 : file->at.column + (((unsigned char)*file->next & 0xc0) != 0x80);
}

/* Skips blanks, except a tab that is the separator. */
static void skip_cell_blanks(struct csv_file *file)
{
    while (*file->next && *file->next != file->separator && strchr(" \t\f\v", *file->next))
        advance(file);
}

static bool at_end(const struct csv_file *file)
{
    return *file->next == '\0' || *file->next == '\n';
}

/* Reads a cell. Also skips the separator or the end of the line after the cell. Sets *more to true if another
 * cell follows. */
static bool cell_read(struct csv_file *file, struct csv_cell *cell, bool *more)
{
    skip_cell_blanks(file);
    const struct csv_place open = file->at;
    bool quoted = *file->next == '"', closed = false;
    if (quoted) {
        advance(file);
        skip_cell_blanks(file);
    }
    char *to = file->next;
    *cell = (struct csv_cell){to, file->at};
    while (quoted ? *file->next && !closed : !at_end(file) && *file->next != file->separator) {
        bool quote = quoted && *file->next == '"';
        if (quote)
            advance(file);
        closed = quote && *file->next != '"';
        if (!closed) {
            *to++ = *file->next;
            advance(file);
        }
    }
    skip_cell_blanks(file);
    *more = !at_end(file);
    if (quoted && !closed)
        return csv_wrong(file, open, "this '\"' is never closed; write another '\"' at the end of the cell");
    if (*more && *file->next != file->separator)
        return csv_wrong(file, file->at, "a %s is missing after the closing '\"'", csv_separator_name(file));
    if (*file->next)
        advance(file);
    while (to > cell->text && isspace((unsigned char)to[-1]))
        to--;
    *to = '\0';
    return true;
}

/* Returns true if the line contains the separator c outside quotes. A tab after a comma only sets the cells
 * apart for a reader. */
static bool line_has(const char *line, char c)
{
    bool is_quoted = false;
    for (const char *at = line; *at && (*at != '\n' || is_quoted); at++) {
        is_quoted ^= *at == '"';
        if (*at == c && !is_quoted && !(c == '\t' && at > line && at[-1] == ','))
            return true;
    }
    return false;
}

/* Finds the separator of cells. If the line is of the form "sep=;", skips the line. */
static void separator_find(struct csv_file *file)
{
    const char *name = file->next + (*file->next == '"');
    bool named = strncasecmp(name, "sep=", 4) == 0 && name[4] && strchr(",;\t", name[4]);
    file->separator = ',';
    if (named)
        file->separator = name[4];
    else if (line_has(file->next, ';'))
        file->separator = ';';
    else if (line_has(file->next, '\t'))
        file->separator = '\t';
    while (named && !at_end(file))
        advance(file);
}

/* If a comment begins here, skips the line. In the line with the names of the columns, a '#' that is a whole
 * cell is the name of a column. */
static bool comment_skip(struct csv_file *file)
{
    const char *c = skip_blanks(file->next);
    bool is_name = !file->separator && *c == '#' && strchr(",;\t", c[1]) && c[1];
    if (*c != '#' || is_name)
        return false;
    while (!at_end(file))
        advance(file);
    return true;
}

bool csv_read(struct csv_file *file, struct csv_record *record)
{
    bool empty = true, good = true;
    while (good && empty && *file->next) {
        const char *begin = file->next;
        if (!comment_skip(file) && !file->separator && *skip_blanks(begin) != '\n')
            separator_find(file);
        *record = (struct csv_record){.at = file->at};
        for (bool more = true; good && more;) {
            struct csv_cell cell;
            good = cell_read(file, &cell, &more);
            empty = empty && !*cell.text;
            if (record->cells < CSV_CELLS_MOST)
                record->cell[record->cells++] = cell;
            else if (good && *cell.text)
                good = csv_wrong(file, cell.at,
                                 "the line has more than %d cells; delete columns that are not used",
                                 CSV_CELLS_MOST);
        }
    }
    if (*file->next == '\0' && file->cut_short)
        return csv_wrong(file, file->at, "%s", file->cut_short);
    return good && !empty;
}

/* ---- Decimal marks ---- */

bool csv_marks_read(struct csv_file *file, struct csv_place at, char *text)
{
    int depth = 0;
    for (char *c = text; *c && file->separator != ','; c++) {
        depth += (*c == '(') - (*c == ')');
        /* Inside parentheses, a comma separates the arguments of a function. */
        if (!isdigit((unsigned char)c[1]) || !(*c == '.' || (*c == ',' && depth == 0)))
            continue;
        if (file->mark && file->mark != *c)
            return csv_wrong(file, at,
                             "this number has a decimal %s, but a number above has a %s; write all numbers "
                             "with the same mark, and without marks between thousands",
                             *c == ',' ? "comma" : "point", *c == ',' ? "point" : "comma");
        file->mark = *c;
        *c = '.';
    }
    return true;
}
