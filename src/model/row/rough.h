/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A quick, rough computation of a head's motion with friction. It evaluates the equation of motion only ROUGH
 * times. This gives a few digits of omegasq, which suffice for most verdicts, and an estimate of the error.
 */
#ifndef DOM_ROUGH_H
#define DOM_ROUGH_H

#include "geometry/chain.h"

/* The relative tolerance of sums along the chain in a rough computation. */
#define ROUGH_TOL ((real)1e-6)

struct rough_motion {
    struct num_rough flow;
    real off; /* estimate of the error in the omegasq of the current head */
};

/* Returns an estimate of the relative error in omegasq that the tolerance of the sums causes. */
KERNEL real rough_error(const struct geometry *head);

/* Let theta be the tilt with tan(theta / 2) = `hi`. Returns true if the head certainly reaches theta. All
 * dominoes must be plumb. The caller must make sure that no contact force is negative. */
KERNEL bool rough_reaches(struct rough_motion *s, const struct geometry *head, real hi, real omegasq);

/*
 * Computes the motion of a head until it hits the next domino, or the floor if it is the last. Sets *after to
 * omegasq at the hit, and *after_off to an estimate of the error in *after. Returns false if the head may
 * come to rest before the hit. The requirements are those of rough_reaches.
 */
KERNEL bool rough_descend(struct rough_motion *s, const struct geometry *head, real omegasq, real *after,
                          real *after_off);

/* Returns true if the sign of the margin is certain in spite of the error in omegasq. */
KERNEL bool rough_sure(const struct rough_motion *s, real omegasq, real margin, real kinetic);

#endif
