/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a finite row in the library and by Newton's equations (direct.c), and compares the results. */
#ifndef TEST_RUN_H
#define TEST_RUN_H

#include "ask.h"
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

/* Makes a row of equal dominoes, the first of which is pushed. */
void alike(struct run *run, size_t count);

/* Returns the tilt at which a domino tips over. */
double tips_at(const struct domq_domino *domino);

/* Makes a random row of equal (kind 0), growing, shrinking or uneven dominoes (kind 3). */
void row_of_kind(struct run *run, uint64_t *seed, int kind);

/* A hit by Newton's equations. The first one is the push, at time 0. */
struct newton_hit {
    double time;
    double omega;   /* angular velocity of this domino just after the hit */
    double kinetic; /* kinetic energy of all moving dominoes just after the hit */
    double kinetic_before;
    double friction_work; /* energy lost to sliding friction and to the air since the start */
};

struct newton {
    struct newton_hit hit[ROW_MOST];
    size_t hits; /* number of dominoes that were hit, including the first */
    bool all_fall;
    double end_time;    /* time at which the head lies flat or comes to rest */
    double least_force; /* smallest normal force between two dominoes; INFINITY if there was no contact */
    /* least_force is between dominoes least_at and least_at + 1, counted from 1; 0 if there is none */
    size_t least_at;
    size_t least_head; /* number, from 1, of the foremost domino at the moment of least_force */
    /* tilt of the head at the end; pi/2 if the head lies flat, even if it has missed the next domino */
    double stop_theta;
    const char *wrong; /* an error, or NULL; the hits before the error are valid */
};

/*
 * Runs the row by Newton's equations (direct.c). A tip that passes above the top of the next domino is an
 * error. If a hit is lower than mu times the thickness of the struck domino, friction holds the tip and the
 * face together: the struck domino does not turn, the row stops, and stop_theta is the lean of this domino. A
 * negative contact force means that the contact pulls. This is not an error, so check least_force.
 */
void newton_run(const struct run *run, struct newton *n);

/* Returns false if a margin of the row is so small that rounding decides the verdict. */
bool run_is_clear(const struct run *run);

/* Compares each hit and the end of a row with Newton's equations. Fails the test if they differ. */
void newton_compare(const struct run *run, const struct newton *n);

#endif
