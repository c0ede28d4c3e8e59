/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limits of growth in many bits: bracketed from scratch, or checked at a given r. */
#ifndef HARD_GROWTH_H
#define HARD_GROWTH_H

#include "reference.h"

struct growth {
    bool grows;    /* false if r = 1 does not go on */
    bool by_reach; /* r_max = 1/s */
    domq_real r_max;
    double scale; /* see reference.h: for the inputs s, d and q, and the terms of the margin */
};

/* Finds the first r, raised from 1, with margin 0; input->r is not used. pair: for two dominoes. */
struct growth growth_find(const struct ref_input *input, bool pair, int digits2);

/*
 * Returns the error of a claim that the margin is 0 at r (with sign, to first order), and finds the scale.
 * NaN if there is no margin.
 */
double growth_error(const struct ref_input *input, bool pair, int digits2, domq_real r, double *scale);

/*
 * Returns |error| where the margin is so curved that first order is wrong: brackets the root in steps of 4
 * from delta on, then bisects.
 */
double growth_distance(const struct ref_input *input, bool pair, int digits2, domq_real r, double delta);

/* Returns the margin over K + B: a sign with a size; NaN without fuel. */
double growth_margin(const struct ref_input *input, bool pair, int digits2, domq_real r);

#endif
