/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses a line that is being typed, for completion, hints and colours. No command is run. */
#ifndef SHELL_PREVIEW_H
#define SHELL_PREVIEW_H

#include "interpreter/reader.h"
#include "session/session.h"

/* The character that marks the cursor. No parser accepts this character, so parsing stops there. */
#define PREVIEW_CURSOR "\001"

enum preview {
    PREVIEW_WRONG,
    PREVIEW_OPEN, /* the command is correct so far, but incomplete */
    PREVIEW_WHOLE,
};

/*
 * Parses the first `length` bytes of a line, followed by `tail`, and says whether the last command is wrong,
 * incomplete or complete. If `offer` is not NULL, the last character of `tail` must be the cursor, and *offer
 * records what may be typed there. If `offer` is NULL, the values of arguments are also computed and checked.
 */
enum preview line_preview(struct session *session, const char *line, size_t length, const char *tail,
                          struct offer *offer);

#endif
