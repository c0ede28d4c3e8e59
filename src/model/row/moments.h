/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tilts of all dominoes of a row at given times, collected while the row runs. */
#ifndef DOM_MOMENTS_H
#define DOM_MOMENTS_H

#include "motion/segment.h"

/* When something begins: so many tau after its head was hit, at `begins` in s. */
struct since {
    real begins, tau, passed;
};

/* A part of the motion of one head in time, in which no domino detaches. */
struct passage {
    struct segment st;
    real to;    /* the tilt where the passage ends */
    bool rests; /* the motion is used up there */
    struct since since;
    real lasts;      /* tau */
    size_t head;     /* from 0 */
    bool has_series; /* false: integrals take its place */
    real span;       /* of a passage that rests: sqrt((to - lo) / its size) */
    real into;       /* of a search: the time that is looked for */
    struct num_series series;
};

/* What the caller asks for, and the state of the row so far. */
struct watch {
    const dom_real *time; /* s, in order */
    size_t times, next;   /* how many there are, and the first that is still to be visited */
    dom_moment_visit *visit;
    void *context;
    bool ended;             /* by the visitor */
    dom_real *tilt, *omega; /* of each domino */
    size_t head, moving;    /* the head, from 0, and how many dominoes move */
    struct passage last;    /* the one that the row ends with */
};

/* Takes and gives back the memory for a row of so many dominoes. */
KERNEL enum dom_status watch_begin(struct watch *watch, size_t count);
KERNEL void watch_free(struct watch *watch);

/* Visits the times before the first hit of a row whose first domino tips over its edge, from lo to hi. */
KERNEL void watch_tip(struct watch *watch, const struct segment *tip, real tau);

/*
 * Visits the times in one passage: up to the tilt `to`, where the motion rests, or goes on after `lasts`.
 * lasts NaN: finds it.
 */
KERNEL enum dom_status watch_passage(struct watch *watch, const struct segment *st, size_t head, real to,
                                     bool rests, const struct since *since, real lasts);

/* Keeps the tilts that dominoes have where they detach: at the end of the segment, all but `stay`. */
KERNEL enum dom_status watch_detach(struct watch *watch, const struct segment *st, size_t head, size_t stay);

/* Visits the times after the end of the run. */
KERNEL enum dom_status watch_rest(struct watch *watch);

#endif
