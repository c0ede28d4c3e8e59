/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reports the tilts of all dominoes of a row at requested times, while the row runs. */
#ifndef DOM_MOMENTS_H
#define DOM_MOMENTS_H

#include "motion/motion.h"

/* The time at which a passage starts: `begins` + `passed` * `tau`. */
struct since {
    real begins; /* time at which the head was hit, in s */
    real tau;    /* tau of the head, in s */
    real passed; /* time from the hit to the start of the passage, in tau */
};

/* A stretch of the motion of one head, during which no domino detaches. */
struct passage {
    struct segment st;
    real to;    /* tilt of the head at the end of the passage */
    bool rests; /* true if the head comes to rest at the tilt `to` */
    struct since since;
    real lasts;  /* duration of the passage in tau */
    size_t head; /* index of the head, from 0 */
};

/* The times at which the caller wants the state of a row, and the current state. */
struct watch {
    const dom_real *time; /* the requested times in s, in ascending order */
    size_t times, next;   /* number of requested times, and index of the next one to report */
    dom_moment_visit *visit;
    void *context;
    bool ended;             /* true if the callback has ended the run */
    dom_real *tilt, *omega; /* tilt and angular velocity of each domino, in rad and rad/s */
    size_t head, moving;    /* index of the head, and number of moving dominoes */
    struct passage last;
    struct clock clock; /* of `last` */
};

/* Allocates the memory for a row. Call watch_free even after an error. */
KERNEL enum dom_status watch_begin(struct watch *watch, const struct row_request *row);
KERNEL void watch_free(struct watch *watch);

/* In watch_tip, watch_passage and watch_detach, a NULL `watch` stands for a run without requested times. */

/* Reports the states at those requested times that lie before the first hit. Until then, the first domino
 * tips over its edge. If it touches the next domino before it tips over, it leans on that domino at rest. */
KERNEL enum dom_status watch_tip(struct watch *watch, const struct segment *tip, real tau);

/* Reports the states at those requested times that lie in one passage. The passage ends when the head has the
 * tilt `to`. `lasts` is the duration of the passage in tau, or NaN if the duration is unknown. */
KERNEL enum dom_status watch_passage(struct watch *watch, const struct segment *st, size_t head, real to,
                                     bool rests, const struct since *since, real lasts);

/* Stores the tilts of the dominoes that detach at the end of a segment; they keep these tilts. The first
 * `moving` dominoes, counted from the head, do not detach. */
KERNEL enum dom_status watch_detach(struct watch *watch, const struct segment *st, size_t head,
                                    size_t moving);

/* After the end of the run, reports the states at all remaining requested times. */
KERNEL enum dom_status watch_rest(struct watch *watch);

#endif
