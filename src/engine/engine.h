/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a row of boxes in the rigid-body engine Chipmunk. The boxes stand on hinges, or on a floor with
 * friction. Nothing here is specific to dominoes; row_engine.c makes boxes of them. */
#ifndef ENGINE_H
#define ENGINE_H

#include "domino_common.h"
#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

/* A box of a row. `gap` is the clear distance to the previous box and is ignored for the first box. */
struct engine_box {
    double height, thickness, gap, mass;
    /* moment of inertia about the centre, divided by that of a solid box; 0 means a solid box */
    double inertia;
    /* Radius of the edges of this box. If it is 0, the radius is the height of the box multiplied by the
     * member `radius` of struct engine_row. Ignored if the row has sharp edges. */
    double radius;
};

struct engine_row {
    const struct engine_box *box;
    size_t count;
    double g;
    /* angular velocity given to the first box; NaN if this box is tipped over its edge and released */
    double push;
    double tilt;   /* tilt at which the first box gets the push; 0 if it is upright */
    double slope;  /* angle at which the floor slopes down in the direction of the row */
    double mu;     /* friction coefficient between boxes */
    double bounce; /* coefficient of restitution between boxes */
    /* Friction coefficient of the floor. If it is infinite, feet with sharp edges turn on hinges, and rounded
     * feet roll without slipping. */
    double feet;
    double radius; /* radius of the edges, relative to the height; 0 means sharp edges */
    /* length by which the upper back edge is cut off, relative to the height; masses are unaffected */
    double bevel;
};

/* Initialiser for a row of solid, frictionless boxes on hinges. A caller may change members afterwards. */
#define ENGINE_ROW(box_, count_)                                                                             \
    {                                                                                                        \
        .box = (box_), .count = (count_), .g = 1, .push = (double)NAN, .feet = (double)INFINITY              \
    }

/* The resolution of a run. A caller refines both numbers until the result stops changing. */
struct engine_grain {
    /*
     * Steps per unit of time. The unit is sqrt(height / g), where the height is that of the foremost box that
     * was hit. If this box turns faster than 1 rad per unit of time, `steps` is the number of steps per
     * radian instead.
     */
    double steps;
    /* The engine finds impulses by iteration, which leaves errors in the velocities after a step. The
     * iteration ends when these errors are at most `tolerance` times the largest change of a velocity in the
     * step. */
    double tolerance;
};

/* The record of a box that was hit. */
struct engine_hit {
    /* Time of the hit. Times are measured from the push or, without a push, from the first hit. If the first
     * box was released, its time is NaN. */
    double time;
    double omega;   /* angular velocity after the hit; 0 if the box hardly moves or was released */
    double kinetic; /* kinetic energy of all boxes after the hit */
    /* distance that the foot has slid by the end of the run; negative if it slid backwards */
    double slid;
};

struct engine_fall {
    bool all;  /* true if all boxes fall */
    bool lies; /* true if the last box that was hit has fallen to the floor */
    /* true if the first box starts from its balance point and already touches the second box there; the row
     * is then not run */
    bool leans;
    size_t hits;    /* number of boxes that were hit, including the first */
    double seconds; /* time until the last box lies on the floor, or until the row has come to rest */
    double zero;    /* time from the start of the run to the moment from which all other times are measured */
    /*
     * How close the row came to stopping. At each moment, the run divides the angular velocity of the
     * foremost box by the largest angular velocity that this box has had. `slowest` is the smallest of these
     * ratios. If a foremost box had a contact of the kind that other_contact records, `slowest` is 0.
     */
    double slowest;
    /* The largest tilt of the foremost box, relative to the tilt at which it balances on its lower front
     * corner. 1 if the box went beyond its balance point. */
    double climbed;
    /* True if an edge of a box touched the top of the box behind it. In a normal contact, a tip touches the
     * back face of the next box. */
    bool other_contact;
};

/* The largest number of boxes in a row. The time of a run grows with the square of this number. */
enum { ENGINE_MOST = 200 };

/* The state of a row during a run. For k < count, tilt[k] is the tilt of box k, and foot[k] is how far its
 * foot has slid. */
struct engine_moment {
    double time;  /* time since the start of the run */
    size_t head;  /* index of the foremost box that was hit */
    size_t count; /* number of boxes in the engine so far; all later boxes still stand upright */
    const double *tilt, *foot;
};
typedef bool engine_visit(const struct engine_moment *moment, void *context);

/* The result of repeating a run with shorter and shorter steps. */
struct engine_settled {
    struct engine_fall fall;
    struct engine_grain grain; /* the resolution of the last run */
    /* How much the last halving of the step length changed the times: the largest change of any time, divided
     * by the duration. NaN if the verdict changed. Valid only if times were requested. */
    double change;
    /* True if the verdict is reliable: the last halving of the step length did not change it, or the verdict
     * of a single run was certain. */
    bool same;
};

/* Two limits for engine_settle. It stops when no time changes by more than ENGINE_AGREES times the duration.
 * It also stops after a run with ENGINE_FINEST steps per unit of time. */
#define ENGINE_AGREES 0.01
#define ENGINE_FINEST 1600

/* Loads the engine, unless it is already loaded. The status is DOM_NO_METHOD if Chipmunk is not installed. */
enum dom_status engine_load(void);

/* Returns the version of the engine, or NULL if it cannot be loaded. */
const char *engine_version(void);

/*
 * Runs a row once. `hit` is an array of row->count elements and receives a record of each box that is hit. If
 * `hit` is NULL, all times are measured from the start of the run. `visit`, which may be NULL, is called
 * after each step and returns false to end the run.
 *
 * If `hit` and `visit` are both NULL, only the verdict is wanted. The run then ends as soon as it is certain
 * that all boxes fall, and fall->seconds is roughly the time at which the run ended.
 *
 * The status is DOM_NOT_CONVERGED if the run has not ended after a very large number of steps.
 */
enum dom_status engine_run(const struct engine_row *row, const struct engine_grain *grain,
                           const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                           engine_visit *visit, void *context, struct engine_fall *fall);

/* The resolution of engine_settle's first run if times are requested. It is enough for a rough answer. */
extern const struct engine_grain engine_coarsest;

/*
 * Runs a row repeatedly and halves the step length until the verdict no longer changes. `hit` is an array as
 * in engine_run, and may be NULL if `times` is false.
 * - If `times` is true, halving goes on until no time changes by more than ENGINE_AGREES times the duration.
 * - If `times` is false, a coarse first run is not repeated if its verdict is certain.
 * - No run takes more than ENGINE_FINEST steps per unit of time.
 */
enum dom_status engine_settle(const struct engine_row *row, bool times,
                              const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                              struct engine_settled *settled);

#endif
