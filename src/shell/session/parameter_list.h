/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of all parameters: the parameters of the model, the settings of the calculator, and the effects.
 * Completion, and commands such as set, show and save, work from this list. If a parameter needs code of its
 * own, its entry in the list has a pointer to this code. */
#ifndef SHELL_PARAMETER_LIST_H
#define SHELL_PARAMETER_LIST_H

#include "session/scene.h"
#include <stdio.h>

/* A word that stands for a value, such as hollow = 3 or exact = 0. */
struct word {
    const char *name;
    domq_real value;
};

struct run_context;

struct parameter {
    const char *name;
    const char *feature; /* the feature without which the parameter does not exist; NULL for none */
    /* the description of the value; for an effect, an array with a description of each value */
    const struct domq_effect_argument *value;
    /* An effect has these three texts in its description, from which they are copied. */
    const char *meaning;              /* a short phrase */
    const char *help;                 /* the text that 'help' shows; may be NULL */
    const char *synonyms;             /* other words for the parameter, separated by blanks; may be NULL */
    const struct domq_effect *effect; /* the description of an effect; NULL for other parameters */
    int which;                        /* the number of the effect, if the parameter is an effect */
    const struct word *words;         /* words for some of the values; may be NULL */
    /* the value must be one of `words`, and is stored as an unsigned int */
    bool words_only;
    /* The parameter is a setting of the calculator. 'reset' leaves it unchanged unless its name is given. */
    bool setting;
    /* the default and the lower bound depend on the precision, as for tol */
    bool of_precision;
    bool of_row;      /* the sizes and gaps of 'set row N' follow from it */
    enum share share; /* which share of the height the parameter is */
    /* the name of a parameter that may change when this parameter is set; may be NULL */
    const char *moves;
    const char *example; /* commands that demonstrate an effect; may be NULL */
    /* the usual range, which 'solve' searches unless another is given; 0 and 0 if there is none */
    double from, to;
    size_t offset; /* the offset of the value in struct state; features leave it out */

    /* Hooks; each may be NULL. */
    /* Checks whether a value fits the other parameters. The value is known to be in the range of the
     * parameter. If it does not fit, sets *problem and returns false. */
    bool (*check)(const struct state *state, const struct parameter *parameter, domq_real value,
                  struct problem *problem);
    /* Changes other members of the state before the value is stored. */
    void (*before)(struct state *state, domq_real value);
    /* Sets the effect from the file that the user named instead of a number. On failure, sets *problem,
     * changes nothing and returns false. */
    bool (*load)(struct scene *scene, const char *name, const struct run_context *run_context,
                 struct problem *problem);
    /* Writes the commands that must follow 'set' in a saved script. */
    void (*save)(const struct scene *scene, FILE *out);
};

/* The parameters of this build in the order of 'show', followed by the effects. The last name is NULL. */
extern const struct parameter *session_parameters;

/* The words that every effect takes: off and on. */
extern const struct word effect_words[];

/* Returns true if `effect` cannot be on without the effect `other`. An effect that is about rows waits until
 * there is a row. */
bool effect_needs(int effect, int other);

/* Returns true if an effect can be turned on: all effects that it needs must be on, and the current 'fuel'
 * must not exclude it. If the effect cannot be turned on, sets *problem and returns false. */
bool effect_check_needs(const struct scene *scene, int effect, struct problem *problem);

/* Leaves out the parameters of features for which `has` returns false. */
void parameters_of_features(bool (*has)(const char *feature));

/* Adds an effect that a feature describes, in place of the entry that it may have. If it needs a feature for
 * which `has` returns false, adds its description alone. */
void parameters_add(const struct parameter *effect, bool (*has)(const char *feature));

/* Returns the feature to which a parameter belongs that is not in session_parameters, or NULL. */
const char *parameter_missing(const char *name);

#endif
