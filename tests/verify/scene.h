/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scene, which is a row of boxes in the engine and the same row in the model. */
#ifndef VERIFY_SCENE_H
#define VERIFY_SCENE_H

#include "../unit/ask.h"
#include "engine/engine.h"

struct scene {
    double s, q, mu, r; /* r is not used in a search for the largest growth */
    size_t count;       /* number of dominoes, at most SCENE_MOST; the first has the height 1, and g is 1 */
    double push;        /* initial angular velocity of the first domino */
    double bevel;       /* bevel of the boxes in the engine */
};

enum { SCENE_MOST = 64 };

/* Returns the row for the engine. The next call overwrites its boxes. */
struct engine_row scene_boxes(const struct scene *scene);

/* A value of the engine, and its uncertainty. */
struct found {
    double value;
    /* The change of the value when the steps were last halved, or half of the previous change if that is
     * larger. */
    double change;
    double steps;       /* steps per sqrt(height / g) in the last run */
    bool same;          /* true if neither two more dominoes nor more exact impulses change the value */
    bool other_contact; /* true if a run had a contact that the model does not have */
    double depth, drift;
};

/*
 * Steps are halved until a halving changes the value by a fraction of less than scene_still, or until
 * scene_finest is reached. The remaining first-order error is as large as the last change. A difference of up
 * to scene_allowed times the last change, or times scene_still, counts as agreement, because the verdict of a
 * row also depends on where in a step a hit happens.
 */
extern const double scene_still, scene_finest, scene_allowed;
extern const double scene_bracket; /* relative width to which growths are bisected */

/* Returns the allowed difference, relative to the value. */
double scene_uncertain(const struct found *found);

/* Raises the growth from 1 until the row no longer falls and finds the last growth at which it falls. */
void scene_growth(const struct scene *scene, struct found *found);
double scene_growth_of_row(const struct scene *scene);

/* Finds the mean duration of the last SCENE_CYCLES cycles, from hit to hit, each in tau of its head. The
 * durations of the engine are extrapolated to steps of length 0. */
enum { SCENE_CYCLES = 4 };
void scene_duration(const struct scene *scene, struct found *found);
double scene_duration_of_row(const struct scene *scene);

struct setup scene_train(const struct scene *scene);

#endif
