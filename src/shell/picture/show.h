/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shows the picture of a command where its answer goes. On the terminal the picture is made of characters or,
 * if the terminal can display graphics, of pixels. In the file after '>' its format depends on the extension
 * of the file.
 */
#ifndef SHELL_SHOW_H
#define SHELL_SHOW_H

#include "answer/format.h"
#include "picture/chart.h"
#include "picture/stage.h"
#include "session/problem.h"
#include <signal.h>

enum ending_kind {
    ENDING_NONE,  /* the name has no extension, so the session's settings decide */
    ENDING_OTHER, /* no format has this extension, which is an error */
    ENDING_TEXT,  /* .txt, which is the same as no extension */
    ENDING_DATA,  /* .csv, .json and every other format of answers */
    ENDING_SHEET, /* the ending of a picture, of a document, or of both, such as .pdf */
};

/* A file extension and what it decides. */
struct ending {
    const char *text; /* the extension, such as ".csv"; NULL for ENDING_NONE and ENDING_OTHER */
    enum ending_kind kind;
    const struct format *format; /* for ENDING_DATA: the format of answers */
    bool is_document;            /* for ENDING_SHEET: the file can be a text with formulas */
    bool is_script;              /* the file gets the script of the picture, instead of the picture */
    /* for the ending of a picture: the gnuplot terminal, with its options; otherwise NULL */
    const char *terminal;
};
const struct ending *ending_of(const char *path);

/* If the terminal is too small for the picture of a command, sets *problem and returns false. */
bool picture_fits(const struct answer *a, const char *command, struct problem *problem);

/* Checks, before any work is done, that a picture can be drawn where the answer goes. If not, sets *problem
 * and returns false. */
bool picture_ready(const struct answer *a, struct problem *problem);

/* Returns how dominoes will be marked in a picture that goes where the answer goes. */
struct marks picture_marks(const struct answer *a);

/* Writes the first lines of the script of a picture. The script draws into a .pdf file that is named after
 * the script. */
void script_head(const struct answer *a, const char *terminal);

/* Draws a chart where the answer goes, and frees the chart. */
bool chart_show(struct chart *chart, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

/* Draws a stage where the answer goes. */
bool stage_show(const struct stage *stage, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

#endif
