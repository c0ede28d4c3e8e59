/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'row', which lists dominoes, and what other lists of dominoes share with it. */
#ifndef SHELL_LISTING_H
#define SHELL_LISTING_H

#include "commands/rows/falling.h"
#include "interpreter/command.h"

extern const struct column row_columns[];
bool run_row(const struct query *query, struct answer *a, struct problem *problem);

/* Chooses the units of lengths and masses by the largest domino. */
void row_largest(struct answer *answer, const struct scene_row *scene);

#endif
