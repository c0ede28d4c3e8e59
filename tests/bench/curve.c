/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A curve of r_max over s: a loop over the library, its points shared out to threads in turn. */
#include "bench.h"
#include <pthread.h>
#include <stdatomic.h>

enum { THREADS_MAX = 256, AT_ONCE = 16 };

struct curve {
    size_t points;
    atomic_size_t next;
    atomic_bool failed;
};

static void *curve_run(void *context)
{
    struct curve *curve = context;
    struct dom_train train = dom_train_default();
    struct dom_limit limit;
    size_t first;
    while ((first = atomic_fetch_add(&curve->next, AT_ONCE)) < curve->points)
        for (size_t i = first; i < first + AT_ONCE && i < curve->points; i++) {
            train.s = 0.02 + 0.88 * (double)i / (double)(curve->points - 1);
            if (dom_limit_rmax(&train, &limit, NULL, NULL) != DOM_OK)
                curve->failed = true;
        }
    return NULL;
}

double curve_library(size_t points, unsigned threads, int repeats)
{
    pthread_t thread[THREADS_MAX];
    double least = INFINITY;
    threads = threads < THREADS_MAX ? threads : THREADS_MAX;
    for (int k = 0; k < repeats; k++) {
        struct curve curve = {.points = points};
        unsigned n = 0;
        double begun = seconds_now();
        while (n + 1 < threads && pthread_create(&thread[n], NULL, curve_run, &curve) == 0)
            n++;
        curve_run(&curve);
        while (n > 0)
            pthread_join(thread[--n], NULL);
        double seconds = seconds_now() - begun;
        if (curve.failed)
            return NAN;
        least = fmin(least, seconds);
    }
    return least;
}
