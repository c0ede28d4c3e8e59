/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows with random errors: the kinds of error, and studies of many random rows. */
#pragma once

#include "parallel/workers.h"
#include "rows/rows.h"

/* ---- Kinds of random error ---- */

/* A kind of random error. Errors in gaps and heights belong to the effect 'placement', which stands with the
 * gaps; every other kind has an effect of its own. */
struct error_kind {
    const char *name, *unit;    /* as in DOM_ERRORS */
    struct parameter parameter; /* the effect as a parameter; not used for heights */
    struct domq_effect effect;
};

/* The last one stands for "all": its value is a factor, without a unit. */
extern const struct error_kind error_kinds[DOM_ERROR_COUNT + 1];

/* Returns the number of the effect that describes a kind of random error. */
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

/* Runs a study of `rows` random rows, and stores their errors in `error`. Without random errors, runs nothing
 * and leaves the study as it is. */
bool study_run(const struct query *query, struct problem *problem, size_t rows, struct dom_study *study,
               struct dom_random_error error[DOM_ERROR_COUNT]);

/* Reports that `what` needs random errors. Returns false. */
bool problem_no_errors(struct problem *problem, const char *what);

/* Returns a phrase such as "1795 of 2000 rows fall (88.3 % to 91 %)". */
struct words study_words(const struct dom_study *study);
