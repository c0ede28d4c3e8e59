/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The model in long double, computed quickly by plain formulas. It only finds where to search, for instance
 * how many maxima H has and near which tilts, and never supplies a result.
 */
#ifndef HARD_SKETCH_H
#define HARD_SKETCH_H

#include "reference.h"

enum { SKETCH_NODES = 256 };

struct sketch {
    long double s, r, d, L, theta_c, theta_f, theta_leave, rq, cut;
    bool detaches;
    size_t dominoes;
};

struct sketch sketch_of(const struct ref *ref);
/* Returns dH / d tilt. */
long double sketch_slope(const struct sketch *sketch, long double tilt);
/* Returns H(tilt) - H(0). */
long double sketch_energy_change(const struct sketch *sketch, long double tilt);
/* Finds tilts from 0 to theta_c in increasing order, which are dense where H may change fast. Returns the
 * number of these tilts. */
int sketch_nodes(const struct sketch *sketch, long double node[SKETCH_NODES]);
/* Returns the tilt of the head at which a follower detaches, because the tilt of its leader passes
 * theta_leave. */
long double sketch_leaving(const struct sketch *sketch);

#endif
