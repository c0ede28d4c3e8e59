/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the fraction of random rows that do not fall, as a smooth function of gaps and sizes. */
#ifndef DOM_CHANCE_H
#define DOM_CHANCE_H

#include "planning/shape.h"

struct chance {
    const struct shape *shape;
    struct dom_compute compute;
    struct dom_placement placement; /* describes the random rows */
    /* The width of the smoothing for each margin. Each margin contributes a factor Phi(margin / width)
     * to the probability that a row falls, where Phi is the normal distribution. Small widths make this
     * probability nearly 0 or 1. */
    const double *width;
};

/*
 * Finds the smoothed fraction of the rows that do not fall. Unless by_gap is NULL, also finds its
 * derivatives:
 * - by_gap[k], with respect to the gap before domino k, in 1/m
 * - by_size[k], with respect to the logarithm of the size of domino k
 */
enum dom_status chance_find(const struct chance *chance, const struct dom_domino *domino, double *fails,
                            double *by_gap, double *by_size);

/*
 * Finds 2 * count margins for each random row. The first `count` are the energy margins ln(kinetic / barrier)
 * of the dominoes. The others are the margins of reach: 1 - gap / (height of the domino before the gap).
 */
enum dom_status chance_margins(const struct chance *chance, const struct dom_domino *domino, double *margin);

#endif
