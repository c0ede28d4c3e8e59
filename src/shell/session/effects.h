/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Turns effects on and off, and makes the dominoes of the scene's row. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "session/engine.h"
#include "session/query.h"

/* Writes the values of an effect for people, such as "0.2", "1 m, 0.1", "record.csv" or "off". */
enum { EFFECT_SETTING = 256 }; /* room for the longest name of a file and a NUL byte */
const char *effect_setting(const struct scene *scene, int name, char setting[EFFECT_SETTING]);

/* Returns the path of the file that replaces the first value of an effect, or NULL. */
const char *effect_file(const struct scene *scene, int name);

/*
 * Completes the values that a user gives to an effect: `given` values, of which the first may be EFFECT_OFF
 * or EFFECT_ON. The usual values are used for the others. Returns false with a problem if a value is missing
 * that has no usual one, or if the effect is turned off while another effect needs it.
 */
bool effect_complete(const struct scene *scene, int name, const domq_real *value, int given,
                     domq_real all[DOM_EFFECT_ARGUMENTS], struct problem *problem);

/*
 * Sets the first value of an effect to `value`, which may be EFFECT_OFF, and its other values to `others`. If
 * `others` is NULL, an effect that is on keeps its other values, and an effect that is off gets the usual
 * ones. The scene must be a copy that borrows the memory of its row from the original, because this function
 * does not free the row that it replaces.
 */
void effect_put(struct scene *scene, int name, domq_real value, const domq_real *others);

/* Returns true if all effects that an effect needs are on, and if the effect can be combined with the fuel.
 * Otherwise reports the problem. */
bool effect_needs(const struct scene *scene, int name, struct problem *problem);

/*
 * Returns true if 'save' can write the name of the row's file. Otherwise reports the problem: the name has a
 * control character such as a line end, after which a script would read the remainder as another command.
 */
bool effects_savable(const struct scene *scene, struct problem *problem);

/* Writes the commands that restore an effect. `folder` is the directory of the script that gets the commands,
 * or NULL. For the effect 'row', the commands also restore the gaps that 'place' changed. */
void effect_save(const struct scene *scene, int name, const char *folder, FILE *out);

/* ---- The row ---- */

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

/* Fills in the first `count` dominoes of the row, with the gaps that 'place' changed and with their
 * masses. */
void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count);

/* Returns true if the masses of the row are known. If they are, energies are in J; otherwise energies are in
 * m g h / 2 of the first domino. */
bool scene_has_masses(const struct scene *scene);

/* Turns on the effect 'row' with the dominoes of a file. After an error the row is off, and the message says
 * so. If an earlier row stayed on, later commands would silently compute answers for it. */
bool scene_row_load(struct scene *scene, const char *name, const struct means *means,
                    struct problem *problem);

/* Changes the gap before domino k to a length in m. Dominoes are numbered from 1. The change is lost when the
 * row is replaced. */
bool scene_row_place(struct scene *scene, size_t k, domq_real gap, struct problem *problem);

#endif
