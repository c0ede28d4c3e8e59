/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes the plain row of a train, and prepares any row for a run in the model or in a rigid-body engine. */
#pragma once

#include "precision/any.h"
#include "session/scene.h"

struct engine_report; /* what an engine finds beyond what the library asks for */

/* A row that can be run. The caller frees `domino`. */
struct scene_row {
    struct domq_row row;
    struct any_compute compute;
    struct domq_domino *domino;
    /* `row.engine` may point to this member, so the struct must not be copied. */
    struct scene_engine {
        struct dom_engine engine; /* engine.context points to this struct */
        double feet;              /* friction coefficient of the floor; infinite if feet are hinged to it */
        double bounce;            /* coefficient of restitution between dominoes */
        /* Each run that computes times fills in this report. NULL if no report is needed, as in studies. */
        struct engine_report *report;
    } engine;
};

/* A rigid-body engine, which a feature provides. The library's searches and studies call it through struct
 * dom_engine. */
struct engine_driver {
    const char *train_note; /* what an answer about a train says where the engine would run a row */
    /* Returns why the engine runs the row of the scene, such as "feet is on", or NULL if the model runs it.
     */
    const char *(*why)(const struct scene *scene);
    /* Prepares the engine for a row, and sets row->row.engine and the members that its runs need. If the
     * engine cannot be loaded or cannot run this row, sets *problem and returns false. */
    bool (*make)(const struct scene *scene, struct scene_row *row, struct problem *problem);
};

/* The engine of this build, or NULL. */
extern const struct engine_driver *row_engine;

/* The note of answers about a train while a row is set, or NULL if this build has no rows. */
extern const char *row_note;

/* Returns why the rigid-body engine, rather than the model, runs the row of the scene, or NULL if the model
 * runs it. */
const char *scene_engine(const struct scene *scene);

/* Returns the note which tells the user that an answer about the train is not about the row, or about hinged
 * dominoes. Returns NULL if the scene needs no such note. */
const char *scene_train_note(const struct scene *scene);

/* Makes the row of the train that 'set row N' asks for, without what the slot of the scene says, and prepares
 * it for a run. If the row cannot be run, sets *problem and returns false. */
bool train_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Fills in the first `count` dominoes of that row, with their masses. */
void train_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count);

/* Scales the masses of a row. Before the call, only their ratios are correct. `first` gets the mass that
 * 'mass' or 'density' gives, and the other masses change by the same factor. If neither is known, m g h/2 of
 * `first` becomes 1. `first` may be one of the dominoes. */
void row_weigh(const struct scene *scene, const struct domq_domino *first, struct domq_domino *domino,
               size_t count);

/* Prepares the dominoes row->domino, of which there are row->row.count, for a run. The masses are in kg if
 * `has_masses` is true. If the row cannot be run, frees the dominoes, sets *problem and returns false. */
bool row_prepare(const struct scene *scene, bool has_masses, struct scene_row *row, struct problem *problem);

/* Converts a row that can be run to double, in which the library searches and runs many rows. The caller
 * frees made->domino. While made->row is used, `row` must exist, except its dominoes. */
static inline enum dom_status scene_row_in_double(const struct scene_row *row, struct double_row *made)
{
    return double_row_make(&row->row, &row->compute, made) ? DOM_OK : DOM_NO_MEMORY;
}

/* Checks that the walls fit into the dominoes of a row. */
bool scene_walls_fit(const struct scene *scene, const struct scene_row *row, struct problem *problem);

/* Returns the height in m of the first domino of the row or, if there is no row, of the train. */
domq_real scene_first_height(const struct scene *scene);

/* Returns the push in rad/s for a first domino of this height in m, or NaN if there is no push. A first
 * domino that is released at a tilt has a push of 0. */
domq_real scene_push(const struct scene *scene, domq_real height);

/* Returns the radius of the edges in a row, divided by the height, or 0. A radius that was typed as a length
 * is that of the first domino of the row. */
domq_real scene_edges(const struct scene *scene);

/* Returns the tilt in rad at which the first domino is released, as in struct domq_row. */
domq_real scene_release(const struct scene *scene);
