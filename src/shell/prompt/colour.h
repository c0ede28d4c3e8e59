/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The colour of commands in the line that is being typed. */
#ifndef SHELL_COLOUR_H
#define SHELL_COLOUR_H

#include "session/session.h"

/*
 * Colours the names of commands in the typed line while Readline waits for a key, where the terminal has
 * colours. Writes the line again, character for character, so that what Readline knows of the screen stays
 * true.
 */
void colour_show(struct session *session);

#endif
