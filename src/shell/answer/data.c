/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The formats for programs, csv and json, and the list of all formats. */
#define _GNU_SOURCE /* fputs_unlocked */
#include "answer/answer.h"
#include "io/escape.h"
#include "language/text.h"
#include <ctype.h>
#include <string.h>
#include <strings.h>

/* ---- csv (RFC 4180): a line of column names, followed by a line for each row ---- */

static void csv_cell(const struct answer *a, struct cell cell)
{
    char text[CELL_TEXT];
    const char *plain = cell.kind == CELL_NONE ? "" : cell_plain(&a->style, cell, text);
    if (cell.kind != CELL_WORD || !strpbrk(plain, ",\"")) {
        fputs_unlocked(plain, a->out);
        return;
    }
    putc_unlocked('"', a->out);
    for (const char *c = plain; *c; c++)
        fputs_unlocked(*c == '"' ? "\"\"" : (char[]){*c, '\0'}, a->out);
    putc_unlocked('"', a->out);
}

/* Writes the column names, unless the previous rows in the output have the same columns, or 'header' is
 * off. */
static void csv_begin(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)cells;
    char header[ANSWER_HEADER] = "";
    /* Unless a sweep has already set has_reasons, the first row decides whether the answer has the column
     * "reason". */
    a->csv.has_reasons = a->csv.has_reasons || reason;
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        text_add(header, sizeof header, a->csv.units && *c->unit ? "%s%s (%s)" : "%s%s", i ? "," : "", c->key,
                 c->unit);
        if (answer_has_error(a, i))
            text_add(header, sizeof header, ",%s_error", c->key);
    }
    text_add(header, sizeof header, "%s%s", a->csv.has_reasons ? ",reason" : "", a->note ? ",note" : "");
    bool is_same = a->csv.last_header && strcmp(a->csv.last_header, header) == 0;
    if (a->style.header && !is_same)
        fprintf(a->out, "%s\n", header);
    if (a->csv.last_header)
        memcpy(a->csv.last_header, header, sizeof header);
}

/* A line is a header if every cell in it begins with a letter. */
static bool csv_is_header(const char *line)
{
    for (const char *cell = line; *cell; cell += strcspn(cell, ","), cell += *cell == ',')
        if (!isalpha((unsigned char)*cell))
            return false;
    return *line;
}

static void csv_row(struct answer *a, const struct cell *cells, const char *reason)
{
    char text[CELL_TEXT];
    for (int i = 0; a->columns[i].key; i++) {
        if (i)
            putc_unlocked(',', a->out);
        csv_cell(a, cells[i]);
        if (answer_has_error(a, i))
            fprintf(a->out, ",%s", cell_plain_error(&a->style, cells[i], "", text));
    }
    if (a->csv.has_reasons) {
        putc_unlocked(',', a->out);
        csv_cell(a, cell_word(reason));
    } else if (reason && !*a->late_reason)
        snprintf(a->late_reason, sizeof a->late_reason, "%s", reason);
    if (a->note) {
        putc_unlocked(',', a->out);
        csv_cell(a, cell_word(a->note));
    }
    putc_unlocked('\n', a->out);
}

const struct format format_csv = {.begin = csv_begin, .row = csv_row, .is_header = csv_is_header};

/* ---- json: each row of an answer is an object on a line of its own, and so is an error. If a command has no
 * rows, an object with only the name of the command shows that the command has finished. ---- */

static void json_cell(const struct answer *a, struct cell cell)
{
    char text[CELL_TEXT];
    if (cell.kind == CELL_WORD)
        escape_json(a->out, cell.word);
    else
        fputs_unlocked(cell.kind == CELL_NONE ? "null" : cell_plain(&a->style, cell, text), a->out);
}

static void json_row(struct answer *a, const struct cell *cells, const char *reason)
{
    char text[CELL_TEXT];
    fprintf(a->out, "{\"command\":\"%s\"", a->command);
    for (int i = 0; a->columns[i].key; i++) {
        fprintf(a->out, ",\"%s\":", a->columns[i].key);
        json_cell(a, cells[i]);
        if (answer_has_error(a, i))
            fprintf(a->out, ",\"%s_error\":%s", a->columns[i].key,
                    cell_plain_error(&a->style, cells[i], "null", text));
    }
    if (reason) {
        fputs_unlocked(",\"reason\":", a->out);
        json_cell(a, cell_word(*reason ? reason : NULL));
    }
    if (a->note) {
        fputs_unlocked(",\"note\":", a->out);
        json_cell(a, cell_word(a->note));
    }
    fputs_unlocked("}\n", a->out);
}

static void json_done(FILE *out, const char *command)
{
    fprintf(out, "{\"command\":\"%s\"}\n", command);
}

static void json_failed(FILE *out, const char *command, const char *text, const char *source, long line,
                        int column)
{
    fprintf(out, command ? "{\"command\":\"%s\",\"error\":" : "{\"command\":null,\"error\":", command);
    escape_json(out, text);
    fputs(",\"source\":", out);
    escape_json(out, source);
    fprintf(out, column ? ",\"line\":%ld,\"column\":%d}\n" : ",\"line\":%ld,\"column\":null}\n", line,
            column);
}

const struct format format_json = {
    .escapes = true, .row = json_row, .done = json_done, .failed = json_failed};

/* ---- Formats, and the extensions of files ---- */

#define FORMAT_POINTER(name) &format_##name,
const struct format *const formats[] = {FORMATS(FORMAT_POINTER)};

#define EXTENSION_OF_FORMAT(name) {.text = "." #name, .kind = EXTENSION_DATA, .format = &format_##name},
static const struct extension extensions[] = {
    FORMATS(EXTENSION_OF_FORMAT){.text = ".txt", .kind = EXTENSION_TEXT},
    {.text = ".svg", .kind = EXTENSION_SHEET, .terminal = "svg"},
    {.text = ".png", .kind = EXTENSION_SHEET, .terminal = "pngcairo"},
    {.text = ".pdf", .kind = EXTENSION_SHEET, .terminal = "pdfcairo"},
    {.text = ".gp", .kind = EXTENSION_SHEET, .terminal = "pdfcairo", .is_script = true},
    {.text = ".gif", .kind = EXTENSION_FILM},
};

const struct extension *extension_of(const char *path)
{
    static const struct extension none = {.kind = EXTENSION_NONE}, other = {.kind = EXTENSION_OTHER};
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    if (!dot || dot == name || dot[1] == '\0') /* '.hidden' has no extension */
        return &none;
    for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++)
        if (strcasecmp(extensions[i].text, dot) == 0)
            return &extensions[i];
    return &other;
}
