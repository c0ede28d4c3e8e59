/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The margin of a train by plain sums of the equations, with code that shares nothing with the model. All
 * functions return margin / kinetic energy, (K - B) / K, or -1 if there is no fuel.
 */
#ifndef HARD_PLAIN_H
#define HARD_PLAIN_H

#include "domino_quad.h"

/* A train with sharp edges and without friction. */
domq_real plain_share(domq_real s, domq_real d, domq_real q, domq_real r);
double plain_share_double(double s, double d, double q, double r);

#endif
