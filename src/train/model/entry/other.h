/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Asks another precision about the same train. Quad starts from the limits that double has found, and float
 * and double leave to quad what is open in their own arithmetic. This file must be included before api.h,
 * which renames the names of domino.h.
 */
#pragma once

#include "domino_float.h"
#include "domino_quad.h"

/* Add the prefix of this precision to a name, and that of the other precision. */
#if defined DOMF
#define OWN(name)   domf_##name
#define OTHER(name) domq_##name
#elif defined DOMQ
#define OWN(name)   domq_##name
#define OTHER(name) dom_##name
#else
#define OWN(name)   dom_##name
#define OTHER(name) domq_##name
#endif

#define TO_OTHER(name, ...)                     .name = (OTHER(real))train->name,
#define EFFECT_TO_OTHER(effect, member, status) .member = (OTHER(real))train->member,

static inline struct OTHER(train) train_there(const struct OWN(train) * train)
{
    return (struct OTHER(train)){DOM_TRAIN_PARAMETERS(TO_OTHER) DOM_DYNAMICS(EFFECT_TO_OTHER).fuel =
                                     train->fuel};
}

#undef TO_OTHER
#undef EFFECT_TO_OTHER

static inline struct OTHER(compute) compute_there(const struct OWN(compute) * compute, OTHER(real) tol)
{
    return (struct OTHER(compute)){.tol = tol, .work = compute->work, .interrupt = compute->interrupt};
}

/* Find r_max or, if `pair` is true, the limit of a pair, in one arithmetic alone (entry.c). `near` is r_max
 * as double has found it, or 0. */
enum dom_status OWN(_limit_alone)(const struct OWN(train) * train, const struct OWN(compute) * compute,
                                  bool pair, OWN(real) near, struct OWN(limit) * limit);
enum dom_status OTHER(_limit_alone)(const struct OTHER(train) * train, const struct OTHER(compute) * compute,
                                    bool pair, OTHER(real) near, struct OTHER(limit) * limit);

#ifdef DOMQ

/* Returns r_max as double finds it, or 0. */
static inline double near_rmax(const struct domq_train *train, const struct domq_compute *compute)
{
    const struct dom_train train_ = train_there(train);
    const struct dom_compute compute_ = compute_there(compute, dom_arithmetic()->tol_floor);
    struct dom_limit limit;
    return dom__limit_alone(&train_, &compute_, false, 0, &limit) == DOM_OK &&
                   limit.ends == DOM_END_BARRIER && limit.r_max > 1
               ? limit.r_max
               : 0;
}

/* Finds the best separation and its r_max in double. */
static inline bool near_best(const struct domq_train *train, const struct domq_compute *compute, domq_real *s,
                             domq_real *r_max)
{
    const struct dom_train train_ = train_there(train);
    const struct dom_compute compute_ = compute_there(compute, dom_arithmetic()->tol_floor);
    struct dom_best best;
    if (dom_limit_best(&train_, &compute_, &best) != DOM_OK)
        return false;
    *s = best.s;
    *r_max = best.r_max;
    return true;
}

#else

/* Finds a limit in quad. */
static inline enum dom_status limit_in_quad(const struct OWN(train) * train,
                                            const struct OWN(compute) * compute, bool pair,
                                            struct OWN(limit) * limit)
{
    const struct domq_train train_ = train_there(train);
    const struct domq_compute compute_ = compute_there(compute, compute->tol);
    struct domq_limit found;
    const enum dom_status status = domq__limit_alone(&train_, &compute_, pair, 0, &found);
    if (status == DOM_OK || status == DOM_OPEN)
        *limit = (struct OWN(limit)){.r_max = (OWN(real))found.r_max,
                                     .ends = found.ends,
                                     .why = found.why,
                                     .uncertainty = (OWN(real))found.uncertainty,
                                     .open = (OWN(real))found.open};
    return status;
}

#endif
