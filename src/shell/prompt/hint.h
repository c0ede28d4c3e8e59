/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is shown faintly after the cursor: the rest of an earlier line, or of the usage of the command. */
#ifndef SHELL_HINT_H
#define SHELL_HINT_H

#include "session/session.h"

/* Makes the keys that move to the end of the line take the hint at its end; after Readline has begun. */
void hint_begin(void);

/* Shows a hint while Readline waits for a key, where the terminal can and the session has hints. */
void hint_show(struct session *session);

/* Removes the hint, before the key that has come is read. */
void hint_remove(void);

#endif
