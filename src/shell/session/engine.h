/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs rows in the rigid-body engine. After 'set method engine', the engine runs every row. After 'set method
 * model', it runs only rows with an effect that the model lacks, such as 'set feet'. The library's
 * searches and studies call the engine through struct domq_engine. */
#ifndef SHELL_ENGINE_H
#define SHELL_ENGINE_H

#include "session/engine_api.h"
#include "session/scene.h"

/* The values of the parameter 'method'. */
enum { METHOD_MODEL, METHOD_ENGINE };

/* Results of an engine run that commands show but the library does not need. */
struct engine_report {
    /* the hits in m, s and kg; the caller provides an element for each domino */
    struct engine_hit *hit;
    struct engine_settled settled; /* in the engine's units */
};

struct scene_engine {
    struct domq_engine engine; /* engine.context points to this struct */
    struct engine_row effects; /* the settings of the effects that only the engine has */
    /* Each run that computes times fills in this report. NULL if no report is needed, as in studies. */
    struct engine_report *report;
};

/* Sets the engine of this build. Without one, no row can be run that needs it. */
void scene_engine_use(const struct engine_driver *driver);

/* Returns the version of the engine, or NULL if it cannot be loaded. */
const char *scene_engine_version(void);

/* Returns true if the rigid-body engine, rather than the model, runs the row of the scene. */
bool scene_has_engine(const struct scene *scene);

/* Returns why the engine runs the row, such as "feet is on" or "method is engine". */
const char *scene_engine_why(const struct scene *scene);

/*
 * Prepares the engine for a row of `count` dominoes. Sets *problem and returns false in these cases:
 * - The engine cannot be loaded, for example because it is not installed.
 * - The row is too long for the engine.
 * - The engine cannot compute one of the effects that are on.
 */
bool scene_engine_make(const struct scene *scene, size_t count, struct scene_engine *engine,
                       struct problem *problem);

/* Runs a row once with coarse steps. The caller measures how long this takes. */
enum dom_status scene_engine_rough(const struct domq_row *row, const struct domq_compute *compute);

/* Does the same as domq_row_watch, but in the engine. The step size comes from the report of an earlier run.
 * Before each call of `visit`, stores in feet[k] how far the foot of domino k has slid, in m. k is counted
 * from 0. */
enum dom_status scene_engine_watch(const struct domq_row *row, const struct domq_compute *compute,
                                   const domq_real *times, size_t count, domq_moment_visit *visit,
                                   void *context, double *feet);

#endif
