/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* sched_getaffinity */
#include "parallel/workers.h"
#include "interpreter/feature.h"
#include "io/io.h"
#include "io/terminal.h"
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCK_MOST = 16, /* points in a block: the lock is then seldom taken, and rows soon appear */
    WINDOW = 16,     /* for each worker, at most this many blocks are being computed or wait to be written */
    THREADS_MOST = 256
};

/* The rows of consecutive points. */
struct block {
    char *text;
    size_t size;
    bool is_done;
    /* If the function `point` returned false in this block, the context of its worker. No later block is
     * written then. */
    const void *last;
};

struct pool {
    const struct workers *job;
    size_t points, blocks; /* the number of points in a block, and the number of blocks */
    pthread_mutex_t lock;
    pthread_cond_t room;   /* signalled when blocks have been written, and when the computation stops */
    size_t taken, written; /* the number of blocks taken, and the number of blocks written */
    size_t window;         /* the size of `waiting` */
    struct block *waiting; /* a ring buffer: block k is element k % window */
    bool is_over;
    /* How the computation ended: */
    enum dom_status status;
    bool is_lost;  /* a write has failed */
    bool by_point; /* the function `point` returned false */
};

struct worker {
    struct pool *pool;
    void *context;
    pthread_t thread;
    bool is_caller; /* runs in the caller's thread, which shows progress */
};

/* ---- The pool; the caller of these functions holds the lock ---- */

/* Writes the blocks in order, up to the first one that is still being computed. */
static void pool_write(struct pool *p)
{
    FILE *out = p->job->out;
    struct block *b;
    while (!p->is_over && p->written < p->taken && (b = &p->waiting[p->written % p->window])->is_done) {
        if (out && ((b->size > 0 && fwrite(b->text, 1, b->size, out) != b->size) || ferror(out)))
            p->is_lost = true;
        else if (b->last) {
            memcpy(p->job->context, b->last, p->job->size);
            p->by_point = true;
        } else if (dom_raised(p->job->interrupt))
            p->status = DOM_INTERRUPTED;
        p->is_over = p->is_lost || p->by_point || p->status != DOM_OK;
        free(b->text);
        *b = (struct block){.text = NULL};
        p->written++;
    }
    if (out)
        io_row(out);
    pthread_cond_broadcast(&p->room);
}

/* ---- Workers ---- */

/* Computes a block without the lock. Returns false if memory runs out. */
static bool block_compute(const struct worker *me, size_t number, struct block *b)
{
    const struct pool *p = me->pool;
    const struct workers *job = p->job;
    const size_t from = number * p->points, left = job->points - from;
    const size_t points = p->points < left ? p->points : left;
    FILE *out = job->out ? io_memory(&b->text, &b->size) : NULL;
    bool was_muted = progress_mute(true); /* a point must not show its own progress */
    bool is_good = out || !job->out;
    for (size_t k = 0; is_good && !b->last && k < points && !dom_raised(job->interrupt); k++)
        if (!job->point(me->context, job->first + from + k, out))
            b->last = me->context;
    progress_mute(was_muted);
    if (job->progress && me->is_caller)
        progress_show((double)from / (double)job->points);
    is_good = is_good && !(out && ferror(out));
    return !(out && fclose(out) != 0) && is_good;
}

