/* SPDX-License-Identifier: GPL-3.0-or-later */
/* In a long sequence of equal dominoes, each head eventually moves exactly like the previous one: all
 * dominoes that influence it are equal, and omegasq no longer changes. Such a head need not be computed. */
#ifndef DOM_STEADY_H
#define DOM_STEADY_H

#include "row/run.h"

struct steady {
    struct dom_fall fall; /* result for the last head that was computed */
    size_t alike;         /* number of equal dominoes up to the current head */
    /* increase in the number of moving dominoes from head to head: 0 or 1 */
    size_t more;
    /* true if the next head will move like the last one, as long as the next two dominoes are equal to the
     * last head */
    bool found;
};

/* Fills in the geometry of the dominoes up to domino k, if this has not been done yet. */
KERNEL enum dom_status row_ready(struct run *run, size_t k);

/* Returns the number of dominoes that get their geometry before the run. All later dominoes are equal to the
 * last of these, so filling in their geometry during the run cannot fail. */
KERNEL size_t steady_made(const struct row_request *request);

/* Called when head k begins to move. If head k repeats the motion of the previous head, fills in *fall,
 * advances the run to the next head, and returns true. */
KERNEL bool steady_repeats(struct steady *s, struct run *run, size_t k, struct dom_fall *fall);

/* Called when head k has hit the next domino. Determines whether that domino will repeat the motion of head
 * k. `before` is the omegasq with which head k began. */
KERNEL void steady_find(struct steady *s, const struct run *run, size_t k, real before,
                        const struct descent *d, const struct dom_fall *fall);

/*
 * Runs the last head of a row in which the previous heads repeated one motion. The geometry of these heads
 * was never filled in, so the last head is computed as if the row ended at the last domino that has a
 * geometry. Returns false if this shorter row has too few equal dominoes at its end.
 */
KERNEL bool steady_last(const struct steady *s, struct run *run, size_t k, struct descent *d,
                        struct dom_fall *fall, enum dom_status *status);

#endif
