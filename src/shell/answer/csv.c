/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A line of names, then a line a row, with commas between (RFC 4180). */
#include "answer/format.h"
#include <string.h>

static void cell_write(const struct answer *a, struct cell cell)
{
    char text[CELL_TEXT];
    if (cell.kind == CELL_WORD && strpbrk(cell.word, ",\"")) {
        putc_unlocked('"', a->out);
        for (const char *c = cell.word; *c; c++)
            fputs_unlocked(*c == '"' ? "\"\"" : (char[]){*c, '\0'}, a->out);
        putc_unlocked('"', a->out);
    } else if (cell.kind != CELL_NONE)
        fputs_unlocked(cell_plain(&a->style, cell, text), a->out);
}

/* Writes the names of the columns; the first row decides whether there is a column for reasons. */
static void csv_begin(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)cells;
    a->reasoned = a->reasoned || reason;
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        fprintf(a->out, a->units && *c->unit ? "%s%s (%s)" : "%s%s", i ? "," : "", c->key, c->unit);
        if (answer_bounded(a, i))
            fprintf(a->out, ",%s_error", c->key);
    }
    fputs_unlocked(a->reasoned ? ",reason\n" : "\n", a->out);
}

static void csv_row(struct answer *a, const struct cell *cells, const char *reason)
{
    char text[CELL_TEXT];
    for (int i = 0; a->columns[i].key; i++) {
        if (i)
            putc_unlocked(',', a->out);
        cell_write(a, cells[i]);
        if (answer_bounded(a, i))
            fprintf(a->out, ",%s", cell_plain_bound(&a->style, cells[i], "", text));
    }
    if (a->reasoned) {
        putc_unlocked(',', a->out);
        cell_write(a, cell_word(reason));
    } else if (reason && !*a->unsaid)
        snprintf(a->unsaid, sizeof a->unsaid, "%s", reason);
    putc_unlocked('\n', a->out);
}

static const char *csv_end(struct answer *a)
{
    return *a->unsaid ? a->unsaid : NULL;
}

const struct format format_csv = {.begin = csv_begin, .row = csv_row, .end = csv_end};
