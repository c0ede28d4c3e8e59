/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Prints the report of the benchmark: the programs that are compared, the times and errors of each question,
 * the lower bounds of the times, how times grow, and which goals are met.
 *
 * usage: bench BUILD, from the top of the project
 */
#include "bench.h"
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifndef BENCH_FLAGS
#define BENCH_FLAGS "unknown flags"
#endif

enum { MANY = 178, FEW = 18, POINTS = 10000, SAMPLED = 10, CURVE_REPEATS = 3, GOALS_MOST = WAITS_MOST + 24 };

#define WHO(name)   (1U << (name))
#define LEAST_GIVEN 1.5 /* all cores together must do at least this many times the work of one core */

/* ---- Goals ---- */

static void goals_print(const struct goal *goals, size_t n)
{
    puts("\nWhat people wait for. Figures 'at first' are older than the goals, and from another machine.");
    printf("  %-62s %9s %11s %9s\n", "", "at first", "goal", "now");
    for (const struct goal *g = goals; g < goals + n; g++) {
        const bool met = g->at_least ? g->measured >= g->goal : g->measured <= g->goal;
        printf("  %-62s", g->text);
        number_print(9, g->first < 10 ? 2 : 0, g->first);
        printf(isnan(g->goal) ? " %11s"
               : g->at_least  ? " %5s %5.4g"
                              : " %5s %5.4g",
               isnan(g->goal) ? "-"
               : g->at_least  ? ">="
                              : "<=",
               g->goal);
        number_print(9, g->measured < 10 ? 2 : 0, g->measured);
        printf(" %-7s %s\n", g->unit,
               isnan(g->measured) ? "not measured here"
               : isnan(g->goal)   ? ""
               : met              ? "met"
                                  : "NOT MET");
        if (g->reason && !isnan(g->measured) && !met)
            printf("      %s\n", g->reason);
    }
}

/* ---- The machine ---- */

static void machine_print(void)
{
    double load;
    char line[256], model[256] = "an unknown processor\n";
    FILE *info = fopen("/proc/cpuinfo", "r");
    while (info && fgets(line, sizeof line, info))
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':'))
            memcpy(model, strchr(line, ':') + 2, strlen(strchr(line, ':') + 2) + 1);
    if (info)
        fclose(info);
    printf("domino %s on %u cores of %s", DOM_VERSION, cores(), model);
    if (getloadavg(&load, 1) == 1)
        printf("load before this: %.1f%s\n", load, load > 0.5 ? "; other programs are using the cores" : "");
    printf("compiled by %s %s: %s\n",
#ifdef __clang__
           "clang",
#else
           "gcc",
#endif
           __VERSION__, BENCH_FLAGS);
    puts("Each time is the shortest of several, and all programs take turns in this one run. An error is\n"
         "the largest relative error of a table's questions, measured against our quad precision at 1e-18.\n"
         "Our tolerance is the target itself. The tolerance of another program is the largest power of 10\n"
         "with which it reaches the target.");
}

/* Prints the errors of our quad precision, compared with tables from other programs. All other errors are
 * measured against quad. */
static void truth_print(void)
{
    static const char path[] = "tests/reference/rmax.csv";
    FILE *table = fopen(path, "r");
    double s, q, d, r_max, worst = 0;
    char line[256], fuel[16];
    int rows = 0;
    while (table && fgets(line, sizeof line, table)) {
        struct question question = {.task = RMAX, .train = setup_default()};
        if (sscanf(line, "%lf,%lf,%lf,%15[^,],%lf", &s, &q, &d, fuel, &r_max) != 5)
            continue;
        question.train.s = s;
        question.train.q = q;
        question.train.d = d;
        question.train.fuel = strcmp(fuel, "paper") == 0 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        worst = fmax(worst, fabs((double)(ask_ours(&question, 1e-18, IN_QUAD, NULL) / r_max - 1)));
        rows++;
    }
    if (table)
        fclose(table);
    printf("Quad precision differs from the %d rows of %s, made in 40-digit arithmetic, by %.0e at most\n"
           "(they are read as doubles).\n",
           rows, path, worst);
}

/* ---- The questions ---- */

static size_t duration_questions(struct question *question)
{
    static const double separations[] = {0.1, 0.2, 0.3, 0.4, 0.5};
    size_t n = 0;
    for (int q = 3; q <= 4; q++)
        for (size_t i = 0; i < sizeof separations / sizeof *separations; i++, n++) {
            struct domq_limit limit = {.r_max = 1};
            struct setup train = setup_default();
            train.q = q;
            train.s = separations[i];
            ask_limit_rmax(&train, &limit);
            train.r = (double)(1 + (domq_real)0.8 * (limit.r_max - 1));
            question[n] = (struct question){.task = DURATION, .train = train};
        }
    return n;
}

