/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shows how time grows with the number of dominoes that matter and with the number of digits, and how it
 * decreases with the number of threads. */
#include "bench.h"
#include <stdlib.h>

#define LEAST_SECONDS 2e-3 /* the shortest time of a batch */

enum { REPEATS = 5 };

#define PEERS_TOL 1e-12 /* the finest tolerance that the other programs reach in double precision */

/* Returns the shortest time per answer, measured in batches that are long enough for the clock. Returns
 * NaN if there is no answer. */
static double time_of(const struct question *q, enum dom_method method, enum precision precision, double tol,
                      int repeats)
{
    struct question asked = *q;
    double least = INFINITY;
    asked.train.method = method;
    double begun = seconds_now();
    if (isnan((double)ask_ours(&asked, tol, precision, NULL)))
        return NAN;
    int batch = (int)(LEAST_SECONDS / (seconds_now() - begun)) + 1;
    for (int k = 0; k < repeats; k++) {
        begun = seconds_now();
        for (int i = 0; i < batch; i++)
            ask_ours(&asked, tol, precision, NULL);
        least = fmin(least, (seconds_now() - begun) / batch);
    }
    return least;
}

static double energy_seconds(double s, double r, struct dom_work *work)
{
    struct setup train = setup_default();
    struct domq_fuels fuels;
    double least = INFINITY;
    train.s = s;
    train.r = r;
    for (int k = 0; k < REPEATS; k++) {
        int batch = 1 + (int)(LEAST_SECONDS / 1e-8 / (1 + (double)work->longest)) / 10;
        double begun = seconds_now();
        for (int i = 0; i < batch; i++)
            if (ask_fuel_find(&train, &fuels) != DOM_OK)
                return NAN;
        least = fmin(least, (seconds_now() - begun) / batch);
        *work = (struct dom_work){.passes = 0};
        train.work = work;
        if (ask_fuel_find(&train, &fuels) != DOM_OK)
            return NAN;
        train.work = NULL;
    }
    return least;
}

/* The other programs in these tables, and the smallest separation at which they are measured. At smaller
 * separations they would take seconds. */
static const enum contender peers[] = {GSL, SCIPY};
#define PEERS_FROM 0.02

/* ---- The three tables, each of which also writes its numbers for the picture ---- */

static void with_dominoes(FILE *data)
{
    static const double separations[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.2, 0.4, 0.9};
    puts("\nTime against the dominoes that matter, tol 1e-12");
    puts("  a pass is measured as the fuel of equal dominoes; thin dominoes have d = 0.005, thick ones 7/48");
    printf("  %-8s %10s %12s %10s %16s %16s %10s %10s\n", "s", "dominoes", "a pass, us", "ns each",
           "r_max thick, us", "r_max thin, us", "GSL", "SciPy");
    for (size_t i = 0; i < sizeof separations / sizeof *separations; i++) {
        double s = separations[i], us[2];
        struct dom_work work = {.longest = 0}, of_thin = {.longest = 0};
        double seconds = energy_seconds(s, 1, &work);
        for (int thin = 0; thin < 2; thin++) {
            struct question q = {.task = RMAX, .train = setup_default()};
            q.train.s = s;
            if (thin) {
                q.train.d = 0.005;
                ask_ours(&q, 1e-12, IN_DOUBLE, &of_thin);
            }
            us[thin] = 1e6 * time_of(&q, DOM_METHOD_OURS, IN_DOUBLE, 1e-12, s < 1e-3 ? 1 : REPEATS);
        }
        printf("  %-8.3g %10zu %12.2f %10.2f", s, work.longest, 1e6 * seconds,
               1e9 * seconds / (double)work.longest);
        number_print(16, 1, us[0]);
        number_print(16, 1, us[1]);
        struct question thick = {.task = RMAX, .train = setup_default()};
        thick.train.s = s;
        for (size_t k = 0; k < sizeof peers / sizeof *peers; k++)
            number_print(10, 0, s >= PEERS_FROM ? 1e6 * contender_seconds(peers[k], &thick, 1e-12) : NONE);
        putchar('\n');
        fflush(stdout);
        fprintf(data, "%g %zu %g %zu %g\n", s, work.longest, 1e6 * seconds, of_thin.longest, us[1]);
    }
    fputs("\n\n", data);
}

