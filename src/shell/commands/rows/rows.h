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

/* How much friction a foot needs. On a floor with less friction than `needs`, the foot of `domino` slips
 * while the domino `head` falls or when `head` is hit. `needs` is infinite if the foot is lifted off the
 * floor. Dominoes are counted from 1; `head` is 0 if no foot was found. */
struct slip {
    domq_real needs;
    size_t domino, head;
};

/* How much friction the feet of a row need: `motion` while dominoes fall, and `hit` at the moment of a hit.
 * `floor` is the friction of the floor. */
struct feet {
    domq_real floor;
    struct needs {
        struct slip most, first; /* the foot that needs the most friction, and the first foot that slips */
    } motion, hit;
};

/* feet_begin takes the friction of the floor from the scene. feet_add is called for each domino that is hit.
 * At the end, feet_say prints how much friction the feet of a row of `count` dominoes need. */
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
    bool causes; /* the rows were also run without each kind of error */
    struct domq_study counts;
    size_t without[DOM_ERROR_COUNT]; /* filled in by domq_placement_causes */
    /* `count` is the number of dominoes in the row. `stops` counts the rows that stop at each domino (see
     * domq_placement_causes). */
    size_t count, *stops;
};

/* Sets up the row of the scene many times with random errors, and counts how many of these rows fall. Writes
 * the sizes of the errors to `error`. If the scene has no errors, study->rows is 0. On failure, sets *problem
 * and returns false. */
bool study_run(const struct query *query, struct problem *problem, size_t rows, struct domq_study *study,
               struct domq_error error[DOM_ERROR_COUNT]);

/* Runs a study. If the rows have several kinds of errors, also counts how many rows would fall without each
 * kind. The caller frees study->stops, even after a failure. */
enum dom_status study_make(const struct domq_row *row, const struct domq_compute *compute,
                           const struct domq_placement *placement, struct study *study);

/* Returns an array in which element k is the number of rows that stop at domino k + 1 because of this kind of
 * error. */
size_t *study_stops(const struct study *study, int kind);

/* Writes the answer of 'placement'. If the study is incomplete, `reason` says why; otherwise it is NULL. */
void study_answer(struct answer *a, const struct study *study, const char *reason);

/* Computes the part of a study that the option --shard selects, and prints it as blocks of counts. The number
 * of parts does not change the blocks. */
bool study_blocks(const struct query *query, struct answer *a, struct problem *problem,
                  const struct scene_row *scene, const struct domq_placement *placement);

/* ---- The windows of a row: how far each domino may be off while all dominoes still fall ---- */

enum { WINDOW_KINDS = DOM_WINDOW_THICKNESS + 1 };

struct windows {
    const struct scene_row *scene;
    size_t count; /* the number of dominoes */
    /* kind[K][k] is the window of domino k, counted from 0, where K is an enum dom_window_of. The friction
     * between dominoes has a single window, with k = 0. */
    struct domq_window *kind[WINDOW_KINDS];
    /* For each kind of window, the number of the domino with the tightest limits, where 0 stands for none. If
     * the row does not fall, only the element for leans is set: to the domino whose lean needs the smallest
     * change. */
    size_t first[WINDOW_KINDS];
    bool falls;
};

/* Finds all windows of the row, with as many threads as the query's settings allow. The caller frees
 * w->kind[0], which holds all of them. */
enum dom_status windows_find(const struct query *query, const struct scene_row *scene, struct windows *w);

#endif
