/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sentences and cells about a row that falls. */
#ifndef SHELL_FALLING_H
#define SHELL_FALLING_H

#include "interpreter/command.h"

/* Returns a cell for a narrow column: a number in this many digits, without an error bound. */
struct cell cell_narrow(domq_real value, int digits);

/* Returns "74 %", with enough digits to differ from 100 %, for a share of something that is needed. */
struct measured share_text(domq_real share);

/* Returns "96 % of the energy that it needs", or "12 times the energy that it needs". */
struct words {
    char text[96];
};
struct words energy_words(domq_real share);

/* Returns "All 8 fall", "Both fall" or "It falls". */
struct words all_fall_words(size_t count);

/* Returns the energy of a domino that is hit, as a share of the energy that it needs; NaN if it needs none.
 */
domq_real fall_share(const struct domq_fall *fall);

/* Prints how a row ends. last: the last domino that was hit; timed: times are known. */
void verdict_say(struct answer *answer, const struct scene_row *scene, const struct domq_verdict *verdict,
                 const struct domq_fall *last, bool timed);

/* Reports a status that is not DOM_OK; also a status of dominoes, which the precision cannot hold. */
bool row_status(const struct query *query, struct problem *problem, enum dom_status status);

/* Says why a row stops that could not fall with any energy. */
extern const char locks_farther_on[];

#endif
