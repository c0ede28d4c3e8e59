/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the rows of an answer in parallel, for example those of a sweep or of 'curve'. */
#ifndef SHELL_POINTS_H
#define SHELL_POINTS_H

#include "parallel/workers.h"
#include "session/query.h"

/*
 * Writes an answer whose rows are computed point by point, in parallel. `workers` holds the number of points
 * of the whole answer, and the function that computes a point. For point 0, this function also begins the
 * answer. With --shard, only a part of the points is computed. If the function that computes a point returns
 * false, sets *by_point to true and returns false. On any other failure, sets *problem and returns false.
 */
bool points_answer(const struct query *query, struct problem *problem, struct answer *answer,
                   struct workers workers, bool *by_point);

#endif
