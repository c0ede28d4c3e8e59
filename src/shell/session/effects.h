/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Turns effects on and off. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "session/query.h"
#include "session/row.h"

/* Returns the values of an effect for messages, as in "1 m, 0.1", "record.csv" or "off". The text lives until
 * the end of the caller's block. */
enum { EFFECT_SETTING = 256 }; /* the longest file name has 255 bytes */
#define effect_setting(scene, effect) effect_setting_write(scene, effect, (char[EFFECT_SETTING]){""})
const char *effect_setting_write(const struct scene *scene, int effect, char setting[EFFECT_SETTING]);

/* Returns the path of the effect's file, or NULL if the user gave none. */
const char *effect_file(const struct scene *scene, int effect);

/* Fills `all` with the values of an effect. The first `given` values come from `value`; the rest are the
 * usual values. value[0] may be EFFECT_OFF or EFFECT_ON. Sets *problem and returns false if a required value
 * is missing, or if the effect cannot be turned off because another effect needs it. */
bool effect_complete(const struct scene *scene, int effect, const domq_real *value, int given,
                     domq_real all[DOM_EFFECT_ARGUMENTS], struct problem *problem);

/* Sets value[0] of an effect to `value`, which may be EFFECT_OFF, and the other values to `others`. If
 * `others` is NULL, the other values of an active effect do not change, and an inactive effect gets the usual
 * ones. The row is not freed, so the scene must not own it. */
void effect_put(struct scene *scene, int effect, domq_real value, const domq_real *others);

/* Returns true if all effects that `effect` needs are on, and if `effect` can be combined with the current
 * 'fuel'. Otherwise reports the problem. */
bool effect_check_needs(const struct scene *scene, int effect, struct problem *problem);

/* Reports a problem and returns false if the path of the row's file contains a control character. In a saved
 * script, the text after a newline would be another command. */
bool effects_savable(const struct scene *scene, struct problem *problem);

/* Writes the commands that give an effect its current values. `folder` is the directory of the script, or
 * NULL. For the effect 'row', also writes the 'change' commands. */
void effect_save(const struct scene *scene, int effect, const char *folder, FILE *out);

/* Turns on the effect 'row' with the dominoes of a file. On failure, sets *problem and returns false. An
 * earlier row is then turned off, so that later answers are not silently about the earlier row. */
bool scene_row_load(struct scene *scene, const char *name, const struct run_context *run_context,
                    struct problem *problem);

#endif
