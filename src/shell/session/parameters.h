/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameters of the model, the settings of the calculator, and the effects. Completion, and commands such
 * as set, show and save, work from one list of them. If a parameter needs code of its own, its entry in the
 * list has a pointer to this code. */
#pragma once

#include "language/names.h"
#include "language/quad.h"
#include "session/query.h"
#include <stdio.h>

/* ---- The list of all parameters ---- */

/* A word that stands for a value, such as hollow = 3 or exact = 0. */
struct word {
    const char *name;
    domq_real value;
};

/* An effect has its name, value, meaning, help, synonyms and words in its description, and `check` and
 * `offset` are those of all effects: an entry leaves them out. */
struct parameter {
    const char *name;
    /* the description of the value; for an effect, an array with a description of each value */
    const struct domq_effect_argument *value;
    const char *meaning;              /* a short phrase */
    const char *help;                 /* the text that 'help' shows; may be NULL */
    const char *synonyms;             /* other words for the parameter, separated by blanks; may be NULL */
    const struct domq_effect *effect; /* the description of an effect; NULL for other parameters */
    int which;                        /* the number of the effect, if the parameter is an effect */
    int *number;                      /* receives the number of an effect of a feature; otherwise NULL */
    /* the name of an effect of a feature, without which this one is not in the build and cannot be on */
    const char *needs;
    bool by_engine;           /* only the rigid-body engine includes the effect */
    bool is_minor;            /* 'effects' lists the effect only while it is on */
    const struct word *words; /* words for some of the values; may be NULL */
    /* the value must be one of `words`, and is stored as an unsigned int */
    bool words_only;
    /* The parameter is a setting of the calculator. 'reset' leaves it unchanged unless its name is given. */
    bool setting;
    /* the default and the lower bound depend on the precision, as for tol */
    bool of_precision;
    enum share share; /* which share of the height the parameter is */
    /* the name of a parameter that may change when this parameter is set; may be NULL */
    const char *moves;
    const char *example; /* commands that demonstrate an effect; may be NULL */
    /* the usual range, which 'solve' searches unless another is given; 0 and 0 if there is none */
    double from, to;
    size_t offset; /* the offset of the value in struct state */

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
};

/* The parameters of this build in the order of 'show', followed by the effects. The last name is NULL. */
extern const struct parameter *session_parameters;

/* Returns true if `effect` cannot be on without the effect `other`, which is not 'row'. */
bool effect_needs(int effect, int other);

/* Returns true if all effects that an effect needs are on, and the current 'fuel' does not exclude it.
 * Otherwise, sets *problem. */
bool effect_check_needs(const struct scene *scene, int effect, struct problem *problem);

/* Removes the parameters of features. */
void parameters_begin(void);

/* Adds a parameter of a feature. If it needs an effect that has not been added before, only gives it a
 * number.
 */
void parameters_add(const struct parameter *parameter);

/* ---- Descriptions ---- */

/* A names_list (see names.h) of all parameters. */
const char *parameter_names(const void *context, int k);

/* Returns true if a parameter of the model accepts this word as its value, as q accepts "hollow". Writes a
 * message that says so. */
bool parameter_by_value(const char *word, char message[NAMES_MESSAGE]);

/* Returns how a parameter is set, such as "friction MU" or "q VALUE". The text lives until the end of the
 * caller's block. */
enum { PARAMETER_USAGE = 64 };
#define parameter_usage(parameter) parameter_usage_write(parameter, (char[PARAMETER_USAGE]){""})
const char *parameter_usage_write(const struct parameter *parameter, char usage[PARAMETER_USAGE]);

/* Lists the words that a parameter accepts as values (see names_list in names.h). parameter_offered omits
 * synonyms. */
const char *parameter_words(const void *parameter, int k);
const char *parameter_offered(const void *parameter, int k);

/* Returns the parameter with this name, or NULL. */
const struct parameter *parameter_find(const char *name);

/* Returns the parameter that has a word as its first synonym or, if `any` is true, as any synonym: the one in
 * whose list it comes earliest. Returns NULL if there is none. */
const struct parameter *parameter_by_synonym(const char *word, bool any);

/* Like names_find, but 'w' is the width, and the message also suggests names that have the word as a synonym.
 */
int parameter_search(names_list *list, const char *what, const char *word, char message[NAMES_MESSAGE]);

/* Returns the description of value number i, counted from 0, or NULL after the last value. Only effects have
 * several values. */
const struct domq_effect_argument *parameter_argument(const struct parameter *parameter, int i);

