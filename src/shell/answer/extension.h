/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The extensions of the files to which answers can be written. */
#ifndef SHELL_EXTENSION_H
#define SHELL_EXTENSION_H

#include "answer/format.h"

enum extension_kind {
    EXTENSION_NONE,  /* no extension: the session's settings decide */
    EXTENSION_OTHER, /* an unknown extension, which is an error */
    EXTENSION_TEXT,  /* .txt, which has the same effect as no extension */
    EXTENSION_DATA,  /* the extension of an answer format, such as .csv */
    EXTENSION_FILM,  /* an extension for animations (.gif) */
    EXTENSION_SHEET, /* an extension for pictures, such as .png */
};

/* A file extension, and how files with this extension are written. */
struct extension {
    const char *text; /* the extension, such as ".csv"; NULL for EXTENSION_NONE and EXTENSION_OTHER */
    enum extension_kind kind;
    const struct format *format; /* for EXTENSION_DATA: the format of the answer */
    bool is_script;              /* the script of the picture is written instead of the picture */
    const char *terminal;        /* the name of the gnuplot terminal that draws the picture, or NULL */
};
const struct extension *extension_of(const char *path);

/* The smallest terminal, in characters, on which a picture is drawn. */
enum { PICTURE_LEAST_WIDTH = 31, PICTURE_LEAST_HEIGHT = 13 };

#endif
