/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A finite row: its joints (joint.c) and its runs (row.c). */
#pragma once

#include "motion/motion.h"

#ifndef KERNEL_SOURCES
/* Models of features include headers that declare functions which only the sources of the kernel define. */
#pragma GCC diagnostic ignored "-Wunused-function"
#endif

/* ---- Joints: two neighbours, as if these were dominoes of a train (joint.c) ---- */

/* A row that has been checked, with the memory that its runs need. */
struct row {
    struct dom_row given;
    struct dom_compute compute;
    /* geometry[k] describes domino k, both as a head and as the follower of domino k + 1 */
    struct geometry *geometry;
    struct flow flow; /* the memory of the law of motion, which all dominoes share */
    /* number of elements of `geometry` that are filled in so far; a run fills in more when it needs them */
    size_t made;
    struct dom_work work; /* the counters, unless the caller has some */
};

/* row_begin checks a row and prepares its runs. Call row_free afterwards, even after an error. If a domino is
 * bad, sets *wrong to its number, counted from 1. */
KERNEL_SHARED enum dom_status row_begin(const struct dom_row *given, const struct dom_compute *compute,
                                        struct row *row, size_t *wrong);
KERNEL_SHARED void row_free(struct row *row);

/* Checks domino k, counted from 0. */
KERNEL_SHARED enum dom_status row_domino_check(const struct dom_row *row, size_t k);

/* Fills in the geometry of domino k, from that of domino k - 1 and from the law of motion of domino 0. */
KERNEL_SHARED enum dom_status row_geometry(struct row *row, size_t k);

/* Returns true if domino k has the same sizes, mass, gap and lean as the domino before it. */
KERNEL_SHARED bool row_repeats(const struct dom_row *row, size_t k);

/* Returns true if the first domino starts at a tilt that takes the place of its lean. */
KERNEL bool row_releases(const struct dom_row *row);

/* Returns how the fall ends when head k reaches the next domino, or DOM_ROW_FALLS if it goes on. */
KERNEL enum dom_row_end joint_ends(const struct row *row, size_t k);

/* ---- Runs (row.c) ---- */

struct run;
struct descent;

/* How a row runs, and what other folders do while it runs. Each function may be NULL. A status other than
 * DOM_OK ends the run. If neither `ends` nor `detaches` is set, a head may repeat the motion of the one
 * before, instead of being computed. */
struct run_options {
    bool times;
    bool forces;     /* the smallest contact force is wanted, not only its sign */
    bool carries_on; /* a domino that would stop gets the energy that it needs, and the run goes on */
    /* Returns true if it is certain, without a search for the barrier, that head k keeps falling. Sets *at to
     * the state at the end of its motion. */
    bool (*passes)(struct run *run, size_t k, struct start *at);
    /* Called after head k, which began in the state *before. Returns true if the run may end here. */
    bool (*ends)(struct run *run, size_t k, const struct run *before, const struct descent *d,
                 const struct dom_fall *fall);
    void (*begins)(struct run *run, size_t k); /* head k begins to move */
    /* The head has moved over a segment, up to the tilt d->to. A first domino that tips over its edge moves
     * in a segment of its own before the first hit. If it touches the next domino before it tips over,
     * d->to <= d->st.lo, and it leans on that domino at rest. */
    enum dom_status (*moves)(struct run *run, const struct descent *d);
    /* Dominoes detach at the end of the segment. The first d->moving dominoes, from the head on, do not. */
    enum dom_status (*detaches)(struct run *run, const struct descent *d);
    enum dom_status (*rests)(struct run *run); /* the run has ended */
    void *context;                             /* for these functions */
};

/* The run of a row, one head after the other. */
struct run {
    struct row *row;
    const struct run_options *options;
    size_t moving; /* number of moving dominoes, including the head */
    real omegasq;  /* tau^2 omega^2 of the head when it is hit */
    /* Inertia ratio T of the collision that set the head in motion (dynamics.h), or 0 if there was none. With
     * sharp edges, T is J(0) - 1 without losses, and A(0) - 1 with losses. */
    real inertia_ratio;
    real time;    /* time since the start in s, or NaN if the time is unknown */
    real carried; /* kinetic energy before the next collision, in J */
    struct dom_verdict verdict;
    struct clock clock; /* of the last motion over a segment, if the run has times */
};

/* The motion of one head, which is computed segment by segment, in the units of this head. */
struct descent {
    struct run *run;
    size_t head;       /* index of the head, from 0 */
    real begins, tau;  /* time of the hit, and tau of the head, both in s */
    struct segment st; /* the current segment */
    size_t moving;     /* number of dominoes that move after this segment */
    real J0;           /* J at the hit */
    /* The time since the hit at which the segment begins, and how long it lasts, in tau. `lasts` is NaN if it
     * is not known. Where the motion ends, it is known only in a run with `moves`. */
    real time, lasts;
    real climbed;               /* rise of the potential energy since the hit */
    real least_margin, theta_m; /* smallest margin so far, and the tilt of its barrier */
    real least_force; /* smallest contact force so far, divided by the weight of the pushed domino */
    /* The last tilt of the motion in the segment. There the head comes to rest if `stops` is true, and
     * friction locks it while it moves if `locks` is true. */
    real to;
    bool stops, locks;
};

/* Checks a row and runs it from the start, as dom_row_run does. */
KERNEL_SHARED enum dom_status row_run(const struct dom_row *row, const struct dom_compute *compute,
                                      const struct run_options *options, dom_fall_visit *visit, void *context,
                                      struct dom_verdict *verdict);

/* Returns a run that begins with the first domino. */
KERNEL_SHARED struct run row_launch(struct row *row, const struct run_options *options);

/* Runs a row from head k on. */
KERNEL_SHARED enum dom_status row_falls(struct run *run, size_t k, dom_fall_visit *visit, void *context);
