/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row of boxes in a rigid-body engine. Boxes with a size, a mass and a moment of inertia stand on hinges,
 * or on a floor with friction. They collide, and gravity pulls them. Nothing here is specific to dominoes. */
#ifndef ENGINE_H
#define ENGINE_H

#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

/* A box of a row. `gap` is the clear distance to the previous box; the gap of the first box is ignored. */
struct engine_box {
    double height, thickness, gap, mass;
    /* Moment of inertia about the centre, relative to that of a solid box; 0 means a solid box. */
    double inertia;
    double radius; /* radius of the edges, if the row has rounded edges; 0 means the radius of the row */
};

struct engine_row {
    const struct engine_box *box;
    size_t count;
    double g;
    /* Angular velocity given to the first box; NaN if the box is instead tipped over its edge and let go. */
    double push;
    double slope;  /* angle by which the floor descends in the direction of the row */
    double mu;     /* friction coefficient between boxes */
    double bounce; /* coefficient of restitution between boxes */
    /* Friction coefficient of the floor. If it is infinite, feet with sharp edges turn on hinges, and feet
     * with rounded edges roll. */
    double feet;
    double radius; /* radius of rounded edges, relative to the height */
    /* length by which the upper back edge is cut off, relative to the height; masses are unaffected */
    double bevel;
};

/* Initialiser for a row of solid, frictionless boxes on hinges. A caller may change members afterwards. */
#define ENGINE_ROW(box_, count_)                                                                             \
    {                                                                                                        \
        .box = (box_), .count = (count_), .g = 1, .push = (double)NAN, .feet = (double)INFINITY              \
    }

/* The resolution of a computation. A caller refines both numbers until the result stops changing. */
struct engine_grain {
    /* Number of steps per unit of time. The unit is sqrt(height / g) of the foremost moving box. A box also
     * takes at least this many steps to turn by one radian. */
    double steps;
    /* The impulses of contacts and hinges are found by iteration. The error in an impulse may change a
     * velocity by at most this fraction of the velocity's whole change in the step. */
    double tolerance;
};

/* The record of a box that was hit. */
struct engine_hit {
    /* Time of the hit, measured from the push or, without a push, from the first hit. NaN for a box that is
     * released instead of hit. */
    double time;
    /* Time at which the box hits the next one, or comes to rest on the floor. NaN if the box does neither, or
     * was released instead of hit. */
    double until;
    double omega;   /* angular velocity after the hit; 0 if the box has hardly moved */
    double kinetic; /* kinetic energy of all boxes after the hit */
    /* Distance that the foot slides until the end of the run; negative if it slides backwards. */
    double slid;
};

struct engine_fall {
    bool all;  /* true if all boxes fall */
    bool lies; /* true if the last box that was hit has fallen to the floor */
    /* True if the first box touches the second while it is being tipped over its edge. The row is not run in
     * this case. */
    bool leans;
    size_t hits;    /* number of boxes that were hit, including the first */
    double seconds; /* time until the last box lies on the floor, or until the row has come to rest */
    double zero;    /* zero point of all other times, measured from the start of the run */
    /* The deepest penetration of one box into another, relative to the height of the rear box. */
    double depth;
    double drift; /* the largest distance of a corner from its hinge, relative to the height */
    /* The largest increase of energy from one hit to the next, relative to the kinetic energy at the second
     * of these hits. */
    double gain;
    /*
     * The smallest value of omega / omega_max, where omega is the angular velocity of the foremost box, and
     * omega_max is its maximum since the box was hit. A row that almost stops has a small value. The value is
     * 0 if the foremost box made any contact other than tip to back face.
     */
    double slowest;
    /* How close the foremost box came to falling by itself: its largest tilt, relative to the tilt at which
     * it balances on its lower front corner. The value is 1 if the box went beyond its balance point. */
    double climbed;
    /* true if a contact occurred that was not between the tip of one box and the back face of the next box */
    bool other_contact;
};

enum engine_status {
    ENGINE_OK,
    ENGINE_NO_LIBRARY, /* Chipmunk is not installed */
    ENGINE_NO_MEMORY,
    ENGINE_INTERRUPTED,
    ENGINE_NO_END /* after a very large number of steps, the row had neither fallen nor come to rest */
};

/* The largest number of boxes in a row. The time that a run takes grows with the square of this number. */
enum { ENGINE_MOST = 200 };

/* Loads the engine, unless an earlier call has already loaded it. Returns ENGINE_OK, ENGINE_NO_LIBRARY or
 * ENGINE_NO_MEMORY. */
enum engine_status engine_load(void);

/* Returns the version of the engine, or NULL if it cannot be loaded. */
const char *engine_version(void);

/* The state of a row during a run. For k < count, tilt[k] is the tilt of box k, and foot[k] the distance that
 * its foot has slid. */
struct engine_moment {
    double time;
    size_t head;  /* index of the foremost box that was hit */
    size_t count; /* number of boxes in the engine so far; all later boxes still stand upright */
    const double *tilt, *foot;
};
typedef bool engine_visit(const struct engine_moment *moment, void *context);

/*
 * Runs a row once. `hit` is an array of row->count elements, or NULL. `visit`, which may be NULL, is called
 * after each step and returns false to end the run. If both are NULL, the run ends as soon as the verdict is
 * certain, and fall->seconds is the time at which the run ended.
 */
enum engine_status engine_run(const struct engine_row *row, const struct engine_grain *grain,
                              const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                              engine_visit *visit, void *context, struct engine_fall *fall);

/* The result of repeating a run with shorter and shorter steps. */
struct engine_settled {
    struct engine_fall fall;
    struct engine_grain grain; /* the resolution of the last run */
    /* The largest change in any time when the step length was last halved, as a fraction of the duration. NaN
     * if the verdict changed or if times were not requested. */
    double change;
    bool same; /* true if the verdict did not change when the step length was last halved */
};

/* engine_settle stops refining when no time changes by more than the fraction ENGINE_AGREES of the duration,
 * or when a run has used ENGINE_FINEST steps per unit of time. */
#define ENGINE_AGREES 0.01
#define ENGINE_FINEST 1600

/* The resolution with which engine_settle starts if times are requested. It is good enough for a rough
 * answer. */
extern const struct engine_grain engine_coarsest;

/*
 * Runs a row repeatedly, and halves the step length until the verdict no longer changes. If `times` is false,
 * a coarse first run with a certain verdict is not repeated. If `times` is true, the times of all hits must
 * also change by at most ENGINE_AGREES times the duration. Never takes more than ENGINE_FINEST steps per unit
 * of time. `hit` is an array of row->count elements; it may be NULL if `times` is false.
 */
enum engine_status engine_settle(const struct engine_row *row, bool times,
                                 const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                                 struct engine_settled *settled);

#endif
