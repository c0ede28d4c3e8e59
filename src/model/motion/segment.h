/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A part of the motion of one head, from a state at lo to hi, by the law of motion of its geometry. The cycle
 * of a train is one segment, whose barrier has an edge where a domino detaches. In a row a segment ends at
 * that edge.
 */
#ifndef DOM_SEGMENT_H
#define DOM_SEGMENT_H

#include "energy/barrier.h"

struct moving; /* forces.c */

/* Memory for a list of moving dominoes. It starts as {0}, and the owner frees the list. */
struct room {
    struct moving *list;
    size_t size;
};

struct segment {
    struct geometry geometry; /* geometry.n: number of moving dominoes */
    real lo, hi;              /* tilts of the head, in rad */
    struct start start;       /* the state at lo */
    size_t summed;            /* number of dominoes in start.J; 0 if J is not known yet */
    real gain;                /* d omegasq / d omegasq(launch) */
    real inertia_ratio;       /* of the collision that begins the segment; 0 if no collision does */
    bool locks;               /* friction locks the motion at hi */
    struct barrier barrier;   /* from lo to hi */
    struct sums end;          /* the sums at hi, relative to lo, which segment_next finds */
    struct room *room;        /* for forces; may be NULL */
    enum dom_status status;   /* status of the function that is searched or integrated */
};

/* Ends the segment at the tilt where a domino detaches. *stay gets the number of dominoes that move on. */
KERNEL enum dom_status segment_cut(struct segment *segment, size_t *stay);

/*
 * Begins a segment from its geometry, lo, hi, gain and start: finds the barrier, and J of the moving
 * dominoes. If friction locks the motion, the segment ends at that tilt.
 */
KERNEL enum dom_status segment_begin(struct segment *segment);

/*
 * Finds segment->end, and begins the next segment at that tilt with the dominoes that move on. Its omegasq is
 * linear in omegasq of the launch. It is negative if the energy is used up earlier, and then tells how much
 * is missing.
 */
KERNEL enum dom_status segment_next(struct segment *segment, struct segment *next);

/* Finds whether a motion that locks at hi is braked there. If so, no motion reaches hi. */
KERNEL enum dom_status segment_braked(const struct segment *segment, bool *braked);

/* Finds tau^2 omega^2 at a tilt, with its error bound unless error is NULL. */
KERNEL enum dom_status segment_speed(const struct segment *segment, real theta, real *omegasq, real *error);

/*
 * Finds the tilt at which a motion that stops has used up its energy. With friction the solution of the
 * motion may end at that tilt afterwards.
 */
KERNEL enum dom_status segment_rest(struct segment *segment, real *theta);

/* Return 1 / (tau omega) at a tilt, and the bound of its error, for integrals. The context is the segment. */
KERNEL real slowness(real theta, void *context);
KERNEL real slowness_error(real theta, void *context);

/*
 * Integrates f, which is as smooth as the slowness, from one tilt to another, piece by piece between the
 * edges of the barrier. *error, unless it is NULL, gets a bound of the error.
 */
KERNEL enum dom_status segment_integral(struct segment *segment, num_function *f, real from, real to,
                                        real tol, real *sum, real *error);

/* Finds the duration of the segment in tau of the head. The duration grows like ln(1/margin) and is NaN if
 * the margin is 0 to rounding. */
KERNEL enum dom_status segment_time(struct segment *segment, real *time);

#endif
