/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The one pool of threads: computes points of a curve or a sweep, and tasks of the library, side by side.
 * Each worker takes block after block of points, and the rows of the blocks are written in the order of the
 * points, as soon as that allows: the output is the same bytes whatever the number of workers.  Blocks, not
 * points, take the one lock, and they take a millisecond or so.
 */
#ifndef SHELL_WORKERS_H
#define SHELL_WORKERS_H

#include "domino_quad.h"
#include <stdio.h>

struct workers {
    size_t first, points; /* the numbers of the points: first, first + 1, ... */
    /*
     * Writes the rows of a point.  own is the worker's copy of `own` below, and all that it may change. False
     * ends the work: rows of the points before this one are written, those of the points after it are not.
     */
    bool (*point)(void *own, size_t point, FILE *out);
    void *own;   /* where a point ended the work, it becomes the copy of that worker */
    size_t size; /* of own, in bytes */
    /* Adds a worker's copy to own, when all is done; NULL: nothing is to be added. */
    void (*gather)(void *own, const void *worker);
    unsigned count;                         /* number of workers; 1 is the caller's thread alone */
    FILE *out;                              /* NULL: no rows are written */
    bool progress;                          /* shows how far the work is */
    const volatile sig_atomic_t *interrupt; /* as in struct dom_compute */
};

struct workers_end {
    enum { WORKERS_DONE, WORKERS_ENDED, WORKERS_INTERRUPTED, WORKERS_LOST, WORKERS_NO_MEMORY } how;
    int error; /* WORKERS_LOST: errno of the rows that cannot be written */
};

/* Computes all points.  The first worker is the caller's thread; without threads for all, fewer do it. */
struct workers_end workers_run(const struct workers *workers);

/* The settings with which workers_tasks runs the library's tasks. */
struct task_pool {
    domq_real threads; /* 0: one for each processor */
    bool progress;
    const volatile sig_atomic_t *interrupt;
};

/* Runs tasks of the library: a dom_parallel whose pool is a struct task_pool. */
enum dom_status workers_tasks(size_t count, dom_task *task, void *context, void *pool);

/* Returns how many workers there should be: as many as asked for, 0 being one for each processor that this
 * process may use, but no more than points. */
unsigned workers_count(domq_real threads, size_t points);

#endif
