/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gives tests access to the internal functions of the kernel in double. */
#ifndef TEST_REQUEST_H
#define TEST_REQUEST_H

#include "precision/double.c"

#include "ask.h"

/* Prepares the geometry of a train. */
static inline enum dom_status geometry_of(const struct setup *a, struct geometry *geometry)
{
#define OF_TRAIN(name, ...)               .name = (double)a->name,
#define OF_EFFECT(effect, member, status) .member = (double)a->member,
    const struct dom_train train = {DOM_TRAIN_PARAMETERS(OF_TRAIN) DOM_DYNAMICS(OF_EFFECT).fuel = a->fuel};
    const struct dom_compute compute = {.tol = (double)a->tol, .work = a->work, .interrupt = a->interrupt};
    return train_make(&train, &compute, true, geometry);
}

#endif
