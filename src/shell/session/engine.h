/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs rows in a rigid-body engine, which is a feature. After 'set method engine', the engine runs every row.
 * After 'set method model', it runs only rows with an effect that the model lacks, such as 'set feet'. The
 * library's searches and studies call the engine through struct dom_engine. */
#ifndef SHELL_ENGINE_H
#define SHELL_ENGINE_H

#include "session/scene.h"

/* The values of the parameter 'method'. */
enum { METHOD_MODEL, METHOD_ENGINE };

/* Results of an engine run that commands show but the library does not need. */
struct engine_report {
    /* How far the foot of each domino that was hit has slid, in m; negative if it slid backwards. The caller
     * provides an element for each domino. */
    double *slid;
    bool lies; /* the last domino that was hit has fallen to the floor */
    /* How much the last halving of the time step changed the times: the largest change of any time, divided
     * by the duration. */
    double change;
    double steps;     /* time steps per sqrt(h/g) in the last run */
    double tolerance; /* how accurate the velocities are after each step of that run */
    double zero; /* the time in s from the start of that run to the moment from which times are measured */
};

struct scene_engine {
    struct dom_engine engine; /* engine.context points to this struct */
    double feet;              /* friction coefficient of the floor; infinite if feet are hinged to it */
    double bounce;            /* coefficient of restitution between dominoes */
    /* Each run that computes times fills in this report. NULL if no report is needed, as in studies. */
    struct engine_report *report;
};

struct engine_driver {
    /* Returns the version of the engine, or NULL if it cannot be loaded. */
    const char *(*version)(void);
    /*
     * Prepares the engine for a row of `count` dominoes. Sets *problem and returns false in these cases:
     * - The engine cannot be loaded, for example because it is not installed.
     * - The row is too long for the engine.
     * - The engine cannot compute one of the effects that are on.
     */
    bool (*make)(const struct scene *scene, size_t count, struct scene_engine *engine,
                 struct problem *problem);
    /* Does the same as any_row_watch, but in the engine. The step size comes from the report of an earlier
     * run. Before each call of `visit`, stores in feet[k] how far the foot of domino k has slid, in m. k is
     * counted from 0. */
    enum dom_status (*watch)(const struct domq_row *row, const struct any_compute *compute,
                             const domq_real *times, size_t count, domq_moment_visit *visit, void *context,
                             double *feet);
};

/* The engine of this build. Without one there are no parameters that need it, so no row asks for it. */
extern const struct engine_driver *row_engine;

/* Returns true if the rigid-body engine, rather than the model, runs the row of the scene. */
bool scene_has_engine(const struct scene *scene);

/* Returns why the engine runs the row, such as "feet is on" or "method is engine". */
const char *scene_engine_why(const struct scene *scene);

#endif
