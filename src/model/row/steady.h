/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speeds up the run of a row with long sequences of equal dominoes. In such a sequence, all heads eventually
 * move alike. From then on, the program repeats the last motion for each head, instead of computing it
 * again. */
#ifndef DOM_STEADY_H
#define DOM_STEADY_H

#include "row/run.h"

struct steady {
    struct dom_fall fall; /* result for the previous head */
    size_t alike;         /* number of equal dominoes up to the current head */
    /* by how many the number of moving dominoes grows from one head to the next; 0 or 1 if `found` is true */
    size_t more;
    /* true if the motion is steady. The next head then repeats the motion, provided that the next two
     * dominoes both equal the current one. */
    bool found;
};

/* Fills in the geometry of the dominoes up to domino k, if this has not been done yet. */
KERNEL enum dom_status row_ready(struct run *run, size_t k);

/*
 * Returns the number of dominoes whose geometry is filled in before the run. The geometry of later dominoes
 * is filled in only when it is needed. Filling it in cannot fail, because all later dominoes equal the last
 * one that is filled in before the run.
 */
KERNEL size_t steady_made(const struct row_request *request);

/* Called when head k begins to move. If head k repeats the motion of the previous head, fills in *fall,
 * advances the run and returns true. Otherwise returns false. */
KERNEL bool steady_repeats(struct steady *s, struct run *run, size_t k, struct dom_fall *fall);

/* Called when head k has hit the next domino. Determines whether the next domino will repeat the motion of
 * head k. The argument `before` is the omegasq with which head k began to move. */
KERNEL void steady_find(struct steady *s, const struct run *run, size_t k, real before,
                        const struct descent *d, const struct dom_fall *fall);

/*
 * Runs head k, the last head of a row, after a steady motion whose repetition skipped the heads before it.
 * The skipped heads and head k have no geometry. But the last domino that has a geometry equals head k. So
 * the function runs this domino in the place of head k, as if the row ended there. If too few equal dominoes
 * precede this domino, returns false, and the caller must run head k itself.
 */
KERNEL bool steady_last(const struct steady *s, struct run *run, size_t k, struct descent *d,
                        struct dom_fall *fall, enum dom_status *status);

#endif
