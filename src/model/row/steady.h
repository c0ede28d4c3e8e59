/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A sequence of equal dominoes: after some of them each head moves as the head before it did. By then all
 * dominoes that matter to a head are equal, and omegasq no longer changes.
 */
#ifndef DOM_STEADY_H
#define DOM_STEADY_H

#include "row/run.h"

struct steady {
    struct dom_fall fall; /* of the last head that was computed */
    size_t alike;         /* number of equal dominoes up to the present head */
    size_t more;          /* 1 if one more domino moves with each head, 0 if as many move as before */
    bool found;           /* the next head repeats this motion if its dominoes are equal as well */
};

/* Makes the geometry of the row up to domino k. */
KERNEL enum dom_status row_ready(struct run *run, size_t k);

/* Returns the number of dominoes whose geometry is made first. All dominoes after them are equal, so that
 * none of them can fail. */
KERNEL size_t steady_made(const struct row_request *request);

/* Begins with head k. Returns true if head k repeats the motion of the head before. `fall` is filled then,
 * and the run goes on to the next head. */
KERNEL bool steady_repeats(struct steady *s, struct run *run, size_t k, struct dom_fall *fall);

/* Finds whether the next head will repeat the motion of head k, which began with omegasq = before and has hit
 * it. */
KERNEL void steady_find(struct steady *s, const struct run *run, size_t k, real before,
                        const struct descent *d, const struct dom_fall *fall);

/*
 * Runs the last head of a row as that of a shorter row, since all heads before it repeat and their geometry
 * is not made. Returns false if the shorter row is too short for that.
 */
KERNEL bool steady_last(const struct steady *s, struct run *run, size_t k, struct descent *d,
                        struct dom_fall *fall, enum dom_status *status);

#endif
