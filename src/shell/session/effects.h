/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Turns effects on and off. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "session/query.h"
#include "session/row.h"

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
 * or NULL. For the effect 'row', the commands also restore the measures that 'change' has changed. */
void effect_save(const struct scene *scene, int name, const char *folder, FILE *out);

/* Turns on the effect 'row' with the dominoes of a file. After an error the row is off, and the message says
 * so. If an earlier row stayed on, later commands would silently compute answers for it. */
bool scene_row_load(struct scene *scene, const char *name, const struct means *means,
                    struct problem *problem);

#endif
