/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Represents a row as bodies in a Chipmunk space and handles their contacts. */
#ifndef ENGINE_WORLD_H
#define ENGINE_WORLD_H

#include "chipmunk.h"
#include "engine.h"

/* penetration and drift are recorded for this many boxes up to the head */
enum { FOREMOST = 4 };

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
    double moment;
    /* the velocities before the first iteration of a step, and after the latest iteration */
    struct motion begin, now;
};

struct world {
    const struct chipmunk *cp;
    const struct engine_row *row;
    struct engine_fall *fall;
    struct engine_hit *hit; /* may be NULL */
    bool has_room;          /* true if room_take has reserved memory for the space */
    cpSpace *space;
    cpShape *floor; /* NULL if the boxes stand on hinges */
    struct body *body;
    size_t count, head; /* number of boxes in the space, and index of the foremost box that was hit */
    double now;
    double energy;             /* energy of all boxes in `space`, recorded when the head was hit */
    struct cpConstraint watch; /* ends the iterations of a step (converge.c) */
    double tolerance;          /* tolerance of the impulses, as in struct engine_grain */
    double change;             /* the largest change in any velocity during the last iteration */
};

/* Creates a world with the first box, which is pushed or tips over. Call world_free afterwards, even after an
 * error. */
enum engine_status world_make(struct world *world);
void world_free(struct world *world);

/* Adds the next box in its upright position. */
void world_add_box(struct world *world);

/*
 * Call converge_begin after the first box has been added, converge_step before each step, and converge_end
 * before the boxes are freed. The solver then iterates until its impulses have converged.
 */
void converge_begin(struct world *world);
void converge_step(struct world *world);
void converge_end(struct world *world);

/* Returns the components of the gravitational acceleration along the floor and perpendicular to it. */
cpVect world_gravity(const struct engine_row *row);

struct motion world_motion(const struct world *world, size_t k);

/* These functions return the tilt and the angular velocity of box k, and its upper and lower front
 * corners. */
double world_tilt(const struct world *world, size_t k);
double world_spin(const struct world *world, size_t k);
cpVect world_tip(const struct world *world, size_t k);
cpVect world_foot(const struct world *world, size_t k);

/* Returns the foremost point of the upper or lower front edge of box k, which may be rounded. */
cpVect world_front(const struct world *world, size_t k, bool upper);

/* These functions return the kinetic energy and the total energy of all boxes in the space. */
double world_kinetic(const struct world *world);
double world_energy(const struct world *world);

#endif
