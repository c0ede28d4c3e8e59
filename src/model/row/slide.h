/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heads with friction, roughly. Eight evaluations of the equation of motion give the motion of a head to a
 * few digits, with an estimate of the error; most verdicts need no more.
 */
#ifndef DOM_SLIDE_H
#define DOM_SLIDE_H

#include "geometry/chain.h"

/* The tolerance of the sums in rough motions. */
#define SLIDE_TOL ((real)1e-6)

struct slide {
    struct num_rough flow;
    real off; /* possible error of omegasq of the present head */
};

/* Returns the relative error that the tolerance of the sums leaves to omegasq. */
KERNEL real slide_error(const struct geometry *head);

/* Returns true if a plain head, whose contacts all push, surely gets to the tilt 2 atan hi. */
KERNEL bool slide_passes(struct slide *s, const struct geometry *head, real hi, real omegasq);

/*
 * Finds omegasq of a plain head at its end, whose contacts all push, and its possible error. Returns false if
 * it may not get there.
 */
KERNEL bool slide_goes(struct slide *s, const struct geometry *head, real omegasq, real *after,
                       real *after_off);

/* Returns true if an energy `margin` of `kinetic` has a sign despite the error of omegasq. */
KERNEL bool slide_sure(const struct slide *s, real omegasq, real margin, real kinetic);

#endif
