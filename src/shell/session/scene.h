/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The scene: all that an answer depends on. A state is a scene with the settings and the names that a person
 * has given; 'undo', 'save' and 'diff' work on states. parameters.h has the table of the parameters.
 */
#ifndef SHELL_SCENE_H
#define SHELL_SCENE_H

#include "answer/cell.h"
#include "domino_quad.h"
#include "language/variables.h"
#include "session/engine_effects.h"
#include "session/problem.h"

/* An effect of the scene: on, with these values, or off. */
struct effect_state {
    bool on;
    domq_real value[DOM_EFFECT_ARGUMENTS];
};

/* Dominoes that are listed in a file, and gaps that were changed since. */
struct listed_row {
    struct domq_domino *domino; /* NULL for none */
    size_t count;
    bool weighed;     /* masses are in kg; else they are relative */
    domq_real *width; /* m, of each, where masses follow from volumes; NULL: masses are given */
    char *path;
    char *others; /* of its file, as csv: names of other columns, then what each row has there, each after a
                     comma; NUL ends each line */
    struct placed {
        size_t k; /* from 1 */
        domq_real gap;
    } * placed;
    size_t changes;
    bool saved;      /* no gap was changed since the row was written to a file */
    size_t *holders; /* of what the file had: states of the session that share them; NULL: one */
};

/* The place of a walk through the cycles: at an event of a cycle, or between two. */
struct walk {
    struct domq_train
        train; /* the train of the session when the walk began; with another train the walk begins again */
    struct domq_compute compute; /* to a finer tolerance than the session's */
    domq_real tol;               /* the session's then */
    struct domq_event events[DOM_EVENTS_MAX];
    int count; /* of the events; 0: no walk has begun */
    int event; /* the last one that was passed */
    domq_real theta;
    int cycle;               /* from 1 */
    enum dom_status verdict; /* DOM_OK, or DOM_STOPS */
};

struct scene {
    struct domq_train train;
    struct domq_compute compute; /* without bounds of errors: see query_compute */
    struct domq_scale scale;
    domq_real mass, density; /* of the first domino, in kg; of solid dominoes, in kg/m^3; 0: not known */
    domq_real seed;          /* of random rows */
    unsigned method;         /* what runs rows, see engine.h */
    struct effect_state effect[EFFECT_COUNT];
    struct listed_row listed; /* the row, where it is not counted */
    struct walk walk;
};

/* How answers look, and how they are computed where that changes no answer. */
struct settings {
    struct answer_style style; /* output, digits, angle */
    unsigned timing, hints;
    domq_real threads; /* 0: as many as there are processors */
};

struct state {
    struct scene scene;
    struct settings settings;
    struct variables variables;
};

enum { SEED_DEFAULT = 1, DIGITS_DEFAULT = 6 };

/* Begins a state in which every parameter has its default. */
void state_init(struct state *state);

/* Frees what a state holds. */
void state_close(struct state *state);

/* Turns every effect off, and frees what the scene holds for them. */
void effects_reset(struct scene *scene);

/* Copies the values of the effects to the train of the scene. */
void effects_apply(struct scene *scene);

/* Returns true if changed gaps of the row are in no file yet. */
static inline bool row_unsaved(const struct scene *scene)
{
    return scene->listed.changes > 0 && !scene->listed.saved;
}

/* Copies a row that shares its dominoes with the other one; each is freed on its own.  False: no memory. */
bool listed_share(struct listed_row *to, struct listed_row *from);

/* Frees a listed row. */
void listed_free(struct listed_row *row);

/* Returns the share of the volume of a domino that is filled: by its walls, or all of a solid block. */
domq_real scene_filled(const struct scene *scene, domq_real height, domq_real thickness, domq_real width);

/* Return the first domino's mass in kg, of a block of these sizes in m, or of h and d; 0: not known. */
domq_real scene_block_mass(const struct scene *scene, domq_real height, domq_real thickness);
domq_real scene_mass(const struct scene *scene);

/* Describes that the walls have no room in domino k, or in that of a train if k is 0.  Returns false. */
bool problem_no_room(struct problem *problem, const struct scene *scene, size_t k, domq_real thickness);

/*
 * Describes that domino k, or no domino of a train if k is 0, can stand upright on the slope, which may be up
 * to `limit`.  Returns false.
 */
bool problem_no_stand(struct problem *problem, const struct scene *scene, size_t k, domq_real limit);

/* Describes a library status that is not DOM_OK.  Returns false. */
bool problem_status(struct problem *problem, const struct scene *scene, enum dom_status status);

#endif
