/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How fast could it be?  One domino follows from the one before it: (A6) is a chain of dependent operations,
 * and no pass down the train is shorter than their latency.
 */
#include "bench.h"

enum { DOMINOES = 64, TRAINS = 20000, REPEATS = 7, LANES = 4 };

/* Newton's method from one digit: 2, 4, 8, 16. */
enum { NEWTON_STEPS = 4, PASSES_A_STEP = 2 };

struct point {
    double x, y;
};

/* (b8) and (A6), and nothing else. */
static inline struct point next(struct point p, double r, double L, double d)
{
    double X = r * (L * p.y - d), Y = sqrt(1 - X * X);
    return (struct point){Y * p.x + X * p.y, Y * p.y - X * p.x};
}

static double lanes_measure(size_t lanes)
{
    const struct dom_train train = dom_train_default();
    volatile double sink;
    double r = 1, d = (double)train.d, L = (double)train.s + d, least = INFINITY;
    for (int k = 0; k < REPEATS; k++) {
        struct point p[LANES] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}};
        double begun = seconds_now();
        for (int t = 0; t < TRAINS; t++) {
            /* Each train begins upright, but not before the one before has ended. */
            for (size_t lane = 0; lane < lanes; lane++)
                p[lane] = (struct point){0.0 * p[lane].x, 1 + 0.0 * p[lane].y};
            if (lanes == 1)
                for (int i = 0; i < DOMINOES; i++)
                    p[0] = next(p[0], r, L, d);
            else
                for (int i = 0; i < DOMINOES; i++)
                    for (size_t lane = 0; lane < LANES; lane++)
                        p[lane] = next(p[lane], r, L, d);
        }
        least = fmin(least, seconds_now() - begun);
        sink = p[0].x + p[1].x + p[2].x + p[3].x;
    }
    (void)sink;
    return 1e9 * least / ((double)TRAINS * DOMINOES * (double)lanes);
}

struct recurrence recurrence_measure(void)
{
    return (struct recurrence){.one = lanes_measure(1), .four = lanes_measure(LANES)};
}

void floor_print(const struct question *question, size_t n, double seconds, const char *operations)
{
    struct dom_work work = {.passes = 0};
    struct recurrence bare = recurrence_measure();
    for (size_t i = 0; i < n; i++)
        ask_ours(&question[i], 1e-12, DOM_DOUBLE, &work);
    double passes = (double)work.passes / (double)n, dominoes = (double)work.dominoes / (double)n;
    double pass = dominoes / passes, us = 1e6 * seconds, fewest = NEWTON_STEPS * PASSES_A_STEP;
    printf("\nThe floor of r_max at 1e-12, mean of the same %zu questions\n", n);
    printf("  %-66s %9.2f us\n", "measured, ours", us);
    printf("  %-66s %9.1f\n", "passes down the train (struct dom_work)", passes);
    printf("  %-66s %9.1f\n", "dominoes a pass", pass);
    printf("  %-66s %9.2f ns\n", "so much a domino", 1e3 * us / dominoes);
    if (operations)
        printf("  executed for a domino, everything included:\n    %s\n", operations);
    printf("  %-66s %9.2f ns\n", "the bare recurrence (b8), (A6) on this machine, a domino", bare.one);
    printf("  %-66s %9.2f ns\n", "  four trains side by side, a domino", bare.four);
    printf("  %-66s %9.2f us\n", "floor of these passes: every domino of them at that latency",
           1e-3 * dominoes * bare.one);
    printf("  %-66s %9.2f\n", "  measured / that floor", us / (1e-3 * dominoes * bare.one));
    printf("  %-66s %9.2f us\n", "floor of any search: 8 such passes, one after the other (*)",
           1e-3 * fewest * pass * bare.one);
    printf("  %-66s %9.2f\n", "  measured / that floor", us / (1e-3 * fewest * pass * bare.one));
    puts("  (*) Newton's method for r from one digit right: 4 steps, each of them a pass at theta_c for the\n"
         "      launch and one at theta_m for the barrier.  Whoever runs trains side by side can be below "
         "it.");
    fflush(stdout);
}
