/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A finite row and its result, by the library and by Newton's equations (direct.h). */
#ifndef TEST_RUN_H
#define TEST_RUN_H

#include "ask.h"
#include "direct.h"

enum { ROW_MOST = 64 };

struct run {
    struct domq_domino domino[ROW_MOST];
    struct asked_row row;
    struct domq_fall fall[ROW_MOST];
    size_t falls;
    struct domq_verdict verdict;
};

/* Runs the row with times. */
enum dom_status run_whole(struct run *run);

/* Returns how the row ends, from the verdict alone; fails the test if there is no verdict. */
enum dom_row_end row_end(struct run *run);

/* Returns the angular velocity that turns a single domino over its edge, in rad/s: half of I omega^2 lifts
 * its centre. */
double push_over(const struct domq_domino *domino);

/* Makes a row of count standard dominoes, each r times the one before, of 10 g at first, pushed three times
 * as hard as push_over. */
void make_row(struct run *run, size_t count, double s, double r, double mu);

struct newton {
    double height[ROW_MOST], thickness[ROW_MOST], gap[ROW_MOST], mass[ROW_MOST], lean[ROW_MOST];
    struct direct_hit hit[ROW_MOST];
    struct direct_result result;
    const char *wrong;
};

/* Runs the row by Newton's equations; its domino arrays stay in n. */
void newton_run(const struct run *run, struct newton *n);

/* Returns false if a margin of the row is so small that rounding decides. */
bool run_is_clear(const struct run *run);

/* Compares each hit and the end of a row with Newton's equations; fails the test where they differ. */
void newton_compare(const struct run *run, const struct newton *n);

#endif
