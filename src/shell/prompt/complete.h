/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_COMPLETE_H
#define SHELL_COMPLETE_H

#include <stdbool.h>

/*
 * Everything that may stand in place of the last word of a line: commands, then what the command's
 * arguments are, files where they belong.
 */
void complete_line(const char *line, bool files, void (*emit)(const char *candidate, void *context),
                   void *context);

/* The same as Readline's completion function. */
char **complete_word(const char *text, int start, int end);

#endif
