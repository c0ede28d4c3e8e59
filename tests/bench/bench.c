/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Prints how long the main questions take, and which goals are met. The command 'cost' compares the methods
 * at every tolerance, and 'make guard' counts instructions, which are less noisy.
 *
 * usage: bench BUILD, from the top of the project
 */
#include "bench.h"
#include "../unit/ask.h"
#include "domino_methods.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { MANY = 178, FEW = 18, CYCLES = 10, REPEATS = 2000, LONG = 10000 };

#define PATIENCE 0.5 /* seconds that the repetitions of one measurement may take */

double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double bare_link(void)
{
    enum { DOMINOES = 64, TRAINS = 20000, ROUNDS = 7 };
    const struct setup train = setup_default();
    const double r = 1, d = (double)train.d, L = (double)train.s + d;
    double least = INFINITY, x = 0, y = 1;
    volatile double sink;
    for (int k = 0; k < ROUNDS; k++) {
        const double begun = seconds_now();
        for (int t = 0; t < TRAINS; t++) {
            x *= 0.0; /* each train begins upright, but only after the previous one has ended */
            y = 1 + 0.0 * y;
            for (int i = 0; i < DOMINOES; i++) {
                const double X = r * (L * y - d), Y = sqrt(1 - X * X), from = x;
                x = Y * x + X * y;
                y = Y * y - X * from;
            }
        }
        least = fmin(least, seconds_now() - begun);
        sink = x + y;
    }
    (void)sink;
    return least / ((double)TRAINS * DOMINOES);
}

/* ---- Trains ---- */

typedef bool question(const struct setup *train);

static bool ask_rmax(const struct setup *train)
{
    struct domq_limit limit;
    return ask_limit_rmax(train, &limit) == DOM_OK;
}

static bool ask_best(const struct setup *train)
{
    struct domq_best best;
    const enum dom_status status = ask_limit_best(train, &best);
    return status == DOM_OK || status == DOM_NO_GROWTH;
}

/* Define questions for the methods for comparison. */
#define ASK_METHOD(method)                                                                                   \
    static bool ask_##method(const struct setup *setup)                                                      \
    {                                                                                                        \
        const struct domq_train wide = setup_train(setup);                                                   \
        const struct any_compute in = setup_compute(setup);                                                  \
        const struct dom_train train = train_in_double(&wide);                                               \
        const struct dom_compute compute = compute_in_double(&in);                                           \
        struct dom_limit limit;                                                                              \
        return dom_##method##_rmax(&train, &compute, &limit) == DOM_OK;                                      \
    }
ASK_METHOD(gsl)
ASK_METHOD(paper)

static bool ask_duration(const struct setup *train)
{
    domq_real duration;
    return ask_cycle_duration(train, &duration) == DOM_OK;
}

/* Returns the shortest of several mean times of n questions, or NONE if one of them has no answer. */
static double mean_seconds(question *ask, const struct setup *train, size_t n)
{
    double least = INFINITY, spent = 0;
    for (int k = 0; k < REPEATS && spent < PATIENCE; k++) {
        const double begun = seconds_now();
        for (size_t i = 0; i < n; i++)
            if (!ask(&train[i]))
                return NONE;
        const double seconds = seconds_now() - begun;
        spent += seconds;
        least = fmin(least, seconds);
    }
    return least / (double)n;
}

static double one_seconds(question *ask, struct setup train, enum precision precision)
{
    train.precision = precision;
    train.tol = any_arithmetic(precision).tol_default;
    return mean_seconds(ask, &train, 1);
}

/* Makes trains for s from 0.02 to 0.9, first hollow and then solid, for a tolerance. */
static void growths_make(struct setup *train, size_t n, double tol)
{
    for (size_t i = 0; i < n; i++) {
        train[i] = setup_default();
        train[i].q = i < n / 2 ? 3 : 4;
        train[i].s = 0.02 + 0.88 * (double)(i % (n / 2)) / (double)(n / 2 - 1);
        train[i].tol = tol;
    }
}

