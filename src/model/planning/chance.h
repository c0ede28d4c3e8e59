/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The share of random rows that do not fall, as a smooth function of the measures of the row. */
#ifndef DOM_CHANCE_H
#define DOM_CHANCE_H

#include "planning/shape.h"

struct chance {
    const struct shape *shape;
    struct dom_compute compute;
    struct dom_placement placement; /* its rows are those that are run */
    /* The numbers, counted from 0, of the rows that are run; the others are known to fall. If NULL, all rows
     * are run. */
    const size_t *row;
    size_t rows;
    /* A row whose margin is z falls with the probability Phi(z / width), where the margin is the smallest
     * ln(kinetic / barrier) of its dominoes. A smaller width is closer to counting. */
    double width;
};

/* Finds the share of the rows that do not fall and, unless by_gap is NULL, its derivatives by the gap before
 * each domino, in 1/m, and by the logarithm of the size of each domino. */
enum dom_status chance_find(const struct chance *chance, const struct dom_domino *domino, double *fails,
                            double *by_gap, double *by_size);

/* Finds the margin of each row. */
enum dom_status chance_margins(const struct chance *chance, const struct dom_domino *domino, double *margin);

#endif
