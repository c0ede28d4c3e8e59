/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A line of names, then a line a row, with commas between (RFC 4180). */
#include "language/csv.h"
#include "answer/answer.h"
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

/* Takes what comes after the head or after the cells of the next row. */
static const char *others_next(struct answer *a)
{
    const char *others = a->others ? a->others : "";
    a->others = a->others ? others + strlen(others) + 1 : NULL;
    return others;
}

/* Writes the names of the columns; the first row decides whether there is a column for reasons. */
static void csv_begin(struct answer *a, const struct cell *cells, const char *reason)
{
    (void)cells;
    char head[ANSWER_HEAD];
    size_t n = 0;
    a->reasoned = a->reasoned || reason;
    for (int i = 0; a->columns[i].key && n < sizeof head; i++) {
        const struct column *c = &a->columns[i];
        n += (size_t)snprintf(head + n, sizeof head - n, a->units && *c->unit ? "%s%s (%s)" : "%s%s",
                              i ? "," : "", c->key, c->unit);
        if (answer_bounded(a, i) && n < sizeof head)
            n += (size_t)snprintf(head + n, sizeof head - n, ",%s_error", c->key);
    }
    if (n < sizeof head)
        snprintf(head + n, sizeof head - n, "%s%s", a->reasoned ? ",reason" : "",
                 answer_note(a) ? ",note" : "");
    /* Rows with the columns of the rows above go on below them. */
    const char *others = others_next(a);
    bool again = a->head && !*others && strcmp(a->head, head) == 0;
    if (a->style.header && !again)
        fprintf(a->out, "%s%s\n", head, others);
    if (a->head)
        memcpy(a->head, *others ? "" : head, *others ? 1 : sizeof head);
}

/* Numbers and empty cells begin with no letter. */
static bool csv_is_head(const char *line)
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
        if (answer_bounded(a, i))
            fprintf(a->out, ",%s", cell_plain_bound(&a->style, cells[i], "", text));
    }
    if (a->reasoned) {
        putc_unlocked(',', a->out);
        cell_write(a, cell_word(reason));
    } else if (reason && !*a->unsaid)
        snprintf(a->unsaid, sizeof a->unsaid, "%s", reason);
    if (answer_note(a)) {
        putc_unlocked(',', a->out);
        cell_write(a, cell_word(answer_note(a)));
    }
    fputs_unlocked(others_next(a), a->out);
    putc_unlocked('\n', a->out);
}

static const char *csv_end(struct answer *a)
{
    return *a->unsaid ? a->unsaid : NULL;
}

const struct format format_csv = {.begin = csv_begin, .row = csv_row, .is_head = csv_is_head, .end = csv_end};
