/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/sweeps/swept.h"
#include "answer/format.h"
#include <string.h>

static bool column_add(struct swept *s, int *n, struct column column, const char *key)
{
    if (*n + 1 >= ANSWER_COLUMNS)
        return false;
    s->column[*n] = column;
    s->key[(*n)++] = key;
    s->column[*n].key = NULL;
    return true;
}

bool swept_columns(struct swept *s, const struct grid *grid, const struct command *c,
                   const struct column *columns, bool echoed)
{
    bool room = true;
    int n = 0, twice = 0;
    for (int i = 0; i < grid->axes; i++) {
        const struct parameter *p = grid->axis[i].parameter;
        struct column column = {p->name, p->value->unit, "", 0};
        room = room && column_add(s, &n, column, NULL);
    }
    s->values = n;
    for (const struct column *from = columns; from->key; from++) {
        struct column column = *from;
        bool same = false;
        for (int i = 0; i < grid->axes; i++)
            same = same || strcmp(from->key, s->column[i].key) == 0;
        if (same && c->echo && strcmp(c->echo, from->key) == 0 && !echoed)
            continue;
        if (same) {
            snprintf(s->renamed[twice], sizeof *s->renamed, "%s.%s", c->name, from->key);
            column.key = s->renamed[twice++];
        }
        room = room && column_add(s, &n, column, from->key);
    }
    return room;
}

void swept_begin(struct swept *s)
{
    s->answered = s->reasoned = false;
    s->reason[0] = '\0';
}

/* Returns the column with this key, or -1; checks the column `first` first. */
static int find(const struct column *columns, const char *key, int first)
{
    if (columns[first].key && strcmp(columns[first].key, key) == 0)
        return first;
    for (int i = 0; columns[i].key; i++)
        if (strcmp(columns[i].key, key) == 0)
            return i;
    return -1;
}

/* Fills a row from the columns that the command has at this point, which may depend on mass and friction. */
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

/* Keeps the first reason of the point. */
static void swept_reason(struct swept *s, const char *reason)
{
    if (!s->reasoned)
        snprintf(s->reason, sizeof s->reason, "%s", reason);
    s->reasoned = true;
}

static void swept_write(struct swept *s, const struct cell *row, const char *reason)
{
    if (reason)
        swept_reason(s, reason);
    if (!s->to)
        return;
    /* A table has no column of reasons; other formats have one in every row. */
    answer_row(s->to, row, s->to->style.format->for_people ? NULL : reason ? reason : "");
    if (*s->to->late_reason)
        swept_reason(s, s->to->late_reason);
    s->to->late_reason[0] = '\0'; /* the sweep prints it */
}

void swept_row(struct answer *a, const struct cell *cells, const char *reason)
{
    struct cell row[ANSWER_COLUMNS];
    swept_cells(a->swept, a->columns, cells, row);
    if (!a->swept->answered)
        memcpy(a->swept->first, row, sizeof row);
    a->swept->answered = true;
    swept_write(a->swept, row, reason);
}

void swept_none(struct swept *s, const char *reason)
{
    struct cell row[ANSWER_COLUMNS] = {{.kind = CELL_NONE}};
    memcpy(row, s->value, (size_t)s->values * sizeof *row);
    swept_write(s, row, reason);
}
