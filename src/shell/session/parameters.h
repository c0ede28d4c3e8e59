/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The registry of parameters: one table of all parameters, of the model, of the calculator, and of the
 * effects, each of which is a parameter whose default is off.  A row drives set, effect, show, reset, save,
 * sweep, help, apropos and completion.  What is special to a parameter is a hook in its row.
 */
#ifndef SHELL_PARAMETERS_H
#define SHELL_PARAMETERS_H

#include "session/effects.h"
#include "session/query.h"

/* A name for a value: hollow = 3, exact = 0. */
struct word {
    const char *name;
    domq_real value;
};

struct parameter {
    const char *name;
    /* What it takes: one value, whose .usual is the default, or the arguments of an effect. */
    const struct domq_effect_argument *value;
    const char *help;                 /* more, or NULL */
    const char *synonyms;             /* other words that people look for, for 'apropos'; not of an effect */
    const struct domq_effect *effect; /* NULL: not an effect */
    int which;                        /* of the effect */
    const struct word *words;         /* names for some values; NULL for none */
    bool words_only;                  /* stored as an unsigned */
    bool setting;                     /* of the calculator, not of the model: reset without a name keeps it */
    const char *moves;                /* a parameter that a change of this one may change too; or NULL */
    size_t offset;                    /* in struct state; not of an effect */

    /* Hooks; NULL where nothing is special. */
    /* Return the default and the lowest value, where the arithmetic of the session's precision decides. */
    domq_real (*fallback_of)(const struct domq_arithmetic *arithmetic);
    domq_real (*lowest_of)(const struct domq_arithmetic *arithmetic);
    /* Describes a problem where the state cannot take the value, though it is in the range. */
    bool (*check)(const struct state *state, domq_real value, struct problem *problem);
    /* Stores the value and changes what follows from it. */
    void (*put)(struct state *state, domq_real value);
};

/* All parameters in the order of show, then the effects; ends with a NULL name. */
extern const struct parameter session_parameters[];

/* Lists for names.h: the parameters; the words of the parameter that is the context. */
const char *parameter_names(const void *context, int k);
const char *parameter_words(const void *parameter, int k);

/* Lists the words without synonyms: of the words for one value the first. */
const char *parameter_offered(const void *parameter, int k);

/* Returns the parameter with this name, or NULL. */
const struct parameter *parameter_find(const char *name);

/* Returns what the parameter's i-th value is, counted from 0; NULL after the last one. */
const struct domq_effect_argument *parameter_value(const struct parameter *parameter, int i);

/* Return what the parameter means, in a few words; and more about it, or NULL. */
const char *parameter_meaning(const struct parameter *parameter);
const char *parameter_help(const struct parameter *parameter);

/* Returns other words that people look for, or NULL. */
const char *parameter_synonyms(const struct parameter *parameter);

/* Returns true for a parameter that is a number in expressions: 'print 2*s'. */
bool parameter_is_number(const struct parameter *parameter);

/* Returns the value, the first one of an effect; EFFECT_OFF for an effect that is off. */
domq_real parameter_get(const struct state *state, const struct parameter *parameter);

/* Returns the default at the session's precision; EFFECT_OFF for an effect. */
domq_real parameter_fallback(const struct state *state, const struct parameter *parameter);

/*
 * Stores a value that is in the range, and what follows from it, into a session that may be a copy: what the
 * copy shares with others is not freed.
 */
void parameter_put(struct state *state, const struct parameter *parameter, domq_real value);

/*
 * Gives a parameter these values, which are in their ranges, as 'set' does; path, unless NULL, is a file
 * instead of the first value. Returns false after an error, see effect_turn.
 */
bool parameter_set(struct state *state, const struct parameter *parameter, const domq_real *value, int given,
                   const char *path, const struct means *means, struct problem *problem);

/* A parameter or effect and its value, EFFECT_OFF for an effect that is to be off. */
struct assigned {
    const struct parameter *parameter;
    domq_real value;
};
enum { ASSIGNED_MAX = 8 };

/*
 * Gives parameters values in a copy of a state, which shares its memory with the original and must not be
 * closed: words first, since the precision has its own default of tol. Describes a problem if a value is not
 * in its range, or if an effect needs another one that is off.
 */
bool state_assign(struct state *state, const struct assigned *assigned, int count, struct problem *problem);

/*
 * Returns the parameters in an order in which 'set' can take them, NULL after the last: first the effects
 * that are off, then how answers are written, then words, since the smallest tol depends on the precision,
 * then numbers, and then the effects that are on.
 */
const struct parameter *parameter_in_order(const struct state *state, int k);

/* Writes the command that gives the parameter the value that it has in the session, into a file of this
 * folder (see effect_save). */
void parameter_save(const struct state *state, const struct parameter *parameter, const char *folder,
                    FILE *out);

/* Reports an error unless the i-th value may be this one. */
bool parameter_check(const struct state *state, const struct parameter *parameter, int i, domq_real value,
                     struct problem *problem);

/* Returns the name of a value that has one, else NULL. */
const char *parameter_word(const struct parameter *parameter, domq_real value);

/* Writes the range of the i-th value: "1e-12 .. 1", or "exact|paper". */
void parameter_range(const struct state *state, const struct parameter *parameter, int i, char *text,
                     size_t size);

/* Writes a value as 'set' reads it. */
void parameter_text(const struct parameter *parameter, domq_real value, int digits, char *text, size_t size);

/* Returns the style of answers, in the format that 'set output' has chosen. */
struct answer_style state_style(const struct state *state);

#endif
