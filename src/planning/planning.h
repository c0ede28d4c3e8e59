/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Types and functions that the files in this directory share, and the commands that these files define. */
#pragma once

#include "domino_study.h"
#include "interpreter/question.h"

/* ---- The wishes of 'design' and 'improve' ---- */

enum { BOARDS_MOST = 32 };

struct wishes {
    domq_real falls;  /* the probability with which a design must fall, or 0 if it does not matter */
    domq_real safety; /* the minimum safety that a design must have */
    domq_real hall;   /* the maximum length of the row in m */
    domq_real grid;
    bool sizes;                /* true if 'improve' also changes sizes */
    double board[BOARDS_MOST]; /* as in struct dom_limits */
    size_t boards;
};

bool wishes_parse(struct reader *reader, struct question *question);
bool wishes_bind(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);

/* Each is a names_list (see names.h). */
const char *design_wishes(const void *context, int k);
const char *improve_wishes(const void *context, int k);

/* Returns the wishes of a command whose arguments wishes_bind has bound. */
const struct wishes *wishes_of(const struct query *query);

/* If `grid` is not 0, all gaps of a design are multiples of this length. Checks that `grid` is less than
 * `first`, the height of the first domino. Otherwise every gap would be too long for this domino to reach the
 * next one. */
bool grid_check(domq_real grid, domq_real first, struct problem *problem);

/* Converts a domino that the library has computed in double to quad, with 15 digits. */
struct domq_domino domino_from_double(const struct dom_domino *domino);

/* ---- The commands ---- */

extern const struct column design_columns[], plan_columns[];
bool run_design(const struct query *query, struct answer *a, struct problem *problem);
bool run_plan(const struct query *query, struct answer *a, struct problem *problem);
bool plan_parse(struct reader *reader, struct question *question);
