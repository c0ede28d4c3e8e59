/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The scene contains everything on which the numbers in an answer depend. The state contains the scene, the
 * settings, and the variables that 'let' has defined. The parameters in parameter_list.c are members of the
 * state. */
#pragma once

#include "answer/cell.h"
#include "language/variables.h"
#include "precision/any.h"
#include "session/problem.h"
#include <math.h>

/* ---- Effects: first those of the library, then those that features of the program describe ---- */

/* The kinds of random error that have their own effect, which the feature 'chance' describes, and the feature
 * without which there is no such effect. Errors in gaps and heights belong to 'placement'. */
#define ERROR_EFFECTS(X)                                                                                     \
    X(place, "chance")                                                                                       \
    X(thickness, "chance")                                                                                   \
    X(mass, "chance")                                                                                        \
    X(lean, "chance")                                                                                        \
    X(radius, "chance") X(friction, "chance") X(slope, "chance") X(floor, "engine") X(push, "chance")

/* The numbers of the shell's effects continue after the library's last effect. */
enum {
    EFFECT_placement = DOM_EFFECT_COUNT,
    EFFECT_floor,
    EFFECT_feet,
    EFFECT_bounce,
    EFFECT_ENGINE_END,
    EFFECTS_BEFORE_ERRORS = EFFECT_ENGINE_END - 1,
#define ERROR_EFFECT_ENUM(name, feature) EFFECT_error_##name,
    ERROR_EFFECTS(ERROR_EFFECT_ENUM)
#undef ERROR_EFFECT_ENUM
        EFFECT_COUNT
};

/* First values of an effect that stand for the words "off" and "on". EFFECT_ON turns an effect on with its
 * usual values. If the effect is already on, its values do not change. */
#define EFFECT_OFF ((domq_real)-HUGE_VAL)
#define EFFECT_ON  ((domq_real)HUGE_VAL)

/* The value of the effect 'release' that stands for the word "touch": the domino leans against the next one,
 * which it touches before it lies flat. */
#define RELEASE_TOUCH ((domq_real)1.5707963267948966)

/* Returns the description of effect number k, counted from 0, or NULL if this build lacks the effect. */
const struct domq_effect *effect_at(int k);

struct effect_state {
    bool on;
    domq_real value[DOM_EFFECT_ARGUMENTS]; /* the first one is EFFECT_OFF if the effect is off */
};

/* The measurements of a domino that 'change' can change. */
enum row_measure {
    MEASURE_HEIGHT,
    MEASURE_THICKNESS,
    MEASURE_GAP,
    MEASURE_MASS,
    MEASURE_RADIUS,
    MEASURE_LEAN,
    MEASURE_WIDTH,
    ROW_MEASURES
};

/* A domino of a row that has been changed. */
struct changed_domino {
    /* The domino that it is, or that it was copied from: its index in the file, or in the row that 'set row
     * N' makes. Along the row, these indices never decrease. */
    size_t origin;
    /* The changed measurements, and NaN for the others. A changed mass is stored as a factor, because the
     * mass also changes with the size. */
    struct domq_domino to;
};

/* The dominoes of a row that was read from a file, and the changes to any row. */
struct listed_row {
    struct domq_domino *domino; /* the dominoes, or NULL if the row does not come from a file */
    size_t count;
    bool has_masses;   /* the masses are in kg; otherwise, only their ratios are known */
    bool from_volumes; /* the masses follow from the volumes, not from a column "mass" or "relative" */
    char *path;
    struct changed_domino *change; /* all dominoes of the row, or NULL if nothing has been changed */
    size_t changes;                /* the number of elements of `change` */
    /* the reference count of `domino` and `path`; NULL if these are NULL */
    size_t *holders;
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
    /* METHOD_MODEL or METHOD_ENGINE (row.h): whether the model or the engine runs rows */
    unsigned method;
    struct typed_length length[SHARE_COUNT];
    struct effect_state effect[EFFECT_COUNT];
    struct listed_row listed;
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

/* Turns all effects off and frees the memory of the row. */
void effects_reset(struct scene *scene);

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

/* Returns the number of dominoes in the row of the file or of 'set row N', before any are removed or
 * inserted. Returns 0 if there is no row. */
size_t scene_row_planned(const struct scene *scene);

/* Returns the number of dominoes in the row, or 0 if there is no row. */
size_t scene_row_count(const struct scene *scene);

/* Copies a row. The arrays that were read from a file are not copied: both rows share them. Returns false if
 * memory runs out. */
bool listed_share(struct listed_row *to, const struct listed_row *from);
void listed_free(struct listed_row *row);

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

/* Returns the width in m of a domino of a row from a file that gives no width. */
domq_real scene_width(const struct scene *scene, domq_real height);

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

/* Returns how far the top of a domino is off plumb, in m. A backward lean is negative. */
domq_real lean_offset(const struct domq_domino *domino);

/* Returns true if a leaning domino with sharp edges does not fall over by itself on a slope of `alpha`
 * radians. If the domino would fall over, writes a message with the limit of the lean, and returns false. */
enum { LEAN_MESSAGE = 400 };
bool lean_stands(const struct domq_domino *domino, domq_real alpha, char message[LEAN_MESSAGE]);

/* Returns true for DOM_OK. Reports any other status as a problem and returns false. */
bool problem_status(struct problem *problem, const struct scene *scene, enum dom_status status);
