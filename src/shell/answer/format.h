/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How answers are written.  To add a format, write one file like csv.c with its `struct format`, and name it
 * in FORMATS: 'set output', its help and its completion take it from there.
 */
#ifndef SHELL_FORMAT_H
#define SHELL_FORMAT_H

#include "answer/answer.h"

/* All formats, the default first. */
#define FORMATS(EACH) EACH(table) EACH(csv) EACH(json)

#define FORMAT_EXTERN(name) extern const struct format format_##name;
FORMATS(FORMAT_EXTERN)

/* Returns a format by its number in the list. */
const struct format *format_at(unsigned number);

#endif
