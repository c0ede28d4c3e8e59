/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The place in the cycles at which a session's walk stands, event by event. */
#ifndef SHELL_PLACE_H
#define SHELL_PLACE_H

#include "domino_quad.h"

/* Where the walk stands: at an event of a cycle, or between two. */
struct walk {
    struct domq_train train;     /* that the session had when the walk began; another one begins anew */
    struct domq_compute compute; /* to a finer tolerance than the session's */
    domq_real tol;               /* the session's then */
    struct domq_event events[DOM_EVENTS_MAX];
    int count; /* of the events; 0: no walk has begun */
    int event; /* the last one that was passed */
    domq_real theta;
    int cycle;               /* from 1 */
    enum dom_status verdict; /* DOM_OK, or DOM_STOPS */
};

#endif
