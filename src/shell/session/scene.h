/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The scene is everything that an answer depends on. The state is the scene, the settings, and the variables
 * that 'let' has defined; 'undo', 'save' and 'diff' work on states. parameters.h lists the parameters, which
 * are members of the state.
 */
#ifndef SHELL_SCENE_H
#define SHELL_SCENE_H

#include "answer/cell.h"
#include "domino_quad.h"
#include "language/variables.h"
#include "session/effect_list.h"
#include "session/problem.h"

struct effect_state {
    bool on;
    domq_real value[DOM_EFFECT_ARGUMENTS];
};

/* The dominoes of a row that was read from a file, and the gaps that 'place' has changed in any row. */
struct listed_row {
    struct domq_domino *domino; /* NULL if the row does not come from a file */
    size_t count;
    bool has_masses;  /* the masses are in kg; otherwise only their ratios matter */
    domq_real *width; /* the widths in m, if masses follow from volumes; otherwise NULL */
    char *path;
    char *others; /* the other columns of the file as csv: their names, then the cells of each row. Each cell
                     begins with a comma, and each line ends with a NUL byte. */
    struct gap_change {
        size_t k; /* the number of the domino behind the gap, from 1 */
        domq_real gap;
    } * change;
    size_t changes;  /* the number of changed gaps */
    bool saved;      /* the changed gaps have been written to a file */
    size_t *holders; /* the reference count of what comes from the file; NULL without a file */
};

/* The place of a walk through the cycles of the train: at an event, or between two events. */
struct walk {
    struct domq_train train;     /* the train of the walk; another train begins a new walk */
    struct domq_compute compute; /* with a smaller tolerance than the session's */
    domq_real tol;               /* the session's tolerance when the walk began */
    struct domq_event events[DOM_EVENTS_MAX];
    int count; /* the number of events; 0 if no walk has begun */
    int event; /* the index of the last event that the walk has passed */
    domq_real theta;
    int cycle;               /* from 1 */
    enum dom_status verdict; /* DOM_OK or DOM_STOPS */
};

struct scene {
    struct domq_train train;
    struct domq_compute compute; /* without error bounds; see query_compute */
    struct domq_scale scale;
    domq_real mass;    /* of the first domino in kg; 0 if it is not known */
    domq_real density; /* of solid dominoes in kg/m^3; 0 if it is not known */
    domq_real seed;    /* for random rows */
    unsigned method;   /* what runs rows; see engine.h */
    struct effect_state effect[EFFECT_COUNT];
    struct listed_row listed;
    struct walk walk;
};

/* The parameters that change the form of answers, or their speed, but not their values. */
struct settings {
    struct answer_style style; /* only output, header, digits, angle and errors; see state_style */
    unsigned timing, hints;
    domq_real threads; /* 0 stands for the number of processors */
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

/* Turns all effects off, and frees the row. */
void effects_reset(struct scene *scene);

/* Copies the values of effects into the train of the scene. */
void effects_apply(struct scene *scene);

/* Returns true if 'place' has changed gaps that are in no file yet. */
static inline bool row_unsaved(const struct scene *scene)
{
    return scene->listed.changes > 0 && !scene->listed.saved;
}

/* Makes a copy of a row, which shares what comes from the file. Returns false if there is no memory. */
bool listed_share(struct listed_row *to, const struct listed_row *from);
void listed_free(struct listed_row *row);

/* Returns the share of the volume of a domino that its walls fill; 1 for a solid domino. */
domq_real scene_filled(const struct scene *scene, domq_real height, domq_real thickness, domq_real width);

/* Returns the mass in kg of a first domino of this size in m, or 0 if neither mass nor density is known. */
domq_real scene_block_mass(const struct scene *scene, domq_real height, domq_real thickness);

/* Returns the mass in kg of the first domino of the train, or 0 if neither mass nor density is known. */
domq_real scene_mass(const struct scene *scene);

/* Returns true if a domino with sharp edges and this lean stands by itself on the slope alpha. Otherwise
 * writes a message that says how far the domino can lean. */
enum { LEAN_MESSAGE = 400 };
bool lean_stands(const struct domq_domino *domino, domq_real alpha, char message[LEAN_MESSAGE]);

/* Describes that the walls do not fit into domino k, or into a domino of the train if k is 0. Returns false.
 */
bool problem_no_room(struct problem *problem, const struct scene *scene, size_t k, domq_real thickness);

/* Describes that domino k, or any domino of the train if k is 0, cannot stand upright on the slope, which is
 * steeper than the limit. Returns false. */
bool problem_no_stand(struct problem *problem, const struct scene *scene, size_t k, domq_real limit);

/* Describes a status of the library that is not DOM_OK. Returns false. */
bool problem_status(struct problem *problem, const struct scene *scene, enum dom_status status);

#endif
