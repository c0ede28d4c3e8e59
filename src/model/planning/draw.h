/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One random row: what a study, a budget and a search for a better row run again and again. */
#ifndef DOM_DRAW_H
#define DOM_DRAW_H

#include "numerics/api.h"
#include <gsl/gsl_rng.h>

struct draw {
    gsl_rng *random[2];
    struct dom_domino *domino; /* the dominoes that were drawn */
    struct dom_row row;        /* the row of these dominoes, with the common values that were drawn */
};

/* Takes the memory for rows like this one. draw_end frees it, also after a failure. */
enum dom_status draw_begin(struct draw *draw, const struct dom_row *row);
void draw_end(struct draw *draw);

/* Draws row number i. The errors whose bit 1 << kind is set in `off` are left out, and all others are the
 * same as without that. */
void draw_row(struct draw *draw, const struct dom_row *row, const struct dom_placement *placement, size_t i,
              unsigned off);

/* Returns true if only gaps differ between the rows of a placement. */
bool draws_gaps(const struct dom_placement *placement);

/* Returns the steepest slope on which all dominoes of a row stand with their leans, in rad. */
dom_real row_steepest(const struct dom_row *row);

#endif
