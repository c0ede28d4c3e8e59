/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Points of a curve or a sweep on all processors.  Each worker takes block after block of them, and the rows
 * of the blocks are written in the order of the points, as soon as that allows: the output is the same bytes
 * whoever computed them.  Blocks, not points, take the one lock, and they are as long as a millisecond or so.
 */
#ifndef SHELL_WORKERS_H
#define SHELL_WORKERS_H

#include "domino_quad.h"
#include <stdio.h>

struct workers {
    size_t first, points; /* their numbers: first, first + 1, ... */
    /*
     * Writes the rows of a point.  own is what this worker has to itself, and all that it may change.  False
     * ends the work: rows of the points before it are written, those behind it are not.
     */
    bool (*point)(void *own, size_t point, FILE *out);
    void *own; /* of the first worker; those of the others stand behind it, `size` bytes each */
    size_t size;
    unsigned count;
    FILE *out;                              /* NULL: nobody reads them */
    bool progress;                          /* is it to be shown? */
    const volatile sig_atomic_t *interrupt; /* as of a train */
};

struct workers_end {
    enum { WORKERS_DONE, WORKERS_ENDED, WORKERS_INTERRUPTED, WORKERS_LOST, WORKERS_NO_MEMORY } how;
    void *by;  /* WORKERS_ENDED: own of the worker whose point did */
    int error; /* WORKERS_LOST: the rows cannot be written any more, errno */
};

/* One worker is the caller's thread, and none is made; where no more can be had, fewer do it. */
struct workers_end workers_run(const struct workers *workers);

/* How many: as asked for, 0 being one for each processor that this process may use, but no more than points.
 */
unsigned workers_count(domq_real threads, size_t points);

#endif
