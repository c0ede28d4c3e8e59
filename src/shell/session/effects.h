/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Turns effects on and off. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "session/query.h"
#include "session/row.h"

/* Returns the values of an effect in the form that messages show, such as "0.2", "1 m, 0.1", "record.csv" or
 * "off". The text lives until the end of the block that contains the call. */
enum { EFFECT_SETTING = 256 }; /* the longest file name has 255 bytes */
#define effect_setting(scene, name) effect_setting_write(scene, name, (char[EFFECT_SETTING]){""})
const char *effect_setting_write(const struct scene *scene, int name, char setting[EFFECT_SETTING]);

/* Returns the path of the file that the user gave instead of the effect's first value, or NULL if the user
 * gave no file. */
const char *effect_file(const struct scene *scene, int name);

/*
 * Completes the values of an effect. `value` holds the `given` values that the user typed; the first of them
 * may be EFFECT_OFF or EFFECT_ON. Copies them to `all`, and adds the usual value for each one that the user
 * left out. Sets *problem and returns false if a value that is not optional is missing, or if the effect
 * cannot be turned off because another effect needs it.
 */
bool effect_complete(const struct scene *scene, int name, const domq_real *value, int given,
                     domq_real all[DOM_EFFECT_ARGUMENTS], struct problem *problem);

/*
 * Sets the values of an effect: the first one to `value`, which may be EFFECT_OFF, and the others to
 * `others`. If `others` is NULL, an effect that is on keeps its other values, and an effect that is off gets
 * the usual values. The scene must be a copy that does not own the memory of its row, because this function
 * replaces the row without freeing it.
 */
void effect_put(struct scene *scene, int name, domq_real value, const domq_real *others);

/* Returns true if all effects that effect `name` needs are on, and if the effect can be combined with the
 * current 'fuel'. Otherwise reports the problem. */
bool effect_needs(const struct scene *scene, int name, struct problem *problem);

/*
 * Reports a problem and returns false if the name of the row's file contains a control character. 'save'
 * cannot write such a name into a script: after a newline, for example, the rest of the name would be another
 * command.
 */
bool effects_savable(const struct scene *scene, struct problem *problem);

/* Writes the commands that give an effect its current values. `folder` is the directory of the script that
 * the commands go to, or NULL. For the effect 'row', also writes 'change' commands for the dominoes that have
 * been changed. */
void effect_save(const struct scene *scene, int name, const char *folder, FILE *out);

/* Turns on the effect 'row' with the dominoes of a file. On failure, sets *problem, returns false and turns
 * off the earlier row, if there was one. If that row stayed on, later commands would silently compute answers
 * for it. */
bool scene_row_load(struct scene *scene, const char *name, const struct means *means,
                    struct problem *problem);

#endif
