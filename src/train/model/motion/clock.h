/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The times of a motion: how long a segment lasts, at what time the head has a given tilt, and what tilt it
 * has at a given time. */
#ifndef DOM_CLOCK_H
#define DOM_CLOCK_H

#include "motion/segment.h"

/* Returns the relative error of times, which rounding errors cause. It is large if the energy is hardly
 * enough for the barrier or, for a motion that starts at rest, if hardly anything sets it in motion. */
KERNEL real segment_noise(const struct segment *segment);

/* The time since the beginning of a motion, as a function of the tilt of the head. */
struct clock {
    struct segment *segment;
    real to;     /* the last tilt of the motion */
    real smooth; /* from this tilt up to `to`, no domino detaches */
    bool rests;  /* true if the head comes to rest at the tilt `to` */
    real width;  /* the width of the peak that the slowness has at the top of the barrier */
    real tol;
    struct num_linear time; /* the time in tau, as a function of the variable x (clock.c) */
};

/* Makes the clock of the motion from segment->lo to the tilt `to`. The segment must exist as long as the
 * clock. The memory of an earlier clock is used again; a new one must be {0}, and clock_free frees it.
 * Returns DOM_NO_MARGIN if the energy is too close to the barrier to compute times. */
KERNEL enum dom_status clock_begin(struct clock *clock, struct segment *segment, real to, bool rests,
                                   real tol);
KERNEL void clock_free(struct clock *clock);

/* Returns the time from the beginning of the motion to a tilt, in tau. */
KERNEL real clock_time(const struct clock *clock, real theta);

/* Finds the tilt at a time from 0 to clock_time(clock, clock->to). */
KERNEL enum dom_status clock_tilt(const struct clock *clock, real time, real *theta);

/* Finds the duration of a segment, in tau. If the train nearly stops, the duration grows like ln(1/margin).
 * Returns DOM_NO_MARGIN as clock_begin does. */
KERNEL enum dom_status segment_time(struct segment *segment, real tol, real *time);

#endif
