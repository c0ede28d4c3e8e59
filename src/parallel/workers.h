/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The thread pool. It computes the points of an answer, such as a sweep, and runs tasks of the library. Each
 * worker takes a block of up to 16 consecutive points, computes it, and then takes another block. Blocks are
 * written in order, so the output does not depend on the number of workers. */
#ifndef PARALLEL_WORKERS_H
#define PARALLEL_WORKERS_H

#include "domino_study.h"
#include "session/query.h"

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
    /* The members below are set by points_answer. */
    unsigned count; /* the number of workers, including the caller's thread */
    FILE *out;      /* the stream for the rows, or NULL if the points have no rows */
    bool progress;
    const volatile sig_atomic_t *interrupt;
};

/*
 * Computes all points of an answer. With --shard, computes only the requested part of them. The caller sets
 * the members points, point, context, size and merge of `workers`. The function workers.point must begin the
 * answer when it computes point 0. If something fails:
 * - If workers.point has returned false, sets *by_point and returns false.
 * - If a write has failed, sets answer->error and returns true.
 * - Otherwise sets *problem and returns false.
 */
bool points_answer(const struct query *query, struct problem *problem, struct answer *answer,
                   struct workers workers, bool *by_point);

/* Returns the index of the first point that --shard requests, and the number of points. */
struct range {
    size_t first, count;
};
struct range shard_range(const struct shard *shard, size_t points);

/* Runs tasks of the library. This is a dom_parallel whose pool is a struct task_pool. */
enum dom_status workers_tasks(size_t count, dom_task *task, void *context, void *pool);

struct task_pool {
    domq_real threads; /* the value of the parameter 'threads' */
    bool progress;
    const volatile sig_atomic_t *interrupt;
};

#endif
