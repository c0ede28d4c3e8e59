/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'count H fewest', and what features can add to its rows. */
#ifndef SHELL_FEWEST_H
#define SHELL_FEWEST_H

#include "interpreter/command.h"

/* The number of random rows that a share counts. */
enum { FEWEST_ROWS = 1000 };

/* The context of an extension of 'fewest' (struct feature_extension): a row that falls as planned. */
struct fewest_row {
    struct scene scene; /* the scene with this row; it shares the memory of the query's scene */
    double share;       /* set by the extension: the share of such rows that fall in spite of random errors */
    struct problem *problem; /* set if the share cannot be computed */
};

extern const struct column fewest_columns[];
bool run_fewest(const struct query *query, struct answer *a, struct problem *problem);

#endif
