/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Start-up to the first answer: domino and bc in turn, whole processes, minimum and median of many runs.
 * usage: bench_start DOMINO
 */
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { RUNS = 200 };

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Time of one run, its input from a string, its output thrown away; negative if it fails. */
static double run(char **argv, const char *input)
{
    extern char **environ;
    posix_spawn_file_actions_t actions;
    int ends[2], status;
    pid_t child;
    if (pipe(ends) != 0 || dprintf(ends[1], "%s", input) < 0)
        return -1;
    close(ends[1]);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    double begun = seconds();
    int failed = posix_spawnp(&child, argv[0], &actions, NULL, argv, environ);
    if (failed == 0)
        waitpid(child, &status, 0);
    double took = seconds() - begun;
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    return failed || status != 0 ? -1 : took;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int argc, char **argv)
{
    static double ours[RUNS], theirs[RUNS];
    char *domino[] = {argc > 1 ? argv[1] : "domino", "-e", "count 112", NULL}, *bc[] = {"bc", "-l", NULL};
    int have_bc = run(bc, "l(112/0.048)/l(1.5)\n") >= 0;
    if (run(domino, "") < 0) {
        fprintf(stderr, "bench_start: %s does not run\n", domino[0]);
        return EXIT_FAILURE;
    }
    for (int i = 0; i < RUNS; i++) {
        ours[i] = run(domino, "");
        theirs[i] = have_bc ? run(bc, "l(112/0.048)/l(1.5)\n") : 0;
    }
    qsort(ours, RUNS, sizeof *ours, ascending);
    qsort(theirs, RUNS, sizeof *theirs, ascending);
    printf("start-up to first answer, %d runs in turn      minimum   median\n", RUNS);
    printf("  domino -e 'count 112'                       %7.3f  %7.3f ms\n", 1e3 * ours[0],
           1e3 * ours[RUNS / 2]);
    if (!have_bc) {
        puts("  bc is not installed: no comparison");
        return EXIT_SUCCESS;
    }
    printf("  echo 'l(112/0.048)/l(1.5)' | bc -l          %7.3f  %7.3f ms\n", 1e3 * theirs[0],
           1e3 * theirs[RUNS / 2]);
    printf("  domino / bc                                 %7.2f  %7.2f\n", ours[0] / theirs[0],
           ours[RUNS / 2] / theirs[RUNS / 2]);
    return EXIT_SUCCESS;
}
