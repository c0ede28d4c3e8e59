/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The run of a row, head by head. row.c implements it; sample.c, course.c and steady.c also run rows. */
#ifndef DOM_RUN_H
#define DOM_RUN_H

#include "motion/forces.h"
#include "row/joint.h"
#include "row/moments.h"

struct run {
    const struct row_request *request;
    /* geometry[k] describes domino k as a head, and as a follower of domino k + 1 */
    struct geometry *geometry;
    /* number of elements of `geometry` made so far, if they are made during the run (steady.h) */
    size_t made;
    bool times;
    bool forces;   /* true to find the smallest contact force, and not only its sign */
    size_t moving; /* number of moving dominoes, including the head */
    real omegasq;  /* tau^2 omega^2 of the head when it is hit */
    /* inertia ratio of the collision in which the head was hit: J(0) - 1, or A(0) - 1 with friction. The
     * ratio is 0 if no collision took place. */
    real inertia_ratio;
    real time;           /* time of the run so far in s, or NaN if the time is unknown */
    real carried;        /* kinetic energy before the next collision, in J */
    struct watch *watch; /* the times to report, or NULL */
    struct dom_verdict verdict;
};

/* The motion of one head, segment by segment, in units of that head. */
struct descent {
    struct segment st; /* the current segment */
    size_t stay;       /* number of dominoes that still move after this segment */
    real J0, least_margin, theta_m, time, climbed, least_force, stop;
    /* whether the head stops, and whether it is still moving when friction locks it */
    bool stops, locks;
    bool forces;                                /* as in struct run */
    struct required_friction required_friction; /* coefficients of friction that the floor needs */
    struct watch *watch;
    size_t head;
    real begins, tau; /* the time when the head was hit, and tau of the head, in s */
};

/* Sets the state in which the first domino begins to move. */
KERNEL void row_launch(struct run *run);

/* Runs head k from the moment when it is hit, or from the start for the first domino, and adds the head to
 * the verdict. */
KERNEL enum dom_status row_head(struct run *run, size_t k, struct descent *d, struct dom_fall *fall);

/* Moves head k from its first tilt to its last tilt. On return `d` has the state at the end of this
 * motion. */
KERNEL enum dom_status row_descend(struct run *run, size_t k, struct descent *d, struct dom_fall *fall);

/* Lets head k, which arrives in the state `at` with the chain `hitting`, hit domino k + 1, which becomes the
 * head. The row ends there if domino k + 1 cannot move on. */
KERNEL enum dom_status row_hit(struct run *run, size_t k, const struct geometry *hitting,
                               const struct start *at);

#endif
