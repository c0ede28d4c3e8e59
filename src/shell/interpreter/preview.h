/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A line that is being typed: it is parsed, for completion, hints and colours, and not run. */
#ifndef SHELL_PREVIEW_H
#define SHELL_PREVIEW_H

#include "interpreter/reader.h"
#include "session/session.h"

/* The cursor is a character that no parser accepts, so that parsing ends there. */
#define PREVIEW_CURSOR "\001"

/*
 * Parses the first `length` bytes of a line with `tail` after them. Returns true if the last command is
 * right as far as it goes: an error at its end says only that something has to follow. With `offer`,
 * records what may stand at the last character, which is the cursor; else the values are also computed and
 * checked.
 */
bool line_preview(struct session *session, const char *line, size_t length, const char *tail,
                  struct offer *offer);

#endif
