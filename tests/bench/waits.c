/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures questions for which people have to wait. Each question starts the program anew, as it does for a
 * user. */
#include "bench.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS = 3 };

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
    double first, goal;
} waits[] = {
    {"the verdict of 100,000 equal dominoes, memory",
     "set threads 1; set r 1; effect row 100000; effect push 6; verdict", MEGABYTES, NONE, 40},
    {"feet that slip: 'rowmax' of 12 dominoes", "effect row 12; " FEET "rowmax", WALL, 4.1, 0.82},
    {"  'placement 100' of examples/record.csv", RECORD FEET "placement 100", WALL, 5, 1},
    {"  'tolerance' of the same row", RECORD FEET "tolerance", WALL, 108, 13.5},
    {"'tolerance' of 200 equal dominoes", "set r 1; effect row 200; effect push 6; tolerance", WALL, 2.8,
     0.28},
    {"  of 2,000", "set r 1; effect row 2000; effect push 6; tolerance", WALL, NONE, 10},
    {"'plan' of 200 equal dominoes", "set r 1; effect row 200; effect push 6; plan", WALL, NONE, NONE},
    {"'budget 0.95 300' of examples/record.dom", RECORD MODEL "budget 0.95 300", LINKS, 188, 47},
    {"  with rounded edges", RECORD EDGES "budget 0.95 300", WALL, 2.1, 0.53},
    {"'placement 10000' of the same row", RECORD MODEL "placement 10000", LINKS, 131, 32},
    {"  with rounded edges and a slope", RECORD EDGES "effect slope 1 deg; placement 10000", WALL, 2, 0.67},
    {"'best' in quad with friction", "set precision quad; effect friction 0.2; best", WALL, 20, 3},
    {"'improve' of eleven dominoes for gaps off by 6.4 mm", GAPS "improve sizes", WALL, NONE, 60},
    {"'animate' of 20 dominoes as a gif", "effect row 20; animate > film.gif", WALL, 16.7, 5},
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
        const struct process p = process_least(argv, RUNS);
        const double measured[] = {p.seconds, 1e-6 * p.work / link, p.megabytes};
        *goal = (struct goal){.text = w->text,
                              .unit = unit[w->measure],
                              .first = w->first,
                              .goal = w->goal,
                              .measured = measured[w->measure]};
    }
    remove("film.gif");
    const struct goal others[] = {
        {"rows of eleven dominoes that fail after 'improve'", "%", 29.1, 5, failures(domino, GAPS), false},
        {"  with errors of four kinds", "%", 8.6, 5.2, failures(domino, ELEVEN KINDS), false},
        {"a clean 'make', processor time", "s", 62, 20, make_seconds(build), false},
        {"the program's text", "MB", 3, 2, text_megabytes(build), false},
    };
    memcpy(goal, others, sizeof others);
    return WAITS + sizeof others / sizeof *others;
}