static size_t row_questions(struct question *question)
{
    static const double growths[] = {1, 1.05, 1.1};
    size_t n = 0;
    for (; n < sizeof growths / sizeof *growths; n++) {
        struct setup train = setup_default();
        train.r = growths[n];
        question[n] = (struct question){.task = ROW, .train = train, .dominoes = 20, .push = 6};
    }
    return n;
}

/* Returns the output of the script `operations`, which is one line. */
static const char *operations(const char *build, char *line, int size)
{
    char command[4200];
    snprintf(command, sizeof command, "tests/bench/operations '%s'", build);
    FILE *pipe = popen(command, "r");
    bool there = pipe && fgets(line, size, pipe);
    if (pipe)
        pclose(pipe);
    line[there ? strcspn(line, "\n") : 0] = '\0';
    return there ? line : "not counted: valgrind or objdump is not installed";
}

/* ---- The curve, as a user of the program asks for it ---- */

static struct process curve_command(const char *domino, const char *threads)
{
    char text[128];
    struct process best = {.done = false, .seconds = INFINITY};
    snprintf(text, sizeof text, "set output csv; %scurve 0.02 0.9 %d", threads, POINTS);
    const char *const argv[] = {domino, "-n", "-e", text, NULL};
    for (int k = 0; k < CURVE_REPEATS; k++) {
        struct process now = process_run(argv, "");
        if (!now.done)
            return now;
        if (now.seconds < best.seconds)
            best = now;
    }
    return best;
}

/* Results of the curve that are compared with goals. Efficiencies are in percent of the speed-up that the
 * machine allows. */
struct curve_goals {
    double library, efficiency, command_efficiency, megabytes;
};

static struct curve_goals curve_print(const char *domino)
{
    const unsigned threads[] = {1, cores()};
    struct threaded at[2];
    struct process one = curve_command(domino, "set threads 1; "), all = {.done = false};
    threads_measure(POINTS, threads, at, 2);
    if (one.done)
        all = curve_command(domino, "set threads 0; ");
    else
        one = curve_command(domino, ""); /* a curve on one thread */
    struct curve_goals goals = {.library = at[0].seconds, .megabytes = fmax(one.megabytes, all.megabytes)};
    double command_all = all.done ? all.seconds : NONE;
    /* If other programs use the cores, there is no result. */
    double given = at[1].given > LEAST_GIVEN ? at[1].given : NONE;
    goals.efficiency = 100 * at[0].seconds / at[1].seconds / given;
    goals.command_efficiency = 100 * one.seconds / command_all / given;
    printf("\nThe curve of %d points, s from 0.02 to 0.9, massive, tol 1e-12, on one core and on all %u.\n"
           "In a loop of multiplications all cores do %.2f times the work of one: an efficiency of 100%%.\n",
           POINTS, threads[1], at[1].given);
    printf("  %-46s %12s %12s %12s\n", "", "one, ms", "all, ms", "efficiency");
    printf("  %-46s %12.1f %12.1f", "a loop over ask_limit_rmax", 1e3 * at[0].seconds, 1e3 * at[1].seconds);
    number_print(11, 0, goals.efficiency);
    puts(isnan(goals.efficiency) ? "" : "%");
    printf("  %-46s %12.1f", "domino -e 'set output csv; curve 0.02 0.9 ...'", 1e3 * one.seconds);
    number_print(12, 1, 1e3 * command_all);
    number_print(11, 0, goals.command_efficiency);
    printf("%s\n  (the command computes three curves: r_max with both fuels, and pairs; it takes %.1f MB)\n",
           isnan(goals.command_efficiency) ? "" : "%", goals.megabytes);
    return goals;
}

/* Returns the largest number of passes that r_max takes for separations from s - 0.01 to s + 0.01. */
static double passes_near(double s, double q)
{
    size_t most = 0;
    for (int k = -100; k <= 100; k++) {
        struct dom_work work = {.passes = 0};
        struct question question = {.task = RMAX, .train = setup_default()};
        question.train.s = s + 1e-4 * k;
        question.train.q = q;
        ask_ours(&question, 1e-12, IN_DOUBLE, &work);
        most = work.passes > most ? work.passes : most;
    }
    return (double)most;
}

/* Returns the time of a contender divided by ours, or NaN if the contender was not measured. */
static double ratio(const struct result *result, enum contender contender)
{
    return result[contender].compared ? result[contender].seconds / result[OURS].seconds : NONE;
}

