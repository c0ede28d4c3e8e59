/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lines of a page of help. */
#ifndef SHELL_HELP_PAGE_H
#define SHELL_HELP_PAGE_H

#include <stdio.h>

/* Returns the width of help: that of the terminal, but no wider than reads well. */
int help_width(FILE *out);

/* Prints a sentence, wrapped, and a line end. */
void help_say(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Prints what can be typed, and from the column on what it does; below it where the terminal is narrow. */
void help_entry(FILE *out, const char *typed, int column, const char *does);

/* Prints a paragraph, with a blank line before it. */
void help_text(FILE *out, const char *text);

#endif
