/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The model in long double, quick and by plain formulas. It finds where to search (how many maxima H has,
 * near which tilt), never what the answer is.
 */
#ifndef HARD_SKETCH_H
#define HARD_SKETCH_H

#include "reference.h"

enum { SKETCH_NODES = 256 };

struct sketch {
    long double s, r, d, q, L, theta_c, theta_f, theta_leave, rq, cut;
    bool detaches, paper;
    size_t dominoes;
};

struct sketch sketch_of(const struct ref *ref);
/* Returns dH / d tilt. */
long double sketch_slope(const struct sketch *sketch, long double tilt);
/* Returns H(tilt) - H(0). */
long double sketch_energy_change(const struct sketch *sketch, long double tilt);
/* Finds tilts from 0 to theta_c, ascending, dense where H may have features; returns their number. */
int sketch_nodes(const struct sketch *sketch, long double node[SKETCH_NODES]);
/* Returns the tilt at which a follower detaches: of the leader that begins below theta_leave and ends
 * above. */
long double sketch_leaving(const struct sketch *sketch);
/* Returns the train with another r. */
struct sketch sketch_grown(const struct sketch *sketch, long double r);
/* Finds kinetic energy and barrier; false without fuel. */
bool sketch_verdict(const struct sketch *sketch, long double *kinetic, long double *barrier);

#endif
