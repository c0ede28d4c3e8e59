/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects that a session's scene asks for, and the row that they may make of it. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "language/names.h"
#include "session/session.h"

/* For names.h. */
const char *effect_names(const void *context, int k);

/* Where the word is an effect, says so in the message of what it is not. */
bool effect_hint(const char *word, char message[NAMES_MESSAGE]);

/* "friction MU". */
enum { EFFECT_USAGE = 64 };
const char *effect_usage(enum dom_effect_name name, char usage[EFFECT_USAGE]);

/* "0.2", "13", "record.csv"; "" where it is off. */
enum { EFFECT_SETTING = 256 }; /* the longest name of a file */
const char *effect_setting(const struct session *session, enum dom_effect_name name,
                           char setting[EFFECT_SETTING]);

/*
 * Turns an effect on; values that are not given are the usual ones.  path, unless NULL, is the file in the
 * place of its first argument.  False: an error was reported, and nothing has changed; but
 * a file that gives no row leaves none in force, nor what needs one, and the error says so.
 */
bool effect_turn_on(struct session *session, enum dom_effect_name name, const domq_real *value, int given,
                    const char *path);
/*
 * The first value of an effect, which is on then, into a session that borrows its row: that is not given
 * back. effect_needs: is there what it says nothing without?  An error if not.
 */
void effect_put(struct session *session, enum dom_effect_name name, domq_real value);
bool effect_needs(struct session *session, enum dom_effect_name name);

bool effect_turn_off(struct session *session, enum dom_effect_name name);

/*
 * Reports an error where a saved session could not name the row's file: a control character, such as a new
 * line, would begin a command of its own.  Every other name is read back byte for byte.
 */
bool effects_savable(struct session *session);

/* Writes the commands that turn off what is off here, for a session that has it on. */
void effects_save_off(const struct session *session, FILE *out);

/* The commands that turn on again what is on. */
void effects_save(const struct session *session, FILE *out);

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

/* Are masses known, so that energies are in J?  Else they are in m g h / 2 of the first domino. */
bool scene_weighed(const struct session *session);

/* Changes the gap before domino k, from 1, until another row is taken. */
bool scene_row_place(struct session *session, size_t k, domq_real gap);

#endif
