/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The precision that a kernel may ask about the same train. Quad starts from the limits that double has
 * found, and float and double leave to quad what is open in their own arithmetic. This file must be included
 * before api.h, which renames the names of domino.h.
 */
#pragma once

#include "domino_float.h"
#include "domino_quad.h"

#ifdef DOMQ
#define OTHER(name) dom_##name
#else
#define OTHER(name) domq_##name
#endif

typedef OTHER(real) other_real;
typedef struct OTHER(train) other_train;
typedef struct OTHER(compute) other_compute;
typedef struct OTHER(limit) other_limit;
typedef struct OTHER(best) other_best;

/* limit_answer and limit_best of the other precision (growth/limit.h) */
enum dom_status OTHER(_limit_answer)(const other_train *train, const other_compute *compute, bool pair,
                                     other_real near, other_limit *limit);
enum dom_status OTHER(_limit_best)(const other_train *train, const other_compute *compute, other_real near,
                                   other_best *best);
