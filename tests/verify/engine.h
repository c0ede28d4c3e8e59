/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row of boxes in Chipmunk, a public rigid-body engine. This file contains no equation of domino: boxes
 * have a size, a mass, and a hinge at their front lower corner; neighbours collide without restitution, and
 * gravity pulls.
 */
#ifndef VERIFY_ENGINE_H
#define VERIFY_ENGINE_H

#include <stdbool.h>
#include <stddef.h>

enum { ENGINE_MOST = 64 };

/* The gap is the free distance to the box before it; that of the first is not read. */
struct engine_box {
    double height, thickness, gap, mass;
};

struct engine_row {
    struct engine_box box[ENGINE_MOST];
    size_t count;
    double g, push; /* push: angular velocity of the first, upright box */
    double mu;
    double bevel; /* cuts off the upper back edge by this part of the height; masses stay the same */
};

/* How fine the computation is: refine both numbers until they no longer matter. */
struct engine_grain {
    double steps;   /* in sqrt(height / g) of the foremost moving box, and in a radian that it turns */
    int iterations; /* of the engine's solver in a step; fifty times as many in a collision */
};

struct engine_fall {
    bool all;                 /* true: all boxes fall */
    size_t hits;              /* boxes that were hit, the first included */
    double time[ENGINE_MOST]; /* when */
    bool caught;  /* true: boxes touched in another way than by the tip of one on the back face of the next */
    double depth; /* the deepest penetration, over the height of the follower */
    double drift; /* the farthest that a corner strays from its hinge, over the height */
};

/* Returns name and version. The first call also keeps the engine from writing its name to standard output. */
const char *engine_name(void);

/* Runs a row. Returns false if the row has neither fallen nor stopped after very many steps. */
bool engine_run(const struct engine_row *row, const struct engine_grain *grain, struct engine_fall *fall);

#endif
