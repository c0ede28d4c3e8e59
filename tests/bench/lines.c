/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Many commands on standard input: whole processes that read them from a file. */
#include "bench.h"
#include <stdio.h>

enum { MANY = 100000, SOME = 10000, RUNS = 7, TIMED = 300 };

/* Returns the least time of a program that reads the file; NaN if it does not run. */
static double reading_seconds(const char *program, const char *path)
{
    char command[9000];
    double least = NONE;
    snprintf(command, sizeof command, "exec %s < '%s'", program, path);
    const char *const argv[] = {"sh", "-c", command, NULL};
    for (int k = 0; k < RUNS; k++) {
        struct process now = process_run(argv, "");
        if (!now.done)
            return NONE;
        least = fmin(least, now.seconds);
    }
    return least;
}

static bool lines_write(const char *path, const char *line, int count)
{
    FILE *file = fopen(path, "w");
    for (int i = 0; file && i < count; i++)
        fprintf(file, "%s\n", line);
    return file && fclose(file) == 0;
}

/* Returns the seconds that the library takes for r_max with both fuels. */
static double both_seconds(void)
{
    struct asked train = asked_default();
    struct domq_limit limit;
    double least = INFINITY;
    train.s = (domq_real)4 / 10;
    for (int k = 0; k < RUNS; k++) {
        double begun = seconds_now();
        for (int i = 0; i < TIMED; i++) {
            train.fuel = i % 2 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
            if (ask_limit_rmax(&train, &limit, NULL, NULL) != DOM_OK)
                return NONE;
        }
        least = fmin(least, (seconds_now() - begun) / (TIMED / 2.0));
    }
    return least;
}

struct lines_goals lines_print(const char *build, const char *domino)
{
    char path[4200], program[4200];
    struct lines_goals goals = {NONE, NONE};
    snprintf(path, sizeof path, "%s/lines", build);
    snprintf(program, sizeof program, "'%s' -n", domino);
    if (!lines_write(path, "print 2+2", MANY)) {
        perror(path);
        return goals;
    }
    double print = reading_seconds(program, path);
    if (!lines_write(path, "2+2", MANY))
        return goals;
    double bc = reading_seconds("bc", path);
    if (!lines_write(path, "rmax 0.4", SOME))
        return goals;
    double rmax = reading_seconds(program, path), library = SOME * both_seconds();
    remove(path);
    goals = (struct lines_goals){.print = print / bc, .rmax = rmax / library};
    printf("\nLines on standard input, ms\n  %-46s", "100,000 times 'print 2+2'");
    number_print(10, 1, 1e3 * print);
    printf("\n  %-46s", "  '2+2' in bc");
    number_print(10, 1, 1e3 * bc);
    printf("\n  %-46s", "10,000 times 'rmax 0.4'");
    number_print(10, 1, 1e3 * rmax);
    printf("\n  %-46s", "  the same r_max with both fuels, by the library");
    number_print(10, 1, 1e3 * library);
    putchar('\n');
    fflush(stdout);
    return goals;
}
