/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws a random row: a copy of a row with random errors. Studies and budgets run many such rows. */
#ifndef DOM_DRAW_H
#define DOM_DRAW_H

#include "numerics/api.h"
#include <gsl/gsl_rng.h>

struct draw {
    gsl_rng *random[2];
    struct dom_domino *domino; /* the dominoes with their random errors */
    /* The row of these dominoes, whose friction, slope and push have random errors as well. */
    struct dom_row row;
};

/* Allocates the memory for rows with as many dominoes as this one. draw_end frees the memory and must be
 * called after a failure, too. */
enum dom_status draw_begin(struct draw *draw, const struct dom_row *row);
void draw_end(struct draw *draw);

/* Draws row number i. The kinds of error whose bit 1 << kind is set in `off` are left out, which does not
 * change the errors of the other kinds. */
void draw_row(struct draw *draw, const struct dom_row *row, const struct dom_placement *placement, size_t i,
              unsigned off);

/* Returns true if the rows of a placement differ only in their gaps. */
bool draws_gaps(const struct dom_placement *placement);

/* Returns the steepest slope on which all dominoes of a row stand with their leans, in rad. */
dom_real row_steepest(const struct dom_row *row);

#endif