static void with_digits(FILE *data)
{
    static const double tolerances[] = {1e-3,  1e-6,  1e-9,  1e-12, 1e-15, 1e-18,
                                        1e-21, 1e-24, 1e-27, 1e-30, 1e-33};
    struct question q = {.task = RMAX, .train = setup_default()};
    puts("\nTime against digits: r_max at s = 0.4, massive, us; '-': no such arithmetic, or too slow to wait "
         "for");
    printf("  %-8s %12s %12s %12s %12s %14s %10s\n", "tol", "float", "double", "quad", "GSL, nested",
           "paper's recipe", "SciPy");
    for (size_t i = 0; i < sizeof tolerances / sizeof *tolerances; i++) {
        static const struct {
            enum dom_method method;
            enum precision precision;
            double finest;
        } column[] = {{DOM_METHOD_OURS, IN_FLOAT, 0},
                      {DOM_METHOD_OURS, IN_DOUBLE, 0},
                      {DOM_METHOD_OURS, IN_QUAD, 0},
                      {DOM_METHOD_GSL, IN_DOUBLE, 0},
                      {DOM_METHOD_PAPER, IN_DOUBLE, 1e-6}};
        printf("  %-8.0e", tolerances[i]);
        fprintf(data, "%g", tolerances[i]);
        for (size_t k = 0; k < sizeof column / sizeof *column; k++) {
            double us = NAN;
            if (tolerances[i] >= column[k].finest)
                us = 1e6 * time_of(&q, column[k].method, column[k].precision, tolerances[i], REPEATS);
            number_print(k + 1 < sizeof column / sizeof *column ? 12 : 14, 1, us);
            fprintf(data, " %g", us);
        }
        for (size_t k = 1; k < sizeof peers / sizeof *peers; k++)
            number_print(10, 0,
                         tolerances[i] >= PEERS_TOL ? 1e6 * contender_seconds(peers[k], &q, tolerances[i])
                                                    : NONE);
        putchar('\n');
        fflush(stdout);
        fputc('\n', data);
    }
    fputs("\n\n", data);
}

static void with_threads(FILE *data)
{
    enum { POINTS = 10000, MOST = 64 };
    unsigned most = cores(), count[MOST], n = 0;
    struct threaded at[MOST];
    for (unsigned threads = 1; threads < most && n < MOST - 1; threads *= 2)
        count[n++] = threads;
    count[n++] = most;
    threads_measure(POINTS, count, at, n);
    printf(
        "\nThreads: how many times as fast the curve of %d points is, and the most that the machine allows\n",
        POINTS);
    printf("  %-8s %12s %12s %12s %12s\n", "threads", "ms", "times", "at best", "efficiency");
    for (unsigned i = 0; i < n; i++) {
        double times = at[0].seconds / at[i].seconds;
        printf("  %-8u %12.2f %12.2f %12.2f %11.0f%%\n", count[i], 1e3 * at[i].seconds, times, at[i].given,
               100 * times / at[i].given);
        fprintf(data, "%u %g %g\n", count[i], times, at[i].given);
    }
}

/* ---- The picture ---- */

static const char script[] =
    "set terminal svg size 1400,420 font 'Helvetica,13' background 'white'\n"
    "set output '%s/bench.svg'\n"
    "set datafile missing 'nan'\n"
    "set multiplot layout 1,3 title 'domino: what an answer costs'\n"
    "set grid lc '#dddddd'; set key top left; unset mxtics; set format '10^{%%L}'; set logscale xy\n"
    "set xlabel 'dominoes of the longest pass (s = 10^{-6} ... 0.9)'; set ylabel 'us'\n"
    "plot '%s/bench.dat' index 0 using 2:3 with linespoints lw 2 pt 7 ps 0.6 title 'one pass', \\\n"
    "     '' index 0 using 4:5 with linespoints lw 2 pt 7 ps 0.6 title 'r_{max}, thin dominoes'\n"
    "set xlabel 'relative tolerance'; set ylabel 'us, r_{max} at s = 0.4'\n"
    "set xrange [1e-1:1e-34]; set yrange [*:1e6]; set key top right\n"
    "plot '' index 1 using 1:6 with linespoints lw 2 pt 7 ps 0.6 title \"paper's recipe\", \\\n"
    "     '' index 1 using 1:5 with linespoints lw 2 pt 7 ps 0.6 title 'GSL, nested', \\\n"
    "     '' index 1 using 1:4 with linespoints lw 2 pt 7 ps 0.6 title 'ours, quad', \\\n"
    "     '' index 1 using 1:3 with linespoints lw 2 pt 7 ps 0.6 title 'ours, double', \\\n"
    "     '' index 1 using 1:2 with linespoints lw 2 pt 7 ps 0.6 title 'ours, float'\n"
    "unset logscale; set format '%%g'; set xrange [0.5:*]; set yrange [0:*]; set xtics 1\n"
    "if (GPVAL_DATA_X_MAX > 16) set xtics autofreq\n"
    "set key bottom right; set xlabel 'threads'; set ylabel 'times as fast, 10,000 points'\n"
    "plot '' index 2 using 1:2 with linespoints lw 2 pt 7 ps 0.6 title 'measured', \\\n"
    "     '' index 2 using 1:3 with lines dt 2 lc '#888888' title 'what the machine allows'\n"
    "unset multiplot\n";

void growth_print(const char *build)
{
    char path[4096], text[sizeof script + 2 * sizeof path];
    const char *const gnuplot[] = {"gnuplot", "-", NULL};
    snprintf(path, sizeof path, "%s/bench.dat", build);
    FILE *data = fopen(path, "w");
    if (!data) {
        perror(path);
        return;
    }
    with_dominoes(data);
    fflush(stdout);
    with_digits(data);
    fflush(stdout);
    with_threads(data);
    fclose(data);
    snprintf(text, sizeof text, script, build, build);
    if (process_run(gnuplot, text).done)
        printf("\nThese three tables as a picture: %s/bench.svg\n", build);
    else
        puts("\ngnuplot is not installed: no picture");
    fflush(stdout);
}