/* Returns true if expressions can use the parameter as a number, as in 'print 2*s'. */
bool parameter_is_number(const struct parameter *parameter);

/* Returns the word that stands for a value of the parameter, or NULL if no word does. */
const char *parameter_word(const struct parameter *parameter, domq_real value);

/* Returns the range of value number i, such as "1e-12 .. 1", or the words that it can be, such as
 * "exact|paper". The text lives until the end of the caller's block. */
enum { PARAMETER_RANGE = 64 };
#define parameter_range(state, parameter, i)                                                                 \
    parameter_range_write(state, parameter, i, (char[PARAMETER_RANGE]){""})
const char *parameter_range_write(const struct state *state, const struct parameter *parameter, int i,
                                  char text[PARAMETER_RANGE]);

/* Returns value number i as people read it, such as "0.1 rad" or "4 (solid)" or, with WIDE_DIGITS digits, as
 * 'set' reads it back without any change. The buffer may not be used. */
enum { PARAMETER_TEXT = LENGTH_TEXT };
const char *parameter_text(const struct parameter *parameter, int i, domq_real value, int digits,
                           char text[PARAMETER_TEXT]);

/* Returns all values of a parameter in this form, as in "18 mm, 0.3 m", "record.csv" or "off". The text lives
 * until the end of the caller's block. */
#define parameter_setting(state, parameter, digits)                                                          \
    parameter_setting_write(state, parameter, digits, (char[PARAMETER_SETTING]){""})
const char *parameter_setting_write(const struct state *state, const struct parameter *parameter, int digits,
                                    char setting[PARAMETER_SETTING]);

/* ---- Values ---- */

/* Returns the first value of a parameter: EFFECT_OFF for an effect that is off. */
domq_real parameter_get(const struct state *state, const struct parameter *parameter);

/* Returns true if two states have the same values of a parameter. */
bool parameter_equal(const struct state *a, const struct state *b, const struct parameter *parameter);

/* Returns the default of a parameter at the precision of the state, or EFFECT_OFF for an effect. */
domq_real parameter_fallback(const struct state *state, const struct parameter *parameter);

/* Returns true if `value` is allowed as value number i of the parameter. Otherwise reports the problem. */
bool parameter_check(const struct state *state, const struct parameter *parameter, int i, domq_real value,
                     struct problem *problem);

/* A parameter and its new value, which may be EFFECT_OFF for an effect. */
struct assigned {
    const struct parameter *parameter;
    domq_real value;
    const domq_real *others; /* the other values of an effect, or NULL (effect_put) */
    /* For a share of the height that was given as a length; `value` is then not used. */
    struct typed_length length;
};
enum { ASSIGNED_MAX = 8 };

/* Returns the length for struct assigned if the value of the parameter was given as a length, or the push as
 * a speed. */
static inline struct typed_length share_length(const struct parameter *parameter,
                                               const struct quantity *typed)
{
    const struct quantity unit = {.length = 1, .time = parameter->share == SHARE_push ? -1 : 0};
    return (struct typed_length){.m = parameter->share && quantity_alike(*typed, unit) ? typed->value : 0};
}

/* Makes *changed a copy of `query` in which the parameters in `assigned` have their new values. *state
 * becomes the state of the copy; it shares memory with the original and must not be closed. On failure, sets
 * *problem and returns false. */
bool query_with(const struct query *query, const struct assigned *assigned, int count, struct state *state,
                struct query *changed, struct problem *problem);

/* Sets a parameter. `value` is an array with `given` elements; only effects take more than one value. The
 * first may be EFFECT_OFF or EFFECT_ON, and values that are not given are the usual ones. If the first value
 * was given as a length, `length` is this length; otherwise, it may be NULL. The state must own its memory.
 * On failure, sets *problem, changes nothing and returns false. */
bool parameter_set(struct state *state, const struct parameter *parameter, const domq_real *value, int given,
                   const struct typed_length *length, struct problem *problem);

/* ---- Effects ---- */

/* Returns true if the slot of the scene belongs to this effect. */
bool effect_slot(const struct state *state, const struct parameter *parameter);

/* Sets the values of an effect: value[0] to `value`, which may be EFFECT_OFF, and the other values to
 * `others`. If `others` is NULL, an effect that is already on keeps its other values, and an effect that is
 * off gets the usual ones. Empties the slot of the effect without dropping it, so the scene must not own it.
 */
void effect_put(struct scene *scene, int effect, domq_real value, const domq_real *others);

/* Returns the style of answers, including the members that depend on the precision and on tol. */
struct answer_style state_style(const struct state *state);
