/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs jobs in parallel, in processes. */
#ifndef HARD_WORKERS_H
#define HARD_WORKERS_H

#include <stdbool.h>
#include <stddef.h>

/* Returns zeroed memory that all workers share. Aborts if there is not enough memory. */
void *workers_share(size_t size);
void workers_unshare(void *memory, size_t size);

/* Returns the number of workers: one for each processor, up to a few. */
int workers_number(void);

/*
 * Runs job(k, context) for k = 0 ... jobs - 1, in any order, each in a child process. Returns the sum of
 * their results, or -1 if a child failed.
 */
long workers_run(int jobs, long (*job)(int k, void *context), void *context);

#endif
