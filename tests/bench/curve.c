/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures a curve of r_max over s on several threads, and the largest speed-up that threads can achieve on
 * this machine. */
#include "bench.h"
#include <pthread.h>
#include <stdatomic.h>

enum { THREADS_MAX = 256, AT_ONCE = 16, ROUNDS = 3, SPINS = 20000000 };

struct curve {
    size_t points;
    atomic_size_t next;
    atomic_bool failed;
};

static void *curve_run(void *context)
{
    struct curve *curve = context;
    struct setup train = setup_default();
    struct domq_limit limit;
    size_t first;
    while ((first = atomic_fetch_add(&curve->next, AT_ONCE)) < curve->points)
        for (size_t i = first; i < first + AT_ONCE && i < curve->points; i++) {
            train.s = 0.02 + 0.88 * (double)i / (double)(curve->points - 1);
            if (ask_limit_rmax(&train, &limit) != DOM_OK)
                curve->failed = true;
        }
    return NULL;
}

/* Returns the seconds until f(context) has returned on all of `threads` threads. */
static double run_threads(void *(*f)(void *), void *context, unsigned threads)
{
    pthread_t thread[THREADS_MAX];
    unsigned n = 0;
    threads = threads < THREADS_MAX ? threads : THREADS_MAX;
    double begun = seconds_now();
    while (n + 1 < threads && pthread_create(&thread[n], NULL, f, context) == 0)
        n++;
    f(context);
    while (n > 0)
        pthread_join(thread[--n], NULL);
    return seconds_now() - begun;
}

struct tasks {
    size_t count;
    dom_task *task;
    void *context;
    atomic_size_t next;
};

static void *tasks_run(void *context)
{
    struct tasks *tasks = context;
    for (size_t i; (i = atomic_fetch_add(&tasks->next, 1)) < tasks->count;)
        tasks->task(i, tasks->context);
    return NULL;
}

enum dom_status threads_tasks(size_t count, dom_task *task, void *context, void *pool)
{
    struct tasks tasks = {.count = count, .task = task, .context = context};
    run_threads(tasks_run, &tasks, *(const unsigned *)pool);
    return DOM_OK;
}

double curve_library(size_t points, unsigned threads)
{
    struct curve curve = {.points = points};
    double seconds = run_threads(curve_run, &curve, threads);
    return curve.failed ? NONE : seconds;
}

/* Keeps a core busy without memory, locks or shared data. */
static void *spin(void *context)
{
    volatile double x = 1;
    (void)context;
    for (int i = 0; i < SPINS; i++)
        x = x * 0.5 + 1;
    return NULL;
}

void threads_measure(size_t points, const unsigned *threads, struct threaded *threaded, unsigned n)
{
    double alone = INFINITY, together[THREADS_MAX];
    for (unsigned i = 0; i < n; i++) {
        threaded[i].seconds = INFINITY;
        together[i] = INFINITY;
    }
    for (int round = 0; round < ROUNDS; round++) {
        alone = fmin(alone, run_threads(spin, NULL, 1));
        for (unsigned i = 0; i < n; i++) {
            threaded[i].seconds = fmin(threaded[i].seconds, curve_library(points, threads[i]));
            together[i] = fmin(together[i], run_threads(spin, NULL, threads[i]));
        }
    }
    for (unsigned i = 0; i < n; i++)
        threaded[i].given = threads[i] * alone / together[i];
}
