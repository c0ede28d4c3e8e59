/* SPDX-License-Identifier: GPL-3.0-or-later */
/* In a long sequence of equal dominoes, each head eventually moves like the previous one. From then on, all
 * dominoes that matter to a head are equal, and omegasq no longer changes. */
#ifndef DOM_STEADY_H
#define DOM_STEADY_H

#include "row/run.h"

struct steady {
    struct dom_fall fall; /* the fall of the last head that was computed */
    size_t alike;         /* number of equal dominoes up to the current head */
    /* 1 if each head has one more moving domino than the previous head, or 0 if both have the same number */
    size_t more;
    bool found; /* true if the next head repeats this motion, provided that the dominoes near it are equal,
                   too */
};

/* Makes the geometry of the dominoes up to domino k that have no geometry yet. */
KERNEL enum dom_status row_ready(struct run *run, size_t k);

/* Returns the number of dominoes whose geometry is made before the run. All later dominoes are equal to the
 * last of these, so making their geometry cannot fail. */
KERNEL size_t steady_made(const struct row_request *request);

/* Called when head k begins. Returns true if head k repeats the motion of the previous head: then `fall` is
 * filled, and the run is advanced to the next head. */
KERNEL bool steady_repeats(struct steady *s, struct run *run, size_t k, struct dom_fall *fall);

/* Finds whether the next head will repeat the motion of head k. Head k began with omegasq = before, and has
 * hit the next head. */
KERNEL void steady_find(struct steady *s, const struct run *run, size_t k, real before,
                        const struct descent *d, const struct dom_fall *fall);

/* Runs the last head of a row as the last head of a shorter row, since all heads before it repeat one motion
 * and their geometry has not been made. Returns false if the shorter row is too short for that. */
KERNEL bool steady_last(const struct steady *s, struct run *run, size_t k, struct descent *d,
                        struct dom_fall *fall, enum dom_status *status);

#endif
