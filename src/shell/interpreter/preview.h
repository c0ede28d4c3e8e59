/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses a line that is being typed, for completion. No command is run. */
#ifndef SHELL_PREVIEW_H
#define SHELL_PREVIEW_H

#include "interpreter/reader.h"
#include "session/session.h"

/* The character that marks the cursor. No name, value or operator contains this character. */
#define PREVIEW_CURSOR "\001"

enum preview {
    PREVIEW_WRONG,
    PREVIEW_OPEN, /* the command is correct so far, but incomplete */
    PREVIEW_WHOLE,
};

/*
 * Parses a line that is not complete yet and judges its last command. The line consists of `length` bytes of
 * the text `line`, followed by the text `tail`. If `offer` is NULL, also computes and checks the values in
 * the line. If `offer` is not NULL, stores in *offer where the names of commands are and, if `tail` ends with
 * PREVIEW_CURSOR, what may be typed at the cursor.
 */
enum preview line_preview(struct session *session, const char *line, size_t length, const char *tail,
                          struct offer *offer);

#endif
