/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A printed guide for building a row: a stage drawn to scale, with tables below it. */
#ifndef SHELL_GUIDE_H
#define SHELL_GUIDE_H

#include "pictures/picture/show.h"

enum { GUIDE_COLUMNS = 9, GUIDE_CELL = 24, GUIDE_TABLES = 3 };

/* A line of a table. A cell may be an empty string. */
struct guide_line {
    char cell[GUIDE_COLUMNS][GUIDE_CELL];
    bool bold[GUIDE_COLUMNS];
};

struct guide_table {
    const char *title;
    const char *note;                /* a sentence below the title */
    const char *head[GUIDE_COLUMNS]; /* the headings of the columns; the first NULL ends them */
    struct guide_line *line;
    size_t count;
};

struct guide {
    const struct stage *stage; /* the caption of the stage says what the builder must know */
    const char *title;         /* title of the guide, or NULL */
    struct guide_table table[GUIDE_TABLES];
    int tables;
};

/* Writes a table as plain text. Cells that are bold on paper are followed by a '!'. */
void guide_text(const struct guide_table *table, struct answer *a);

/* Draws a guide into the file of the answer. A .pdf file has A4 pages, like the .pdf file that a .gp script
 * draws. Other pictures have one long page. On failure, sets *problem and returns false. */
bool guide_show(const struct guide *guide, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

#endif
