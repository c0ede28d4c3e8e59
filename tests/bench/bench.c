/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Prints how long the main questions take in one run, beside their goals. Many goals are ratios between times
 * of this run: to the time of another program, or of the bare step from a domino to the next. The shortest of
 * several times counts, so that other work of the machine matters little. The command 'cost' compares the
 * methods at every tolerance, and 'make guard' counts instructions, which are less noisy.
 *
 * usage: bench BUILD, from the top of the project
 */
#include "../unit/ask.h"
#include <fcntl.h>
#include <math.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>

extern char **environ;

#define NONE     ((double)NAN) /* a value that does not exist */
#define PATIENCE 0.5           /* seconds that the repetitions of one measurement may take */
#define SLOW     5             /* a process that takes longer than this many seconds runs only once */

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Prints a line of the table. The goal may be NONE. */
static void goal_print(const char *text, const char *unit, double goal, double measured)
{
    printf("  %-62s ", text);
    printf(isnan(goal) ? "          -" : "   <= %5.4g", goal);
    printf(" %9.*f %-7s %s\n", measured < 10 ? 2 : 0, measured, unit,
           isnan(measured)    ? "not measured here"
           : isnan(goal)      ? ""
           : measured <= goal ? "met"
                              : "NOT MET");
    fflush(stdout);
}

/* Returns the time of a link of a train that does nothing but follow (12; b8) and (31; A6), in seconds. Each
 * link waits for the one before, so no pass along a train is faster. */
