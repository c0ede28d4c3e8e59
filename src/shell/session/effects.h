/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects that are on in a session's scene, and the row that they may make of it. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "session/session.h"
#include <math.h>

/* Beside its numbers, an effect has these values: off; and on, as it is, or with the usual values. */
#define EFFECT_OFF ((domq_real)-HUGE_VAL)
#define EFFECT_ON  ((domq_real)HUGE_VAL)

static inline const struct domq_effect *effect_at(int k)
{
    return domq_effect((enum dom_effect_name)k);
}

/* For names.h: the effects. */
const char *effect_names(const void *context, int k);

/* Returns true for the name of an effect, and writes into the message how it is turned on. */
bool effect_hint(const char *word, char message[NAMES_MESSAGE]);

/* Writes "friction MU". */
enum { EFFECT_USAGE = 64 };
const char *effect_usage(enum dom_effect_name name, char usage[EFFECT_USAGE]);

/* Writes what the effect is set to: "0.2", "1 m, 0.1", "record.csv", "off". */
enum { EFFECT_SETTING = 256 }; /* the longest name of a file */
const char *effect_setting(const struct session *session, enum dom_effect_name name,
                           char setting[EFFECT_SETTING]);

/* Returns the file that stands in the place of the effect's first value, or NULL. */
const char *effect_file(const struct session *session, enum dom_effect_name name);

/* Writes commands that show the effect. */
enum { EFFECT_EXAMPLE = 128 };
const char *effect_example(enum dom_effect_name name, char example[EFFECT_EXAMPLE]);

/*
 * Turns an effect on or off; values that are not given are the usual ones.  path, unless NULL, is the file in
 * the place of its first argument.  Returns false after an error, and nothing has changed then; but a file
 * that gives no row leaves none in force, nor what needs one, and the error says so.
 */
bool effect_turn(struct session *session, enum dom_effect_name name, const domq_real *value, int given,
                 const char *path);

/* Gives an effect its first value, or EFFECT_OFF, in a session that borrows its row, which is not freed. */
void effect_put(struct session *session, enum dom_effect_name name, domq_real value);

/* Reports an error if an effect that this one needs is off, or what it cannot be combined with is on. */
bool effect_needs(struct session *session, enum dom_effect_name name);

/*
 * Reports an error where a saved session could not name the row's file: a control character, such as a new
 * line, would begin a command of its own.  Every other name is read back byte for byte.
 */
bool effects_savable(struct session *session);

/* Writes the command that turns the effect off, or on with its values, and the gaps of its row that changed.
 */
void effect_save(const struct session *session, enum dom_effect_name name, FILE *out);

/* ---- The row ---- */

/*
 * The row of the scene, ready to run, of dominoes that are the caller's: free() them.  Energies come in the
 * unit that session_energy_unit names.
 */
struct scene_row {
    struct domq_row row;
    struct domq_compute compute;
    struct domq_domino *domino;
};

/* False: there is no row, or no memory, which was reported. */
bool scene_row_make(struct session *session, struct scene_row *row);

/* Fills domino[0] to domino[count - 1] with the row that the session has, its changes and masses included. */
void scene_row_fill(const struct session *session, struct domq_domino *domino, size_t count);

/* Are masses known, so that energies are in J?  Else they are in m g h / 2 of the first domino. */
bool scene_weighed(const struct session *session);

/* Changes the gap before domino k, from 1, until another row is taken. */
bool scene_row_place(struct session *session, size_t k, domq_real gap);

#endif
