/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limits of growth in many bits: bracketed from scratch, or checked where somebody says they are. */
#ifndef HARD_GROWTH_H
#define HARD_GROWTH_H

#include "reference.h"

struct growth {
    bool grows;    /* false where r = 1 does not go on */
    bool by_reach; /* r_max = 1/s */
    domq_real r_max;
    double scale; /* see reference.h: for the inputs s, d and q, and the terms of the margin */
};

/* The first r, raised from 1 (input->r is ignored), with margin 0.  pair: of two dominoes. */
struct growth growth_find(const struct ref_input *input, bool pair, int digits2);

/*
 * A claim that the margin is 0 at r: by how much r is wrong (with sign, to first order), and the scale.
 * NaN where there is no margin.
 */
double growth_error(const struct ref_input *input, bool pair, int digits2, domq_real r, double *scale);

/*
 * |error| where the margin is so curved that first order is far off: bracketed in steps of 4 from delta on,
 * then bisected.
 */
double growth_distance(const struct ref_input *input, bool pair, int digits2, domq_real r, double delta);

/* The margin over K + B: a sign with a size; NaN without fuel. */
double growth_margin(const struct ref_input *input, bool pair, int digits2, domq_real r);

#endif
