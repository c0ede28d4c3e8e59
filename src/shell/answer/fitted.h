/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row of an answer just before it is written: what cannot be written as it is, and why. */
#ifndef SHELL_FITTED_H
#define SHELL_FITTED_H

#include "answer/answer.h"

/* What a row refers to while it is written. */
struct fitted {
    char *own[ANSWER_COLUMNS]; /* escaped words, and the reason behind the last of them; NULL for none */
    char lost[ANSWER_REASON];
};

/*
 * Makes cells of numbers that the precision cannot hold empty, and escapes words, which json escapes itself.
 * Returns the reason that the row is to have; where it has no place for one, answer_unsaid has it.
 */
const char *row_fit(struct answer *answer, struct cell *shown, const char *reason, struct fitted *fitted);
void fitted_free(struct fitted *fitted);

#endif
