/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws random rows: copies of a row with random errors. */
#pragma once

#include "rows/model/boxes.h"
#include <gsl/gsl_rng.h>

struct draw {
    gsl_rng random[2];
    struct dom_domino *domino; /* the dominoes of the random row */
    struct dom_row row;        /* the random row; its friction, slope, floor and push may have errors too */
};

/* Draws random row number i. */
void draw_row(struct draw *draw, const struct dom_row *row, const struct dom_placement *placement, size_t i);

/* Runs a random row. Of the verdict only `end` and `domino` count. */
enum dom_status draw_verdict(const struct dom_row *row, const struct dom_compute *compute,
                             struct dom_verdict *verdict);

/* Returns the steepest slope, in rad, on which no domino of a row falls over by itself. */
double row_steepest(const struct dom_row *row);

/*
 * Calls visit(draw, i, context) for i from 0 to placement->rows - 1, in batches that run in parallel if the
 * placement can. The visit draws random rows of `row` into *draw. All visits of a batch share *draw. After a
 * visit that returns another status than DOM_OK, no batch begins, and this status is returned.
 */
typedef enum dom_status draw_visit(struct draw *draw, size_t i, void *context);
enum dom_status draw_run(const struct dom_row *row, const struct dom_placement *placement, draw_visit *visit,
                         void *context);
