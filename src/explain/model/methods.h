/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the methods for comparison share. */
#ifndef EXPLAIN_METHODS_H
#define EXPLAIN_METHODS_H

#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_methods.h"
#pragma GCC visibility pop

/* A train, how to compute, and the status of the computation so far. */
struct method {
    struct dom_train train;
    struct dom_compute compute;
    enum dom_status status;
};

/* Begins a computation. Its status is not DOM_OK if the methods have no answer for this train. */
static inline struct method method_begin(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_angles angles;
    struct method m = {*train, compute ? *compute : dom_compute_default(),
                       dom_angles_find(train, compute, &angles)};
    if (m.status == DOM_OK && dom_first_effect(train))
        m.status = DOM_NO_METHOD;
    return m;
}

/* Begins a search for the largest growth, which does not use train->r. */
static inline struct method method_begin_growth(const struct dom_train *train,
                                                const struct dom_compute *compute)
{
    struct dom_train equal = *train;
    equal.r = 1;
    return method_begin(&equal, compute);
}

#endif
