/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows with random errors: the kinds of error, and studies of many random rows. */
#ifndef CHANCE_H
#define CHANCE_H

#include "parallel/workers.h"
#include "rows/rows.h"

/* ---- Kinds of random error ---- */

/* A kind of random error. Errors in gaps and heights belong to the effect 'placement'; every other kind has
 * an effect of its own. */
struct error_kind {
    const char *name, *unit;    /* as in DOM_ERRORS */
    const char *keep;           /* what to do about the error, such as "Keep the gaps accurate" */
    const char *cause;          /* a noun phrase, such as "the errors in the gaps" */
    struct parameter parameter; /* the effect as a parameter; not used for gaps and heights */
    struct domq_effect effect;
};
/* The last one stands for "all": its value is a factor, without a unit. */
extern const struct error_kind error_kinds[DOM_ERROR_COUNT + 1];

/* A names_list (see names.h) of the kinds, with "all" as its last name. */
const char *error_names(const void *context, int k);

/* Lists the parameters of the kinds that have an effect of their own, as in struct feature. */
const struct parameter *error_parameter(int k);

/* Returns the effect that describes a kind of random error. */
int error_effect(int kind);

/* Fills the array `error` with the random errors of a scene. If a kind of error is off, its size is 0.
 * Returns true if any of the effects for random errors is on. */
bool scene_errors(const struct scene *scene, struct dom_random_error error[DOM_ERROR_COUNT]);

/* Returns true if the random errors can be combined with the other effects. Otherwise reports the problem. */
bool errors_check(const struct scene *scene, struct problem *problem);

/* Describes the DOM_ERROR_COUNT elements of `error`, for programs as in "gap 0.003 m, friction 0.05 uniform",
 * and for people with three digits and other units, as in "gap 3 mm, lean 1 deg at most". */
enum { ERRORS_TEXT = 1024 };
const char *errors_text(const struct dom_random_error *error, bool for_people, char text[ERRORS_TEXT]);

/* ---- Studies ---- */

extern const struct column placement_columns[];
bool run_pool(const struct query *query, struct answer *a, struct problem *problem);

/* The row and the random errors of a study. Do not copy this struct, which has pointers into itself. */
struct trials {
    struct double_row row;
    struct scene_row scene; /* for its engine; its dominoes have been freed */
    struct dom_placement placement;
    bool has_errors; /* an effect that describes random errors is on */
    struct task_pool pool;
};

/* Makes the row and its random errors. After a failure nothing needs to be freed. */
bool trials_make(const struct query *query, struct problem *problem, size_t rows, bool progress,
                 struct trials *trials);

/* Reports that `what` needs random errors. Returns false. */
bool problem_no_errors(struct problem *problem, const char *what);

/* The results of a study of random rows. */
struct study {
    double sigma, heights;
    char errors[ERRORS_TEXT];
    bool is_on[DOM_ERROR_COUNT];
    bool causes; /* the rows were also run with each kind of error left out in turn */
    struct dom_study result;
    size_t without[DOM_ERROR_COUNT]; /* for each kind of error, how many rows fall if it is left out */
    size_t dominoes;                 /* the number of dominoes in the row */
    size_t *stops;                   /* how many rows stop at each domino: see dom_placement_causes */
};

/* Runs a study of the scene's row with `rows` random rows. Stores the scene's random errors in `error`. If
 * the scene has no random errors, runs nothing and sets study->rows to 0. */
bool study_run(const struct query *query, struct problem *problem, size_t rows, struct dom_study *study,
               struct dom_random_error error[DOM_ERROR_COUNT]);

/* Runs a study. If there are several kinds of errors, finds out which of them matter: for each kind, runs the
 * rows again without errors of this kind. The caller frees study->stops, even after a failure. */
enum dom_status study_run_with_causes(const struct dom_row *row, const struct dom_compute *compute,
                                      const struct dom_placement *placement, struct study *study);

/* Returns an array whose element k is the number of rows that this kind of error stops at domino k + 1. */
size_t *study_stops(const struct study *study, int kind);

/* Writes the answer of 'placement'. If the study is incomplete, `reason` says why; otherwise it is NULL. */
void study_answer(struct answer *a, const struct study *study, const char *reason);

/* Computes and prints the part of a study that --shard selects, as counts for blocks of 100 rows. */
bool study_blocks(const struct query *query, struct answer *a, struct problem *problem,
                  const struct double_row *row, const struct dom_placement *placement);

#endif
