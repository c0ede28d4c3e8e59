/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of output formats. To add a format, write a file like csv.c and add its name to FORMATS. 'set
 * output', its help, its completion and the extensions of output files then include the new format. Only a
 * few help texts and messages name the formats themselves and must be changed by hand. */
#ifndef SHELL_FORMAT_H
#define SHELL_FORMAT_H

#include "answer/answer.h"

/* The first format is the default. */
#define FORMATS(EACH) EACH(table) EACH(csv) EACH(json)

#define FORMAT_EXTERN(name) extern const struct format format_##name;
FORMATS(FORMAT_EXTERN)

/* The formats, indexed by their position in the list. */
extern const struct format *const formats[];

/* ---- The extensions of the files to which answers can be written ---- */

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
