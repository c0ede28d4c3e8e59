/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A line as it was typed, made plain: the field's letters, typographic signs and blanks become the ASCII
 * that the interpreter reads; columns are still those of the characters that were typed.
 */
#ifndef SHELL_TEXT_H
#define SHELL_TEXT_H

#include <stdbool.h>
#include <stddef.h>

struct text {
    char *line;
    int *column; /* of each byte of line, and of its end */
};

/* False if there is no memory. */
bool text_make(struct text *text, const char *typed, size_t length);
void text_free(struct text *text);

/* Column of a place in the line, from 1. */
int text_column(const struct text *text, const char *place);

#endif
