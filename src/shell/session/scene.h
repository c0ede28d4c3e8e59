/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The scene contains everything on which the numbers in an answer depend. The state contains the scene, the
 * settings, and the variables that 'let' has defined. The parameters in parameter_list.c are members of the
 * state. */
#pragma once

#include "answer/cell.h"
#include "language/units.h"
#include "precision/any.h"
#include "session/problem.h"
#include <math.h>
#include <stdio.h>

/* ---- Effects: first those of the library, then those that features describe, in the order in which the
 * features are registered ---- */

enum { EFFECTS_MOST = DOM_EFFECT_COUNT + 16 };

/* First values of an effect that stand for the words "off" and "on". EFFECT_ON turns an effect on with its
 * usual values. If the effect is already on, its values do not change. */
#define EFFECT_OFF ((domq_real)-HUGE_VAL)
#define EFFECT_ON  ((domq_real)HUGE_VAL)

/* The value of the effect 'release' that stands for the word "touch": the domino leans against the next one,
 * which it touches before it lies flat. */
#define RELEASE_TOUCH ((domq_real)1.5707963267948966)

/* Returns the description of effect number k, counted from 0. */
const struct domq_effect *effect_at(int k);

struct effect_state {
    bool on;
    domq_real value[DOM_EFFECT_ARGUMENTS]; /* the first one is EFFECT_OFF if the effect is off */
};

struct scene;
struct parameter;

/* What a feature keeps in a scene beyond the values of its effects: the dominoes of a row of one's own.
 * Copies of a scene share it, so it never changes; a change puts another one in its place. A struct of the
 * feature begins with this one. */
struct slot {
    const struct slot_kind *kind;
    size_t holders;   /* reference count */
    size_t size;      /* the number of dominoes in memory, which limits the history of 'undo' */
    const char *file; /* the file that it was read from, or NULL */
};

enum { PARAMETER_SETTING = 256 }; /* the longest file name has 255 bytes */

/* What the shell does with the slot of a scene. */
struct slot_kind {
    /* the effect that exists as long as the slot does, and whose setting it describes */
    int effect;
    void (*free)(struct slot *slot);
    /* Returns the height in m of the first domino. */
    domq_real (*height)(const struct scene *scene);
    /* Writes the setting of the effect, such as "hall.csv". */
    void (*setting)(const struct scene *scene, char text[PARAMETER_SETTING]);
    /* If setting the parameter leaves some of the slot as it was, writes a sentence that says so. Otherwise
     * writes "". */
    void (*kept)(const struct scene *scene, const struct parameter *parameter, char text[PROBLEM_TEXT]);
    /* Writes the commands that make the slot. `folder` is the directory of the script, or NULL. */
    bool (*save)(const struct scene *scene, const char *folder, FILE *out, struct problem *problem);
};

/* The parameters that are shares of the height h, and the push. A length that was given instead of a share
 * stays the same when h changes, and so does a push that was given as the speed of the first domino's upper
 * edge. */
enum share { SHARE_NONE, SHARE_s, SHARE_d, SHARE_width, SHARE_walls, SHARE_edges, SHARE_push, SHARE_COUNT };

struct typed_length {
    domq_real m;  /* the length in m, or 0 for a share; for the push, the speed in m/s */
    char unit[8]; /* the unit that was typed, for 'show'; "" if the length was not one number with a unit */
};

struct scene {
    struct domq_train train;
    /* the library's options */
    struct any_compute compute;
    struct domq_scale scale;
    domq_real mass;    /* the mass of the first domino in kg; 0 if it is not known */
    domq_real density; /* the density of the material in kg/m^3; 0 if it is not known */
    domq_real seed;    /* the seed of random rows */
    unsigned method;   /* how rows are computed, if a feature offers a choice; 0 stands for the model */
    struct typed_length length[SHARE_COUNT];
    struct effect_state effect[EFFECTS_MOST];
    struct slot *slot; /* NULL unless a feature keeps something */
};

/* Parameters that affect the form of answers or the speed of computation, but not the numbers. */
struct settings {
    /* Only the members `output`, `header`, `digits`, `angle` and `errors` are used here. state_style returns
     * a copy in which all members are set. */
    struct answer_style style;
    domq_real threads; /* the number of threads; 0 means one thread for each processor */
};

struct state {
    struct scene scene;
    struct settings settings;
    struct variables variables;
};

enum { SEED_DEFAULT = 1, DIGITS_DEFAULT = 6 };

/* Sets every parameter to its default. */
void state_init(struct state *state);

void state_close(struct state *state);

/* Sets the parameters of the scene to their defaults, turns all effects off and empties the slot. */
void scene_reset(struct scene *scene);

/* Returns false if no length and no speed has been given. This costs a sweep less than to look at each of
 * them. */
bool scene_has_lengths(const struct scene *scene);

/* Sets the parameters for which lengths, or a speed, have been given. */
void scene_apply_lengths(struct scene *scene);

/* Copies the values of effects into the train of the scene. Must be called again if the sizes or the mass of
 * the dominoes change, because the effect of the air depends on them. */
void effects_apply(struct scene *scene);

/* Returns value i of an effect, or 0 if the effect is off. */
static inline domq_real effect_value(const struct scene *scene, int effect, int i)
{
    return scene->effect[effect].on ? scene->effect[effect].value[i] : 0;
}

/* A scene that owned the slot no longer does. The last owner frees it. `slot` may be NULL. */
void slot_drop(struct slot *slot);

/* Returns the thickness of the walls of boxes in m, or 0 if all dominoes are solid. */
static inline domq_real scene_walls(const struct scene *scene)
{
    return effect_value(scene, DOM_EFFECT_walls, 0) * scene->scale.h;
}

/* Returns the height in m above which dominoes are boxes, or 0 if there is no such limit, because all
 * dominoes are boxes or all are solid. */
static inline domq_real scene_boxes_above(const struct scene *scene)
{
    return effect_value(scene, DOM_EFFECT_walls, 1);
}

/* Returns the fraction of a domino's volume that its walls fill: 1 for a solid domino. */
domq_real scene_filled(const struct scene *scene, const struct domq_domino *domino);

/* Returns the mass in kg of a domino that is the first one of the row, or 0 if the mass is not known. */
domq_real scene_first_mass(const struct scene *scene, const struct domq_domino *domino);

/* Returns the mass in kg of the first domino of the train, or 0 if it is not known. */
domq_real scene_mass(const struct scene *scene);

/* Returns true if the mass of the first domino of the train is known. */
static inline bool scene_has_mass(const struct scene *scene)
{
    return scene_mass(scene) > 0;
}

/* Returns what takes energy from the moving dominoes of a train, such as "friction". Returns "" if nothing
 * does. The text lives until the end of the caller's block. */
enum { LOSSES_TEXT = 64 };
#define losses_of(train) losses_write(train, (char[LOSSES_TEXT]){""})
const char *losses_write(const struct domq_train *train, char text[LOSSES_TEXT]);

/* Returns true for DOM_OK. Reports any other status as a problem and returns false. */
bool problem_status(struct problem *problem, const struct scene *scene, enum dom_status status);
