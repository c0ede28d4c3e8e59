/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Words, numbers and errors about a row that falls. */
#ifndef SHELL_FALLING_H
#define SHELL_FALLING_H

#include "interpreter/command.h"

/* Returns a cell with so many digits in a table; no bound of its error is known. */
struct cell cell_narrow(domq_real value, int digits);

/* Rounds a positive number to so many significant digits, up or down. Returns any other number as it is. */
domq_real round_digits(domq_real value, int digits, bool up);

struct words {
    char text[CELL_TEXT + 40];
};

/* Returns "96 % of the energy that it needs", or "12 times the energy that it needs". */
struct words energy_words(domq_real share);

/* Returns "All 8 fall", "Both fall" or "It falls". */
struct words all_fall_words(size_t count);

/* Returns the energy of a domino that is hit, as a share of the energy that it needs to go on. Returns NaN if
 * it needs none, or if no energy is enough. */
domq_real fall_share(const struct domq_fall *fall);

/* Says which domino has the least energy to spare, if one is known. */
void weakest_say(struct answer *answer, const struct domq_verdict *verdict);

/* Describes why there is no answer about the row of the scene: any status but DOM_OK. Returns false. */
bool row_status(const struct query *query, struct problem *problem, enum dom_status status);

#endif
