/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The thread pool. It computes the points of an answer, such as a sweep, and runs tasks of the library. Each
 * worker takes a block of up to 16 consecutive points, computes it, and then takes another block. Blocks are
 * written in order, so the output does not depend on the number of workers. */
#ifndef SHELL_WORKERS_H
#define SHELL_WORKERS_H

#include "domino_quad.h"
#include <stdio.h>

struct workers {
    size_t first, points; /* the index of the first point, and the number of points */
    /* Computes a point and writes its rows to `out`. Other threads run at the same time, so the function may
     * change only `context`, which is the worker's own copy. Returns false to stop the computation after this
     * point. */
    bool (*point)(void *context, size_t point, FILE *out);
    /* The context for `point`. Each worker has its own copy. If `point` returns false in a worker, the copy
     * of this worker is written back to `context`. */
    void *context;
    size_t size; /* the size of the context */
    /* Merges a worker's copy into `context` after all points have been computed. May be NULL. */
    void (*merge)(void *context, const void *copy);
    unsigned count; /* the number of workers, including the caller's thread */
    FILE *out;      /* the stream for the rows, or NULL if the points have no rows */
    bool progress;
    const volatile sig_atomic_t *interrupt;
};

struct workers_end {
    enum { WORKERS_DONE, WORKERS_ENDED, WORKERS_INTERRUPTED, WORKERS_WRITE_FAILED, WORKERS_NO_MEMORY } how;
    int error; /* for WORKERS_WRITE_FAILED: errno of the write that failed */
};

/* Computes all points. If some threads cannot be created, the other workers compute all points. */
struct workers_end workers_run(const struct workers *workers);

/* Returns how many workers to use for `points` points. `threads` is the value of the parameter 'threads'. If
 * it is 0, there is one worker for each processor. There are never more workers than points, and never more
 * than 256, but there is always at least one. */
unsigned workers_count(domq_real threads, size_t points);

/* Runs tasks of the library. This is a dom_parallel whose pool is a struct task_pool. */
enum dom_status workers_tasks(size_t count, dom_task *task, void *context, void *pool);

struct task_pool {
    domq_real threads; /* as for workers_count */
    bool progress;
    const volatile sig_atomic_t *interrupt;
};

#endif
