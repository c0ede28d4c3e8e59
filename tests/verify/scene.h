/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One scene for both: a row of boxes in the engine, and the same row in the model. */
#ifndef VERIFY_SCENE_H
#define VERIFY_SCENE_H

#include "../unit/ask.h"
#include "engine/engine.h"

struct scene {
    double s, q, mu, r; /* r is not used if it is searched */
    size_t count;       /* number of dominoes, the first of height 1; g = 1; at most SCENE_MOST */
    double push;        /* angular velocity that the first gets */
    double bevel;       /* of the engine's boxes */
    /* What only the engine has; the friction of the floor is 0 where feet are hinges. */
    double feet, bounce, slope, radius;
};

enum { SCENE_MOST = 64 };

/* Returns the row in the engine. Its boxes are those of the last call. */
struct engine_row scene_boxes(const struct scene *scene);

/* A value of the engine, and its uncertainty. */
struct found {
    double value;
    /* change of the value when steps were last halved, or half of the change before if that is more */
    double change;
    double steps; /* in sqrt(height / g), the last time */
    bool same;    /* true: two more dominoes, and more exact impulses, change nothing */
    bool caught;  /* as in engine_fall, with the last steps */
    double depth, drift;
};

/*
 * Steps are halved until the value changes by less than the part scene_still, which then is the remaining
 * error of first order, or until scene_finest is reached. A difference of scene_allowed times the last
 * change, or times that part, counts as agreement: the verdict of a row also depends on where in a step a hit
 * happens.
 */
extern const double scene_still, scene_finest, scene_allowed;
extern const double scene_bracket; /* growths are bisected to it */

/* Returns the allowed difference, as a part of the value. */
double scene_uncertain(const struct found *found);

/* Finds the largest growth at which the row falls, raised from 1. */
void scene_growth(const struct scene *scene, struct found *found);
double scene_growth_of_row(const struct scene *scene);

/* Finds the mean of the last cycles, from hit to hit, each in tau of its head; the engine's are extrapolated
 * to steps of 0. */
enum { SCENE_CYCLES = 4 };
void scene_duration(const struct scene *scene, struct found *found);
double scene_duration_of_row(const struct scene *scene);

struct asked scene_train(const struct scene *scene);

#endif
