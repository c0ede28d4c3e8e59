/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses a line that is being typed, for completion, hints and colours. Nothing is run. */
#ifndef SHELL_PREVIEW_H
#define SHELL_PREVIEW_H

#include "interpreter/reader.h"
#include "session/session.h"

/* No parser accepts this character, so that parsing ends at the cursor. */
#define PREVIEW_CURSOR "\001"

enum preview {
    PREVIEW_WRONG,
    PREVIEW_OPEN, /* The command is correct so far, but more has to follow. */
    PREVIEW_WHOLE,
};

/*
 * Parses the first `length` bytes of a line, followed by `tail`, and judges the last command. If `offer` is
 * not NULL, the last character is the cursor, and what may stand there is recorded; otherwise the values are
 * also computed and checked.
 */
enum preview line_preview(struct session *session, const char *line, size_t length, const char *tail,
                          struct offer *offer);

#endif
