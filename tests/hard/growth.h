/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limits of growth in many bits. A limit is either searched from scratch, or checked at a given r. */
#ifndef HARD_GROWTH_H
#define HARD_GROWTH_H

#include "reference.h"

struct growth {
    bool grows;    /* false if even a train with r = 1 stops */
    bool by_reach; /* true if r_max = 1/s */
    domq_real r_max;
    /* scale of the error (reference.h), for the inputs s, d and q and the terms of the margin */
    double scale;
};

/* Finds the first r, raised from 1, at which the margin is 0. If `pair` is true, finds it for a train of two
 * dominoes. input->r is not used. */
struct growth growth_find(const struct ref_input *input, bool pair, int digits2);

/*
 * Returns the signed error, to first order, of the claim that the margin is 0 at r, and finds its scale.
 * Returns NaN if there is no margin.
 */
double growth_error(const struct ref_input *input, bool pair, int digits2, domq_real r, double *scale);

/*
 * Returns the absolute error for a margin so curved that the first order is wrong. Brackets the root by
 * distances from delta on, each 4 times the one before, and then bisects.
 */
double growth_distance(const struct ref_input *input, bool pair, int digits2, domq_real r, double delta);

/* Returns the margin divided by K + B, or NaN if there is no fuel. */
double growth_margin(const struct ref_input *input, bool pair, int digits2, domq_real r);

#endif
