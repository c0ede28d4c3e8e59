/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The lower bound of the times. The tilt of a domino follows from the tilt of the one before it, so (31; A6)
 * is a chain of dependent operations, and no pass along the train takes less time than their latency.
 */
#include "bench.h"
#include <stdlib.h>

enum { DOMINOES = 64, TRAINS = 20000, REPEATS = 7, LANES = 4 };

/* Newton's method doubles the number of digits in each step: 1, 2, 4, 8, 16. */
enum { NEWTON_STEPS = 4, PASSES_A_STEP = 2 };

struct point {
    double x, y;
};

/* Returns the tilt of the follower by (12; b8) and (31; A6), and computes nothing else. */
static inline struct point next(struct point p, double r, double L, double d)
{
    double X = r * (L * p.y - d), Y = sqrt(1 - X * X);
    return (struct point){Y * p.x + X * p.y, Y * p.y - X * p.x};
}

/* Returns the time in nanoseconds of one link of a train with rounded edges. The link consists of the turn,
 * by the estimate and the first correction of turn_solve (src/train/model/geometry/rounded.c), and of the
 * tilt. */
static double rounded_link(double rho)
{
    const struct setup train = setup_default();
    const double r = 1.5, d = (double)train.d, L = (double)train.s + d, l = (1 - 2 * rho) / r,
                 rho_1 = rho / r;
    double least = INFINITY, x = 0, y = 1, theta = 0;
    volatile double sink;
    for (int k = 0; k < REPEATS; k++) {
        double begun = seconds_now();
        for (int t = 0; t < TRAINS; t++) {
            x *= 0.0;
            y = 1 + 0.0 * y;
            theta *= 0.0;
            for (int i = 0; i < DOMINOES; i++) {
                double G = L * y - d + (rho - rho_1) * (1 - y - x + theta * y), c = rho_1 * y,
                       X = G / (l + c), z = X * X,
                       excess = z * (0.1604 + z * 0.1353 - z * z * (0.1387 - z * 0.2231)),
                       w = X - c / (l + c) * X * excess, Y = sqrt(1 - w * w), U = asin(w),
                       by = (G - l * w - c * U) / (l * Y + c), sine = w + by * Y, cosine = Y - by * w;
                struct point next = {cosine * x + sine * y, cosine * y - sine * x};
                x = next.x;
                y = next.y;
                theta += U + by;
            }
        }
        least = fmin(least, seconds_now() - begun);
        sink = x + y + theta;
    }
    (void)sink;
    return 1e9 * least / ((double)TRAINS * DOMINOES);
}

static double lanes_measure(size_t lanes)
{
    const struct setup train = setup_default();
    volatile double sink;
    double r = 1, d = (double)train.d, L = (double)train.s + d, least = INFINITY;
    for (int k = 0; k < REPEATS; k++) {
        struct point p[LANES] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}};
        double begun = seconds_now();
        for (int t = 0; t < TRAINS; t++) {
            /* Each train begins upright, but only after the previous one has ended. */
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

void shares_print(const char *build)
{
    char command[4200];
    double link = recurrence_measure().one;
    printf("\nWhere the time of an answer goes, also in bare links of %.2f ns, (12; b8) and (31; A6) alone; "
           "instructions by part\n",
           link);
    fflush(stdout);
    snprintf(command, sizeof command, "tests/bench/shares '%s' %.9g", build, link);
    if (system(command) != 0)
        puts("  not known: tests/bench/shares failed");
}

/* Returns the mean number of dominoes in a pass at the growth of the answer. */
static double dominoes_at_answer(const struct question *question, size_t n)
{
    struct dom_work work = {.passes = 0};
    struct domq_fuels fuels;
    for (size_t i = 0; i < n; i++) {
        struct setup train = question[i].train;
        train.r = ask_ours(&question[i], 1e-12, IN_DOUBLE, NULL);
        train.work = &work;
        ask_fuel_find(&train, &fuels);
    }
    return (double)work.dominoes / (double)n;
}

static void line(const char *what, double value, const char *unit)
{
    printf("  %-68s %9.2f %s\n", what, value, unit);
}

void floor_print(const char *title, const struct question *question, size_t n, double seconds,
                 const char *operations)
{
    struct dom_work work = {.passes = 0};
    struct recurrence bare = recurrence_measure();
    for (size_t i = 0; i < n; i++)
        ask_ours(&question[i], 1e-12, IN_DOUBLE, &work);
    double passes = (double)work.passes / (double)n, dominoes = (double)work.dominoes / (double)n;
    double at_answer = dominoes_at_answer(question, n), us = 1e6 * seconds;
    double of_passes = 1e-3 * dominoes * bare.one;
    double of_any = 1e-3 * NEWTON_STEPS * PASSES_A_STEP * at_answer * bare.one;
    printf("\nThe lower bound of %s at 1e-12, mean of the same %zu questions\n", title, n);
    line("measured, ours", us, "us");
    line("passes along the train (struct dom_work)", passes, "");
    line("dominoes in all these passes", dominoes, "");
    line("time for a domino", 1e3 * us / dominoes, "ns");
    if (operations)
        printf("  executed for a domino, everything included:\n    %s\n", operations);
    puts("  the bare recurrence, (12; b8) and (31; A6), each domino waiting for the one before:\n"
         "    4 adds, 7 multiplies, 1 square root");
    line("  a domino of one train on this machine", bare.one, "ns");
    line("  a domino of four trains side by side", bare.four, "ns");
    line("lower bound of these passes: the bare recurrence of their dominoes", of_passes, "us");
    line("  measured / this bound", us / of_passes, "");
    if (question->task != RMAX)
        return;
    line("dominoes of a pass at r_max itself", at_answer, "");
    line("lower bound of a search that knows where to look: 8 such passes (*)", of_any, "us");
    line("  measured / this bound", us / of_any, "");
    puts("  (*) Newton's method for r, from one correct digit: 4 steps, each with a pass at theta_c for the\n"
         "      launch and one at theta_m for the barrier.  Trains side by side can be faster.");
}

void floor_print_edges(const struct question *sharp, double sharp_seconds, const struct question *rounded,
                       double rounded_seconds)
{
    struct dom_work few = {.passes = 0}, many = few;
    ask_ours(sharp, 1e-12, IN_DOUBLE, &few);
    ask_ours(rounded, 1e-12, IN_DOUBLE, &many);
    const double of_sharp = 1e9 * sharp_seconds / (double)few.dominoes,
                 of_rounded = 1e9 * rounded_seconds / (double)many.dominoes;
    printf("\nThe cost of rounded edges in r_max, massive, s = %.1f\n", (double)sharp->train.s);
    line("measured, with sharp edges", 1e6 * sharp_seconds, "us");
    line("measured, with rounded edges", 1e6 * rounded_seconds, "us");
    line("dominoes in all passes, with sharp edges", (double)few.dominoes, "");
    line("dominoes in all passes, with rounded edges", (double)many.dominoes, "");
    line("time for a domino, with sharp edges", of_sharp, "ns");
    line("time for a domino, with rounded edges", of_rounded, "ns");
    line("a bare link of one train, with sharp edges", recurrence_measure().one, "ns");
    line("a bare link of one train, with rounded edges", rounded_link((double)rounded->train.rho), "ns");
    line("measured, with rounded edges / with sharp edges", rounded_seconds / sharp_seconds, "");
    line("this ratio if both searches visited the same number of dominoes", of_rounded / of_sharp, "");
}
