/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shows how the time for a row grows with the number of dominoes. */
#include "../../src/engine/engine.h"
#include "../unit/direct.h"
#include "bench.h"
#include <stdlib.h>

enum { REPEATS = 3, DIRECT_MOST = 50, ENGINE_TIMED = 50, GOAL = 10000 };

#define PUSH     6.0 /* rad/s */
#define PATIENCE 0.5 /* seconds that the repetitions of one measurement may take */

/* A row of equal solid dominoes. Each method finds whether all of them fall. */
struct line {
    size_t count;
    struct domq_domino *domino;
};

static bool line_make(struct line *line, size_t count)
{
    struct setup train = setup_default();
    struct domq_scale scale = domq_scale_default();
    train.r = 1;
    *line = (struct line){.count = count, .domino = calloc(count, sizeof *line->domino)};
    if (line->domino)
        ask_row_of_train(&train, &scale, 1, line->domino, count);
    return line->domino != NULL;
}

static struct row_setup line_setup(const struct line *line)
{
    struct domq_scale scale = domq_scale_default();
    return (struct row_setup){.domino = line->domino,
                              .count = line->count,
                              .g = scale.g,
                              .push = PUSH,
                              .tol = setup_default().tol,
                              .precision = IN_DOUBLE};
}

static bool ours_falls(const struct line *line, bool times)
{
    struct row_setup row = line_setup(line);
    struct domq_verdict verdict;
    return ask_row_run(&row, times, NULL, NULL, &verdict) == DOM_OK && verdict.end == DOM_ROW_FALLS;
}

static bool verdict_falls(const struct line *line)
{
    return ours_falls(line, false);
}

static bool times_fall(const struct line *line)
{
    return ours_falls(line, true);
}

/* Integrates Newton's laws for all dominoes of the row with GSL. */
static bool direct_falls(const struct line *line)
{
    double height[DIRECT_MOST], thickness[DIRECT_MOST], width[DIRECT_MOST], gap[DIRECT_MOST],
        mass[DIRECT_MOST];
    struct direct_hit hits[DIRECT_MOST];
    struct direct_result result;
    if (line->count > DIRECT_MOST)
        return false;
    for (size_t i = 0; i < line->count; i++) {
        height[i] = (double)line->domino[i].height;
        thickness[i] = (double)line->domino[i].thickness;
        width[i] = (double)line->domino[i].width;
        gap[i] = (double)line->domino[i].gap;
        mass[i] = (double)line->domino[i].mass;
    }
    struct direct_row row = {.n = line->count,
                             .height = height,
                             .thickness = thickness,
                             .width = width,
                             .gap = gap,
                             .mass = mass,
                             .g = (double)domq_scale_default().g,
                             .omega = PUSH};
    return !direct_run(&row, hits, &result) && result.all_fall;
}

/* Runs the row in Chipmunk, with steps so short that its verdict no longer changes. */
static bool engine_falls(const struct line *line)
{
    struct engine_box box[ENGINE_TIMED];
    struct engine_settled settled;
    if (line->count > ENGINE_TIMED || !engine_version())
        return false;
    for (size_t i = 0; i < line->count; i++)
        box[i] = (struct engine_box){.height = (double)line->domino[i].height,
                                     .thickness = (double)line->domino[i].thickness,
                                     .gap = (double)line->domino[i].gap,
                                     .mass = (double)line->domino[i].mass};
    struct engine_row row = ENGINE_ROW(box, line->count);
    row.g = (double)domq_scale_default().g;
    row.push = PUSH;
    return engine_settle(&row, false, NULL, NULL, &settled) == ENGINE_OK && settled.fall.all;
}

/* Returns the shortest of several times. Returns NaN if there is no answer, or if the answer is wrong. */
static double seconds_of(bool falls(const struct line *), const struct line *line)
{
    double least = NONE, spent = 0;
    for (int k = 0; k < REPEATS && spent < PATIENCE; k++) {
        double begun = seconds_now();
        if (!falls(line))
            return NONE;
        double seconds = seconds_now() - begun;
        spent += seconds;
        least = fmin(least, seconds);
    }
    return least;
}

double lengths_print(void)
{
    double of_goal = NONE;
    static const size_t counts[] = {10, 20, 50, 100, 1000, 10000, 100000};
    puts("\nTime against the dominoes of a row: equal ones, pushed by 6 rad/s, all fall; us\n"
         "('-': not installed, or not measured with so many dominoes)");
    printf("  %-8s %12s %10s %12s %14s %12s\n", "dominoes", "verdict", "each", "with times", "Newton by GSL",
           "Chipmunk");
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        struct line line;
        if (!line_make(&line, counts[i]))
            return of_goal;
        double verdict = seconds_of(verdict_falls, &line);
        of_goal = counts[i] == GOAL ? verdict : of_goal;
        printf("  %-8zu", counts[i]);
        number_print(12, 1, 1e6 * verdict);
        number_print(10, 2, 1e6 * verdict / (double)counts[i]);
        number_print(12, 1, counts[i] > 10000 ? NONE : 1e6 * seconds_of(times_fall, &line));
        number_print(14, 1, 1e6 * seconds_of(direct_falls, &line));
        number_print(12, 1, 1e6 * seconds_of(engine_falls, &line));
        putchar('\n');
        fflush(stdout);
        free(line.domino);
    }
    return of_goal;
}
