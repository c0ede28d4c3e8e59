/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parallel/points.h"

bool points_answer(const struct query *query, struct problem *problem, struct answer *a, struct workers w,
                   bool *by_point)
{
    struct range part = shard_range(&query->run_context->shard, w.points);
    w.first = part.first;
    w.points = part.count;
    w.count = workers_count(query->state->settings.threads, part.count);
    w.out = a->out;
    w.progress = true;
    w.interrupt = query->scene->compute.interrupt;
    struct workers_end end = workers_run(&w);
    *by_point = end.how == WORKERS_ENDED;
    a->progress.has_rows = a->progress.is_open = true;
    if (end.how == WORKERS_WRITE_FAILED)
        a->error = a->error ? a->error : end.error;
    if (end.how == WORKERS_INTERRUPTED || end.how == WORKERS_NO_MEMORY)
        return problem_status(problem, query->scene,
                              end.how == WORKERS_INTERRUPTED ? DOM_INTERRUPTED : DOM_NO_MEMORY);
    return !*by_point;
}
