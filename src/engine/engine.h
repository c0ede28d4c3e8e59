/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row of boxes in a rigid-body engine. This folder has no equations about dominoes: boxes with a size, a
 * mass and a moment of inertia stand on hinges or on a floor with friction, collide, and are pulled by
 * gravity.
 */
#ifndef ENGINE_H
#define ENGINE_H

#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

/* The gap is the free distance to the box before this one. The gap of the first box is not read. */
struct engine_box {
    double height, thickness, gap, mass;
    double inertia; /* moment of inertia about its centre over that of a solid box; 0 means a solid box */
    double radius;  /* of its edges, if the row has rounded edges; 0 means the radius of the row */
};

struct engine_row {
    const struct engine_box *box;
    size_t count;
    double g;
    double push; /* angular velocity of the first box; NaN if it is tipped over its edge and let go instead */
    double slope;  /* the angle by which the floor falls in the direction of the row */
    double mu;     /* friction between boxes */
    double bounce; /* restitution between boxes */
    double feet;   /* friction of the floor; if infinite, a foot is a hinge, or rolls if it is rounded */
    double radius; /* of rounded edges, over the height */
    double bevel;  /* the share of the height by which the upper back edge is cut off; masses stay the same */
};

/* Initializer of a row of solid boxes on hinges without any effect. Change what differs. */
#define ENGINE_ROW(box_, count_)                                                                             \
    {                                                                                                        \
        .box = (box_), .count = (count_), .g = 1, .push = (double)NAN, .feet = (double)INFINITY              \
    }

/* How fine a computation is. A caller refines both numbers until the answer stops changing. */
struct engine_grain {
    double steps;   /* in sqrt(height / g) of the foremost moving box, and in each radian that it turns */
    int iterations; /* of the engine's solver in a step; a collision takes fifty times as many */
};

/* A box that was hit. */
struct engine_hit {
    double time;    /* of the hit, since the push or else since the first hit; NaN before that */
    double until;   /* the time when it hits the next box, or lies; NaN if it does neither */
    double omega;   /* its angular velocity just after it was hit; 0 if it has hardly moved */
    double kinetic; /* the kinetic energy of all boxes at that time */
    double slid;    /* how far its foot has slid when the row ends; negative if it has slid backwards */
};

struct engine_fall {
    bool all;       /* all boxes fall */
    bool lies;      /* the last box that was hit lies */
    bool leans;     /* the first box, tipped over its edge, would already touch the second; nothing was run */
    size_t hits;    /* number of boxes that were hit, the first included */
    double seconds; /* until the last box lies, or the row has come to rest */
    double zero;    /* the time since the start at which the clock starts */
    double depth;   /* the deepest penetration of a box, over its height */
    double drift;   /* the largest distance of a corner from its hinge, over the height */
    double gain;    /* the largest growth of energy between two hits, over the kinetic energy at the second */
    bool caught;    /* boxes have touched in another way than with a tip on the back face of the next box */
};

enum engine_status {
    ENGINE_OK,
    ENGINE_NO_LIBRARY, /* Chipmunk is not installed */
    ENGINE_NO_MEMORY,
    ENGINE_INTERRUPTED,
    ENGINE_NO_END /* the row has neither fallen nor come to rest after very many steps */
};

/* The largest number of boxes in a row. The time that a run takes grows with its square. */
enum { ENGINE_MOST = 200 };

/* Loads the engine unless an earlier call has loaded it. Returns ENGINE_OK, ENGINE_NO_LIBRARY or
 * ENGINE_NO_MEMORY. */
enum engine_status engine_load(void);

/* Returns the version of the engine, or NULL if it cannot be loaded. */
const char *engine_version(void);

/* The row at one time since the start. tilt[k] is the tilt of box k, and foot[k] is the distance that its
 * foot has slid, for k < count. */
struct engine_moment {
    double time;
    size_t head;  /* index of the foremost box that was hit */
    size_t count; /* number of boxes in the engine so far; all others stand */
    const double *tilt, *foot;
};
typedef bool engine_visit(const struct engine_moment *moment, void *context);

/*
 * Runs a row once. `hit` has room for row->count boxes, or is NULL. visit, which may be NULL, is called after
 * each step and returns false to end the run.
 */
enum engine_status engine_run(const struct engine_row *row, const struct engine_grain *grain,
                              const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                              engine_visit *visit, void *context, struct engine_fall *fall);

/* The result of runs with ever shorter steps. */
struct engine_settled {
    struct engine_fall fall;
    double steps;  /* of the last run */
    double change; /* the largest change of a time when the steps were last halved, over the last time */
    bool same;     /* the verdict did not change when the steps were last halved */
};

/* The largest relative change of a time that counts as settled, and the finest steps. */
#define ENGINE_AGREES 0.01
#define ENGINE_FINEST 1600

/* The grain with which engine_settle begins, and with which a rough answer is found. */
extern const struct engine_grain engine_coarsest;

/*
 * Runs a row and halves the steps until the verdict no longer changes, and with `times` until the times of
 * all hits change by less than ENGINE_AGREES, or until the steps are as short as ENGINE_FINEST. `hit` is as
 * in engine_run; it may not be NULL with `times`.
 */
enum engine_status engine_settle(const struct engine_row *row, bool times,
                                 const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                                 struct engine_settled *settled);

#endif
