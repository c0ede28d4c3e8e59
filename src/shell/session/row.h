/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes the dominoes of the scene's row, and changes their measures. */
#ifndef SHELL_ROW_H
#define SHELL_ROW_H

#include "session/engine.h"
#include "session/row_change.h"

/* The row of a scene. The caller frees `domino`. */
struct scene_row {
    struct domq_row row;
    struct domq_compute compute;
    struct domq_domino *domino;
    struct engine_report report; /* what the engine found, for commands that request it */
    /* `row.engine` may point to this member, so the struct must not be copied. */
    struct scene_engine engine;
};

/*
 * Makes the row so that it can be run, by the model or, if the scene uses it, by the rigid-body engine.
 * Returns false with a problem if there is no row, no memory or no engine, or if a domino would fall over by
 * itself.
 */
bool scene_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Makes the row so that it can be listed. Unlike scene_row_make, this function does not check that the row
 * can be run. */
bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Fills in the first `count` dominoes of the row, with the measures that 'change' has changed and with their
 * masses. */
void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count);

/* Returns true if the masses of the row are known. If they are, energies are in J; otherwise energies are in
 * m g h / 2 of the first domino. */
bool scene_has_masses(const struct scene *scene);

/* Returns a measure of a domino in m or kg: for a lean the distance of the top off plumb, and for a radius
 * that of 'effect edges' if the domino has none of its own. */
domq_real scene_row_measure(const struct scene *scene, const struct domq_domino *domino,
                            enum row_measure measure);

/*
 * Changes one measure of the dominoes in some ranges. A domino whose height or thickness changes keeps its
 * density. The changes are lost when the row is replaced. Returns false with a problem if there is no such
 * domino, or if a domino cannot have the new measure; nothing has changed then.
 */
bool scene_row_change(struct scene *scene, const struct row_change *change, const struct row_range *range,
                      int ranges, struct problem *problem);

#endif
