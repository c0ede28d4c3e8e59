/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files about proofs share. */
#ifndef SHELL_PROOF_H
#define SHELL_PROOF_H

#include "interpreter/command.h"

extern const struct command prove_commands[];

/* Adds a row for each proof of 'rmax' or 'pair', with smaller and smaller tolerances until a proof fails. A
 * proof takes a long time, so it is timed only once. `context` is a struct cost_more. */
void cost_proved(const struct query *query, struct answer *answer, void *context);

#endif
