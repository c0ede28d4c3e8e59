/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs processes, and measures the program: many lines on its standard input, its start, a long curve, and
 * questions for which people have to wait. Each question starts the program anew, as it does for a user. */
#include "bench.h"

#include "domino.h"
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>

extern char **environ;

#define SLOW 5 /* a process that takes longer than this many seconds runs only once */

/* The result of a process without input, whose output is discarded. */
struct process {
    bool done; /* true if the process has run and ended with status 0 */
    double seconds;
    double work;      /* processor time in s */
    double megabytes; /* the largest memory of the process */
};

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

/* Runs a program, with arguments that end with NULL, several times. Returns the run with the least processor
 * time. */
static struct process process_least(const char *const *argv, int runs)
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
    goal[0] =
        (struct goal){"100,000 lines 'print 2+2', times as long as '2+2' in bc", "x", 1, print / sum, false};
    goal[1] = (struct goal){"lines 'rmax 0.4', times as long as the library for both fuels", "x", 15,
                            rmax / library_seconds(), false};
    goal[2] =
        (struct goal){"'count 112' from a cold start, times as long as bc", "x", 1.15, start / bc, false};
    goal[3] = (struct goal){"'curve 0.02 0.9 10000' on one core", "s", NONE, many.seconds, false};
    goal[4] = (struct goal){"  its peak memory", "MB", 10, many.megabytes, false};
    return 5;
}

/* ---- Questions for which people have to wait ---- */

/* The row of examples/record.dom, in the model with sharp and with rounded edges, and in the engine with feet
 * that slip. */
#define RECORD "effect row examples/record.csv; effect push 3; effect placement 5 mm; "
#define MODEL  "set threads 1; effect friction 0.3; place 8 0.75 m; "
#define EDGES  MODEL "effect edges 0.01; "
#define FEET   "effect feet 0.4; "

/* Eleven dominoes from 48 mm to 8 m. GAPS has errors of the gaps only, and KINDS has errors of four kinds. */
#define ELEVEN "set q hollow; effect friction 0.3; design 8 m; "
#define GAPS   ELEVEN "effect placement 6.4 mm; "
#define KINDS                                                                                                \
    "effect placement 3 mm; effect error_thickness 1 % uniform; effect error_friction 0.05; effect "         \
    "error_slope 0.3 "                                                                                       \
    "deg; "
#define COUNT "set output csv; set header off; placement 20000"

enum measure { WALL, LINKS, MEGABYTES };

static const struct wait {
    const char *text, *commands;
    enum measure measure;
    double goal;
} waits[] = {
    {"the verdict of 100,000 equal dominoes, memory",
     "set threads 1; set r 1; effect row 100000; effect push 6; verdict", MEGABYTES, 40},
    {"feet that slip: 'rowmax' of 12 dominoes", "effect row 12; " FEET "rowmax", WALL, 0.82},
    {"  'placement 100' of examples/record.csv", RECORD FEET "placement 100", WALL, 1},
    {"  'tolerance' of the same row", RECORD FEET "tolerance", WALL, 13.5},
    {"'tolerance' of 200 equal dominoes", "set r 1; effect row 200; effect push 6; tolerance", WALL, 0.28},
    {"  of 2,000", "set r 1; effect row 2000; effect push 6; tolerance", WALL, 10},
    {"'plan' of 200 equal dominoes", "set r 1; effect row 200; effect push 6; plan", WALL, NONE},
    {"'budget 0.95 300' of examples/record.dom", RECORD MODEL "budget 0.95 300", LINKS, 47},
    {"  with rounded edges", RECORD EDGES "budget 0.95 300", WALL, 0.53},
    {"'placement 10000' of the same row", RECORD MODEL "placement 10000", LINKS, 32},
    {"  with rounded edges and a slope", RECORD EDGES "effect slope 1 deg; placement 10000", WALL, 0.67},
    {"'best' in quad with friction", "set precision quad; effect friction 0.2; best", WALL, 3},
    {"'improve' of eleven dominoes for gaps off by 6.4 mm", GAPS "improve sizes", WALL, 60},
    {"'animate' of 20 dominoes as a gif", "effect row 20; animate > film.gif", WALL, 5},
};
enum { WAITS = sizeof waits / sizeof *waits };

/* Returns the first number of the last line that a shell command prints, after `skipped` commas. */
static double number_of(const char *command, int skipped)
{
    char line[1024];
    double number = NONE;
    FILE *answer = popen(command, "r");
    while (answer && fgets(line, sizeof line, answer)) {
        const char *cell = line;
        for (int k = 0; k < skipped && cell; k++)
            cell = strchr(cell, ',') ? strchr(cell, ',') + 1 : NULL;
        number = cell ? strtod(cell, NULL) : NONE;
    }
    return answer && pclose(answer) == 0 ? number : NONE;
}

/* Returns the percentage of 20,000 random rows that fail after these commands. */
static double failures(const char *domino, const char *commands)
{
    char line[2048];
    snprintf(line, sizeof line, "'%s' -n -e '%simprove sizes; " COUNT "'", domino, commands);
    return 100 * (1 - number_of(line, 4));
}

/* Returns the processor time of a clean build in s. */
static double make_seconds(const char *build)
{
    char command[4200];
    snprintf(command, sizeof command, "unset MAKEFLAGS; rm -rf '%s/clean'; exec make -s -j2 B='%s/clean'",
             build, build);
    const char *const argv[] = {"sh", "-c", command, NULL};
    return process_least(argv, 1).work;
}

static double text_megabytes(const char *build)
{
    char command[4200];
    snprintf(command, sizeof command, "rm -rf '%s/clean'; size '%s/domino' | awk 'NR == 2 { print $1 }'",
             build, build);
    return 1e-6 * number_of(command, 0);
}

size_t waits_measure(const char *build, struct goal *goal)
{
    static const char *const unit[] = {"s", "M links", "MB"};
    char domino[1000];
    const double link = bare_link();
    snprintf(domino, sizeof domino, "%s/domino", build);
    for (const struct wait *w = waits; w < waits + WAITS; w++, goal++) {
        const char *const argv[] = {domino, "-n", "-e", w->commands, NULL};
        const struct process p = process_least(argv, 3);
        const double measured[] = {p.seconds, 1e-6 * p.work / link, p.megabytes};
        *goal = (struct goal){
            .text = w->text, .unit = unit[w->measure], .goal = w->goal, .measured = measured[w->measure]};
    }
    remove("film.gif");
    const struct goal others[] = {
        {"rows of eleven dominoes that fail after 'improve'", "%", 5, failures(domino, GAPS), false},
        {"  with errors of four kinds", "%", 5.2, failures(domino, ELEVEN KINDS), false},
        {"a clean 'make', processor time", "s", 20, make_seconds(build), false},
        {"the program's text", "MB", 2, text_megabytes(build), false},
    };
    memcpy(goal, others, sizeof others);
    return WAITS + sizeof others / sizeof *others;
}
