/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The run of a row, head by head (row.c), for the files that run rows. */
#ifndef DOM_RUN_H
#define DOM_RUN_H

#include "motion/forces.h"
#include "row/joint.h"
#include "row/moments.h"

struct run {
    const struct row_request *request;
    struct geometry *geometry; /* geometry[k]: of domino k as a head, and as a follower of k + 1 */
    size_t made;               /* so many of them are made, if not all are (steady.h) */
    bool times;
    bool forces;         /* true: find the smallest contact force, not only its sign */
    size_t moving;       /* number of moving dominoes, including the head */
    real omegasq;        /* of the head at its start, in its tau */
    real inertia_ratio;  /* of its collision: J(0) - 1, or A(0) - 1 with friction; 0: none */
    real time;           /* in s, up to now; NaN if it has no value */
    real carried;        /* J, kinetic energy before the next collision */
    struct watch *watch; /* the moments to report, or NULL */
    struct dom_verdict verdict;
};

/* The sums over the segments of one head, in its units. */
struct descent {
    struct segment st;
    size_t stay;
    real J0, least_margin, theta_m, time, climbed, least_force, stop;
    bool stops, locks;                          /* locks: it still moves where friction locks */
    bool forces;                                /* as in struct run */
    struct required_friction required_friction; /* friction that the floor needs */
    struct watch *watch;
    size_t head;
    real begins, tau; /* s */
};

/* Sets the state in which the first domino begins. */
KERNEL void row_launch(struct run *run);

/* Runs head k from when it was hit, or the first domino, and adds it to the verdict of the run. */
KERNEL enum dom_status row_head(struct run *run, size_t k, struct descent *d, struct dom_fall *fall);

/* Moves the head k down, and leaves the state at its end in d. */
KERNEL enum dom_status row_descend(struct run *run, size_t k, struct descent *d, struct dom_fall *fall);

/* Makes head k, which has arrived with `at` as `hitting`, hit k + 1, the next head. The row ends there if k +
 * 1 cannot move on. */
KERNEL enum dom_status row_hit(struct run *run, size_t k, const struct geometry *hitting,
                               const struct start *at);

#endif
