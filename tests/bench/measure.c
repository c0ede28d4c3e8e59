/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* pipe2 */
#include "bench.h"
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

unsigned cores(void)
{
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n > 1 ? (unsigned)n : 1;
}

void number_print(int width, int digits, double value)
{
    if (isnan(value))
        printf(" %*s", width, "-");
    else
        printf(" %*.*f", width, digits, value);
}

/* Starts a program with its input and output connected to these files. Returns 0 if the program cannot be
 * started. */
static pid_t start(const char *const *argv, int in, int out)
{
    posix_spawn_file_actions_t actions;
    pid_t child;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in, 0);
    if (out >= 0)
        posix_spawn_file_actions_adddup2(&actions, out, 1);
    else
        posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    int failed = posix_spawnp(&child, argv[0], &actions, NULL, (char *const *)(size_t)argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed ? 0 : child;
}

struct process process_run(const char *const *argv, const char *input)
{
    struct process process = {.done = false};
    struct rusage used;
    int ends[2], status;
    if (pipe2(ends, O_CLOEXEC) != 0)
        return process;
    if (write(ends[1], input, strlen(input)) != (ssize_t)strlen(input))
        perror("bench: pipe");
    close(ends[1]);
    double begun = seconds_now();
    pid_t child = start(argv, ends[0], -1);
    if (child > 0 && wait4(child, &status, 0, &used) == child) {
        process.seconds = seconds_now() - begun;
        process.work = (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                       1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
        process.done = status == 0;
        process.megabytes = (double)used.ru_maxrss / 1024;
    }
    close(ends[0]);
    return process;
}

bool coprocess_start(struct coprocess *process, const char *const *argv)
{
    int to[2], from[2];
    if (pipe2(to, O_CLOEXEC) != 0 || pipe2(from, O_CLOEXEC) != 0)
        return false;
    process->pid = start(argv, to[0], from[1]);
    close(to[0]);
    close(from[1]);
    process->to = fdopen(to[1], "w");
    process->from = fdopen(from[0], "r");
    return process->pid > 0;
}

bool coprocess_ask(struct coprocess *process, const char *question, double *seconds, double *value)
{
    char line[128], *end;
    if (fprintf(process->to, "%s\n", question) < 0 || fflush(process->to) != 0 ||
        !fgets(line, sizeof line, process->from))
        return false;
    *seconds = strtod(line, &end);
    *value = strtod(end, NULL);
    return *seconds > 0;
}

void coprocess_end(struct coprocess *process)
{
    if (process->pid <= 0)
        return;
    fclose(process->to);
    fclose(process->from);
    waitpid(process->pid, NULL, 0);
}
