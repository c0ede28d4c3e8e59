/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The list of all parameters: those of the model, the settings of the calculator, and the effects, whose
 * default is off. The commands set, effect, show, reset, save, sweep, help and apropos and the completion all
 * work from this list. Code that only one parameter needs is a hook in the parameter's entry.
 */
#ifndef SHELL_PARAMETER_LIST_H
#define SHELL_PARAMETER_LIST_H

#include "session/effects.h"

/* A word that stands for a value, such as hollow = 3 or exact = 0. */
struct word {
    const char *name;
    domq_real value;
};

struct parameter {
    const char *name;
    /* Describes the parameter's value, whose default is the member `usual`. For an effect, this is an array
     * that describes all values of the effect. */
    const struct domq_effect_argument *value;
    const char *help;     /* the text of 'help'; may be NULL */
    const char *synonyms; /* words that people may use instead, separated by blanks; may be NULL */
    /* NULL unless the parameter is an effect. For an effect, `help` and `synonyms` above are NULL, because
     * the description of the effect contains them. */
    const struct domq_effect *effect;
    int which;                /* the number of the effect, if the parameter is an effect */
    const struct word *words; /* words for some of the values; may be NULL */
    /* the parameter takes only these words, and its value is stored as an unsigned */
    bool words_only;
    /* The parameter is a setting of the calculator. 'reset' does not change it unless its name is given. */
    bool setting;
    bool of_precision; /* the default and the lowest value depend on the precision, as for tol */
    const char *moves; /* the name of another parameter that may change when this one is set; may be NULL */
    size_t offset;     /* the offset of the value in struct state; not used for effects */

    /* Hooks; each may be NULL. */
    /* Sets *problem and returns false if a value is in the range but cannot be combined with the state. */
    bool (*check)(const struct state *state, domq_real value, struct problem *problem);
    /* Changes other members of the state before the value is stored. */
    void (*before)(struct state *state, domq_real value);
};

/* All parameters in the order in which 'show' lists them, and then the effects. A NULL name ends the
 * table. */
extern const struct parameter session_parameters[];

#endif
