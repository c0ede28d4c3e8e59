/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A second opinion on finite rows, for the tests only: constrained rigid bodies, Newton's equations for all
 * angular accelerations and contact forces at once, integrated numerically. It shares no formula with the
 * model. SI units throughout.
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
    double omega; /* angular velocity given to the first domino, upright at time 0 */
    double slope; /* rad, by which the floor falls towards the later dominoes */
};

struct direct_hit {
    double time;           /* when it was hit; 0 for the first */
    double omega_before;   /* of the hitting domino just before; 0 for the first */
    double omega;          /* of this domino just after */
    double kinetic;        /* of all moving dominoes just after */
    double kinetic_before; /* just before; for the first the same as kinetic: nothing is lost there */
    double potential;      /* of all dominoes that have not fallen off, those still upright included */
    double friction_work;  /* lost to sliding friction in the motion since the start */
};

struct direct_result {
    size_t hit; /* dominoes that were hit, the first included */
    bool all_fall;
    double end_time;    /* the last domino is flat, or the head comes to rest */
    double least_force; /* least normal force between two dominoes; INFINITY if two never leaned */
    size_t least_at;    /* ... between dominoes least_at and least_at + 1 (from 1); 0 if none */
    size_t least_head;  /* ... while domino least_head (from 1) was the foremost one */
    double stop_theta;  /* of the head at the end; pi/2 and not all_fall: it fell past the next one */
};

/*
 * Fills hits[0 .. result->hit - 1]. Returns 0, or what went wrong as a sentence; hits made before that stay.
 * A tip that arrives above the top of the next domino is refused: that contact is of another kind.
 * A blow within mu times the thickness of the bottom of the struck face cannot turn that domino: the friction
 * it calls up holds tip and face together, and the row stops there and then, at stop_theta 0.
 * Negative contact forces are not refused (the contact then pulls): look at least_force.
 */
const char *direct_run(const struct direct_row *row, struct direct_hit *hits, struct direct_result *result);

#endif
