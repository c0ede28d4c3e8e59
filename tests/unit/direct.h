/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finite rows by another method, for the tests alone: constrained rigid bodies, Newton's equations for all
 * angular accelerations and contact forces together, integrated numerically. This file shares no formula with
 * the model. SI units throughout.
 */
#ifndef DIRECT_H
#define DIRECT_H

#include <stdbool.h>
#include <stddef.h>

/* gap[k] is the free gap between dominoes k - 1 and k; gap[0] is not read. */
struct direct_row {
    size_t n;
    const double *height, *thickness, *gap, *mass;
    double mu, g;
    double omega;       /* angular velocity given to the first domino at time 0 */
    double slope;       /* rad, by which the floor falls towards the later dominoes */
    double walls;       /* of boxes half as wide as tall, of one density; 0: solid blocks */
    const double *lean; /* rad, tilts before the hits; NULL: all are upright */
};

struct direct_hit {
    double time;           /* when it was hit; 0 for the first */
    double omega_before;   /* of the hitting domino just before; 0 for the first */
    double omega;          /* of this domino just after */
    double kinetic;        /* of all moving dominoes just after */
    double kinetic_before; /* just before; for the first domino equal to kinetic: no energy is lost there */
    double potential;      /* of all dominoes that have not detached, including upright ones */
    double friction_work;  /* lost to sliding friction in the motion since the start */
};

struct direct_result {
    size_t hit; /* number of dominoes that were hit, including the first */
    bool all_fall;
    double end_time;    /* the last domino is flat, or the head comes to rest */
    double least_force; /* smallest normal force between two dominoes; INFINITY if there was no contact */
    size_t least_at;    /* ... between dominoes least_at and least_at + 1 (from 1); 0 if none */
    size_t least_head;  /* ... while domino least_head (from 1) was the foremost one */
    double stop_theta;  /* of the head at the end; pi/2 and not all_fall: it fell past the next one */
};

/*
 * Fills hits[0 .. result->hit - 1]. Returns 0, or a sentence about the error; hits before the error stay. A
 * tip that arrives above the top of the next domino is an error: that contact is of another kind. A collision
 * within mu times the thickness of the bottom of the struck face cannot turn that domino: its friction holds
 * tip and face together, and the row stops there, at stop_theta 0. Negative contact forces (the contact then
 * pulls) are no error: check least_force.
 */
const char *direct_run(const struct direct_row *row, struct direct_hit *hits, struct direct_result *result);

#endif
