/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A part of the motion of one head, from a state at lo to hi, by the law of motion of its geometry. The cycle
 * of a train is one segment, whose barrier has an edge where a domino detaches; in a row a segment ends
 * there.
 */
#ifndef DOM_SEGMENT_H
#define DOM_SEGMENT_H

#include "energy/barrier.h"

struct moving; /* forces.c */

/* Memory for a list of moving dominoes. Begins as {0}; the owner frees the list. */
struct room {
    struct moving *list;
    size_t size;
};

struct segment {
    struct geometry geometry; /* geometry.n: number of moving dominoes */
    real lo, hi;              /* tilts of the head, in rad */
    struct start start;       /* the state at lo */
    size_t summed;            /* dominoes in start.J; 0: not yet known */
    real gain;                /* d omegasq / d omegasq at the launch */
    real inertia_ratio;       /* of the collision that the segment begins with; 0: none */
    bool locks;               /* true: friction locks at hi */
    struct barrier barrier;   /* from lo to hi */
    struct sums end;          /* at hi, from lo; segment_next finds them */
    struct room *room;        /* for forces; NULL: none */
    enum dom_status status;   /* status of the function that is searched or integrated */
};

/* Ends the segment where a domino detaches; *stay dominoes move on from there. */
KERNEL enum dom_status segment_cut(struct segment *segment, size_t *stay);

/*
 * Begins a segment from its geometry, lo, hi, gain and start: finds the barrier, and J of the moving
 * dominoes. If friction locks, the segment ends there.
 */
KERNEL enum dom_status segment_begin(struct segment *segment);

/*
 * Finds segment->end, and begins the next segment there, with the dominoes that move on. Its omegasq is
 * linear in that at the launch. It is negative where the energy is used up before: the amount that is
 * missing.
 */
KERNEL enum dom_status segment_next(struct segment *segment, struct segment *next);

/* Finds whether the motion is braked where it locks at hi: then no motion reaches hi. */
KERNEL enum dom_status segment_braked(const struct segment *segment, bool *braked);

/* Finds tau^2 omega^2 at a tilt, with its error bound unless error is NULL. */
KERNEL enum dom_status segment_speed(const struct segment *segment, real theta, real *omegasq, real *error);

/*
 * Finds the tilt where a motion that stops has used up its energy. With friction the solution of the motion
 * may then end at that tilt.
 */
KERNEL enum dom_status segment_rest(struct segment *segment, real *theta);

/* Returns 1 / (tau omega) at a tilt, or the bound of its error, for integrals. context is the segment. */
KERNEL real slowness(real theta, void *context);
KERNEL real slowness_error(real theta, void *context);

/*
 * Integrates f from one tilt to another, piece by piece between the edges of the barrier. f is as smooth as
 * the slowness. *error, unless NULL, gets the bound.
 */
KERNEL enum dom_status segment_integral(struct segment *segment, num_function *f, real from, real to,
                                        real tol, real *sum, real *error);

/* Finds the duration of the segment in tau of the head; NaN where the margin is 0 to rounding, since the
 * duration grows like ln(1/margin). */
KERNEL enum dom_status segment_time(struct segment *segment, real *time);

#endif
