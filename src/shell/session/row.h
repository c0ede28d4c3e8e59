/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes the row of a scene and changes the measurements of its dominoes. */
#pragma once

#include "precision/any.h"
#include "session/scene.h"

/* ---- The rigid-body engine, which is a feature. After 'set method engine', the engine runs every row. After
 * 'set method model', it runs only rows with an effect that the model lacks, such as 'set feet'. The
 * library's searches and studies call the engine through struct dom_engine. ---- */

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
    /* Does the same as dom_row_watch, but in the engine. The step size comes from the report of an earlier
     * run. Before each call of `visit`, stores in feet[k] how far the foot of domino k has slid, in m. k is
     * counted from 0. */
    enum dom_status (*watch)(const struct dom_row *row, const struct dom_compute *compute,
                             const double *times, size_t count, dom_moment_visit *visit, void *context,
                             double *feet);
};

/* The engine of this build. Without one there are no parameters that need it, so no row asks for it. */
extern const struct engine_driver *row_engine;

/* Returns true if the rigid-body engine, rather than the model, runs the row of the scene. */
bool scene_has_engine(const struct scene *scene);

/* Returns why the engine runs the row, such as "feet is on" or "method is engine". */
const char *scene_engine_why(const struct scene *scene);

/* ---- The row ---- */

/* The row of a scene. The caller frees `domino`. */
struct scene_row {
    struct domq_row row;
    struct any_compute compute;
    struct domq_domino *domino;
    struct engine_report report; /* additional results of the engine, for the commands that show them */
    /* `row.engine` may point to this member, so the struct must not be copied. */
    struct scene_engine engine;
};

/* Makes the row of a scene and prepares it for a run in the model or in the engine. If there is no row, or
 * if the row cannot be run, sets *problem and returns false. */
bool scene_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Like scene_row_make, but does not prepare a run. It checks only that there is a row. */
bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Converts a row that scene_row_make has made to double, in which the library searches and runs many rows.
 * The caller frees made->domino. While made->row is used, `row` must exist, except its dominoes. */
static inline enum dom_status scene_row_in_double(const struct scene_row *row, struct double_row *made)
{
    return double_row_make(&row->row, &row->compute, made) ? DOM_OK : DOM_NO_MEMORY;
}

/* Checks that the walls fit into the dominoes of a row. */
bool scene_walls_fit(const struct scene *scene, const struct scene_row *row, struct problem *problem);

/* Fills in the first `count` dominoes of the row, with their masses and with the changes that the user has
 * made. If 'change' changes the height, the width stays as it was. */
void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count);

/* Returns the height in m of the first domino of the row or, if there is no row, of the train. */
domq_real scene_first_height(const struct scene *scene);

/* Returns the push in rad/s for a first domino of this height in m, or NaN if there is no push. A first
 * domino that is released at a tilt has a push of 0. */
domq_real scene_push(const struct scene *scene, domq_real height);

/* Returns the tilt in rad at which the first domino is released, as in struct domq_row. */
domq_real scene_release(const struct scene *scene);

/* Returns true if the masses of the row are known in kg. Energies are then in J. If the masses are not known,
 * the unit of energy is m g h/2 of the first domino. */
bool scene_has_masses(const struct scene *scene);

/* Reports that the session has no row. Returns false. */
bool problem_no_row(struct problem *problem);

/* ---- The changes to single dominoes, which commands such as 'change' and 'improve' make ---- */

/* Returns a pointer to the member that holds a measurement. `domino` may be the
 * member `to` of struct changed_domino. */
domq_real *row_measure_at(struct domq_domino *domino, enum row_measure measure);

/* Returns true if the measurement is a size: the height, the thickness or the width. When a size changes, the
 * domino keeps its density. */
static inline bool row_measure_is_size(enum row_measure measure)
{
    return measure == MEASURE_HEIGHT || measure == MEASURE_THICKNESS || measure == MEASURE_WIDTH;
}

/* Allocates the changes for a row of `count` dominoes, if necessary. Returns false if memory runs out. */
bool row_changes_open(struct listed_row *row, size_t count);
