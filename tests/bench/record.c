/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures large questions about rows as a user asks them: each is a process of the program on one core. */
#include "bench.h"

enum { RUNS = 3 };

/* The commands with which examples/record.dom sets up its row before it asks for a budget. */
#define RECORD                                                                                               \
    "set threads 1; effect row examples/record.csv; effect push 3; effect friction 0.3; place 8 0.75 m; "    \
    "effect placement 5 mm; "

/* Runs the commands several times, and returns the fastest run. */
static struct process least(const char *domino, const char *commands)
{
    const char *const argv[] = {domino, "-n", "-e", commands, NULL};
    struct process best = {.work = NONE, .megabytes = NONE};
    for (int k = 0; k < RUNS; k++) {
        struct process now = process_run(argv, "");
        if (now.done && !(best.work <= now.work))
            best = now;
    }
    return best;
}

struct record_goals record_print(const char *domino)
{
    static const struct {
        const char *name, *commands;
    } asked[] = {
        {"'budget 0.95 300' of examples/record.dom", RECORD "budget 0.95 300"},
        {"'placement 10000' of the same row", RECORD "placement 10000"},
        {"the verdict of 100,000 equal dominoes", "set r 1; effect row 100000; effect push 6; verdict"}};
    struct process of[3];
    printf("\nLarge questions about rows, whole processes on one core\n  %-50s %10s %10s\n", "", "CPU, ms",
           "MB");
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
        of[i] = least(domino, asked[i].commands);
        printf("  %-50s", asked[i].name);
        number_print(10, 1, 1e3 * of[i].work);
        number_print(10, 1, of[i].megabytes);
        putchar('\n');
    }
    fflush(stdout);
    return (struct record_goals){of[0].work, of[1].work, of[2].megabytes};
}
