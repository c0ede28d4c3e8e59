/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: parallel */
/* The shell's thread pool, as the library uses it: each task runs once, with any number of threads. */
#include "parallel/workers.h"
#include "support.h"
#include <stdatomic.h>

enum { TASKS = 5000 };

struct tally {
    atomic_int runs[TASKS];
    atomic_size_t begun;
    size_t raise_at; /* the flag is raised after this many tasks have begun */
    volatile sig_atomic_t flag;
};

static void count_task(size_t index, void *context)
{
    struct tally *t = context;
    assert_true(index < TASKS);
    t->runs[index]++;
    if (++t->begun == t->raise_at)
        t->flag = 1;
}

TEST(each_task_once)
{
    static struct tally t;
    static const size_t counts[] = {0, 1, 2, 17, 1000, TASKS};
    static const int threads[] = {0, 1, 2, 7, 300};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        for (size_t j = 0; j < sizeof threads / sizeof *threads; j++) {
            struct task_pool pool = {.threads = threads[j]};
            memset(&t, 0, sizeof t);
            assert_status(workers_tasks(counts[i], count_task, &t, &pool), DOM_OK);
            for (size_t k = 0; k < TASKS; k++)
                assert_int_equal(t.runs[k], k < counts[i]);
        }
}

/* Checks that the pool starts no task after its flag is raised, and reports that tasks are missing. */
TEST(an_interrupt_ends_it)
{
    static struct tally t;
    for (int threads = 1; threads <= 3; threads++) {
        struct task_pool pool = {.threads = threads, .interrupt = &t.flag};
        memset(&t, 0, sizeof t);
        t.raise_at = 10;
        assert_status(workers_tasks(TASKS, count_task, &t, &pool), DOM_INTERRUPTED);
        assert_true(t.begun >= 10 && t.begun < TASKS);
        for (size_t k = 0; k < TASKS; k++)
            assert_true(t.runs[k] <= 1);
    }
}
