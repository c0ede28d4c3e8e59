/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects of a session, and its row. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "session/engine.h"
#include "session/query.h"
#include <math.h>

/* Values of an effect besides its numbers: off; and on, which keeps its values or takes the usual ones. */
#define EFFECT_OFF ((domq_real)-HUGE_VAL)
#define EFFECT_ON  ((domq_real)HUGE_VAL)

/* Returns the name of effect k, for names.h; NULL after the last. */
const char *effect_names(const void *context, int k);

/* Returns true for the name of an effect, and writes a message that shows how to turn the effect on. */
bool effect_hint(const char *word, char message[NAMES_MESSAGE]);

/* Writes the usage of an effect, such as "friction MU". */
enum { EFFECT_USAGE = 64 };
const char *effect_usage(int name, char usage[EFFECT_USAGE]);

/* Writes what the effect is set to: "0.2", "1 m, 0.1", "record.csv", "off". */
enum { EFFECT_SETTING = 256 }; /* room for the longest name of a file */
const char *effect_setting(const struct scene *scene, int name, char setting[EFFECT_SETTING]);

/* Returns the file that replaces the first value of the effect, or NULL. */
const char *effect_file(const struct scene *scene, int name);

/* Writes commands that show the effect. */
enum { EFFECT_EXAMPLE = 128 };
const char *effect_example(int name, char example[EFFECT_EXAMPLE]);

/*
 * Turns an effect on or off; values that are not given are the usual ones.  path, unless NULL, is a file that
 * replaces the first value.  Returns false after an error, and changes nothing then; but after an error in
 * the file of a row, the row and the effects that need one are off, and the message says so.
 */
bool effect_turn(struct scene *scene, int name, const domq_real *value, int given, const char *path,
                 const struct means *means, struct problem *problem);

/* Sets the first value of an effect, or EFFECT_OFF, in a copy of a session; the row, borrowed, is not freed.
 */
void effect_put(struct scene *scene, int name, domq_real value);

/* Reports an error if an effect that this one needs is off, or one that it cannot be combined with is on. */
bool effect_needs(const struct scene *scene, int name, struct problem *problem);

/*
 * Reports an error if a saved session could not name the file of the row: a control character in it, such as
 * a new line, would begin another command.  All other names are read back byte for byte.
 */
bool effects_savable(const struct scene *scene, struct problem *problem);

/* Writes the commands that turn the effect off, or on with its values and the changed gaps of its row.  A
 * file is named from the folder on if it is there or below; folder may be NULL. */
void effect_save(const struct scene *scene, int name, const char *folder, FILE *out);

/* ---- The row ---- */

/* The row of the scene, ready to run. The caller frees its dominoes. Energies are in the unit of the session.
 */
struct scene_row {
    struct domq_row row;
    struct domq_compute compute;
    struct domq_domino *domino;
    struct engine_report report; /* of the engine, where a command asks for it */
    struct scene_engine engine;  /* used if row.engine points to it: do not copy the struct then */
};

/*
 * Makes the row of the scene, which the rigid-body engine runs if the session asks for it. Reports an error
 * if there is no row, no memory, or no engine, or if a domino does not stand.
 */
bool scene_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* The same for a row that is not run. */
bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Writes the row of the session, with changed gaps and with masses, to domino[0] ... domino[count - 1]. */
void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count);

/* Returns true if masses are known: energies are then in J, else in m g h / 2 of the first domino. */
bool scene_weighed(const struct scene *scene);

/* Changes the gap before domino k, counted from 1, until another row is entered. */
bool scene_row_place(struct scene *scene, size_t k, domq_real gap, struct problem *problem);

#endif
