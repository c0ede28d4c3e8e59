/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a finite row in the library and by Newton's equations (direct.h), and compares the results. */
#ifndef TEST_RUN_H
#define TEST_RUN_H

#include "ask.h"
#include "direct.h"
#include <stdint.h>

enum { ROW_MOST = 64 };

struct run {
    struct domq_domino domino[ROW_MOST];
    struct row_setup row;
    struct domq_fall fall[ROW_MOST];
    size_t falls;
    struct domq_verdict verdict;
};

/* Runs the row with times. */
enum dom_status run_whole(struct run *run);

/* Runs the row without times and returns how it ends. Fails the test if there is no verdict. */
enum dom_row_end row_end(struct run *run);

/* Returns the angular velocity in rad/s that just turns a single domino over its edge. The energy I omega^2 /
 * 2 lifts the centre. */
double push_over(const struct domq_domino *domino);

/* Makes a row of `count` standard dominoes, each r times as large as the one before. The first has a mass of
 * 10 g, and is pushed three times as hard as push_over says. */
void make_row(struct run *run, size_t count, double s, double r, double mu);

/* Makes a random row of equal (kind 0), growing, shrinking or uneven dominoes (kind 3). */
void row_of_kind(struct run *run, uint64_t *seed, int kind);

struct newton {
    double height[ROW_MOST], thickness[ROW_MOST], gap[ROW_MOST], mass[ROW_MOST], lean[ROW_MOST],
        width[ROW_MOST];
    struct direct_hit hit[ROW_MOST];
    struct direct_result result;
    const char *wrong;
};

/* Runs the row by Newton's equations. *n holds the arrays that describe the dominoes. */
void newton_run(const struct run *run, struct newton *n);

/* Returns false if a margin of the row is so small that rounding decides the verdict. */
bool run_is_clear(const struct run *run);

/* Compares each hit and the end of a row with Newton's equations. Fails the test if they differ. */
void newton_compare(const struct run *run, const struct newton *n);

#endif
