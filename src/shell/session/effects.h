/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Turns effects on and off. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "language/quad.h"
#include "session/query.h"
#include "session/row.h"

/* Returns the values of an effect for messages, as in "1 m, 0.1", "record.csv" or "off". The text lives until
 * the end of the caller's block. */
enum { EFFECT_SETTING = 256 }; /* the longest file name has 255 bytes */
#define effect_setting(scene, effect) effect_setting_write(scene, effect, (char[EFFECT_SETTING]){""})
const char *effect_setting_write(const struct scene *scene, int effect, char setting[EFFECT_SETTING]);

/* Returns the path of the effect's file, or NULL if the user gave none. */
const char *effect_file(const struct scene *scene, int effect);

/* Fills the array `all` with the values of an effect. The user has given the first `given` values, in the
 * array `value`. The other values are the usual ones. value[0] may be EFFECT_OFF or EFFECT_ON. Sets *problem
 * and returns false if a required value is missing, or if the effect cannot be turned off because another
 * effect needs it. */
bool effect_complete(const struct scene *scene, int effect, const domq_real *value, int given,
                     domq_real all[DOM_EFFECT_ARGUMENTS], struct problem *problem);

/* Sets the values of an effect: value[0] to `value`, which may be EFFECT_OFF, and the other values to
 * `others`. If `others` is NULL, an effect that is already on keeps its other values, and an effect that is
 * off gets the usual ones. If the effect is 'row', the memory of the row is not freed, so the scene must not
 * own this memory. */
void effect_put(struct scene *scene, int effect, domq_real value, const domq_real *others);

/* Returns true if an effect can be turned on: all effects that it needs must be on, and the current 'fuel'
 * must not exclude it. If the effect cannot be turned on, sets *problem and returns false. */
bool effect_check_needs(const struct scene *scene, int effect, struct problem *problem);

/* Returns true if the effects can be saved as a script. A saved script names the file of the row. If the path
 * contains a control character, the text after it might be read as another command, so this is reported as a
 * problem. */
bool effects_savable(const struct scene *scene, struct problem *problem);

/* Writes the command that gives an effect its current values. `folder` is the directory of the script, or
 * NULL. */
void effect_save(const struct scene *scene, int effect, const char *folder, FILE *out);

#endif
