/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs rows in the rigid-body engine if an effect that the model lacks is on, or after 'set method engine'.
 * The library's searches and studies of such rows also call the engine, through struct dom_engine. */
#ifndef SHELL_ENGINE_H
#define SHELL_ENGINE_H

#include "engine/engine.h"
#include "session/scene.h"

/* The values of the parameter 'method'. */
enum { METHOD_MODEL, METHOD_ENGINE };

/* Results of one run of the engine that the library does not need. */
struct engine_report {
    /* in m, s and kg; the caller provides the array, with one element for each domino */
    struct engine_hit *hit;
    struct engine_settled settled; /* in the engine's units */
};

struct scene_engine {
    struct domq_engine engine; /* engine.own points to this struct */
    struct engine_row effects; /* the engine's settings for the effects that the library lacks */
    /* each run fills in this report; NULL if no report is wanted, as in studies */
    struct engine_report *report;
};

/* Returns true if the rigid-body engine runs the row of the scene instead of the model. */
bool scene_has_engine(const struct scene *scene);

/* Returns the reason why the engine runs the row, such as "feet is on" or "method is engine". */
const char *scene_engine_why(const struct scene *scene);

/* Prepares the engine for a row of `count` dominoes. Sets *problem and returns false if the engine is not
 * installed, cannot run that many dominoes, or does not include an effect that is on. */
bool scene_engine_make(const struct scene *scene, size_t count, struct scene_engine *engine,
                       struct problem *problem);

/* Runs a row once with coarse steps, so that the caller can measure how long a run takes. */
enum dom_status scene_engine_rough(const struct domq_row *row, const struct domq_compute *compute);

/*
 * Does the same as domq_row_watch, but in the engine, with the step size that an earlier run stored in the
 * report. Before each visit, sets feet[k] to the distance in m that the foot of domino k, counted from 0, has
 * slid.
 */
enum dom_status scene_engine_watch(const struct domq_row *row, const struct domq_compute *compute,
                                   const domq_real *times, size_t count, domq_moment_visit *visit,
                                   void *context, double *feet);

#endif
