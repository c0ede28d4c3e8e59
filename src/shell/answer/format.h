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

#endif
