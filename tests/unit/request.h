/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gives tests access to the internal functions of the kernel in double. */
#ifndef TEST_REQUEST_H
#define TEST_REQUEST_H

#include "precision/double.c"

#include "ask.h"

#define REQUEST_EFFECT(effect, member, status) (double)a->member,

/* Returns the request that the kernel gets for the train. */
static inline struct request request_of(const struct setup *a)
{
    return (struct request){.s = (double)a->s,
                            .r = (double)a->r,
                            .d = (double)a->d,
                            .q = (double)a->q,
                            .tol = (double)a->tol,
                            .fuel = a->fuel,
                            .effect = {DOM_DYNAMICS(REQUEST_EFFECT)},
                            .work = a->work,
                            .interrupt = a->interrupt};
}

#endif
