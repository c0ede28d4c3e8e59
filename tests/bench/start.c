/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures whole processes, from their start to their end. */
#include "bench.h"
#include <stdlib.h>

enum { RUNS = 200, SLOW_RUNS = 5 };

#define SLOW 0.02 /* processes that take longer than this many seconds are measured less often */

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double start_print(const char *domino)
{
    static const char *const answer = "theta1 0.2", *const logarithms = "l(112/0.048)/l(1.5)\n";
    const struct {
        const char *name, *argv[5], *input;
    } programs[] = {
        {"domino -e 'theta1 0.2'", {domino, "-e", answer, NULL}, ""},
        {"echo 'l(112/0.048)/l(1.5)' | bc -l", {"bc", "-l", NULL}, logarithms},
        {"python3 -c 'import scipy.optimize; ...'",
         {"/usr/bin/python3", "-c",
          "import math, scipy.optimize; print(math.log(112 / 0.048) / math.log(1.5))", NULL},
         ""},
    };
    enum { PROGRAMS = sizeof programs / sizeof *programs };
    static double seconds[PROGRAMS][RUNS];
    int runs[PROGRAMS] = {0};
    bool there[PROGRAMS];
    for (int i = 0; i < PROGRAMS; i++)
        there[i] = process_run(programs[i].argv, programs[i].input).done;
    for (int k = 0; k < RUNS; k++)
        for (int i = 0; i < PROGRAMS; i++) {
            if (!there[i] || (k >= SLOW_RUNS && seconds[i][0] > SLOW))
                continue;
            seconds[i][runs[i]++] = process_run(programs[i].argv, programs[i].input).seconds;
        }
    printf("\nStart-up to the first answer, whole processes in turn, %d runs (%d of the slow ones)\n", RUNS,
           SLOW_RUNS);
    printf("  %-52s %10s %10s %9s\n", "", "least, ms", "median, ms", "ratio");
    for (int i = 0; i < PROGRAMS; i++) {
        if (!there[i]) {
            printf("  %-52s is not installed, or does not run\n", programs[i].name);
            continue;
        }
        qsort(seconds[i], (size_t)runs[i], sizeof **seconds, ascending);
        printf("  %-52s %10.2f %10.2f %9.3g\n", programs[i].name, 1e3 * seconds[i][0],
               1e3 * seconds[i][runs[i] / 2], seconds[i][0] / seconds[0][0]);
    }
    fflush(stdout);
    return there[1] ? seconds[0][0] / seconds[1][0] : NONE;
}
