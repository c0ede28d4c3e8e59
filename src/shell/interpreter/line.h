/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands from a stream, and where a person's files are. */
#ifndef SHELL_LINE_H
#define SHELL_LINE_H

#include "session/session.h"

/* Runs a stream line by line. name: the source for messages. */
void line_stream(struct session *session, FILE *in, const char *name);

/* Writes $variable/domino/name, or $HOME/fallback/domino/name, as XDG has it; false if neither is known. */
bool line_path(const char *variable, const char *fallback, const char *name, char *path, size_t size);

#endif
