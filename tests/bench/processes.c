/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs processes, and measures the program: many lines on its standard input, its start, and a long curve. */
#include "bench.h"

#include "domino.h"
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>

extern char **environ;

#define SLOW 5 /* a process that takes longer than this many seconds runs only once */

static struct process process_run(const char *const *argv)
{
    struct process process = {.done = false};
    struct rusage used;
    posix_spawn_file_actions_t actions;
    pid_t child;
    int status;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    const double begun = seconds_now();
    if (posix_spawnp(&child, argv[0], &actions, NULL, (char *const *)(size_t)argv, environ) == 0 &&
        wait4(child, &status, 0, &used) == child) {
        process.seconds = seconds_now() - begun;
        process.work = (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                       1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
        process.done = status == 0;
        process.megabytes = (double)used.ru_maxrss / 1024;
    }
    posix_spawn_file_actions_destroy(&actions);
    return process;
}

struct process process_least(const char *const *argv, int runs)
{
    struct process best = {.seconds = NONE, .work = NONE, .megabytes = NONE};
    for (int k = 0; k < runs && !(best.seconds > SLOW); k++) {
        const struct process now = process_run(argv);
        if (now.done && !(best.work <= now.work))
            best = now;
    }
    return best;
}

/* Runs a command of the shell several times. */
static struct process command_least(const char *command, int runs)
{
    const char *const argv[] = {"sh", "-c", command, NULL};
    return process_least(argv, runs);
}

/* ---- Lines on standard input ---- */

enum { MANY = 100000, SOME = 10000, RUNS = 5, STARTS = 200 };

/* Returns the processor time of a program that reads a line many times. */
static double lines_seconds(const char *build, const char *program, const char *line, int count)
{
    char path[1000], command[4200];
    snprintf(path, sizeof path, "%s/lines", build);
    FILE *file = fopen(path, "w");
    for (int i = 0; file && i < count; i++)
        fprintf(file, "%s\n", line);
    if (!file || fclose(file) != 0)
        perror(path);
    snprintf(command, sizeof command, "exec %s < '%s'", program, path);
    const double seconds = command_least(command, RUNS).work;
    remove(path);
    return seconds;
}

/* Returns the processor time that the library takes to find r_max with both fuels, SOME times. */
static double library_seconds(void)
{
    struct dom_train train = dom_train_default();
    struct dom_limit limit;
    struct timespec from, to;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &from);
    for (int i = 0; i < 2 * SOME; i++) {
        train.fuel = i % 2 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        if (dom_limit_rmax(&train, NULL, &limit) != DOM_OK)
            return NONE;
    }
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &to);
    return (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
}

size_t processes_measure(const char *build, struct goal *goal)
{
    char program[1000], count[1200], curve[1200];
    snprintf(program, sizeof program, "'%s/domino' -n", build);
    snprintf(count, sizeof count, "exec %s -e 'count 112'", program);
    snprintf(curve, sizeof curve, "exec %s -e 'set threads 1; set output csv; curve 0.02 0.9 10000'",
             program);
    const double print = lines_seconds(build, program, "print 2+2", MANY),
                 sum = lines_seconds(build, "bc", "2+2", MANY),
                 rmax = lines_seconds(build, program, "rmax 0.4", SOME),
                 start = command_least(count, STARTS).seconds,
                 bc = command_least("echo 'l(112/0.048)/l(1.5)' | exec bc -l", STARTS).seconds;
    const struct process many = command_least(curve, RUNS);
    goal[0] = (struct goal){
        "100,000 lines 'print 2+2', times as long as '2+2' in bc", "x", 0.70, 1, print / sum, false};
    goal[1] = (struct goal){"lines 'rmax 0.4', times as long as the library for both fuels",
                            "x",
                            NONE,
                            1.5,
                            rmax / library_seconds(),
                            false};
    goal[2] = (struct goal){
        "'count 112' from a cold start, times as long as bc", "x", 1.7, 1.15, start / bc, false};
    goal[3] = (struct goal){"'curve 0.02 0.9 10000' on one core", "s", NONE, NONE, many.seconds, false};
    goal[4] = (struct goal){"  its peak memory", "MB", NONE, 10, many.megabytes, false};
    return 5;
}
