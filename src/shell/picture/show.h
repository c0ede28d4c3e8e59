/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where the picture of a command goes, which is where its answer goes: as characters or as a real picture to
 * the terminal, or into the file after '>', whose ending decides the format.
 */
#ifndef SHELL_SHOW_H
#define SHELL_SHOW_H

#include "answer/format.h"
#include "picture/chart.h"
#include "picture/stage.h"
#include "session/problem.h"
#include <signal.h>

enum ending_kind {
    ENDING_NONE,    /* the name has no ending: the session's settings decide */
    ENDING_OTHER,   /* no format has this ending: an error */
    ENDING_TEXT,    /* .txt: as without an ending */
    ENDING_DATA,    /* .csv, .json and every other format of answers */
    ENDING_PICTURE, /* .svg, .png, .pdf */
};

/* What the ending of a file's name decides. */
struct ending {
    const char *text; /* ".csv"; NULL for ENDING_NONE and ENDING_OTHER */
    enum ending_kind kind;
    const struct format *format; /* for ENDING_DATA */
    const char *terminal;        /* for ENDING_PICTURE: the terminal of gnuplot, with its options */
};
const struct ending *ending_of(const char *path);

/* Describes a problem and returns false if the terminal is too small for the picture of a command. */
bool picture_fits(const struct answer *a, const char *command, struct problem *problem);

/* Describes a problem and returns false, before any work is done, if the picture cannot be drawn where the
 * answer goes. */
bool picture_ready(const struct answer *a, struct problem *problem);

/* Returns how the dominoes of a stage are marked where the answer goes. */
struct marks picture_marks(const struct answer *a);

/* Draws a chart, and frees it. */
bool chart_show(struct chart *chart, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

/* Draws a stage. */
bool stage_show(const struct stage *stage, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

#endif
