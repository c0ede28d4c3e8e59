/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of all parameters: those of the model, the settings of the calculator, and the effects, whose
 * default is off. Completion works from this list, and so do the commands set, effect, show, reset, save,
 * sweep, help and apropos. Code that only one parameter needs is a hook in the parameter's entry. */
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
    /* The description of the parameter's value, including the default, `usual`. For an effect, an array with
     * a description of each value. */
    const struct domq_effect_argument *value;
    const char *help;     /* the text that 'help' shows; may be NULL */
    const char *synonyms; /* other words for the parameter, separated by blanks; may be NULL */
    /* For an effect, its description, which contains the help and the synonyms; `help` and `synonyms` above
     * are NULL. For any other parameter, NULL. */
    const struct domq_effect *effect;
    int which;                /* the number of the effect, if the parameter is an effect */
    const struct word *words; /* words for some of the values; may be NULL */
    /* the value must be one of `words`, and is stored as an unsigned */
    bool words_only;
    /* The parameter is a setting of the calculator. 'reset' leaves it unchanged unless its name is given. */
    bool setting;
    /* the default and the lower bound depend on the precision, as for tol */
    bool of_precision;
    /* the name of another parameter, which may change when this one is set; NULL if there is none */
    const char *moves;
    size_t offset; /* the offset of the value in struct state; not used for effects */

    /* Hooks; each may be NULL. */
    /* Checks whether a value in the range can be combined with the values of other parameters. If not, sets
     * *problem and returns false. */
    bool (*check)(const struct state *state, domq_real value, struct problem *problem);
    /* Changes other members of the state before the value is stored. */
    void (*before)(struct state *state, domq_real value);
};

/* All parameters, in the order in which 'show' lists them, followed by the effects. The name in the last
 * entry is NULL. */
extern const struct parameter session_parameters[];

#endif