/* Returns a pseudo-random number between lo and hi, evenly distributed in its logarithm. */
static double between(uint64_t *state, double lo, double hi)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return lo * pow(hi / lo, (double)(*state >> 11) * 0x1p-53);
}

/* Returns the mean time in seconds of the best separation of 400 random thicknesses and exponents. */
static double best_seconds(void)
{
    uint64_t state = 400;
    const double begun = seconds_now();
    for (int k = 0; k < 400; k++) {
        struct setup train = setup_default();
        struct domq_best best;
        train.d = between(&state, 1e-4, 0.6);
        train.q = 0.3 + log(between(&state, 1, exp(5.7)));
        ask_limit_best(&train, &best);
    }
    return (seconds_now() - begun) / 400;
}

/* Returns the mean time in seconds of r_max of 30,000 random trains. */
static double wide_seconds(void)
{
    uint64_t state = 30000;
    const double begun = seconds_now();
    for (int k = 0; k < 30000; k++) {
        struct setup train = setup_default();
        struct domq_limit limit;
        train.s = between(&state, 1e-4, 1);
        train.d = between(&state, 2e-6, 2);
        train.q = 0.3 + log(between(&state, 1, exp(6)));
        ask_limit_rmax(&train, &limit);
    }
    return (seconds_now() - begun) / 30000;
}

