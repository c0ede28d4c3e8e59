/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rough computation of a head's motion with friction. Eight evaluations of the equation of motion give a
 * few digits and an error estimate, which suffice for most verdicts. */
#ifndef DOM_ROUGH_H
#define DOM_ROUGH_H

#include "geometry/chain.h"

/* The relative tolerance of sums along the chain in a rough computation. */
#define ROUGH_TOL ((real)1e-6)

struct rough_motion {
    struct num_rough flow;
    real off; /* bound on the error in the omegasq of the current head */
};

/* Returns the relative error in omegasq that is caused by the tolerance of the sums. */
KERNEL real rough_error(const struct geometry *head);

/* Returns true if the head certainly reaches the tilt 2 atan hi. The dominoes must be plumb, and no contact
 * force may be negative. */
KERNEL bool rough_reaches(struct rough_motion *s, const struct geometry *head, real hi, real omegasq);

/* Sets *after to omegasq at the end of the motion, and *after_off to a bound on its error. Returns false if
 * the head may come to rest earlier. The dominoes must be plumb, and no contact force may be negative. */
KERNEL bool rough_descend(struct rough_motion *s, const struct geometry *head, real omegasq, real *after,
                          real *after_off);

/* Returns true if the sign of the margin is certain in spite of the error in omegasq. */
KERNEL bool rough_sure(const struct rough_motion *s, real omegasq, real margin, real kinetic);

#endif
