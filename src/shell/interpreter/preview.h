/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses a line that is being typed, for completion, hints and colours. Nothing is run. */
#ifndef SHELL_PREVIEW_H
#define SHELL_PREVIEW_H

#include "interpreter/reader.h"
#include "session/session.h"

/* No parser accepts this character, so that parsing ends at the cursor. */
#define PREVIEW_CURSOR "\001"

/* Parses the first `length` bytes of a line, followed by `tail`. Returns true if the last command is correct
 * so far: an error at its end only means that more has to follow. If `offer` is not NULL, the last character
 * is the cursor, and what may stand there is recorded; otherwise the values are also computed and checked. */
bool line_preview(struct session *session, const char *line, size_t length, const char *tail,
                  struct offer *offer);

#endif
