/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The registry: one table of all parameters, of the model, of the calculator, and of the effects, which are
 * parameters whose default is off. The commands set, effect, show, reset, save, sweep, help and apropos and
 * the completion all work from its rows. Code for one parameter alone is a hook in its row.
 */
#ifndef SHELL_REGISTRY_H
#define SHELL_REGISTRY_H

#include "session/effects.h"

/* A word for a value: hollow = 3, exact = 0. */
struct word {
    const char *name;
    domq_real value;
};

struct parameter {
    const char *name;
    /* The only argument, whose `usual` is the default; or the arguments of an effect. */
    const struct domq_effect_argument *value;
    const char *help;     /* may be NULL */
    const char *synonyms; /* words that people may use instead, separated by blanks; may be NULL */
    const struct domq_effect
        *effect;              /* NULL for other parameters, and help and synonyms are NULL for effects */
    int which;                /* the number of the effect */
    const struct word *words; /* words for some of the values; may be NULL */
    bool words_only;          /* only these words are values; the member is an unsigned */
    bool setting;             /* belongs to the calculator: 'reset' keeps it unless it is named */
    bool of_precision;        /* the default and the lowest value depend on the precision, as for tol */
    const char *moves;        /* the name of a parameter that may change with this one; may be NULL */
    size_t offset;            /* of the member in struct state, unless the parameter is an effect */

    /* Hooks; each may be NULL. */
    /* Describes a problem if the state does not allow this value, although it is in the range. */
    bool (*check)(const struct state *state, domq_real value, struct problem *problem);
    /* Changes other members of the state before the value is stored. */
    void (*before)(struct state *state, domq_real value);
};

/* All parameters in the order in which 'show' lists them, and then the effects. A NULL name ends the table.
 */
extern const struct parameter session_parameters[];

#endif
