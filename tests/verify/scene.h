/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One scene for both: a row of boxes in the engine, and the same row in the model. */
#ifndef VERIFY_SCENE_H
#define VERIFY_SCENE_H

#include "../unit/ask.h"
#include "engine.h"

struct scene {
    double s, q, mu, r; /* r is not used where it is sought */
    size_t count;       /* dominoes, the first as high as 1, where g = 1 */
    double push;        /* angular velocity that the first gets */
    double bevel;       /* of the engine's boxes */
};

/* What was found in the engine, and how well. */
struct found {
    double value;
    double change; /* of the value when steps were last halved, or half of that before if it is more */
    double steps;  /* in sqrt(height / g), the last time */
    bool same;     /* two more dominoes, and twice the iterations, change nothing */
    bool caught;   /* as in engine_fall, with the last steps */
    double depth, drift;
};

/*
 * Steps are halved until that changes less than the share scene_still of a value, which is then what is left
 * of an error of first order, or scene_finest is reached.  scene_allowed times what the last halving changed,
 * or that share, counts as agreement: the verdict of a row also depends on where in a step it is hit.
 */
extern const double scene_still, scene_finest, scene_allowed;
extern const double scene_bracket; /* growths are bisected to it */

/* The share of the value that is allowed. */
double scene_uncertain(const struct found *found);

/* The largest growth at which the row falls, raised from 1. */
void scene_growth(const struct scene *scene, struct found *found);
double scene_growth_of_row(const struct scene *scene);

/* The last cycles, from hit to hit, on the average, each in tau of its head; the engine's are extrapolated to
 * steps of 0. */
enum { SCENE_CYCLES = 4 };
void scene_duration(const struct scene *scene, struct found *found);
double scene_duration_of_row(const struct scene *scene);

struct asked scene_train(const struct scene *scene);

#endif
