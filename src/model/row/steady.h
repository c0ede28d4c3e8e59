/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Equal dominoes one after the other: after some of them each head does what the head before did. The chain
 * that matters is equal then, all within the run of equal dominoes, and omegasq no longer changes.
 */
#ifndef DOM_STEADY_H
#define DOM_STEADY_H

#include "row/run.h"

struct steady {
    struct dom_fall fall; /* of the last head that was computed */
    size_t alike;         /* so many dominoes, up to the present head, are equal */
    size_t more;          /* how many dominoes more move from that head to the next: 0 or 1 */
    bool found;           /* the next head does the same, if its dominoes are equal, too */
};

/* Makes the geometry of the row up to domino k. */
KERNEL enum dom_status row_ready(struct run *run, size_t k);

/* Returns the number of dominoes whose geometry is made first; those after them are equal, so none of them
 * can fail. */
KERNEL size_t steady_made(const struct row_request *request);

/* Begins with head k. Returns true if it does what the head before did: `fall` is filled, and the run goes on
 * to the next head. */
KERNEL bool steady_repeats(struct steady *s, struct run *run, size_t k, struct dom_fall *fall);

/* Finds whether the next head repeats the head k, which had `before` as omegasq and has hit the next. */
KERNEL void steady_find(struct steady *s, const struct run *run, size_t k, real before,
                        const struct descent *d, const struct dom_fall *fall);

/*
 * Runs the last head of a row whose geometry is not made up to there, since all heads before it repeat: as
 * the last of a shorter row. Returns false if that row is too short.
 */
KERNEL bool steady_last(const struct steady *s, struct run *run, size_t k, struct descent *d,
                        struct dom_fall *fall, enum dom_status *status);

#endif
