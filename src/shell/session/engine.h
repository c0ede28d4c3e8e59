/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rows that a rigid-body engine runs: those with an effect that the model lacks, and any row after 'set
 * method engine'. The library's searches and studies then ask the engine, see struct dom_engine.
 */
#ifndef SHELL_ENGINE_H
#define SHELL_ENGINE_H

#include "engine/engine.h"
#include "session/scene.h"

/* What 'method' may be. */
enum { METHOD_MODEL, METHOD_ENGINE };

/* What the engine found besides the answer of the library, for one run. */
struct engine_report {
    struct engine_hit *hit; /* of each domino that was hit, in m and s; of the caller */
    struct engine_settled settled;
    double seconds; /* until the row has fallen or stopped */
};

/* How a row is run by the engine. */
struct scene_engine {
    struct domq_engine engine;    /* for the row; its own is this */
    struct engine_row effects;    /* the effects that the library lacks */
    struct engine_report *report; /* unless NULL, takes what one run finds; not for studies */
};

/* Returns true if the engine runs the rows of this session. */
bool scene_has_engine(const struct scene *scene);

/* Returns why: "feet is on", "method is engine". */
const char *scene_engine_why(const struct scene *scene);

/*
 * Prepares the engine. Reports an error if it is not installed, or if a row of so many dominoes or an effect
 * that is on is not for it.
 */
bool scene_engine_make(const struct scene *scene, size_t count, struct scene_engine *engine,
                       struct problem *problem);

/* Runs a row once with coarse steps, for its cost. */
enum dom_status scene_engine_rough(const struct domq_row *row, const struct domq_compute *compute);

/*
 * Does what domq_row_watch does, with the steps of the report, which an earlier run has filled. feet, of the
 * row's length, takes how far each foot has slid, in m, before each visit.
 */
enum dom_status scene_engine_watch(const struct domq_row *row, const struct domq_compute *compute,
                                   const domq_real *times, size_t count, domq_moment_visit *visit,
                                   void *context, double *feet);

#endif
