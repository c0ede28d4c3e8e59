/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Represents a row as bodies in a space of the rigid-body engine Chipmunk 7, and handles their contacts. The
 * library is loaded only when needed, since it may not be installed. */
#ifndef ENGINE_WORLD_H
#define ENGINE_WORLD_H

#include "engine.h"
#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>

/* Calls X(name) for each function of the library that is used. Few of them are getters and setters, since
 * most members of Chipmunk's structures are used directly. */
#define CHIPMUNK_FUNCTIONS(X)                                                                                \
    X(cpSpaceNew)                                                                                            \
    X(cpSpaceFree)                                                                                           \
    X(cpSpaceStep)                                                                                           \
    X(cpSpaceAddDefaultCollisionHandler)                                                                     \
    X(cpSpaceAddBody)                                                                                        \
    X(cpSpaceAddShape)                                                                                       \
    X(cpSpaceAddConstraint)                                                                                  \
    X(cpSpaceRemoveBody)                                                                                     \
    X(cpSpaceRemoveShape)                                                                                    \
    X(cpSpaceRemoveConstraint)                                                                               \
    X(cpBodyNew)                                                                                             \
    X(cpBodyFree)                                                                                            \
    X(cpBodySetPosition)                                                                                     \
    X(cpBodySetAngle)                                                                                        \
    X(cpBodyGetVelocityAtWorldPoint)                                                                         \
    X(cpPolyShapeNewRaw)                                                                                     \
    X(cpSegmentShapeNew)                                                                                     \
    X(cpShapeFree)                                                                                           \
    X(cpPivotJointNew)                                                                                       \
    X(cpRotaryLimitJointNew)                                                                                 \
    X(cpConstraintFree)

struct chipmunk {
#define CHIPMUNK_MEMBER(name) __typeof__(name) *name;
    CHIPMUNK_FUNCTIONS(CHIPMUNK_MEMBER)
#undef CHIPMUNK_MEMBER
    char version[24]; /* "7.0.3" */
};

/* Sets *functions. The first call loads the library. Thread-safe. Returns DOM_NO_METHOD or
 * DOM_NO_MEMORY if loading fails. */
enum dom_status chipmunk_load(const struct chipmunk **functions);

/*
 * Chipmunk crashes if an allocation fails. So a space is created only if there is enough memory for this
 * space and for all existing spaces. chipmunk_reserve reserves memory for a space with this many boxes, or
 * returns false. chipmunk_release ends the reservation after the space has been freed. Thread-safe.
 */
bool chipmunk_reserve(size_t boxes);
void chipmunk_release(size_t boxes);

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
    bool has_room;          /* true if chipmunk_reserve has reserved memory for the space */
    cpSpace *space;
    cpShape *floor; /* NULL if the boxes stand on hinges */
    struct body *body;
    size_t count, head; /* number of boxes in the space, and index of the foremost box that was hit */
    double now;
    struct cpConstraint watch; /* ends the iterations of a step */
    double tolerance;          /* tolerance of the impulses, as in struct engine_grain */
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

/* These functions return the tilt and the angular velocity of box k, and its upper and lower front
 * corners. */
double world_tilt(const struct world *world, size_t k);
double world_spin(const struct world *world, size_t k);
cpVect world_tip(const struct world *world, size_t k);
cpVect world_foot(const struct world *world, size_t k);

/* Returns the foremost point of the upper or lower front edge of box k, which may be rounded. */
cpVect world_front(const struct world *world, size_t k, bool upper);

/* Returns the kinetic energy of all boxes in the space. */
double world_kinetic(const struct world *world);

#endif
