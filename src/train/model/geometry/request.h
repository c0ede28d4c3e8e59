/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The input of a kernel. */
#pragma once

#include "numerics/interrupt.h"
#include "numerics/real.h"

static inline struct dom_compute compute_or_default(const struct dom_compute *compute)
{
    return compute ? *compute : dom_compute_default();
}

#define MEMBER(name, default_, lowest, highest, unit, meaning) dom_real name;

/* A train and the options of the computation, like struct dom_train and struct dom_compute of the API. */
struct request {
    DOM_TRAIN_PARAMETERS(MEMBER)
    DOM_COMPUTE_PARAMETERS(MEMBER)
    enum dom_fuel fuel;
    dom_real effect[DOM_DYNAMICS_COUNT]; /* indexed by enum dom_effect_name; 0 means off */
    dom_real near;                       /* r_max as found in double, or 0 if there is none */
    struct dom_work *work;
    const volatile sig_atomic_t *interrupt;
};

/* A row and the options of the computation, like struct dom_row and struct dom_compute of the API. */
struct row_request {
    const struct dom_domino *domino;
    size_t count;
    dom_real g, push, release;
    dom_real effect[DOM_DYNAMICS_COUNT];
    dom_real boxes_above; /* as in struct dom_row */
    /* If true, the run does not end at a domino that would stop. Instead, the domino gets the energy that it
     * needs, and the run goes on. */
    bool carries_on;
    DOM_COMPUTE_PARAMETERS(MEMBER)
    struct dom_work *work;
    const volatile sig_atomic_t *interrupt;
};

#undef MEMBER

/* Find the request for a train or a row, and check it (entry.c). Return an error if the precision does not
 * exist, or if the caller asks for something that came with a later version. */
KERNEL_SHARED enum dom_status train_request_of(const struct dom_train *train,
                                               const struct dom_compute *compute, struct request *request);
KERNEL_SHARED enum dom_status row_request_of(const struct dom_row *row, const struct dom_compute *compute,
                                             struct row_request *request);
