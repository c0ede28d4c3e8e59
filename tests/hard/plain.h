/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The margin of a train by plain sums of the equations, with code that shares nothing with the model. All
 * functions return margin / kinetic energy, (K - B) / K, or -1 if there is no fuel.
 */
#ifndef HARD_PLAIN_H
#define HARD_PLAIN_H

#include "domino_quad.h"

/* A train with sharp edges and without friction. */
/* A train with rounded edges, and one with friction between dominoes. */
long double plain_share_rounded(long double s, long double d, long double q, long double rho, long double r);
long double plain_share_rubbing(long double s, long double d, long double q, long double mu, long double r);

domq_real plain_share(domq_real s, domq_real d, domq_real q, domq_real r);
double plain_share_double(double s, double d, double q, double r);

/* Returns the minimum of plain_share between the growths lo and hi, by golden section, and where it is. */
domq_real plain_dip(domq_real s, domq_real d, domq_real q, double lo, double hi, domq_real *at);

/* Returns the growth at which plain_share changes from >= 0 at lo to < 0 at hi. */
domq_real plain_root(domq_real s, domq_real d, domq_real q, domq_real lo, domq_real hi);

/* Returns r_max, or 0 if there is none: the first negative margin at growths that differ by `ratio`, or at
 * the minima between them, which are found in the widest type where they are close to 0. */
double plain_rmax(double s, double d, double q, double ratio);

#endif
