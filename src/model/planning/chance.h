/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The share of random rows that do not fall, as a smooth function of the gaps and sizes of the row. */
#ifndef DOM_CHANCE_H
#define DOM_CHANCE_H

#include "planning/shape.h"

struct chance {
    const struct shape *shape;
    struct dom_compute compute;
    struct dom_placement placement; /* the errors and the numbers of the random rows */
    /* The indices of the `rows` rows that are run, while the others are known to fall. If NULL, all rows are
     * run. */
    const size_t *row;
    size_t rows;
    /* A row with the margin z counts as falling with the probability Phi(z / width). Its margin is the
     * smallest ln(kinetic / barrier) of its dominoes. The smaller the width, the closer is the sum to a plain
     * count. */
    double width;
};

/* Finds the share of the rows that do not fall. Unless by_gap is NULL, also finds the derivatives of this
 * share with respect to the gap before each domino, in 1/m, and to the logarithm of the size of each
 * domino. */
enum dom_status chance_find(const struct chance *chance, const struct dom_domino *domino, double *fails,
                            double *by_gap, double *by_size);

/* Finds the margin of each row. */
enum dom_status chance_margins(const struct chance *chance, const struct dom_domino *domino, double *margin);

#endif