/* The main function of a worker: computes blocks until there are no more, or the computation stops. */
static void *worker_run(void *worker)
{
    const struct worker *me = worker;
    struct pool *p = me->pool;
    pthread_mutex_lock(&p->lock);
    for (;;) {
        while (!p->is_over && p->taken < p->blocks && p->taken - p->written >= p->window)
            pthread_cond_wait(&p->room, &p->lock);
        if (p->is_over || p->taken >= p->blocks)
            break;
        size_t number = p->taken++;
        pthread_mutex_unlock(&p->lock);
        struct block b = {.is_done = true};
        bool is_good = block_compute(me, number, &b);
        pthread_mutex_lock(&p->lock);
        p->waiting[number % p->window] = b;
        if (!is_good && !p->is_over) {
            p->status = DOM_NO_MEMORY;
            p->is_over = true;
        }
        pool_write(p);
        if (b.last) /* the context stays as it is, until the block is written */
            break;
    }
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

/* Computes all points of the pool's job. If some threads cannot be created, the other workers compute all. */
static void workers_run(struct pool *pool)
{
    const struct workers *job = pool->job;
    /* With few points, the blocks are smaller, so that all workers finish together. */
    const size_t share = job->points / (8 * (size_t)job->count) + 1;
    pool->points = share < BLOCK_MOST ? share : BLOCK_MOST;
    pool->blocks = (job->points + pool->points - 1) / pool->points;
    pool->window = WINDOW * (size_t)job->count;
    pthread_mutex_init(&pool->lock, NULL);
    pthread_cond_init(&pool->room, NULL);
    struct worker *worker = calloc(job->count, sizeof *worker);
    char *contexts = malloc(job->count * job->size);
    pool->waiting = calloc(pool->window, sizeof *pool->waiting);
    if (!progress_is_muted()) /* this may take a long time, and earlier answers must not wait for it */
        io_stdout_flush();
    if (worker && contexts && pool->waiting) {
        for (unsigned k = 0; k < job->count; k++) {
            worker[k] =
                (struct worker){.pool = pool, .context = contexts + k * job->size, .is_caller = k == 0};
            memcpy(worker[k].context, job->context, job->size);
        }
        /* New threads inherit the signal mask. Signals are blocked until all threads have begun, so that
         * signal handlers run only in the caller's thread. */
        unsigned begun = 1;
        sigset_t before = io_block();
        while (begun < job->count &&
               pthread_create(&worker[begun].thread, NULL, worker_run, &worker[begun]) == 0)
            begun++;
        io_unblock(&before);
        worker_run(&worker[0]);
        for (unsigned k = 1; k < begun; k++)
            pthread_join(worker[k].thread, NULL);
        for (size_t k = 0; k < pool->window; k++)
            free(pool->waiting[k].text);
        for (unsigned k = 0; k < job->count && pool->status == DOM_OK && !pool->is_over && job->merge; k++)
            job->merge(job->context, worker[k].context);
    } else
        pool->status = DOM_NO_MEMORY;
    pthread_cond_destroy(&pool->room);
    pthread_mutex_destroy(&pool->lock);
    free(pool->waiting);
    free(contexts);
    free(worker);
}

/* Returns how many workers to use. `threads` is the value of the parameter 'threads'. If it is 0, there is
 * one worker for each processor that this process may use. */
static unsigned workers_count(domq_real threads, size_t points)
{
    cpu_set_t allowed;
    size_t n = (size_t)threads;
    if (n == 0)
        n = sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? (size_t)CPU_COUNT(&allowed) : 1;
    n = n < points ? n : points;
    return n == 0 ? 1 : n < THREADS_MOST ? (unsigned)n : THREADS_MOST;
}

/* ---- The rows of an answer ---- */

struct range shard_range(const struct shard *shard, size_t points)
{
    const struct shard s = *shard;
    if (s.parts == 0)
        return (struct range){0, points};
    /* Part k ends at floor(points * k / parts). The product points * k could overflow, so `points` is split
     * into whole * parts + rest. */
    size_t whole = points / s.parts, rest = points % s.parts, k = s.part - 1;
    size_t first = whole * k + rest * k / s.parts, end = whole * (k + 1) + rest * (k + 1) / s.parts;
    return (struct range){first, end - first};
}

bool points_answer(const struct query *query, struct problem *problem, struct answer *a, struct workers w,
                   bool *by_point)
{
    struct pool pool = {.job = &w};
    const struct range part = shard_range(&query->run_context->shard, w.points);
    w.first = part.first;
    w.points = part.count;
    w.count = workers_count(query->state->settings.threads, part.count);
    w.out = a->out;
    w.progress = true;
    w.interrupt = query->scene->compute.interrupt;
    workers_run(&pool);
    *by_point = pool.by_point;
    a->progress.has_rows = a->progress.is_open = true;
    return pool.status == DOM_OK ? !pool.by_point : problem_status(problem, query->scene, pool.status);
}

/* ---- Tasks of the library ---- */

struct task {
    dom_task *run;
    void *context;
};

static bool task_run(void *context, size_t point, FILE *out)
{
    const struct task *task = context;
    (void)out;
    task->run(point, task->context);
    return true;
}

enum dom_status workers_tasks(size_t count, dom_task *run, void *context, void *pool)
{
    const struct task_pool *p = pool;
    struct task task = {run, context};
    const struct workers job = {.points = count,
                                .point = task_run,
                                .context = &task,
                                .size = sizeof task,
                                .count = workers_count(p->threads, count),
                                .progress = p->progress,
                                .interrupt = p->interrupt};
    struct pool all = {.job = &job};
    workers_run(&all);
    return all.status;
}

const struct feature parallel_feature = {.name = "parallel"};
