/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Turns effects on and off, and makes the row of the scene. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "session/engine.h"
#include "session/query.h"

/* Writes the values of an effect: "0.2", "1 m, 0.1", "record.csv", "off". */
enum { EFFECT_SETTING = 256 }; /* the longest name of a file, and a NUL byte */
const char *effect_setting(const struct scene *scene, int name, char setting[EFFECT_SETTING]);

/* Returns the path of the file that replaces the first value of an effect, or NULL. */
const char *effect_file(const struct scene *scene, int name);

/* Turns an effect on or off. Values that are not given are the usual ones. After an error nothing has
 * changed. */
bool effect_turn(struct scene *scene, int name, const domq_real *value, int given, struct problem *problem);

/* Sets the first value of an effect, which may be EFFECT_OFF, in a copy of a scene that borrows its row. */
void effect_put(struct scene *scene, int name, domq_real value);

/* Returns true if the effects that an effect needs are on, and none is on that excludes it. Otherwise
 * describes the problem. */
bool effect_needs(const struct scene *scene, int name, struct problem *problem);

/*
 * Returns true if 'save' can write the name of the row's file. Otherwise describes the problem: a control
 * character, such as a line end, would begin another command.
 */
bool effects_savable(const struct scene *scene, struct problem *problem);

/* Writes the commands that restore an effect, for a script in a folder; the folder may be NULL. The effect
 * 'row' includes the gaps that were changed. */
void effect_save(const struct scene *scene, int name, const char *folder, FILE *out);

/* ---- The row ---- */

/* The row of a scene. The caller frees `domino`. */
struct scene_row {
    struct domq_row row;
    struct domq_compute compute;
    struct domq_domino *domino;
    struct engine_report report; /* for the commands that want it */
    struct scene_engine engine;  /* row.engine may point into it, so the struct must not be copied */
};

/*
 * Makes the row, to be run by the model, or by the rigid-body engine if the scene has it. Returns false with
 * a problem if there is no row, no memory or no engine, or if a domino falls over by itself.
 */
bool scene_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Makes the row, to be listed: nothing is checked that only matters when it runs. */
bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Writes the dominoes of the row, with their changed gaps and their masses. */
void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count);

/* Returns true if masses are known. Energies are then in J, and otherwise in m g h / 2 of the first domino.
 */
bool scene_has_masses(const struct scene *scene);

/* Turns on the effect 'row' with the dominoes of a file. After an error there is no row, and the message says
 * so, so that no command answers for an earlier row. */
bool scene_row_load(struct scene *scene, const char *name, const struct means *means,
                    struct problem *problem);

/* Changes the gap before domino k, from 1. Another row forgets the change. */
bool scene_row_place(struct scene *scene, size_t k, domq_real gap, struct problem *problem);

#endif
