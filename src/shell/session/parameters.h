/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds parameters, and reads and changes their values in a state. */
#ifndef SHELL_PARAMETERS_H
#define SHELL_PARAMETERS_H

#include "session/query.h"
#include "session/registry.h"

/* ---- Descriptions ---- */

/* Lists for names.h: the parameters; the words of one parameter; the words without their synonyms. */
const char *parameter_names(const void *context, int k);
const char *parameter_words(const void *parameter, int k);
const char *parameter_offered(const void *parameter, int k);

/* Returns the parameter with this name, or NULL. */
const struct parameter *parameter_find(const char *name);

/*
 * Returns the parameter that has the word among its synonyms, or NULL. Among several parameters, the one in
 * whose list the word comes first is returned. *is_usual tells whether the word is the first of that list,
 * which is what most people call the parameter.
 */
const struct parameter *parameter_by_synonym(const char *word, bool *is_usual);

/* Returns true if a list of synonyms, which may be NULL, has the word. */
bool is_synonym(const char *synonyms, const char *word);

/* Appends to a message how to set the parameter with this synonym: "; did you mean 's'? 's = VALUE' ...".
 * Returns false if no parameter has this synonym. */
bool parameter_hint(const char *word, char *message, size_t size);

/* Returns the description of argument i, from 0, or NULL after the last argument. */
const struct domq_effect_argument *parameter_value(const struct parameter *parameter, int i);

/* These may return NULL, except for the meaning, which is a short phrase. */
const char *parameter_meaning(const struct parameter *parameter);
const char *parameter_help(const struct parameter *parameter);
const char *parameter_synonyms(const struct parameter *parameter);

/* Returns true if expressions can use the parameter as a number: 'print 2*s'. */
bool parameter_is_number(const struct parameter *parameter);

/* Returns the word for a value, or NULL. */
const char *parameter_word(const struct parameter *parameter, domq_real value);

/* Writes the range of argument i: "1e-12 .. 1", or "exact|paper". */
void parameter_range(const struct state *state, const struct parameter *parameter, int i, char *text,
                     size_t size);

/* Writes a value in the form that 'set' reads. */
void parameter_text(const struct parameter *parameter, domq_real value, int digits, char *text, size_t size);

/* ---- Values ---- */

/* Returns the value; for an effect its first argument, or EFFECT_OFF. */
domq_real parameter_get(const struct state *state, const struct parameter *parameter);

/* Returns the default at the precision of the state; EFFECT_OFF for an effect. */
domq_real parameter_fallback(const struct state *state, const struct parameter *parameter);

/* Returns true if a value is in the range of argument i. Otherwise describes the problem. */
bool parameter_check(const struct state *state, const struct parameter *parameter, int i, domq_real value,
                     struct problem *problem);

/* Gives a parameter `given` values, which are in their ranges. After an error nothing has changed. */
bool parameter_set(struct state *state, const struct parameter *parameter, const domq_real *value, int given,
                   struct problem *problem);

/* A parameter and its value, which may be EFFECT_OFF. */
struct assigned {
    const struct parameter *parameter;
    domq_real value;
};
enum { ASSIGNED_MAX = 8 };

/*
 * Gives parameters values in a copy of a state. The copy borrows the memory of the original, and must not be
 * closed. Words come first, because the range of tol depends on the precision. Describes a problem if a value
 * is out of its range, or if an effect needs another one that is off.
 */
bool state_assign(struct state *state, const struct assigned *assigned, int count, struct problem *problem);

/*
 * Lists the parameters, with NULL after the last one, in an order in which 'set' can restore the state: an
 * effect that needs another one is turned off before it and on after it, and tol comes after the precision.
 */
const struct parameter *parameter_in_order(const struct state *state, int k);

/* Writes a command that restores the value. effect_save explains the folder. */
void parameter_save(const struct state *state, const struct parameter *parameter, const char *folder,
                    FILE *out);

/* Returns the style of answers. */
struct answer_style state_style(const struct state *state);

#endif
