/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A segment is a part of the motion of one head, from the tilt lo to the tilt hi. In a row, a segment ends
 * where a domino detaches, where friction locks the motion, or with the next hit. The cycle of a train is a
 * single segment.
 */
#ifndef DOM_SEGMENT_H
#define DOM_SEGMENT_H

#include "energy/barrier.h"

struct moving; /* forces.c */

/* Memory for a list of moving dominoes. Initialise it to {0}; the owner frees the list. */
struct room {
    struct moving *list;
    size_t size;
};

struct segment {
    struct geometry geometry; /* geometry.n is the number of moving dominoes */
    real lo, hi;              /* tilts of the head, in rad */
    struct start start;       /* the state at lo */
    size_t summed;            /* number of dominoes that start.J includes, or 0 if J is not known yet */
    real gain;                /* derivative of start.omegasq with respect to omegasq at the launch */
    /* Inertia ratio of the collision that begins the segment, or 0 if none does. */
    real inertia_ratio;
    bool locks;             /* true if friction locks the motion at hi */
    struct barrier barrier; /* the barrier over [lo, hi] */
    struct sums end;        /* sums at hi, set by segment_next; dH is H(hi) - H(lo) */
    struct room *room;      /* memory for the computation of forces; may be NULL */
    enum dom_status status; /* status of an integrand, or of a function whose root is sought */
};

/* Lowers hi to the tilt at which a domino detaches, if one does. *moving receives the number of dominoes that
 * still move beyond hi. */
KERNEL enum dom_status segment_cut(struct segment *segment, size_t *moving);

/* Finds the barrier of a segment, and J. The members geometry, lo, hi, gain and start must be set. If
 * friction locks the motion, lowers hi to the tilt at which it locks. */
KERNEL enum dom_status segment_begin(struct segment *segment);

/* Finds the sums at hi and stores them in segment->end. Also prepares *next, the segment that begins at hi.
 * next->start.omegasq is a linear function of omegasq at the launch. If next->start.omegasq is negative, the
 * motion does not reach hi, and the value shows how much energy is missing. */
KERNEL enum dom_status segment_next(struct segment *segment, struct segment *next);

/* Only for a segment that friction locks at hi. Near hi, the angular acceleration grows without limit. If it
 * slows the motion down, the motion stops before hi, and *braked is set to true. If it speeds the motion up,
 * *braked is set to false. */
KERNEL enum dom_status segment_braked(const struct segment *segment, bool *braked);

/* Finds tau^2 omega^2 at a tilt. */
KERNEL enum dom_status segment_speed(const struct segment *segment, real theta, real *omegasq);

/* For a motion that stops, finds the tilt at which its energy is used up. With friction, the function may
 * replace the solution of the motion by another solution, which ends near this tilt. */
KERNEL enum dom_status segment_rest(struct segment *segment, real *theta);

#endif
