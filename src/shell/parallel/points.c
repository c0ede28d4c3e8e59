/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parallel/points.h"
#include "io/terminal.h"
#include "parallel/workers.h"
#include <stdlib.h>
#include <string.h>

bool points_answer(struct session *session, struct answer *a, const struct points *points, bool *by_point)
{
    struct range part = session_part(session, points->total);
    struct workers w = {
        .first = part.first,
        .points = part.count,
        .point = points->point,
        .size = points->size,
        .count = workers_count(session->threads, part.count),
        .out = a->out,
        .progress = !(a->out && terminal_width(a->out)), /* rows on the terminal are progress enough */
        .interrupt = session->compute.interrupt,
    };
    char *own = malloc(w.count * w.size);
    if (!own)
        return session_status(session, DOM_NO_MEMORY);
    for (unsigned i = 0; i < w.count; i++)
        memcpy(own + i * w.size, points->own, w.size);
    w.own = own;
    struct workers_end end = workers_run(&w);
    for (unsigned i = 0; i < w.count && end.how == WORKERS_DONE && points->gather; i++)
        points->gather(points->own, own + i * w.size);
    *by_point = end.how == WORKERS_ENDED;
    if (*by_point)
        memcpy(points->own, end.by, w.size);
    free(own);
    a->begun = a->prepared = true; /* what is said now stands behind them */
    if (end.how == WORKERS_LOST)
        a->lost = a->lost ? a->lost : end.error;
    if (end.how == WORKERS_INTERRUPTED || end.how == WORKERS_NO_MEMORY)
        return session_status(session, end.how == WORKERS_INTERRUPTED ? DOM_INTERRUPTED : DOM_NO_MEMORY);
    return !*by_point;
}
