/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parallel/points.h"
#include "parallel/workers.h"

bool points_answer(const struct query *query, struct problem *problem, struct answer *a,
                   const struct points *points, bool *by_point)
{
    struct range part = means_part(query->means, points->total);
    struct workers w = {
        .first = part.first,
        .points = part.count,
        .point = points->point,
        .own = points->own,
        .size = points->size,
        .gather = points->gather,
        .count = workers_count(query->state->settings.threads, part.count),
        .out = a->out,
        .progress = true,
        .interrupt = query->scene->compute.interrupt,
    };
    struct workers_end end = workers_run(&w);
    *by_point = end.how == WORKERS_ENDED;
    a->begun = a->prepared = true; /* later texts come after these rows */
    if (end.how == WORKERS_LOST)
        a->lost = a->lost ? a->lost : end.error;
    if (end.how == WORKERS_INTERRUPTED || end.how == WORKERS_NO_MEMORY)
        return problem_status(problem, query->scene,
                              end.how == WORKERS_INTERRUPTED ? DOM_INTERRUPTED : DOM_NO_MEMORY);
    return !*by_point;
}