int main(int argc, char **argv)
{
    static struct question many[MANY], few[FEW], points[SAMPLED], cycles[16], rows[8];
    struct result all[CONTENDERS], fine[CONTENDERS], coarse[CONTENDERS], cycle[CONTENDERS], other[CONTENDERS];
    char domino[4096], line[256];
    const char *build = argc > 1 ? argv[1] : ".build";
    snprintf(domino, sizeof domino, "%s/domino", build);
    signal(SIGPIPE, SIG_IGN);
    setvbuf(stdout, NULL, _IOLBF, 0);
    double begun = seconds_now();

    machine_print();
    truth_print();
    contenders_start();
    rmax_questions(many, MANY, 0.02, 0.9);
    rmax_questions(few, FEW, 0.02, 0.9);
    rmax_questions(points, SAMPLED, 0.02, 0.9);
    for (size_t i = 0; i < SAMPLED; i++) { /* only solid dominoes, at the middles of ten equal intervals */
        points[i].train.q = 4;
        points[i].train.s = 0.02 + 0.88 * ((double)i + 0.5) / SAMPLED;
    }

    compare("r_max to 1e-12, mean of 178: s = 0.02, 0.03 ... 0.9, hollow and massive", many, MANY, 1e-12,
            WHO(OURS) | WHO(GSL), 1, all);
    compare("r_max to 1e-12, mean of 18: s = 0.02, 0.13 ... 0.9, hollow and massive", few, FEW, 1e-12,
            WHO(OURS) | WHO(GSL) | WHO(SCIPY), 1, fine);
    compare("r_max to 1e-6, the same 18", few, FEW, 1e-6, WHO(OURS) | WHO(GSL) | WHO(PAPER) | WHO(SCIPY), 1,
            coarse);
    compare("One whole cycle, its duration to 1e-12, mean of 10: s = 0.1 ... 0.5, both q, 0.8 of the way to "
            "r_max",
            cycles, duration_questions(cycles), 1e-12, WHO(OURS) | WHO(GSL) | WHO(SCIPY), 1, cycle);
    compare("The same to 1e-6", cycles, duration_questions(cycles), 1e-6,
            WHO(OURS) | WHO(GSL) | WHO(PAPER) | WHO(SCIPY), 1, other);
    compare("A finite row: when the last of 20 dominoes lies, to 1e-10, mean of 3: r = 1, 1.05, 1.1", rows,
            row_questions(rows), 1e-10, WHO(OURS) | WHO(NEWTON) | WHO(SCIPY), 1, other);
    compare("The curve of 10,000 points to 1e-12, by 10 of them", points, SAMPLED, 1e-12,
            WHO(OURS) | WHO(GSL) | WHO(SCIPY), POINTS, other);
    struct curve_goals curve = curve_print(domino);
    struct goal goals[GOALS_MOST] = {{0}};
    size_t n = waits_measure(build, goals);
    struct rows_goals row = rows_print();
    double start = start_print(domino);
    struct lines_goals lines = lines_print(build, domino);
    floor_print("r_max", many, MANY, all[OURS].seconds, operations(build, line, sizeof line));
    floor_print("one cycle's duration", cycles, duration_questions(cycles), cycle[OURS].seconds, NULL);
    shares_print(build);
    front_print();
    growth_print(build);
    double length = lengths_print();
    const double link = 1e-9 * recurrence_measure().one;
    struct question close = many[0], usual = many[0], rounded;
    close.train.q = usual.train.q = 4;
    usual.train.s = (domq_real)4 / 10;
    rounded = usual;
    rounded.train.rho = (domq_real)1 / 100;
    double in_double = contender_seconds(OURS, &usual, 1e-12);
    double with_edges = contender_seconds(OURS, &rounded, 1e-12);
    floor_print_edges(&usual, in_double, &rounded, with_edges);
    usual.train.precision = IN_QUAD;
    double in_quad = contender_seconds(OURS, &usual, (double)any_arithmetic(IN_QUAD).tol_default);
    contenders_end();

    static const char of_rmax[] =
        "no lower bound rules this goal out. By 'The lower bound of r_max' above, there are nearly as few "
        "passes as in a search that knows the root, but a domino takes six times as long as its bare "
        "recurrence";
    const struct goal own[] = {
        {"best of 400 random (d, q)", "ms", 51, 4, 1e3 * best_seconds(), false, NULL},
        {"30,000 trains, s 1e-4 to 1", "us", 68, 68, 1e6 * wide_seconds(), false, NULL},
        {"r_max at 1e-12, mean of 178 questions", "links", 561, 420, all[OURS].seconds / link, false,
         of_rmax},
        {"  times as fast as nested GSL solvers", "x", NONE, 15, ratio(all, GSL), true, of_rmax},
        {"  times as fast as the paper's recipe, at 1e-6", "x", NONE, 1000, ratio(coarse, PAPER), true,
         of_rmax},
        {"  times as fast as SciPy, at 1e-12", "x", NONE, 1500, ratio(fine, SCIPY), true, of_rmax},
        {"r_max at s = 0.02", "links", NONE, 2500, contender_seconds(OURS, &close, 1e-12) / link, false,
         of_rmax},
        {"r_max of hollow dominoes near s = 0.54", "passes", 280, 60, passes_near(0.54, 3), false, NULL},
        {"  of solid ones near s = 0.62", "passes", 221, 60, passes_near(0.62, 4), false, NULL},
        {"  with rounded edges, times as long as with sharp ones", "x", 4.4, 2, with_edges / in_double, false,
         "no lower bound rules this goal out. By 'The cost of rounded edges' above, both searches visit "
         "as many dominoes, but a bare link takes three times as long"},
        {"  in quad, times as long as in double", "x", 64, 50, in_quad / in_double, false,
         "quad has no instructions of its own: each operation is a function of the compiler"},
        {"one cycle's duration to 1e-12", "links", 1761, 1300, cycle[OURS].seconds / link, false,
         "no lower bound rules this goal out. By its lower bound above, the operations of dominoes take "
         "the time"},
        {"verdict of a random row of 20, r = 1.3", "links", NONE, 6000, row.plain / link, false, NULL},
        {"  with friction 0.2", "links", NONE, 15000, row.friction / link, false, NULL},
        {"a row of 10,000 equal dominoes", "s", NONE, 1.5, length, false, NULL},
        {"a curve of 10,000 points on one core, by the library", "ms", 61, 45, 1e3 * curve.library, false,
         of_rmax},
        {"  its efficiency on all cores (100 %: all the machine allows)", "%", NONE, 80, curve.efficiency,
         true, NULL},
        {"  efficiency of the command 'curve' (three curves)", "%", NONE, 80, curve.command_efficiency, true,
         NULL},
        {"  peak memory of this command", "MB", NONE, 10, curve.megabytes, false, NULL},
        {"100,000 lines 'print 2+2', times as long as '2+2' in bc", "x", 0.70, 1, lines.print, false,
         "no lower bound rules this goal out. A line takes half a microsecond, in a hundred functions of "
         "which none takes more than 6 % of it"},
        {"lines 'rmax 0.4', times as long as the library for both fuels", "x", NONE, 1.5, lines.rmax, false,
         "no lower bound is known. The command also finds the growth up to which a row of 24 dominoes "
         "starts"},
        {"domino -e 'theta1 0.2', times as long as bc", "x", 0.93, 1, start, false,
         "two thirds of the instructions are the dynamic linker's and the C library's: "
         "tests/bench/instructions.csv"},
    };
    memcpy(goals + n, own, sizeof own);
    goals_print(goals, n + sizeof own / sizeof *own);
    printf("\n%.0f s in all\n", seconds_now() - begun);
    return EXIT_SUCCESS;
}
