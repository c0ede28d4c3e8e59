/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/swept.h"
#include <string.h>

void swept_begin(struct swept *s)
{
    s->answered = s->reasoned = false;
    s->reason[0] = '\0';
}

/* The column with this key, or -1; nearly always it is the one that is looked at first. */
static int find(const struct column *columns, const char *key, int first)
{
    if (columns[first].key && strcmp(columns[first].key, key) == 0)
        return first;
    for (int i = 0; columns[i].key; i++)
        if (strcmp(columns[i].key, key) == 0)
            return i;
    return -1;
}

/* From the columns of the command as they are here: a mass may be known, dominoes may rub. */
static void swept_cells(struct swept *s, const struct column *columns, const struct cell *cells,
                        struct cell *row)
{
    const struct cell none = {.kind = CELL_NONE};
    memcpy(row, s->value, (size_t)s->values * sizeof *row);
    for (int j = s->values, next = 0; s->column[j].key; j++) {
        int i = find(columns, s->key[j], next);
        row[j] = i < 0 ? none : cells[i];
        if (i >= 0) {
            s->column[j].unit = columns[i].unit;
            next = i + 1;
        }
    }
}

static void swept_write(struct answer *a, const struct cell *row, const char *reason)
{
    struct swept *s = a->swept;
    const struct column *own = a->columns;
    if (reason && !s->reasoned) {
        snprintf(s->reason, sizeof s->reason, "%s", reason);
        s->reasoned = true;
    }
    if (!a->out)
        return;
    if (a->style.output == OUTPUT_TABLE)
        reason = NULL; /* it has no room for one */
    else if (!reason)
        reason = ""; /* its place is there in every row */
    a->columns = s->column;
    answer_write(a, row, reason);
    if (*a->unsaid && !s->reasoned) {
        snprintf(s->reason, sizeof s->reason, "%s", a->unsaid);
        s->reasoned = true;
    }
    a->unsaid[0] = '\0'; /* the sweep says it */
    a->columns = own;
}

void swept_row(struct answer *a, const struct cell *cells, const char *reason)
{
    struct cell row[ANSWER_COLUMNS];
    swept_cells(a->swept, a->columns, cells, row);
    if (!a->swept->answered)
        memcpy(a->swept->first, row, sizeof row);
    a->swept->answered = true;
    swept_write(a, row, reason);
}

void swept_none(struct answer *a, const char *reason)
{
    struct cell row[ANSWER_COLUMNS] = {{.kind = CELL_NONE}};
    memcpy(row, a->swept->value, (size_t)a->swept->values * sizeof *row);
    swept_write(a, row, reason);
}
