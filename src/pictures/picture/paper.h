/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages for printing: a stage at the top, with text and tables below it. */
#ifndef SHELL_PAPER_H
#define SHELL_PAPER_H

#include "answer/answer.h"
#include "pictures/picture/stage.h"

/* A document in a simple markup. The caller writes it to `out`, in lines:
 * - "# HEADING" begins a part, which stays on one page if it fits.
 * - "|CELL|CELL" is a row of a table, whose first row is its head. An empty cell has room for handwriting; a
 *   cell with a blank does not.
 * - "\f" begins a new page.
 * - Any other line is text, which is broken into lines that fit. */
struct paper {
    FILE *out;
    char *text;
    size_t size;
};

/* paper_open returns false if memory runs out. paper_close ends the document; it returns false if there was
 * no memory for it. paper_free may also be called if paper_open failed. */
bool paper_open(struct paper *paper);
bool paper_close(struct paper *paper);
void paper_free(struct paper *paper);

/* Writes a document as plain text. */
void paper_write(const struct paper *paper, FILE *out);

/* Draws a title (or NULL), a stage and the text of a document into the file of the answer. A .pdf file has A4
 * pages, like the .pdf file that a .gp script draws. Other pictures have one long page. On failure, sets
 * *problem and returns false. */
bool paper_draw(const struct paper *paper, const char *title, const struct stage *stage,
                const struct answer *a, const volatile sig_atomic_t *interrupt, struct problem *problem);

#endif
