/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'sheet', which writes a page for a class that times a row of dominoes, and a page with the
 * answers. feature.c finds the numbers, and sheet_text.c writes the text. */
#ifndef SHELL_CLASS_SHEET_H
#define SHELL_CLASS_SHEET_H

#include "answer/answer.h"
#include "pictures/drawing/falling_row.h"

/* ---- The numbers ---- */

enum { TRIALS = 4 };

/* A row that the class can time. */
struct trial {
    double gap; /* in m */
    size_t dominoes;
    double seconds;
};

struct class_row {
    const struct query *query;
    struct falling_row row;
    const char *unit; /* the unit of lengths on the sheet, and its size in m */
    double size;
    bool is_equal;              /* all dominoes and gaps are equal, so that the class can try other gaps */
    double length;              /* from the back of the first domino to the front of the last one, in m */
    struct trial trial[TRIALS]; /* the first one is the row of the session */
    int trials;
    struct trial
        rough; /* the row with more friction between the dominoes; `seconds` is NaN if it does not fall */
    double friction; /* that friction coefficient */
};

/* ---- The pages ---- */

/* Write the page for pupils, below the picture of the row, and the page with the answers, in the markup of
 * paper.h. */
void sheet_questions(const struct class_row *class, FILE *out);
void sheet_answers(const struct class_row *class, FILE *out);

#endif
