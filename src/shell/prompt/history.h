/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lines that a person typed, from session to session. */
#ifndef SHELL_HISTORY_H
#define SHELL_HISTORY_H

#include "session/session.h"

/*
 * Reads the lines of earlier sessions: from DOMINO_HISTORY, where an empty one means none, or from
 * $XDG_STATE_HOME/domino/history.  Only a regular file is read and written; a device, such as /dev/null,
 * means none, and anything else is reported.
 */
void history_load(struct session *session);

/*
 * Adds a line, also at the end of the file, at once: however the session ends, the file has it.  Blank lines,
 * and the line before again, are left out.  The first failure is reported.
 */
void history_keep(struct session *session, const char *text);

#endif
