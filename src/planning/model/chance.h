/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the fraction of random rows that do not fall. The fraction is smoothed, so that it has derivatives
 * with respect to the gaps and the sizes of the dominoes. A search for a better row needs these
 * derivatives. */
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

/*
 * Stores in *fails the smoothed fraction of the random rows that do not fall. If by_gap is not NULL, also
 * finds the derivatives of this fraction:
 * - by_gap[k] is the derivative with respect to the gap before domino k, in 1/m.
 * - by_size[k] is the derivative with respect to the logarithm of the size of domino k.
 */
enum dom_status chance_find(const struct chance *chance, const struct dom_domino *domino, double *fails,
                            double *by_gap, double *by_size);

/*
 * Finds 2 * count margins for each random row, where `count` is the number of dominoes:
 * - The first `count` margins are the energy margins of the dominoes: ln(kinetic energy / barrier).
 * - The others are the margins of reach: 1 - gap / (height of the domino before the gap).
 */
enum dom_status chance_margins(const struct chance *chance, const struct dom_domino *domino, double *margin);

#endif
