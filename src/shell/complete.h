/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_COMPLETE_H
#define SHELL_COMPLETE_H

/* Readline's completion function: commands, parameters, and the words that a parameter may have. */
char **complete_word(const char *text, int start, int end);

#endif
