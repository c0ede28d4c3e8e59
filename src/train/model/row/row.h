/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A finite row: its joints (joint.c), its runs (row.c), and its states at requested times (moments.c). */
#ifndef DOM_ROW_H
#define DOM_ROW_H

#include "motion/motion.h"

/* ---- Joints: two neighbours, as if these were dominoes of a train (joint.c) ---- */

/*
 * Allows for rounding errors in a gap. A head counts as reaching the next domino even if the gap exceeds the
 * reach of the head by up to this fraction. With sharp edges, the reach is the height. Example: in a row that
 * is made from a train with r = 1/s, each gap equals the height of the domino before it, but only up to the
 * rounding errors of r, of the heights and of the gap.
 */
#define REACH_ROUNDED (4 * REAL_EPSILON)

/* One domino, in SI units. */
struct block {
    real height, d, mass, tau; /* d = thickness / height */
    /* moment of inertia, divided by that of a solid block of the same size and mass */
    real inertia_factor;
    real unit; /* unit of energy, m g h / 2 */
};

KERNEL struct block block_of(const struct row_request *row, size_t k);

/* A row that has been checked, with the memory that its runs need. */
struct row {
    struct row_request request;
    struct block *block; /* what the run needs of the dominoes */
    /* geometry[k] describes domino k, both as a head and as the follower of domino k + 1 */
    struct geometry *geometry;
    /* number of elements of `geometry` that are filled in so far; a run fills in more when it needs them */
    size_t made;
};

/* row_begin checks a row and prepares its runs. Call row_free afterwards, even after an error. If a domino is
 * bad, sets *wrong to its number, counted from 1. */
KERNEL_SHARED enum dom_status row_begin(const struct row_request *request, struct row *row, size_t *wrong);
KERNEL_SHARED void row_free(struct row *row);

/* Checks the row again after row->request has changed, and fills in its geometry. If the row ends with many
 * equal dominoes, leaves out all of them except the first. */
KERNEL_SHARED enum dom_status row_read(struct row *row, size_t *wrong);

/* Checks domino k, counted from 0. */
KERNEL_SHARED enum dom_status row_domino_check(const struct row_request *row, size_t k);

/* Fills in row[k], from row[k - 1] and from the law of motion in row[0]. */
KERNEL enum dom_status row_geometry(const struct row_request *request, size_t k, struct geometry *row);

/* Returns true if domino k has the same sizes, mass, gap and lean as the domino before it. */
KERNEL bool row_repeats(const struct row_request *row, size_t k);

/* Returns true if the first domino starts at a tilt that takes the place of its lean. */
KERNEL bool row_releases(const struct row_request *row);

/* Returns the lean of domino k, which is 0 for a first domino that is released. */
KERNEL real row_lean(const struct row_request *row, size_t k);

/*
 * Finds where domino k touches domino k + 1, if one of the two leans at the start. Sets *contact to their
 * contact, and *tilt to the tilt of domino k at that moment. Returns false if the edge of domino k misses the
 * back face of domino k + 1, or if the two dominoes already touch at the start.
 */
KERNEL bool lean_touch(const struct row_request *row, size_t k, struct contact *contact, struct tilt *tilt);

/* ---- Moments (moments.c) ---- */

/* A stretch of the motion of one head, during which no domino detaches. */
struct passage {
    struct segment st;
    size_t head; /* index of the head, from 0 */
    real to;     /* tilt of the head at the end of the passage */
    bool rests;  /* true if the head comes to rest at the tilt `to` */
    /* The head was hit at `begins`, in s. The passage begins `passed` later and lasts `lasts`, in tau of the
     * head, which is `tau` in s. */
    real begins, tau, passed, lasts;
};

/* The times at which the caller wants the state of a row, and the current state. */
struct watch {
    const dom_real *time; /* the requested times in s, in ascending order */
    size_t times, next;   /* number of requested times, and index of the next one to report */
    dom_moment_visit *visit;
    void *context;
    bool ended;             /* true if the callback has ended the run */
    dom_real *tilt, *omega; /* tilt and angular velocity of each domino, in rad and rad/s */
    size_t head, moving;    /* index of the head, and number of moving dominoes */
    struct passage last;
    struct clock clock; /* of `last` */
};

/* In watch_tip and watch_detach, a NULL `watch` stands for a run without requested times. */

/* Reports the states at those requested times that lie before the first hit. Until then, the first domino
 * tips over its edge. If it touches the next domino before it tips over, it leans on that domino at rest. */
KERNEL enum dom_status watch_tip(struct watch *watch, const struct segment *tip, real tau);

/* Reports the states at those requested times that lie in a passage. If passage->lasts is NaN, the duration
 * is not known. */
KERNEL enum dom_status watch_passage(struct watch *watch, const struct passage *passage);

/* Stores the tilts of the dominoes that detach at the end of a segment; they keep these tilts. The first
 * `moving` dominoes, counted from the head, do not detach. */
KERNEL enum dom_status watch_detach(struct watch *watch, const struct segment *st, size_t head,
                                    size_t moving);

/* After the end of the run, reports the states at all remaining requested times. */
KERNEL enum dom_status watch_rest(struct watch *watch);

/* ---- Runs (row.c) ---- */

struct descent; /* below */

/* The run of a row, one head after the other. */
struct run {
    struct row *row;
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
    struct dom_verdict verdict;
    /* What a study adds to a run (rows/model/study.c). The functions may be NULL. */
    struct study *study;
    /* Returns true if it is certain, without a search for the barrier, that head k keeps falling. Sets *at to
     * the state at the end of its motion. */
    bool (*passes)(struct run *run, size_t k, struct start *at);
    /* Called after head k, which began in the state *before. Returns true if the run may end here. */
    bool (*ends)(struct run *run, size_t k, const struct run *before, const struct descent *d,
                 const struct dom_fall *fall);
};

/* The motion of one head, which is computed segment by segment, in the units of this head. */
struct descent {
    struct run *run;
    size_t head;
    real tau;                   /* of the head, in s */
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
    struct required_friction required_friction;
};

/* Returns a run that begins with the first domino. */
KERNEL_SHARED struct run row_launch(struct row *row);

/* Runs a row from head k on. */
KERNEL_SHARED enum dom_status row_falls(struct run *run, size_t k, dom_fall_visit *visit, void *context);

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

/* Returns true if it is certain, without a search for the barrier, that a head keeps falling. Sets *at to the
 * state at the end of its motion. Edges must be sharp, and the chain must move without friction (glide.c). */
KERNEL_SHARED bool row_glides(const struct run *run, const struct geometry *head, struct start *at);

#endif