/* Makes trains of both kinds whose growth is 0.8 of the way to r_max. */
static void cycles_make(struct setup *train)
{
    for (int i = 0; i < CYCLES; i++) {
        struct domq_limit limit = {.r_max = 1};
        train[i] = setup_default();
        train[i].q = i % 2 ? 3 : 4;
        train[i].s = (domq_real)(1 + i / 2) / 10;
        ask_limit_rmax(&train[i], &limit);
        train[i].r = (double)(1 + (domq_real)0.8 * (limit.r_max - 1));
    }
}

/* Returns the largest number of passes that r_max takes for separations from s - 0.01 to s + 0.01. */
static double passes_near(double s, double q)
{
    size_t most = 0;
    for (int k = -100; k <= 100; k++) {
        struct dom_work work = {.passes = 0};
        struct setup train = setup_default();
        train.s = s + 1e-4 * k;
        train.q = q;
        train.work = &work;
        ask_rmax(&train);
        most = work.passes > most ? work.passes : most;
    }
    return (double)most;
}

/* Returns a pseudo-random number between lo and hi, evenly distributed in its logarithm. */
static double between(uint64_t *state, double lo, double hi)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return lo * pow(hi / lo, (double)(*state >> 11) * 0x1p-53);
}

/* Returns the mean time of n random trains. */
static double random_seconds(question *ask, int n, double thinnest, double thickest, double steepest)
{
    uint64_t state = (uint64_t)n;
    const double begun = seconds_now();
    for (int k = 0; k < n; k++) {
        struct setup train = setup_default();
        if (ask == ask_rmax)
            train.s = between(&state, 1e-4, 1);
        train.d = between(&state, thinnest, thickest);
        train.q = 0.3 + log(between(&state, 1, exp(steepest)));
        ask(&train);
    }
    return (seconds_now() - begun) / n;
}

/* ---- Rows ---- */

/* Returns the time of a verdict on a random row of 20, which falls. */
static double row_seconds(double mu)
{
    enum { DOMINOES = 20, ROWS = 2000 };
    struct setup train = setup_default();
    const struct domq_scale scale = domq_scale_default();
    struct domq_domino domino[DOMINOES];
    struct dom_study study;
    const struct dom_placement placement = {.error[DOM_ERROR_gap].size = 1e-4, .seed = 1, .rows = ROWS};
    train.r = 1.3;
    ask_row_of_train(&train, &scale, 1, domino, DOMINOES);
    struct row_setup row = row_setup_default(domino, DOMINOES, 6);
    row.mu = mu;
    const double begun = seconds_now();
    if (ask_placement_study(&row, &placement, &study, NULL) != DOM_OK || study.fall != ROWS)
        return NONE;
    return (seconds_now() - begun) / ROWS;
}

static double length_seconds(void)
{
    static struct domq_domino domino[LONG];
    struct setup train = setup_default();
    const struct domq_scale scale = domq_scale_default();
    struct domq_verdict verdict;
    train.r = 1;
    ask_row_of_train(&train, &scale, 1, domino, LONG);
    const struct row_setup row = row_setup_default(domino, LONG, 6);
    const double begun = seconds_now();
    if (ask_row_run(&row, false, NULL, NULL, &verdict) != DOM_OK || verdict.end != DOM_ROW_FALLS)
        return NONE;
    return seconds_now() - begun;
}

/* ---- The table ---- */

static void number_print(int width, int digits, double value)
{
    if (isnan(value))
        printf(" %*s", width, "-");
    else
        printf(" %*.*f", width, digits, value);
}

static void goals_print(const struct goal *goals, size_t n)
{
    printf("  %-62s %11s %9s\n", "", "goal", "now");
    for (const struct goal *g = goals; g < goals + n; g++) {
        const bool met = g->at_least ? g->measured >= g->goal : g->measured <= g->goal;
        printf("  %-62s", g->text);
        if (isnan(g->goal))
            printf(" %11s", "-");
        else
            printf(" %5s %5.4g", g->at_least ? ">=" : "<=", g->goal);
        number_print(9, g->measured < 10 ? 2 : 0, g->measured);
        printf(" %-7s %s\n", g->unit,
               isnan(g->measured) ? "not measured here"
               : isnan(g->goal)   ? ""
               : met              ? "met"
                                  : "NOT MET");
    }
}

