/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a row many times: with a change of a few dominoes (windows, mending), or with random errors. */
#ifndef DOM_STUDY_H
#define DOM_STUDY_H

#include "dynamics/dynamics.h"
#include "row/run.h"

/* The planned row at the moment when a head is hit: its state, and how clear the verdict is from there on. */
struct mark {
    real omegasq, inertia_ratio; /* values of the members of struct run */
    size_t moving;
    /* the derivative of ln omegasq of the next head with respect to ln omegasq of this head */
    real lambda;
    /* A change of omegasq by less than this fraction can change neither the sign of the margin nor that of a
     * contact force, here and at later heads. */
    real clear;
};

struct study {
    struct row row; /* between two runs, the geometry that is filled in is that of the planned row */
    /* The planned row, whose first `known` heads have marks. NULL if the rows of the study are random: then
     * no row is planned, and of the verdicts only `end` and `domino` count. */
    struct mark *mark;
    size_t known;
    struct dom_verdict verdict;
    /* ---- The current run ---- */
    size_t last; /* index of the last domino that differs from the planned row */
    real off;    /* by which fraction omegasq of the last head differs from the planned one */
    bool quick;  /* true if study_passes may be tried */
    /* True if a motion with friction is computed roughly. If the errors may change the verdict, the run sets
     * `doubt`, and the row is run again, precisely. */
    bool rough, doubt;
};

/* Errors of a rough run may change omegasq by at most this fraction. */
#define ROUGH_CLEAR ((real)1 / 32)

/* In a rough run, a contact force must exceed this fraction of the weight of the pushed domino, so that its
 * sign is certain. */
#define LEAST_CLEAR ((real)1 / 64)

/* Begins a study (entry/study.h). */
KERNEL enum dom_status study_begin(const struct row_request *request, struct study **study,
                                   struct dom_verdict *verdict);

#endif
