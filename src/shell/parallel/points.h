/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An answer whose rows come point by point, on all processors, in order: the part that the session wants. */
#ifndef SHELL_POINTS_H
#define SHELL_POINTS_H

#include "session/query.h"

struct points {
    size_t total; /* of the whole, of which session_part takes its part */
    /*
     * Writes the rows of a point, where point 0 begins the whole answer. false ends the answer after the rows
     * of the points before. own is this worker's copy of `own` below, which only this worker may change.
     */
    bool (*point)(void *own, size_t point, FILE *out);
    void *own;
    size_t size;
    void (*gather)(void *own, const void *worker); /* into own, when all is done; NULL for none */
};

/*
 * Writes the answer. Returns true if all is written, or if there is no reader any more; false if an error was
 * reported, or a point ended the answer: then *by_point is set, and own is as that worker left it.
 */
bool points_answer(const struct query *query, struct problem *problem, struct answer *answer,
                   const struct points *points, bool *by_point);

#endif
