/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a row, one head after the other (row.c). Everything that runs a row calls row_falls: a single run of a
 * whole row, and the many runs of a study (study.c), which begin and end where it asks for. */
#ifndef DOM_RUN_H
#define DOM_RUN_H

#include "motion/motion.h"
#include "row/joint.h"
#include "row/moments.h"

struct run {
    const struct row_request *request;
    /* geometry[k] describes domino k, both as a head and as the follower of domino k + 1 */
    struct geometry *geometry;
    /* number of elements of `geometry` that are filled in so far; row_ready fills in more during the run */
    size_t made;
    bool times;
    bool forces;   /* true if the smallest contact force is wanted, not only its sign */
    size_t moving; /* number of moving dominoes, including the head */
    real omegasq;  /* tau^2 omega^2 of the head when it is hit */
    /* Inertia ratio T of the collision that set the head in motion (dynamics.h), or 0 if there was none. With
     * sharp edges, T is J(0) - 1 without friction, and A(0) - 1 with friction. */
    real inertia_ratio;
    real time;           /* time since the start in s, or NaN if the time is unknown */
    real carried;        /* kinetic energy before the next collision, in J */
    struct watch *watch; /* the times to report, or NULL */
    struct study *study; /* the study that the run belongs to, or NULL */
    struct dom_verdict verdict;
};

/* The motion of one head, which is computed segment by segment, in the units of this head. */
struct descent {
    struct segment st;          /* the current segment */
    size_t moving;              /* number of dominoes that move after this segment */
    real J0;                    /* J at the hit */
    real time;                  /* time since the hit, in tau */
    real climbed;               /* rise of the potential energy since the hit */
    real least_margin, theta_m; /* smallest margin so far, and the tilt of its barrier */
    real least_force; /* smallest contact force so far, divided by the weight of the pushed domino */
    /* `stops` is true if the head comes to rest, `locks` if friction locks it while it moves. Both happen at
     * the tilt `stop`. */
    bool stops, locks;
    real stop;
    bool forces; /* true if the smallest contact force is wanted, not only its sign */
    struct required_friction required_friction; /* coefficients of friction that the floor needs */
    struct watch *watch;
    size_t head;
    real begins, tau; /* time at which the head was hit, and tau of the head, both in s */
};

/* Sets the state in which the first domino begins to move. */
KERNEL void row_launch(struct run *run);

/* Runs a row from head k on. The member `made` of *run counts the geometries that are up to date. */
KERNEL enum dom_status row_falls(struct run *run, size_t k, dom_fall_visit *visit, void *context);

/* Runs head k from the hit, or from the start if k = 0. Updates the verdict. */
KERNEL enum dom_status row_head(struct run *run, size_t k, struct descent *d, struct dom_fall *fall);

/* Runs head k from its first tilt to its last tilt and stores the final state in *d. Unlike row_head, does
 * not update the verdict. */
KERNEL enum dom_status row_descend(struct run *run, size_t k, struct descent *d, struct dom_fall *fall);

/*
 * Computes the collision of head k with domino k + 1, which then becomes the head. The arguments *at and
 * *hitting are the state and the geometry of head k at the hit. If the fall ends here, sets run->verdict.end.
 */
KERNEL enum dom_status row_hit(struct run *run, size_t k, const struct geometry *hitting,
                               const struct start *at);

/* ---- What a study adds to a run (study.c). Without a study, both functions return false. ---- */

/* Returns true if it is certain, without a search for the barrier, that head k keeps falling. Sets *at to the
 * state at the end of its motion. */
KERNEL bool study_passes(struct run *run, size_t k, struct start *at);

/* Called after head k, which began in the state *before. Returns true if the run may end here: either the
 * row moves as planned again, or the run is rough, and its errors may change the verdict. */
KERNEL bool study_ends(struct run *run, size_t k, const struct run *before, const struct descent *d,
                       const struct dom_fall *fall);

#if defined DOMF || defined DOMQ /* studies exist only in double */
KERNEL bool study_passes(struct run *run, size_t k, struct start *at)
{
    (void)run, (void)k, (void)at;
    return false;
}

KERNEL bool study_ends(struct run *run, size_t k, const struct run *before, const struct descent *d,
                       const struct dom_fall *fall)
{
    (void)run, (void)k, (void)before, (void)d, (void)fall;
    return false;
}
#endif

#endif
