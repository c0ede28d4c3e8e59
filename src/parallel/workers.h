/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The thread pool. It computes the points of an answer, such as a sweep, and runs tasks of the library. Each
 * worker takes a block of up to 16 consecutive points, computes it, and then takes another block. Blocks are
 * written in order, so the output does not depend on the number of workers. */
#pragma once

#include "domino_study.h"
#include "session/query.h"

struct workers {
    size_t points;
    /* Computes a point and writes its rows to `out`. Other threads run at the same time, so the function may
     * change only `context`, which is the worker's own copy. Returns false to stop the computation after this
     * point. */
    bool (*point)(void *context, size_t point, FILE *out);
    /* The context for `point`. If `point` returns false in a worker, the copy of this worker is written back
     * to `context`. */
    void *context;
    size_t size; /* the size of the context */
};

/* Computes all points of an answer. If a write fails, or a point returns false, the later points are left
 * out, and the status is DOM_OK. Errors: DOM_INTERRUPTED, DOM_NO_MEMORY. */
enum dom_status points_answer(const struct query *query, struct answer *answer,
                              const struct workers *workers);

struct task_pool {
    domq_real threads; /* the value of the parameter 'threads'; 0 stands for all processors */
    bool progress;
    const volatile sig_atomic_t *interrupt;
};

/* Runs tasks of the library. This is a dom_parallel whose pool is a struct task_pool. */
enum dom_status workers_tasks(size_t count, dom_task *task, void *context, void *pool);
