/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A part of the way of one head, between two tilts where a domino falls off: from a state at lo to hi, by
 * energy (c3), or by the equation of motion where dominoes rub.
 */
#ifndef DOM_SEGMENT_H
#define DOM_SEGMENT_H

#include "energy/barrier.h"
#include "motion/floor.h"

struct segment {
    struct geometry geometry; /* n: dominoes that move */
    struct tilt from;
    real lo, hi;
    real J, omegasq;    /* at lo */
    real gain;          /* d omegasq / d omegasq at the launch */
    real inertia_ratio; /* of the collision that it begins with; 0 for none */
    bool locks;         /* friction locks at hi */
    struct barrier barrier;
    enum dom_status status; /* of what is being searched or integrated */
};

/* Ends the stretch where a domino falls off; *stay move on from there. */
KERNEL enum dom_status segment_cut(struct segment *segment, size_t *stay);

/* From from, lo, hi, J, omegasq, gain: its barrier, and J of those that move now.  It ends where it locks. */
KERNEL enum dom_status segment_begin(struct segment *segment);

/*
 * Where it ends begins the next one, of those that move on from there.  Its omegasq is linear in that at the
 * launch, and negative where the motion is used up before: so much is missing to come as far.
 */
KERNEL enum dom_status segment_next(struct segment *segment, struct segment *next);

/* Does what locks there push back?  Then no motion comes to hi. */
KERNEL enum dom_status segment_braked(const struct segment *segment, bool *braked);

/* At lo, in m g h / 2 of the head. */
KERNEL real segment_kinetic(const struct segment *segment);

/* H(theta) - H(lo), and J; NaN with a status. */
KERNEL real segment_climbed(struct segment *segment, real theta, real *J);

/* tau^2 omega^2 at a tilt; NaN with a status. */
KERNEL real segment_speed(struct segment *segment, real theta);

/* Where the motion is used up. */
KERNEL enum dom_status segment_rest(struct segment *segment, real *theta);

/* In tau of the head; NaN where the margin is 0 to rounding, since it grows like ln(1/margin). */
KERNEL enum dom_status segment_time(struct segment *segment, real *time);

/* For floor_over: how the chain moves at a tilt. */
KERNEL enum dom_status segment_kinematics(real theta, struct tilt *head, struct kinematics *kinematics,
                                          void *segment);

/* The smallest contact force at a few tilts up to `to`, in weights of the dominoes that it is on. */
KERNEL enum dom_status segment_contact(struct segment *segment, real to, real *least);

#endif
