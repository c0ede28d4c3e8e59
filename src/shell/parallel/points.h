/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_POINTS_H
#define SHELL_POINTS_H

#include "parallel/workers.h"
#include "session/query.h"

/*
 * Writes an answer whose rows are computed point by point, in parallel.  `workers` says how many points the
 * whole answer has, and how to compute them; point 0 begins the answer.  With --shard only a part of the
 * points is computed.  Returns false with a problem, or with *by_point if a point ended the work.
 */
bool points_answer(const struct query *query, struct problem *problem, struct answer *answer,
                   struct workers workers, bool *by_point);

#endif
