/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row of boxes in a rigid-body engine. This folder contains no equation of domino: boxes have a size, a
 * mass and a moment of inertia; they stand on hinges or on a floor with friction, collide, and gravity pulls.
 */
#ifndef ENGINE_H
#define ENGINE_H

#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

/* The gap is the free distance to the box before it; that of the first is not read. */
struct engine_box {
    double height, thickness, gap, mass;
    double inertia; /* moment of inertia about its centre, over that of a solid box; 0: a solid box */
    double radius;  /* of its edges, if those of the row are rounded; 0: as the row says */
};

struct engine_row {
    const struct engine_box *box;
    size_t count;
    double g;
    double push;  /* angular velocity of the first, upright box; NaN: it is tipped over its edge and let go */
    double slope; /* the angle by which the floor falls in the direction of the row */
    double mu;    /* friction between boxes */
    double bounce; /* restitution between boxes */
    double feet;   /* friction of the floor; infinite: each foot is a hinge, or rolls if it is rounded */
    double radius; /* of rounded edges, over the height */
    double bevel;  /* cuts off the upper back edge by this part of the height; masses stay the same */
};

/* A row of solid boxes on hinges, without any effect: change what differs. */
#define ENGINE_ROW(box_, count_)                                                                             \
    {                                                                                                        \
        .box = (box_), .count = (count_), .g = 1, .push = (double)NAN, .feet = (double)INFINITY              \
    }

/* How fine a computation is: the numbers are right once it does not matter to refine them. */
struct engine_grain {
    double steps;   /* in sqrt(height / g) of the foremost moving box, and in a radian that it turns */
    int iterations; /* of the engine's solver in a step; fifty times as many in a collision */
};

/* A box that was hit. */
struct engine_hit {
    double time;    /* when; the clock starts with the push, or else with the first hit. NaN: before that */
    double until;   /* when it hits the next, or lies; NaN: it does neither */
    double omega;   /* its angular velocity just after it was hit; 0 if it has hardly moved */
    double kinetic; /* of all boxes then */
    double slid;    /* how far its foot has slid when the row ends; negative: backwards */
};

struct engine_fall {
    bool all;    /* true: all boxes fall */
    bool lies;   /* true: the last box that was hit lies */
    bool leans;  /* true: the first box, tipped over its edge, would already touch the second; nothing ran */
    size_t hits; /* boxes that were hit, the first included */
    double seconds; /* until the last box lies, or the row has come to rest */
    double zero;    /* when the clock starts, in time since the start */
    double depth;   /* the deepest penetration of a box, over its height */
    double drift;   /* the farthest that a corner strays from its hinge, over the height */
    double gain;    /* the largest growth of energy between two hits, over the kinetic energy at the second */
    bool caught; /* true: boxes touched in another way than by the tip of one on the back face of the next */
};

enum engine_status {
    ENGINE_OK,
    ENGINE_NO_LIBRARY, /* Chipmunk is not installed */
    ENGINE_NO_MEMORY,
    ENGINE_INTERRUPTED,
    ENGINE_NO_END /* the row has neither fallen nor come to rest after very many steps */
};

/* The most boxes of a row; the time that a run takes grows with their square. */
enum { ENGINE_MOST = 200 };

/* Loads the engine, unless an earlier call has: ENGINE_OK, ENGINE_NO_LIBRARY or ENGINE_NO_MEMORY. */
enum engine_status engine_load(void);

/* Returns the version of the engine; NULL if it cannot be loaded. */
const char *engine_version(void);

/* The row at one time since the start; tilt[k] and foot[k], the distance that the foot has slid, are of box
 * k, for k < count.
 */
struct engine_moment {
    double time;
    size_t head, count; /* index of the foremost box that was hit; boxes that are known, all others stand */
    const double *tilt, *foot;
};
typedef bool engine_visit(const struct engine_moment *moment, void *context);

/*
 * Runs a row once. hit, unless NULL, has room for row->count boxes. visit, unless NULL, is called after each
 * step, and returns false to end the run.
 */
enum engine_status engine_run(const struct engine_row *row, const struct engine_grain *grain,
                              const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                              engine_visit *visit, void *context, struct engine_fall *fall);

/* A run with steps so short that they no longer matter. */
struct engine_settled {
    struct engine_fall fall;
    double steps;  /* of the last run */
    double change; /* the largest change of a time when steps were last halved, over the last time */
    bool same;     /* true: the verdict was the same then */
};

/* Times that agree to this share are settled; steps are not halved further than this. */
#define ENGINE_AGREES 0.01
#define ENGINE_FINEST 1600

/* The grain with which engine_settle begins, and with which a rough answer is found. */
extern const struct engine_grain engine_coarsest;

/*
 * Runs a row, halving the steps until the verdict no longer changes, and with `times` until the times of all
 * hits agree to the share ENGINE_AGREES; or until they are as short as ENGINE_FINEST. hit as in engine_run,
 * and needed for times.
 */
enum engine_status engine_settle(const struct engine_row *row, bool times,
                                 const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                                 struct engine_settled *settled);

#endif
