/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files of this folder give each other and the tables of their commands. */
#ifndef SHELL_ROWS_H
#define SHELL_ROWS_H

#include "commands/rows/falling.h"

extern const struct column fall_columns[], verdict_columns[], mend_columns[], tolerance_columns[],
    placement_columns[], slip_columns[];
bool run_fall(const struct query *query, struct answer *a, struct problem *problem);
bool run_verdict(const struct query *query, struct answer *a, struct problem *problem);
bool run_mend(const struct query *query, struct answer *a, struct problem *problem);
bool run_tolerance(const struct query *query, struct answer *a, struct problem *problem);
bool run_pool(const struct query *query, struct answer *a, struct problem *problem);
bool run_slip(const struct query *query, struct answer *a, struct problem *problem);

/* The friction that a foot needs while the domino `head` falls, or in the instant when it is hit. */
struct slip {
    domq_real needs;     /* infinite if the domino is lifted off */
    size_t domino, head; /* counted from 1; head is 0 if there is no such foot */
};

/* The friction that the feet of a row need, on a floor with this friction. */
struct feet {
    domq_real floor;
    struct needs {
        struct slip most, first; /* the foot that needs most, and the first that slips */
    } motion, hit;               /* while dominoes fall, and in the instant of a hit */
};

/* Begins with the floor of the scene, adds a domino that was hit, and says what a row of so many dominoes
 * needs and what follows. */
struct feet feet_begin(const struct query *query);
void feet_add(struct feet *feet, const struct domq_fall *fall);
void feet_say(struct answer *a, const struct feet *feet, size_t count);
extern const char foot_lifted[];

/*
 * Writes the answer of 'placement' from its counts: stops[k] rows ended at domino k + 1, of `count`. reason,
 * unless NULL, says which rows are missing.
 */
void study_answer(struct answer *a, domq_real sigma, domq_real heights, const struct domq_study *study,
                  const size_t *stops, size_t count, const char *reason);

/* Answers with the part of a study that --shard asks for: the counts of blocks of rows, which are the same
 * blocks for any number of parts. */
bool study_blocks(const struct query *query, struct answer *a, struct problem *problem,
                  const struct scene_row *scene, const struct domq_placement *placement);

#endif
