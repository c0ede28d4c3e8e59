/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workers.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST = 4 };

struct board {
    atomic_int next; /* the next job that has not begun */
    atomic_long sum;
};

void *workers_share(size_t size)
{
    void *memory = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        abort();
    return memory;
}

void workers_unshare(void *memory, size_t size)
{
    munmap(memory, size);
}

int workers_number(void)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    return cores < 1 ? 1 : cores > MOST ? MOST : (int)cores;
}

static void work(struct board *board, int jobs, long (*job)(int k, void *context), void *context)
{
    for (int k; (k = atomic_fetch_add(&board->next, 1)) < jobs;)
        atomic_fetch_add(&board->sum, job(k, context));
}

long workers_run(int jobs, long (*job)(int k, void *context), void *context)
{
    struct board *board = workers_share(sizeof *board);
    const int workers = workers_number();
    pid_t child[MOST];
    bool good = true;
    fflush(NULL); /* otherwise every child would print the buffered output again */
    for (int k = 0; k < workers; k++)
        if ((child[k] = fork()) == 0) {
            work(board, jobs, job, context);
            fflush(NULL);
            _exit(0);
        }
    for (int k = 0; k < workers; k++) {
        int status = -1;
        good &= child[k] > 0 && waitpid(child[k], &status, 0) == child[k] && status == 0;
    }
    long sum = atomic_load(&board->sum);
    workers_unshare(board, sizeof *board);
    return good ? sum : -1;
}
