/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The benchmark measures how long the main questions take, in one run, and prints these times beside their
 * goals. Most goals are ratios between times of this run: to the time of another program, or of the bare step
 * from a domino to the next. The shortest of several times counts, so that other work of the machine matters
 * little.
 */
#ifndef BENCH_H
#define BENCH_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* Marks a value that does not exist. */
#define NONE ((double)NAN)

/* A line of the table. Numbers that do not exist are NONE. */
struct goal {
    const char *text, *unit;
    double goal, measured;
    bool at_least; /* the goal is a lower bound */
};

double seconds_now(void);

/* Returns the time of a link of a train that does nothing but follow (12; b8) and (31; A6), in seconds. Each
 * link waits for the one before, so no pass along a train is faster. */
double bare_link(void);

/* Measure what the program of this build takes for many lines and for its start, and the questions for which
 * people have to wait (processes.c). Both write at most GOALS_MOST goals and return their number. The system
 * counts the memory of the benchmark as memory of the processes that it starts, so both must be called before
 * the benchmark takes much memory. */
enum { GOALS_MOST = 32 };
size_t processes_measure(const char *build, struct goal *goal);
size_t waits_measure(const char *build, struct goal *goal);

#endif
