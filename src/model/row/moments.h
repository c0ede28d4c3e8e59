/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tilts of all dominoes of a row at given times, collected while the row runs. */
#ifndef DOM_MOMENTS_H
#define DOM_MOMENTS_H

#include "motion/segment.h"

/* The time at which a passage begins, which is begins + passed * tau. The head was hit at the time `begins`.
 * `begins` and `tau` are in s. */
struct since {
    real begins, tau, passed;
};

/* A stretch of the motion of one head, during which no domino detaches. */
struct passage {
    struct segment st;
    real to;    /* the tilt of the head where the passage ends */
    bool rests; /* true if the head comes to rest at this tilt */
    struct since since;
    real lasts;      /* duration in tau */
    size_t head;     /* index of the head, from 0 */
    bool has_series; /* true if time is computed from the series, false if from integrals */
    real span;       /* for a passage that ends at rest, sqrt((to - lo) / passage_size) */
    real into;       /* the time within the passage that a search looks for */
    struct num_series series;
};

/* The times at which the caller wants the state of the row, and the state so far. */
struct watch {
    const dom_real *time; /* in s, in ascending order */
    size_t times, next;   /* number of times, and index of the next one */
    dom_moment_visit *visit;
    void *context;
    bool ended;             /* true if the callback has ended the run */
    dom_real *tilt, *omega; /* tilt and angular velocity of each domino, in rad and rad/s */
    size_t head, moving;    /* index of the head, and number of moving dominoes */
    struct passage last;    /* the last passage so far */
};

/* These two functions allocate and free the memory for a row of `count` dominoes. */
KERNEL enum dom_status watch_begin(struct watch *watch, size_t count);
KERNEL void watch_free(struct watch *watch);

/* Reports the requested times before the first hit, while the first domino tips over its edge. */
KERNEL void watch_tip(struct watch *watch, const struct segment *tip, real tau);

/* Reports the requested times in one passage, which ends at the tilt `to`. `lasts` is the duration of the
 * passage, or NaN if it is not known yet. */
KERNEL enum dom_status watch_passage(struct watch *watch, const struct segment *st, size_t head, real to,
                                     bool rests, const struct since *since, real lasts);

/* Stores the tilts of the dominoes that detach at the end of a segment. The first `stay` dominoes from the
 * head do not detach. */
KERNEL enum dom_status watch_detach(struct watch *watch, const struct segment *st, size_t head, size_t stay);

/* Reports the requested times after the end of the run. */
KERNEL enum dom_status watch_rest(struct watch *watch);

#endif
