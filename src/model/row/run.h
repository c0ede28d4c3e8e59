/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The run of a row, head by head (row.c), for the files that run rows. */
#ifndef DOM_RUN_H
#define DOM_RUN_H

#include "motion/forces.h"
#include "row/moments.h"

/* One domino, in SI units. */
struct block {
    real height, d, mass, tau; /* d = thickness / height */
    real box;                  /* moment of inertia over that of a solid block */
    real unit;                 /* m g h / 2 */
};

struct run {
    const struct row_request *asked;
    struct geometry *geometry; /* geometry[k]: of domino k as a head, and as a follower of k + 1 */
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

KERNEL struct block block_of(const struct row_request *row, size_t k);

/* Checks the row and each domino; *wrong gets the number of a domino that is wrong. row_domino_check checks
 * one. */
KERNEL enum dom_status row_check(const struct row_request *row, size_t *wrong);
KERNEL enum dom_status row_domino_check(const struct row_request *row, size_t k);

/* Makes the geometry of the whole row, or of domino k alone, when that of domino k - 1 is made. row_make also
 * takes the memory of the law, which dynamics_end of row[0] gives back, also after a failure. */
KERNEL enum dom_status row_make(const struct row_request *asked, struct geometry *row);
KERNEL enum dom_status row_geometry(const struct row_request *asked, size_t k, struct geometry *row);

/* Sets the state in which the first domino begins. */
KERNEL void row_launch(struct run *run);

/* Runs head k from when it was hit, or the first domino, and adds it to the verdict of the run. */
KERNEL enum dom_status row_head(struct run *run, size_t k, struct descent *d, struct dom_fall *fall);

/* Moves the head k down, and leaves the state at its end in d. */
KERNEL enum dom_status row_descend(struct run *run, size_t k, struct descent *d, struct dom_fall *fall);

/* Makes head k hit k + 1, the next head. The row ends there if k + 1 cannot move on. */
KERNEL enum dom_status row_hit(struct run *run, size_t k, const struct descent *d);

#endif
