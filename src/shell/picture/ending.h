/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ending of a file's name decides its format: one table for data, text and pictures. */
#ifndef SHELL_ENDING_H
#define SHELL_ENDING_H

#include "answer/format.h"

enum ending_kind {
    ENDING_NONE,    /* the name has no ending: the session's settings decide */
    ENDING_OTHER,   /* no format has this ending: an error */
    ENDING_TEXT,    /* .txt: as without an ending */
    ENDING_DATA,    /* .csv, .json and every other format of answers */
    ENDING_PICTURE, /* .svg, .png, .pdf */
};

struct ending {
    const char *text; /* ".csv"; NULL for ENDING_NONE and ENDING_OTHER */
    enum ending_kind kind;
    const struct format *format; /* of ENDING_DATA */
    const char *terminal;        /* of ENDING_PICTURE, as gnuplot names it, with its options */
};

/* Returns what the name of a file promises; never NULL. */
const struct ending *ending_of(const char *path);

#endif
