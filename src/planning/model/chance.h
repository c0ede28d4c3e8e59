/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the fraction of random rows that do not fall. The fraction is smoothed, so that a search for a
 * better row can use its derivatives. */
#ifndef DOM_CHANCE_H
#define DOM_CHANCE_H

#include "planning/model/shape.h"

struct chance {
    const struct shape *shape;
    struct dom_compute compute;
    struct dom_placement placement; /* describes the random rows */
    /* The width of the smoothing for each margin. Without smoothing, a row would either fall or not. With
     * smoothing, a row falls with a certain probability. Each margin contributes a factor to this
     * probability: Phi(margin / width), where Phi is the cumulative normal distribution. The smaller the
     * widths, the closer the probability is to 0 or 1. */
    const double *width;
};

/* Stores in fails[k] the smoothed fraction of the random rows that do not fall, for `rows` rows whose
 * dominoes are in the array `domino`, one row after the other. The rows after the first must nearly equal the
 * first. All rows have the same random errors, so that the differences of `fails` have no noise. */
enum dom_status chance_find(const struct chance *chance, const struct dom_domino *domino, size_t rows,
                            double *fails);

/*
 * Finds 2 * count margins for each random row, where `count` is the number of dominoes:
 * - The first `count` margins are the energy margins of the dominoes: ln(kinetic energy / barrier).
 * - The others are the margins of reach: 1 - gap / (height of the domino before the gap).
 */
enum dom_status chance_margins(const struct chance *chance, const struct dom_domino *domino, double *margin);

#endif
