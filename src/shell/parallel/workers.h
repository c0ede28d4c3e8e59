/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The thread pool.  It computes the points of a curve or a sweep, and tasks of the library, in parallel. Each
 * worker takes one block of points after another.  The rows of the blocks are written in the order of the
 * points as soon as possible, so that the output has the same bytes for any number of workers.  Only one lock
 * is needed, which is taken once a block, and a block takes about a millisecond.
 */
#ifndef SHELL_WORKERS_H
#define SHELL_WORKERS_H

#include "domino_quad.h"
#include <stdio.h>

struct workers {
    size_t first, points; /* the points are first, first + 1, ... */
    /*
     * Computes a point, and writes its rows.  May change only `context`, of which each worker has a copy.
     * Returning false ends the work after the rows of all earlier points are written.
     */
    bool (*point)(void *context, size_t point, FILE *out);
    void *context; /* if a point ends the work, becomes the copy of its worker */
    size_t size;   /* the size of the context */
    /* Merges a worker's copy into the context after the last point.  May be NULL. */
    void (*merge)(void *context, const void *copy);
    unsigned count; /* how many workers there are, with the caller's thread */
    FILE *out;      /* NULL without rows */
    bool progress;  /* show the progress */
    const volatile sig_atomic_t *interrupt;
};

struct workers_end {
    enum { WORKERS_DONE, WORKERS_ENDED, WORKERS_INTERRUPTED, WORKERS_LOST, WORKERS_NO_MEMORY } how;
    int error; /* for WORKERS_LOST: errno of the rows that could not be written */
};

/* Computes all points.  If there are too few threads, the others do their work. */
struct workers_end workers_run(const struct workers *workers);

/* Returns how many workers to use for this many points: the setting 'threads', where 0 means one for each
 * processor that this process may use. */
unsigned workers_count(domq_real threads, size_t points);

/* Runs tasks of the library.  This is a dom_parallel whose pool is a struct task_pool. */
enum dom_status workers_tasks(size_t count, dom_task *task, void *context, void *pool);

struct task_pool {
    domq_real threads; /* as for workers_count */
    bool progress;
    const volatile sig_atomic_t *interrupt;
};

#endif
