/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Types and functions that the files in this directory share, and the commands that these files define. */
#ifndef SHELL_PLANNING_H
#define SHELL_PLANNING_H

#include "interpreter/question.h"

/* ---- The wishes of 'design' and 'improve' ---- */

enum { BOARDS_MOST = 32 };

struct wishes {
    domq_real safety; /* the minimum safety that a design must have */
    domq_real hall;   /* the maximum length of the row in m */
    enum dom_least least;
    bool has_hall;             /* true if the user has typed 'hall' */
    domq_real probability;     /* the smallest allowed probability of falling, or 0 */
    bool sizes;                /* true if 'improve' also changes sizes */
    domq_real mass, grid;      /* as in struct dom_limits, where `mass` is called `heaviest` */
    double board[BOARDS_MOST]; /* as in struct dom_limits */
    size_t boards;
};
extern const struct wishes usual_wishes;

/* If `grid` is not 0, all gaps of a design are multiples of this length. Checks that `grid` is less than
 * `first`, the height of the first domino. Otherwise every gap would be too long for this domino to reach the
 * next one. */
bool grid_check(domq_real grid, domq_real first, struct problem *problem);

/* ---- The row of 'design' and 'improve' ---- */

struct improved {
    struct dom_study study[2]; /* the studies before and after the changes */
    size_t changed;            /* the number of dominoes that have changed */
    double length;             /* the length of the row in m after its last domino has fallen */
    bool interrupted;          /* true if ^C ended the search: the row is the best one so far */
};

/* Improves the row of the scene and prints the changes. If there is a next state, stores the row in it.
 * Returns false after an error or an interrupt. If found->interrupted is true, the best row so far has been
 * stored in spite of the interrupt. */
bool improve_row(const struct query *query, const struct wishes *wishes, struct answer *a,
                 struct improved *found, struct problem *problem);

/* ---- The commands ---- */

extern const struct column design_columns[], improve_columns[];
bool run_design(const struct query *query, struct answer *a, struct problem *problem);
bool run_improve(const struct query *query, struct answer *a, struct problem *problem);

bool design_parse(struct reader *reader, struct question *question);
bool improve_parse(struct reader *reader, struct question *question);
bool wishes_bind(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);

/* names_lists (see names.h) */
const char *design_wishes(const void *context, int k);
const char *improve_wishes(const void *context, int k);

#endif
