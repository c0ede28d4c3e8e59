/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row as bodies in Chipmunk: how the boxes stand, touch and start. */
#ifndef ENGINE_WORLD_H
#define ENGINE_WORLD_H

#include "chipmunk.h"
#include "engine.h"

/* A box in the space. */
struct body {
    cpBody *body;
    cpShape *shape;
    cpConstraint *hinge, *limit; /* NULL if the box stands on a floor */
    cpVect corner;               /* position of the lower front corner at the start */
    double moment;
};

struct world {
    const struct chipmunk *cp;
    const struct engine_row *row;
    struct engine_fall *fall;
    struct engine_hit *hit; /* may be NULL */
    bool has_room;          /* room_take has reserved memory for the space */
    cpSpace *space;
    cpShape *floor; /* NULL if the boxes stand on hinges */
    struct body *body;
    size_t count, head; /* number of boxes in the space, and index of the foremost box that was hit */
    double now;
    double energy; /* energy of the boxes in the space when the head was hit */
};

/* Creates a world with the first box, which is pushed or tips over. world_free frees the world and must be
 * called after an error, too. */
enum engine_status world_make(struct world *world);
void world_free(struct world *world);

/* Adds the next box in its upright position. */
void world_stand(struct world *world);

/* Return the tilt of box k, its angular velocity, and the positions of its upper and its lower front
 * corner. */
double world_tilt(const struct world *world, size_t k);
double world_spin(const struct world *world, size_t k);
cpVect world_tip(const struct world *world, size_t k);
cpVect world_foot(const struct world *world, size_t k);

/* Returns the foremost point of the upper or of the lower front edge, which may be rounded. */
cpVect world_front(const struct world *world, size_t k, bool upper);

/* Return the kinetic energy and the total energy of all boxes in the space. */
double world_kinetic(const struct world *world);
double world_energy(const struct world *world);

#endif
