/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Jobs side by side, in processes. */
#ifndef HARD_WORKERS_H
#define HARD_WORKERS_H

#include <stdbool.h>
#include <stddef.h>

/* Memory that all workers see, zeroed; aborts if there is none. */
void *workers_share(size_t size);
void workers_unshare(void *memory, size_t size);

/* One for each processor, up to a few. */
int workers_number(void);

/*
 * Does job(k, context) for k = 0 ... jobs - 1, in any order, each in some child process.  The sum of what
 * the jobs return, or -1 if a child broke down.
 */
long workers_run(int jobs, long (*job)(int k, void *context), void *context);

#endif