static double bare_link(void)
{
    enum { DOMINOES = 64, TRAINS = 1000, ROUNDS = 140 };
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

/* ---- The library ---- */

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

static bool ask_duration(const struct setup *train)
{
    domq_real duration;
    return ask_cycle_duration(train, &duration) == DOM_OK;
}

/* Returns the shortest of several mean times of n questions, or NONE if one of them has no answer. */
static double mean_seconds(question *ask, const struct setup *train, size_t n)
{
    double least = INFINITY, spent = 0;
    for (int k = 0; k == 0 || (k < 2000 && spent < PATIENCE); k++) {
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

static void library_measure(double link)
{
    enum { MANY = 178, CYCLES = 10 };
    static struct setup many[MANY], cycles[CYCLES];
    for (int i = 0; i < MANY; i++) { /* s from 0.02 to 0.9, first hollow and then solid */
        many[i] = setup_default();
        many[i].q = i < MANY / 2 ? 3 : 4;
        many[i].s = 0.02 + 0.88 * (i % (MANY / 2)) / (MANY / 2 - 1.0);
    }
    for (int i = 0; i < CYCLES; i++) { /* both kinds, with a growth that is 0.8 of the way to r_max */
        struct domq_limit limit = {.r_max = 1};
        cycles[i] = setup_default();
        cycles[i].q = i % 2 ? 3 : 4;
        cycles[i].s = (domq_real)(1 + i / 2) / 10;
        ask_limit_rmax(&cycles[i], &limit);
        cycles[i].r = (double)(1 + (domq_real)0.8 * (limit.r_max - 1));
    }
    goal_print("r_max at 1e-12, mean of 178: s = 0.02 ... 0.9, both q", "links", 420,
               mean_seconds(ask_rmax, many, MANY) / link);
    goal_print("one cycle's duration to 1e-12", "links", 1300,
               mean_seconds(ask_duration, cycles, CYCLES) / link);
    goal_print("best of 400 random (d, q)", "ms", 4, 1e3 * random_seconds(ask_best, 400, 1e-4, 0.6, 5.7));
    goal_print("30,000 trains, s 1e-4 to 1", "us", 68, 1e6 * random_seconds(ask_rmax, 30000, 2e-6, 2, 6));
    static const struct {
        const char *text;
        double s, d, rho;
        enum precision precision;
    } trains[] = {{"r_max at s = 0.02", 0.02, 7 / 48., 0, IN_DOUBLE},
                  {"  with rounded edges, at s = 0.4", 0.4, 7 / 48., 0.01, IN_DOUBLE},
                  {"  in quad, at s = 0.4", 0.4, 7 / 48., 0, IN_QUAD},
                  {"  of thin dominoes, d = 0.005, at s = 1e-6", 1e-6, 0.005, 0, IN_DOUBLE},
                  {"  at s = 1e-4, in quad", 1e-4, 0.005, 0, IN_QUAD}};
    for (size_t i = 0; i < sizeof trains / sizeof *trains; i++) {
        struct setup train = setup_default();
        train.s = trains[i].s;
        train.d = trains[i].d;
        train.rho = trains[i].rho;
        train.precision = trains[i].precision;
        train.tol = any_arithmetic(train.precision).tol_default;
        goal_print(trains[i].text, "links", NONE, mean_seconds(ask_rmax, &train, 1) / link);
    }
}

/* ---- Processes ---- */

struct process {
    double seconds;
    double work;      /* processor time in s */
    double megabytes; /* the largest memory of the process */
};

/* Runs a shell command without input, whose output is discarded, several times. Returns the run with the
 * least processor time, or NONE if every run failed. */
static struct process process_least(const char *command, int runs)
{
    const char *const argv[] = {"sh", "-c", command, NULL};
    struct process best = {.seconds = NONE, .work = NONE, .megabytes = NONE};
    for (int k = 0; k < runs && !(best.seconds > SLOW); k++) {
        struct rusage used;
        posix_spawn_file_actions_t actions;
        pid_t child;
        int status = -1;
        posix_spawn_file_actions_init(&actions);
        for (int file = 0; file <= 2; file++)
            posix_spawn_file_actions_addopen(&actions, file, "/dev/null", file ? O_WRONLY : O_RDONLY, 0);
        const double begun = seconds_now();
        if (posix_spawnp(&child, argv[0], &actions, NULL, (char *const *)(size_t)argv, environ) == 0 &&
            wait4(child, &status, 0, &used) == child && status == 0) {
            const struct process now = {seconds_now() - begun,
                                        (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                                            1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec),
                                        (double)used.ru_maxrss / 1024};
            best = best.work <= now.work ? best : now;
        }
        posix_spawn_file_actions_destroy(&actions);
    }
    return best;
}

/* Returns the processor time of a program that reads a line many times. */
static double lines_seconds(const char *program, const char *line, int count)
{
    char command[4200];
    snprintf(command, sizeof command, "yes '%s' | head -n %d | %s", line, count, program);
    return process_least(command, 5).work;
}

/* Returns the processor time that the library takes to find r_max with both fuels. */
static double both_fuels_seconds(void)
{
    struct setup both[2] = {setup_default(), setup_default()};
    both[1].fuel = DOM_FUEL_PAPER;
    return 2 * mean_seconds(ask_rmax, both, 2);
}

static void lines_measure(const char *program)
{
    enum { MANY = 100000, SOME = 10000, STARTS = 200 };
    char count[1200];
    snprintf(count, sizeof count, "exec %s -e 'count 112'", program);
    goal_print("100,000 lines 'print 2+2', times as long as '2+2' in bc", "x", 1,
               lines_seconds(program, "print 2+2", MANY) / lines_seconds("bc", "2+2", MANY));
    goal_print("lines 'rmax 0.4', times as long as the library for both fuels", "x", 15,
               lines_seconds(program, "rmax 0.4", SOME) / SOME / both_fuels_seconds());
    goal_print("'count 112' from a cold start, times as long as bc", "x", 1.15,
               process_least(count, STARTS).seconds /
                   process_least("echo 'l(112/0.048)/l(1.5)' | exec bc -l", STARTS).seconds);
}

/* ---- Questions for which people have to wait. Each starts the program anew, as it does for a user. ---- */

/* The row of examples/record.dom, in the model with sharp and with rounded edges, and in the engine with feet
 * that slip. */
#define RECORD "set row examples/record.csv; set push 3; set placement 5 mm; "
#define MODEL  "set threads 1; set friction 0.3; place 8 0.75 m; "
#define EDGES  MODEL "set edges 0.01; "
#define FEET   "set feet 0.4; "

/* Eleven dominoes from 48 mm to 8 m. GAPS has errors of the gaps only, and KINDS has errors of four kinds. */
#define ELEVEN "set q hollow; set friction 0.3; design 8 m; "
#define GAPS   ELEVEN "set placement 6.4 mm; "
#define KINDS                                                                                                \
    ELEVEN "set placement 3 mm; set error_thickness 1 % uniform; set error_friction 0.05; "                  \
           "set error_slope 0.3 deg; "

enum measure { WALL, LINKS, MEGABYTES };

static const struct wait {
    const char *text, *commands;
    enum measure measure;
    double goal;
} waits[] = {
    {"a row of 10,000 equal dominoes, from the start", "set r 1; set row 10000; set push 6; verdict", WALL,
     0.05},
    {"the verdict of 100,000 equal dominoes, memory",
     "set threads 1; set r 1; set row 100000; set push 6; verdict", MEGABYTES, 40},
    {"'curve 0.02 0.9 10000' on one core, memory", "set threads 1; set output csv; curve 0.02 0.9 10000",
     MEGABYTES, 10},
    {"feet that slip: 'rowmax' of 12 dominoes", "set row 12; " FEET "rowmax", WALL, 0.82},
    {"  'placement 100' of examples/record.csv", RECORD FEET "placement 100", WALL, 1},
    {"  'tolerance' of the same row", RECORD FEET "tolerance", WALL, 13.5},
    {"'tolerance' of 2,000 equal dominoes", "set r 1; set row 2000; set push 6; tolerance", WALL, 10},
    {"'budget 0.95 300' of examples/record.dom", RECORD MODEL "budget 0.95 300", LINKS, 47},
    {"  with rounded edges", RECORD EDGES "budget 0.95 300", WALL, 0.53},
    {"'placement 10000' of the same row", RECORD MODEL "placement 10000", LINKS, 32},
    {"  with rounded edges and a slope", RECORD EDGES "set slope 1 deg; placement 10000", WALL, 0.67},
    {"'best' in quad with friction", "set precision quad; set friction 0.2; best", WALL, 3},
    {"'improve' of eleven dominoes for gaps off by 6.4 mm", GAPS "improve sizes", WALL, 60},
    {"'animate' of 20 dominoes as a gif", "set row 20; animate > film.gif", WALL, 5},
};

static void waits_measure(const char *program, double link)
{
    static const char *const unit[] = {"s", "M links", "MB"};
    for (const struct wait *w = waits; w < waits + sizeof waits / sizeof *waits; w++) {
        char command[4200];
        snprintf(command, sizeof command, "exec %s -e '%s'", program, w->commands);
        const struct process p = process_least(command, 3);
        const double measured[] = {p.seconds, 1e-6 * p.work / link, p.megabytes};
        goal_print(w->text, unit[w->measure], w->goal, measured[w->measure]);
    }
    remove("film.gif");
}

/* Returns the percentage of 20,000 random rows that fail after these commands. */
static double failures(const char *program, const char *commands)
{
    char command[4200];
    double falls = NONE;
    snprintf(command, sizeof command,
             "%s -e '%simprove sizes; set output json; placement 20000' | "
             "sed -n 's/.*\"probability\":\\([0-9.]*\\).*/\\1/p'",
             program, commands);
    FILE *answer = popen(command, "r");
    if (!answer || fscanf(answer, "%lf", &falls) != 1 || pclose(answer) != 0)
        return NONE;
    return 100 * (1 - falls);
}

int main(int argc, char **argv)
{
    const char *build = argc > 1 ? argv[1] : ".build";
    char program[1000], clean[4200];
    const double begun = seconds_now(), link = bare_link();
    snprintf(program, sizeof program, "'%s/domino' -n", build);
    snprintf(clean, sizeof clean, "unset MAKEFLAGS; rm -rf '%s/clean'; exec make -s -j2 B='%s/clean'", build,
             build);
    printf("  %-62s %11s %9s\n", "", "goal", "now");
    /* The system counts the memory of the benchmark as memory of the processes that it starts, so these come
     * before the benchmark takes much memory. */
    waits_measure(program, link);
    goal_print("rows of eleven dominoes that fail after 'improve'", "%", 5, failures(program, GAPS));
    goal_print("  with errors of four kinds", "%", 5.2, failures(program, KINDS));
    goal_print("a clean 'make', processor time", "s", 20, process_least(clean, 1).work);
    lines_measure(program);
    library_measure(link);
    printf("\n%.0f s in all\n", seconds_now() - begun);
    return EXIT_SUCCESS;
}
