/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Runs rows in the rigid-body engine: rows with an effect that the model lacks, and all rows after 'set
 * method engine'. The searches and studies of the library then call the engine through struct dom_engine.
 */
#ifndef SHELL_ENGINE_H
#define SHELL_ENGINE_H

#include "engine/engine.h"
#include "session/scene.h"

/* The values of the parameter 'method'. */
enum { METHOD_MODEL, METHOD_ENGINE };

/* What the engine finds in one run, besides what the library asks for. */
struct engine_report {
    struct engine_hit *hit; /* in m and s; the caller provides an element for each domino */
    struct engine_settled settled;
    double seconds; /* until the row has fallen or stopped */
};

struct scene_engine {
    struct domq_engine engine;    /* its member `own` points to this struct */
    struct engine_row effects;    /* the effects that the library lacks */
    struct engine_report *report; /* is filled by a run, unless it is NULL, as it must be for studies */
};

/* Returns true if the engine runs the rows of the scene. */
bool scene_has_engine(const struct scene *scene);

/* Returns the reason why the engine runs the rows: "feet is on", "method is engine". */
const char *scene_engine_why(const struct scene *scene);

/*
 * Prepares the engine for a row of `count` dominoes. Returns false with a problem if the engine is not
 * installed, or cannot run so many dominoes, or lacks an effect that is on.
 */
bool scene_engine_make(const struct scene *scene, size_t count, struct scene_engine *engine,
                       struct problem *problem);

/* Runs a row once with coarse steps, to measure the time. */
enum dom_status scene_engine_rough(const struct domq_row *row, const struct domq_compute *compute);

/*
 * Does what domq_row_watch does, with the step size that an earlier run has left in the report. Before each
 * visit, `feet` is filled: how far the foot of each domino has slid, in m.
 */
enum dom_status scene_engine_watch(const struct domq_row *row, const struct domq_compute *compute,
                                   const domq_real *times, size_t count, domq_moment_visit *visit,
                                   void *context, double *feet);

#endif
