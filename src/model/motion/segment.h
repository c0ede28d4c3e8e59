/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A part of the way of one head, from a state at lo to hi, by the law of motion of its geometry.  The cycle
 * of a train is one segment, whose barrier has the edge where a domino detaches; in a row each segment ends
 * there.
 */
#ifndef DOM_SEGMENT_H
#define DOM_SEGMENT_H

#include "energy/barrier.h"

struct moving; /* forces.c */

/* Memory for a list of moving dominoes; begins as {0}, and its list is the owner's to free. */
struct room {
    struct moving *list;
    size_t size;
};

struct segment {
    struct geometry geometry; /* n: dominoes that move */
    real lo, hi;              /* tilts of the head, in rad */
    struct start start;       /* the state at lo */
    real gain;                /* d omegasq / d omegasq at the launch */
    real inertia_ratio;       /* of the collision that the segment begins with; 0 for none */
    bool locks;               /* friction locks at hi */
    struct barrier barrier;   /* from lo to hi */
    struct room *room;        /* for forces; NULL for none */
    enum dom_status status;   /* of what is being searched or integrated */
};

/* Ends the segment where a domino detaches; *stay dominoes move on from there. */
KERNEL enum dom_status segment_cut(struct segment *segment, size_t *stay);

/*
 * From geometry, lo, hi, gain and start: finds the barrier, and J of the dominoes that move now.  The segment
 * ends where it locks.
 */
KERNEL enum dom_status segment_begin(struct segment *segment);

/*
 * Begins the next segment where this one ends, of the dominoes that move on from there.  Its omegasq is
 * linear in that at the launch, and negative where the motion is used up before: so much is missing to come
 * as far.
 */
KERNEL enum dom_status segment_next(struct segment *segment, struct segment *next);

/* Finds whether what locks at hi pushes back: then no motion comes to hi. */
KERNEL enum dom_status segment_braked(const struct segment *segment, bool *braked);

/* H(theta) - H(lo), and J; NaN with a status. */
KERNEL real segment_climbed(struct segment *segment, real theta, real *J);

/* tau^2 omega^2 at a tilt, and unless error is NULL the bound of its error. */
KERNEL enum dom_status segment_speed(const struct segment *segment, real theta, real *omegasq, real *error);

/*
 * Finds the tilt where the energy is used up, of a motion that stops.  With friction the solution of the
 * motion may not reach farther than that any more.
 */
KERNEL enum dom_status segment_rest(struct segment *segment, real *theta);

/* 1 / (tau omega) at a tilt, and the bound of its error, for integrals; context is the segment. */
KERNEL real slowness(real theta, void *context);
KERNEL real slowness_error(real theta, void *context);

/*
 * Integrates f, which is as smooth as the slowness, from one tilt to another, piece by piece between the
 * edges of the barrier; unless NULL, error gets the bound.
 */
KERNEL enum dom_status segment_integral(struct segment *segment, num_function *f, real from, real to,
                                        real tol, real *sum, real *error);

/* In tau of the head; NaN where the margin is 0 to rounding, since it grows like ln(1/margin). */
KERNEL enum dom_status segment_time(struct segment *segment, real *time);

#endif
