/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The motion of a head, from one collision to the next: the parts in which no domino detaches, times, the
 * cycle of an endless train, and forces. A cycle ends with the next hit, or where the train comes to rest.
 */
#pragma once

#include "energy/barrier.h"

/* ---- Segments (segment.c) ---- */

/*
 * A segment is a part of the motion of one head, from the tilt lo to the tilt hi. In a row, a segment ends
 * where a domino detaches, where friction locks the motion, or with the next hit. The cycle of a train is a
 * single segment.
 */
struct segment {
    struct geometry geometry; /* geometry.n is the number of moving dominoes */
    real lo, hi;              /* tilts of the head, in rad */
    struct start start;       /* the state at lo */
    size_t summed;            /* number of dominoes that start.J includes, or 0 if J is not known yet */
    real gain;                /* derivative of start.omegasq with respect to omegasq at the launch */
    /* Inertia ratio of the collision that begins the segment, or 0 if none does. */
    real inertia_ratio;
    bool locks;             /* true if friction locks the motion at hi */
    struct barrier barrier; /* the barrier over [lo, hi] */
    struct sums end;        /* sums at hi, set by segment_next; dH is H(hi) - H(lo) */
    enum dom_status status; /* status of an integrand, or of a function whose root is sought */
};

/* Lowers hi to the tilt at which a domino detaches, if one does. Beyond hi, *moving dominoes still move. */
KERNEL enum dom_status segment_cut(struct segment *segment, size_t *moving);

/* Finds the barrier of a segment, and J. The members geometry, lo, hi, gain and start must be set. If
 * friction locks the motion, lowers hi to the tilt at which it locks. */
KERNEL enum dom_status segment_begin(struct segment *segment);

/* Finds the sums at hi and stores them in segment->end. Also prepares *next, the segment that begins at hi.
 * next->start.omegasq is a linear function of omegasq at the launch. If next->start.omegasq is negative, the
 * motion does not reach hi, and the value shows how much energy is missing. */
KERNEL enum dom_status segment_next(struct segment *segment, struct segment *next);

/* For a motion that stops, finds the tilt at which its energy is used up. With losses, the function may
 * replace the solution of the motion by another solution, which ends near this tilt. */
KERNEL enum dom_status segment_rest(struct segment *segment, real *theta);

/* ---- Times (clock.c) ---- */

/* The time since the beginning of a motion, as a function of the tilt of the head. */
struct clock {
    struct segment *segment;
    real to;     /* the last tilt of the motion */
    real smooth; /* from this tilt up to `to`, no domino detaches */
    bool rests;  /* true if the head comes to rest at the tilt `to` */
    real width;  /* the width of the peak that the slowness has at the top of the barrier */
    real tol;
    struct num_linear time; /* the time in tau, as a function of the variable x (clock.c) */
    real sought;            /* the time that clock_tilt seeks */
};

/* Makes the clock of the motion from segment->lo to the tilt `to`. The segment must exist as long as the
 * clock. The memory of an earlier clock is used again; a new one must be {0}, and clock_free frees it.
 * If the motion nearly stops, its time grows like ln(1/margin). Returns DOM_NO_MARGIN if the energy is too
 * close to the barrier to compute times. */
KERNEL_SHARED enum dom_status clock_begin(struct clock *clock, struct segment *segment, real to, bool rests,
                                          real tol);
KERNEL_SHARED void clock_free(struct clock *clock);

/* Returns the time from the beginning of the motion to a tilt, in tau. */
KERNEL_SHARED real clock_time(const struct clock *clock, real theta);

/* Finds the tilt at a time from 0 to clock_time(clock, clock->to). */
KERNEL_SHARED enum dom_status clock_tilt(struct clock *clock, real time, real *theta);

/* ---- The cycle of an endless train (cycle.c) ---- */

struct motion {
    struct segment segment; /* from the upright position to theta_c */
    struct flow flow;       /* of the segment's geometry */
    struct launch launch;
    bool stops;         /* true if the train does not get over the barrier */
    real end;           /* the last tilt: theta_c, or the tilt of rest */
    real tol;           /* the tolerance of the caller */
    struct clock clock; /* set by motion_prepare, if it is asked for times */
};

KERNEL_SHARED void motion_end(struct motion *motion);

/* Checks a train, and finds its launch, its barrier over [0, theta_c], its end and, if `timed` is true, its
 * clock, with the status of clock_begin. Returns DOM_NO_FUEL if the train has no energy for a launch. Always
 * call motion_end afterwards. */
KERNEL_SHARED enum dom_status motion_prepare(const struct dom_train *train, const struct dom_compute *compute,
                                             bool timed, struct motion *motion);

/* ---- Forces (forces.c) ---- */

/* Finds the contact forces at a few tilts from lo to `to` and divides each force by the weight of the domino
 * that it pushes. If the smallest of these ratios is below *least, stores it there. If segment->end.pushes is
 * true, no ratio is negative, so callers that only need the sign do not call this function. */
KERNEL_SHARED enum dom_status segment_contact(const struct segment *segment, real to, real *least);

/* This tolerance gives a few digits of a force. */
#define FORCES_TOL ((real)1e-6)

/* The motion of a chain, given by the motion of its head: `omegasq` is tau^2 omega^2, and `acceleration` is
 * tau^2 times the angular acceleration. */
struct kinematics {
    struct tilt head;
    real omegasq, acceleration;
    size_t n; /* number of dominoes that contribute to the sums */
    /*
     * True at the start of a motion that begins with a collision. `omega` is then tau times the angular
     * velocity of the head after the collision. `omega_lost` describes what the followers lose: in the
     * collision, the angular velocity of follower i decreases by theta_i' * `omega_lost` / tau.
     */
    bool hit;
    real omega, omega_lost;
};

/* One domino of a moving chain. Forces are in units of m g of the head, and impulses in units of m g tau of
 * the head. */
struct loaded {
    struct link link;
    real size;           /* height / height of the head */
    struct arms arms;    /* arms of the contact with the follower, if there is one */
    bool leaned;         /* true if a follower leans on this domino */
    real force, impulse; /* of the follower, normal to the back face; NaN if none leans on this domino */
};

/* Finds the motion of a chain at a tilt of its head, and the forces of the contacts of all dominoes that
 * contribute to its sums, and of at least the first `least`, if there are as many. Sets *count to their
 * number, and *list to their list, which the caller frees. */
KERNEL_SHARED enum dom_status forces_at(const struct segment *segment, real theta, size_t least,
                                        struct kinematics *motion, struct loaded **list, size_t *count);

/* ---- The largest value over a motion (forces.c) ---- */

/* Finds the value at a tilt. */
typedef enum dom_status peak_function(real theta, void *context, real *value);

enum { PEAK_MOST = 24, PEAK_HALVINGS = 24 };

struct peak {
    int samples; /* the number of intervals with which a search begins, at most PEAK_MOST */
    peak_function *at;
    void *context;
    real most;     /* the largest value so far */
    real tol, off; /* a search ends when no peak can exceed `most` by more than tol * |most| + off */
};

/* Searches [lo, hi], in which the value must not jump. */
KERNEL_SHARED enum dom_status peak_over(struct peak *peak, real lo, real hi);

/* Searches the cycle of a train, whose motion is in *motion while `at` is called. The edges of its barrier
 * divide the cycle into parts. Forces jump at the edges, so the search of a part begins and ends just inside.
 */
KERNEL_SHARED enum dom_status peak_of_cycle(struct peak *peak, const struct dom_train *train,
                                            const struct dom_compute *compute, struct motion *motion);
