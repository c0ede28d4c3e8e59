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

/* Allocates memory for random copies of a row. Call draw_end afterwards, even if this function fails. */
enum dom_status draw_begin(struct draw *draw, const struct dom_row *row);
void draw_end(struct draw *draw);

/* Draws random row number i. */
void draw_row(struct draw *draw, const struct dom_row *row, const struct dom_placement *placement, size_t i);

/* Returns the steepest slope, in rad, on which no domino of a row falls over by itself. */
double row_steepest(const struct dom_row *row);

/* number of random rows in a batch, large enough to make the time for memory allocation negligible */
enum { BATCH = 16 };

/* Runs all batches of random rows, in parallel if the placement can. */
enum dom_status placement_run(const struct dom_placement *placement, dom_task *batch, void *context);
