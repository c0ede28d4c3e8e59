/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the rows of an answer in parallel, for example the rows of a sweep or of 'curve'. */
#ifndef SHELL_POINTS_H
#define SHELL_POINTS_H

#include "parallel/workers.h"
#include "session/query.h"

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

#endif
