/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rows of 20 dominoes with random gaps: how many a second, on one core and on all; and what effects cost, as
 * times of one answer over that without, side by side in one run.
 */
#include "domino.h"
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { DOMINOES = 20, ROWS = 2000, REPEATS = 3 };

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Rows a second, the most of a few runs; 0 if it fails. */
static double rows_a_second(double growth, double mu, unsigned threads)
{
    struct dom_train train = dom_train_default();
    struct dom_scale scale = dom_scale_default();
    struct dom_domino domino[DOMINOES];
    double most = 0;
    train.r = growth;
    dom_row_of_train(&train, &scale, 1, domino, DOMINOES);
    struct dom_row row = {.domino = domino,
                          .count = DOMINOES,
                          .g = scale.g,
                          .push = 6,
                          .mu = mu,
                          .tol = train.tol,
                          .precision = DOM_DOUBLE};
    struct dom_placement placement = {.sigma = 1e-4, .seed = 1, .rows = ROWS, .threads = threads};
    for (int i = 0; i < REPEATS; i++) {
        struct dom_study study;
        double begun = seconds();
        if (dom_placement_study(&row, &placement, &study, NULL) != DOM_OK || study.fall != study.rows)
            return 0; /* one that stops early is cheaper than one that falls */
        double rate = ROWS / (seconds() - begun);
        most = rate > most ? rate : most;
    }
    return most;
}

int main(void)
{
    static const struct {
        const char *name;
        double growth, mu;
    } kinds[] = {{"equal", 1, 0},
                 {"equal, friction 0.2", 1, 0.2},
                 {"r = 1.3", 1.3, 0},
                 {"r = 1.3, friction 0.2", 1.3, 0.2}};
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    printf("rows of %d dominoes to their verdict, all fall:\n", DOMINOES);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        double one = rows_a_second(kinds[i].growth, kinds[i].mu, 1),
               all = rows_a_second(kinds[i].growth, kinds[i].mu, 0);
        if (one == 0 || all == 0)
            return EXIT_FAILURE;
        printf("  %-22s %6.0f a second on one core, %4.2f times that on %ld\n", kinds[i].name, one, all / one,
               cores);
    }
    return EXIT_SUCCESS;
}
