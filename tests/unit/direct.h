/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finite rows by another method, used only in tests: Newton's equations for constrained rigid bodies are
 * solved for all angular accelerations and contact forces together, and integrated numerically. This file
 * shares no formula with the model. All numbers are in SI units.
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
    /* Angular velocity given to the first domino at time 0. If it is 0, the first domino falls only if its
     * lean makes it fall. */
    double omega;
    double slope; /* angle in rad by which the floor descends towards the later dominoes */
    double walls,
        boxes_above;     /* thickness of the walls, or 0; only blocks taller than boxes_above have them */
    const double *width; /* width[k] is 0 if domino k is half as wide as it is tall */
    /* density of the air, and drag coefficient; the air acts on a plate without thickness */
    double air, drag;
    const double *lean; /* tilts in rad before the hits; NULL if all dominoes are upright */
};

struct direct_hit {
    double time; /* time of the hit; 0 for the first domino */
    /* angular velocity of the hitting domino just before the hit; 0 for the first domino */
    double omega_before;
    double omega;   /* angular velocity of this domino just after the hit */
    double kinetic; /* kinetic energy of all moving dominoes just after the hit */
    /* kinetic energy just before the hit; for the first domino, which loses none, equal to `kinetic` */
    double kinetic_before;
    /* potential energy of all dominoes that have not detached, including upright ones */
    double potential;
    double friction_work; /* energy lost to sliding friction and to the air since the start */
};

struct direct_result {
    size_t hit; /* number of dominoes that were hit, including the first */
    bool all_fall;
    double end_time;    /* time at which the head lies flat or comes to rest */
    double least_force; /* smallest normal force between two dominoes; INFINITY if there was no contact */
    /* least_force is between dominoes least_at and least_at + 1, counted from 1; 0 if there is none */
    size_t least_at;
    size_t least_head; /* number, from 1, of the foremost domino at the moment of least_force */
    /* tilt of the head at the end; pi/2 if the head lies flat, even if it has missed the next domino */
    double stop_theta;
};

/*
 * Runs a row and fills hits[0 .. result->hit - 1]. Returns NULL, or a sentence about an error; the hits
 * before the error are valid. A tip that passes above the top of the next domino is an error. If a hit is
 * lower than mu times the thickness of the struck domino, friction holds the tip and the face together: the
 * struck domino does not turn, the row stops, and stop_theta is the lean of this domino. A negative contact
 * force means that the contact pulls. This is not an error, so check least_force.
 */
const char *direct_run(const struct direct_row *row, struct direct_hit *hits, struct direct_result *result);

#endif
