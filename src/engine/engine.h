/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a row of boxes in the rigid-body engine Chipmunk 7. The boxes stand on hinges, or on a floor with
 * friction. world.c puts the boxes into Chipmunk, run.c moves them step by step, and row_engine.c makes boxes
 * of the dominoes of a scene. */
#pragma once

#include "domino_row.h"
#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>
#include <math.h>
#include <signal.h>

/* The boxes are the dominoes of a row, whose effects `mu`, `alpha`, `rho` and `walls` apply, and whose
 * `release` is finite. `feet` is the friction coefficient of the floor. If it is infinite, feet with sharp
 * edges turn on hinges, and rounded feet roll without slipping. */
struct engine_row {
    struct dom_row row;
    double bounce; /* coefficient of restitution between boxes */
    /* length by which the upper back edge is cut off, relative to the height; masses are unaffected */
    double bevel;
};

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
    struct engine_grain grain; /* the resolution of the run */
    /* Set by engine_settle: how much the last halving of the step length changed the times. This is the
     * largest change of any time, divided by the duration. NaN if the verdict changed, or without times. */
    double change;
    /* Set by engine_settle: true if the verdict is reliable. Either the last halving of the step length did
     * not change it, or the verdict of a single run was certain. */
    bool same;
};

/* The largest number of boxes in a row. The time of a run grows with the square of this number. */
enum { ENGINE_MOST = 200 };

/* Two limits for engine_settle. It stops when no time changes by more than ENGINE_AGREES times the duration.
 * It also stops after a run with ENGINE_FINEST steps per unit of time. */
#define ENGINE_AGREES 0.01
#define ENGINE_FINEST 1600

/* Loads the engine, unless it is already loaded. Thread-safe. The status is DOM_NO_METHOD if Chipmunk is not
 * installed, or DOM_NO_MEMORY. */
enum dom_status engine_load(void);

/* Returns the version of the engine, or NULL if it cannot be loaded. */
const char *engine_version(void);

struct world;
typedef bool engine_visit(const struct world *world, void *context);

/*
 * Runs a row once. `hit` is an array with an element for each box, and receives a record of each box that is
 * hit. If `hit` is NULL, all times are measured from the start of the run. `visit`, which may be NULL, is
 * called after each step and returns false to end the run.
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
                              struct engine_fall *fall);

/* ---- The row as bodies in a space of Chipmunk ---- */

/* the velocity of the centre of a box, and the speed of its ends relative to the centre */
struct motion {
    cpVect v;
    double turns;
};

/* A box in Chipmunk's space. */
struct body {
    cpBody *body;
    cpShape *shape;
    cpConstraint *hinge, *limit; /* hinge and its limit; both NULL if the box stands on a floor */
    cpVect corner;               /* position of the lower front corner at the start */
    double moment, radius;       /* moment of inertia about the centre, and radius of the edges */
    /* the velocities before the first iteration of a step, and after the latest iteration */
    struct motion begin, now;
};

struct world {
    const struct dom_row *row;
    double bounce, bevel;
    struct engine_fall *fall;
    struct engine_hit *hit; /* may be NULL */
    bool has_room;          /* true if memory for the space is reserved */
    cpSpace *space;
    cpShape *floor; /* NULL if the boxes stand on hinges */
    struct body *body;
    size_t count, head; /* number of boxes in the space, and index of the foremost box that was hit */
    double now;
    struct cpConstraint watch; /* ends the iterations of a step */
    double change;             /* the largest change in any velocity during the last iteration */
};

/* Creates a world with the first box, which is pushed or tips over. Call world_free afterwards, even after an
 * error. */
enum dom_status world_make(struct world *world);
void world_free(struct world *world);

/* Adds the next box in its upright position. */
void world_add_box(struct world *world);

/* Moves all boxes by a step. The solver iterates until its impulses have converged. */
void world_step(struct world *world, double dt);

/* The tilt of box k, its angular velocity, its upper or lower front corner, and how far its foot has slid.
 * Chipmunk measures angles anticlockwise, but boxes fall clockwise, towards positive x. */
static inline double world_tilt(const struct world *w, size_t k)
{
    return -w->body[k].body->a;
}

static inline double world_spin(const struct world *w, size_t k)
{
    return -w->body[k].body->w;
}

static inline cpVect world_corner(const struct world *w, size_t k, bool upper)
{
    const struct dom_domino *box = &w->row->domino[k];
    const double y = box->height / 2;
    return cpTransformPoint(w->body[k].body->transform, cpv(box->thickness / 2, upper ? y : -y));
}

static inline double world_slid(const struct world *w, size_t k)
{
    return world_corner(w, k, false).x - w->body[k].corner.x;
}
