/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The csv format (RFC 4180): a line of column names, followed by a line for each row. */
#define _GNU_SOURCE /* fputs_unlocked */
#include "answer/answer.h"
#include "io/escape.h"
#include "language/text.h"
#include <ctype.h>
#include <string.h>

static void cell_write(const struct answer *a, struct cell cell)
{
    char text[CELL_TEXT];
    if (cell.kind == CELL_WORD && strpbrk(cell.word, ",\""))
        csv_write(a->out, cell.word, ",\"");
    else if (cell.kind != CELL_NONE)
        fputs_unlocked(cell_plain(&a->style, cell, text), a->out);
}

/* Returns the text to append to the header line or, in later calls, to a row. */
static const char *extra_next(struct answer *a)
{
    const char *extra = a->csv.extra ? a->csv.extra : "";
    a->csv.extra = a->csv.extra ? extra + strlen(extra) + 1 : NULL;
    return extra;
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
    const char *extra = extra_next(a);
    bool is_same = a->csv.last_header && !*extra && strcmp(a->csv.last_header, header) == 0;
    if (a->style.header && !is_same)
        fprintf(a->out, "%s%s\n", header, extra);
    if (a->csv.last_header)
        memcpy(a->csv.last_header, *extra ? "" : header, *extra ? 1 : sizeof header);
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
        cell_write(a, cells[i]);
        if (answer_has_error(a, i))
            fprintf(a->out, ",%s", cell_plain_error(&a->style, cells[i], "", text));
    }
    if (a->csv.has_reasons) {
        putc_unlocked(',', a->out);
        cell_write(a, cell_word(reason));
    } else if (reason && !*a->late_reason)
        snprintf(a->late_reason, sizeof a->late_reason, "%s", reason);
    if (a->note) {
        putc_unlocked(',', a->out);
        cell_write(a, cell_word(a->note));
    }
    fputs_unlocked(extra_next(a), a->out);
    putc_unlocked('\n', a->out);
}

const struct format format_csv = {.begin = csv_begin, .row = csv_row, .is_header = csv_is_header};
