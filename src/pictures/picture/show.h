/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws a command's picture to the destination of its answer. A terminal shows the picture in characters. In
 * a file, the extension determines the format. */
#ifndef SHELL_SHOW_H
#define SHELL_SHOW_H

#include "answer/format.h"
#include "pictures/picture/chart.h"
#include "pictures/picture/stage.h"
#include "session/problem.h"
#include <signal.h>

enum extension_kind {
    EXTENSION_NONE,  /* no extension: the session's settings decide */
    EXTENSION_OTHER, /* an unknown extension, which is an error */
    EXTENSION_TEXT,  /* .txt, which has the same effect as no extension */
    EXTENSION_DATA,  /* the extension of an answer format, such as .csv */
    EXTENSION_FILM,  /* an extension for animations (.gif) */
    EXTENSION_SHEET, /* an extension for pictures (.png), or also for documents (.tex) */
};

/* A file extension, and how files with this extension are written. */
struct extension {
    const char *text; /* the extension, such as ".csv"; NULL for EXTENSION_NONE and EXTENSION_OTHER */
    enum extension_kind kind;
    const struct format *format; /* for EXTENSION_DATA: the format of the answer */
    bool is_document;            /* for EXTENSION_SHEET: the file can be a document with formulas */
    bool is_script;              /* the script of the picture is written instead of the picture */
    const char *terminal;        /* the name of the gnuplot terminal that draws the picture, or NULL */
};
const struct extension *extension_of(const char *path);

/* Returns true if the terminal is large enough for a picture. Otherwise reports a problem. */
bool picture_has_room(const struct answer *a, const char *command, struct problem *problem);

/* Returns true if a picture can be drawn to the destination of the answer. Otherwise sets *problem. */
bool picture_ready(const struct answer *a, struct problem *problem);

/* Returns the words that explain a picture's marks. Text and gnuplot pictures have different marks. */
struct marks picture_marks(const struct answer *a);

/* Writes the head of a gnuplot script that draws a .pdf file of the same name. */
void script_head(const struct answer *a, const char *terminal);

/* Draws a chart to the destination of the answer and frees the chart. */
bool chart_show(struct chart *chart, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

/* Draws a stage to the destination of the answer. */
bool stage_show(const struct stage *stage, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

#endif
