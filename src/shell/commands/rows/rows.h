/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Types and functions that the files in this directory share, and the commands that are defined in them. */
#ifndef SHELL_ROWS_H
#define SHELL_ROWS_H

#include "commands/rows/falling.h"
#include "session/random_errors.h"

extern const struct column fall_columns[], verdict_columns[], mend_columns[], tolerance_columns[],
    placement_columns[], slip_columns[];
bool run_fall(const struct query *query, struct answer *a, struct problem *problem);
bool run_verdict(const struct query *query, struct answer *a, struct problem *problem);
bool run_mend(const struct query *query, struct answer *a, struct problem *problem);
bool run_tolerance(const struct query *query, struct answer *a, struct problem *problem);
bool run_pool(const struct query *query, struct answer *a, struct problem *problem);
bool run_slip(const struct query *query, struct answer *a, struct problem *problem);

/* The friction that the floor must have so that the foot of `domino` does not slip while `head` falls, or
 * when it is hit. `domino` is often not the head itself. */
struct slip {
    domq_real needs;     /* the friction that is needed; infinite if the domino is lifted off the floor */
    size_t domino, head; /* numbers of dominoes, from 1; head is 0 if no foot slips */
};

/* The friction that the feet of a row need while dominoes fall and at the moment of a hit, and the friction
 * of the floor on which they stand. */
struct feet {
    domq_real floor;
    struct needs {
        struct slip most, first; /* the foot that needs the most friction, and the first foot that slips */
    } motion, hit;
};

/* feet_begin takes the friction of the floor from the scene. The caller then calls feet_add for each domino
 * that is hit and, at the end, feet_say, which prints how much friction the feet of a row of `count`
 * dominoes need. */
struct feet feet_begin(const struct query *query);
void feet_add(struct feet *feet, const struct domq_fall *fall);
void feet_say(struct answer *a, const struct feet *feet, size_t count);
/* The message for a domino that is lifted off the floor. */
extern const char foot_lifted[];

/* The results of a study of random rows. */
struct study {
    domq_real sigma, heights;
    char errors[ERRORS_TEXT];
    bool is_on[DOM_ERROR_COUNT];
    bool causes; /* the rows were also run with each error left out in turn */
    struct domq_study counts;
    size_t without[DOM_ERROR_COUNT]; /* filled in by domq_placement_causes */
    /* The number of dominoes in the row, and the lists of stops that domq_placement_causes fills in. */
    size_t count, *stops;
};

/* Sets up the row many times with the errors of the scene, and writes these errors to `error`. If the scene
 * has no errors, study->rows is 0. On failure, sets *problem and returns false. */
bool study_run(const struct query *query, struct problem *problem, size_t rows, struct domq_study *study,
               struct domq_error error[DOM_ERROR_COUNT]);

/* Runs a study. If the rows have several kinds of errors, also counts how many rows would fall without each
 * kind. The caller frees study->stops, even after a failure. */
enum dom_status study_make(const struct domq_row *row, const struct domq_compute *compute,
                           const struct domq_placement *placement, struct study *study);

/* Returns a list with a count for each domino: how many rows stop at this domino because of one kind of
 * error. */
size_t *study_stops(const struct study *study, int kind);

/* Writes the answer of 'placement'. If the study is incomplete, `reason` says why; otherwise it is NULL. */
void study_answer(struct answer *a, const struct study *study, const char *reason);

/* Computes the part of a study that the option --shard selects, and prints it as blocks of counts. The blocks
 * are the same for any number of parts. */
bool study_blocks(const struct query *query, struct answer *a, struct problem *problem,
                  const struct scene_row *scene, const struct domq_placement *placement);

/* ---- The windows of a row: how far each domino may be off while all dominoes still fall ---- */

enum { WINDOW_KINDS = DOM_WINDOW_THICKNESS + 1 };

struct windows {
    const struct scene_row *scene;
    size_t count; /* the number of dominoes */
    /* The windows of all dominoes, for each kind of window in the order of enum dom_window_of. The friction
     * between dominoes has a single window, which is the first element. */
    struct domq_window *kind[WINDOW_KINDS];
    /* The number of the domino with the tightest limits for each kind of window, or 0 if there is no window.
     * If the row does not fall, the number of the domino that needs the smallest change. */
    size_t first[WINDOW_KINDS];
    bool falls;
};

/* Finds all windows of the row, with as many threads as the query's settings allow. The caller frees
 * w->kind[0], which holds all of them. */
enum dom_status windows_find(const struct query *query, const struct scene_row *scene, struct windows *w);

#endif
