/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rough computation of the motion of heads with friction. Eight evaluations of the equation of motion give
 * the motion of a head to a few digits, with an estimate of the error. Most verdicts need no more. */
#ifndef DOM_SLIDE_H
#define DOM_SLIDE_H

#include "geometry/chain.h"

/* The tolerance of the sums in rough motions. */
#define SLIDE_TOL ((real)1e-6)

struct slide {
    struct num_rough flow;
    real off; /* the largest possible error of omegasq of the current head */
};

/* Returns the relative error of omegasq that the tolerance of the sums causes. */
KERNEL real slide_error(const struct geometry *head);

/* Returns true if the head certainly reaches the tilt 2 atan hi. All dominoes must be plumb, and all contacts
 * must push. */
KERNEL bool slide_passes(struct slide *s, const struct geometry *head, real hi, real omegasq);

/* Finds omegasq at the end of the motion of the head, and the possible error of omegasq. All dominoes must be
 * plumb, and all contacts must push. Returns false if the head may come to rest before the end. */
KERNEL bool slide_goes(struct slide *s, const struct geometry *head, real omegasq, real *after,
                       real *after_off);

/* Returns true if the sign of the margin is certain in spite of the error of omegasq. */
KERNEL bool slide_sure(const struct slide *s, real omegasq, real margin, real kinetic);

#endif