static size_t library_measure(struct goal *goal)
{
    static struct setup many[MANY], rough[FEW], cycles[CYCLES];
    const double link = bare_link();
    growths_make(many, MANY, 1e-12);
    growths_make(rough, FEW, 1e-6);
    cycles_make(cycles);
    struct setup usual = setup_default(), edges = usual, close = usual, thin = usual, thinnest;
    edges.rho = (domq_real)1 / 100;
    close.s = (domq_real)2 / 100;
    thin.s = (domq_real)1 / 10000;
    thin.d = (domq_real)5 / 1000;
    thinnest = thin;
    thinnest.s = (domq_real)1 / 1000000;
    const double rmax = mean_seconds(ask_rmax, many, MANY),
                 in_double = one_seconds(ask_rmax, usual, IN_DOUBLE);
    const struct goal own[] = {
        {"best of 400 random (d, q)", "ms", 4, 1e3 * random_seconds(ask_best, 400, 1e-4, 0.6, 5.7), false},
        {"30,000 trains, s 1e-4 to 1", "us", 68, 1e6 * random_seconds(ask_rmax, 30000, 2e-6, 2, 6), false},
        {"r_max at 1e-12, mean of 178: s = 0.02 ... 0.9, both q", "links", 420, rmax / link, false},
        {"  times as fast as nested GSL solvers", "x", 15, mean_seconds(ask_gsl, many, MANY) / rmax, true},
        {"  times as fast as the paper's recipe, at 1e-6, 18 of them", "x", 1000,
         mean_seconds(ask_paper, rough, FEW) / mean_seconds(ask_rmax, rough, FEW), true},
        {"r_max at s = 0.02", "links", 2500, one_seconds(ask_rmax, close, IN_DOUBLE) / link, false},
        {"r_max of thin dominoes, d = 0.005, at s = 1e-6", "ms", NONE,
         1e3 * one_seconds(ask_rmax, thinnest, IN_DOUBLE), false},
        {"  at s = 1e-4, in quad", "ms", NONE, 1e3 * one_seconds(ask_rmax, thin, IN_QUAD), false},
        {"r_max of hollow dominoes near s = 0.54", "passes", 60, passes_near(0.54, 3), false},
        {"  of solid ones near s = 0.62", "passes", 60, passes_near(0.62, 4), false},
        {"  with rounded edges, times as long as with sharp ones", "x", 2,
         one_seconds(ask_rmax, edges, IN_DOUBLE) / in_double, false},
        {"  in quad, times as long as in double", "x", 50, one_seconds(ask_rmax, usual, IN_QUAD) / in_double,
         false},
        {"one cycle's duration to 1e-12", "links", 1300, mean_seconds(ask_duration, cycles, CYCLES) / link,
         false},
        {"verdict of a random row of 20, r = 1.3", "links", 6000, row_seconds(0) / link, false},
        {"  with friction 0.2", "links", 15000, row_seconds(0.2) / link, false},
        {"a row of 10,000 equal dominoes", "ms", 50, 1e3 * length_seconds(), false},
    };
    memcpy(goal, own, sizeof own);
    return sizeof own / sizeof *own;
}

int main(int argc, char **argv)
{
    static struct goal goals[3 * GOALS_MOST];
    const char *build = argc > 1 ? argv[1] : ".build";
    const double begun = seconds_now();
    size_t n = waits_measure(build, goals);
    n += processes_measure(build, goals + n);
    n += library_measure(goals + n);
    goals_print(goals, n);
    printf("\n%.0f s in all\n", seconds_now() - begun);
    return EXIT_SUCCESS;
}
