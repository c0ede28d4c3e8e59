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
    DOM_COMPUTE_PARAMETERS(MEMBER)
    struct dom_work *work;
    const volatile sig_atomic_t *interrupt;
};

#undef MEMBER
