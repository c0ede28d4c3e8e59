/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures processes that read many commands from a file on their standard input. */
#include "bench.h"
#include <stdio.h>
#include <time.h>

enum { MANY = 100000, SOME = 10000, RUNS = 5 };

/* Returns the processor time in s of a program that reads the file, or NaN if the program cannot be run. */
static double reading_seconds(const char *program, const char *path)
{
    char command[4200];
    snprintf(command, sizeof command, "exec %s < '%s'", program, path);
    const char *const argv[] = {"sh", "-c", command, NULL};
    struct process now = process_run(argv, "");
    return now.done ? now.work : NONE;
}

static bool lines_write(const char *path, const char *line, int count)
{
    FILE *file = fopen(path, "w");
    for (int i = 0; file && i < count; i++)
        fprintf(file, "%s\n", line);
    return file && fclose(file) == 0;
}

/* Returns the processor time in s that the library takes to find r_max with both fuels, as often as the lines
 * do. */
static double library_seconds(void)
{
    struct setup train = setup_default();
    struct domq_limit limit;
    struct timespec from, to;
    train.s = (domq_real)4 / 10;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &from);
    for (int i = 0; i < 2 * SOME; i++) {
        train.fuel = i % 2 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        if (ask_limit_rmax(&train, &limit) != DOM_OK)
            return NONE;
    }
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &to);
    return (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
}

struct lines_goals lines_print(const char *build, const char *domino)
{
    char path[3][1000], program[1000];
    static const struct {
        const char *line;
        int count;
    } files[] = {{"print 2+2", MANY}, {"2+2", MANY}, {"rmax 0.4", SOME}};
    enum { PRINTS, SUMS, GROWTHS };
    double least[] = {NONE, NONE, NONE}, library = NONE;
    snprintf(program, sizeof program, "'%s' -n", domino);
    for (int i = PRINTS; i <= GROWTHS; i++) {
        snprintf(path[i], sizeof path[i], "%s/lines%d", build, i);
        if (!lines_write(path[i], files[i].line, files[i].count))
            perror(path[i]);
    }
    for (int k = 0; k < RUNS; k++) { /* the programs take turns */
        for (int i = PRINTS; i <= GROWTHS; i++)
            least[i] = fmin(least[i], reading_seconds(i == SUMS ? "bc" : program, path[i]));
        library = fmin(library, library_seconds());
    }
    for (int i = PRINTS; i <= GROWTHS; i++)
        remove(path[i]);
    puts("\nLines on standard input, processor time in ms");
    const char *const names[] = {"100,000 times 'print 2+2'", "  '2+2' in bc", "10,000 times 'rmax 0.4'",
                                 "  the same r_max with both fuels, by the library"};
    const double seconds[] = {least[PRINTS], least[SUMS], least[GROWTHS], library};
    for (size_t i = 0; i < sizeof seconds / sizeof *seconds; i++) {
        printf("  %-50s", names[i]);
        number_print(10, 1, 1e3 * seconds[i]);
        putchar('\n');
    }
    fflush(stdout);
    return (struct lines_goals){least[PRINTS] / least[SUMS], least[GROWTHS] / library};
}
