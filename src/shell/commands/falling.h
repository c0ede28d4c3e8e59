/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How rows fall, in cells and sentences. */
#ifndef SHELL_FALLING_H
#define SHELL_FALLING_H

#include "interpreter/command.h"

/* A number that a narrow column shows with so many digits; its errors are not known. */
struct cell cell_narrow(domq_real value, int digits);

/* How a row ends, as a sentence; timed: its times are known. */
void verdict_say(struct session *session, struct answer *answer, const struct scene_row *scene,
                 const struct domq_verdict *verdict, bool timed);

/* Also for a status of a row that is not DOM_OK. */
bool row_status(struct session *session, enum dom_status status);

/* What a row meets that stops short of a place where friction locks. */
extern const char locks_farther_on[];

#endif
