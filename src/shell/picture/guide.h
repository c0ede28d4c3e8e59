/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A guide for building a row, as it is printed: a stage, to scale, and below it tables, on pages of A4. */
#ifndef SHELL_GUIDE_H
#define SHELL_GUIDE_H

#include "picture/show.h"

enum { GUIDE_COLUMNS = 9, GUIDE_CELL = 24, GUIDE_TABLES = 3 };

/* A line of a table. An empty cell is left blank. */
struct guide_line {
    char cell[GUIDE_COLUMNS][GUIDE_CELL];
    bool bold[GUIDE_COLUMNS];
};

struct guide_table {
    const char *title;
    const char *note;                /* a sentence below the title */
    const char *head[GUIDE_COLUMNS]; /* the first NULL ends the columns */
    struct guide_line *line;
    size_t count;
};

struct guide {
    const struct stage *stage; /* its caption says what a builder must know */
    const char *title;         /* title of the guide, or NULL */
    struct guide_table table[GUIDE_TABLES];
    int tables;
};

/* Writes a table in characters, with a '!' after the cells that are bold on paper. */
void guide_text(const struct guide_table *table, FILE *out);

/* Draws a guide into the picture in which the answer goes. A .pdf file gets as many pages of A4 as are
 * needed, and every other picture is one long page. Returns false with a problem. */
bool guide_show(const struct guide *guide, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

#endif
