/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parallel/workers.h"
#include "io/io.h"
#include "io/system.h"
#include "io/terminal.h"
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

/* The intended duration of a block in seconds: much longer than taking the lock, but not noticeable. */
#define BLOCK_SECONDS 1e-3

enum {
    /* A worker's next block has at most about GROWTH times as many points as its last one, even if the last
     * one was computed quickly, because later points may take more time. */
    GROWTH = 4,
    WINDOW = 16, /* for each worker, at most this many blocks are being computed or wait to be written */
    BLOCK_MOST = 4096,
    THREADS_MOST = 256
};

/* The rows of consecutive points. */
struct block {
    char *text;
    size_t size;
    bool is_done;
    bool is_last;        /* the function `point` returned false in this block, so no later block is written */
    const void *context; /* the context of the worker that computed the block */
};

struct pool {
    const struct workers *job;
    pthread_mutex_t lock;
    pthread_cond_t room;   /* signalled when blocks have been written, and when the computation stops */
    size_t next;           /* the first point that no worker has taken yet */
    size_t taken, written; /* the number of blocks taken, and the number of blocks written */
    size_t window;         /* the size of `waiting` */
    struct block *waiting; /* a ring buffer: block k is element k % window */
    bool is_over;
    struct workers_end end;
};

struct worker {
    struct pool *pool;
    void *context;
    pthread_t thread;
    size_t points; /* the number of points and the duration of the last block */
    double seconds;
};

static size_t block_points(const struct workers *job, const struct worker *me, size_t left)
{
    double fit = me->points ? BLOCK_SECONDS * (double)me->points / (me->seconds + 1e-9) : 1;
    double most = me->points ? (double)GROWTH * (double)me->points : 1;
    /* towards the end the blocks get smaller, so that all workers finish together */
    size_t share = job->count > 1 ? left / (2 * (size_t)job->count) + 1 : left;
    size_t points = (size_t)(fit < most ? fit : most) + 1;
    points = points < BLOCK_MOST ? points : BLOCK_MOST;
    return points < share ? points : share;
}

/* Returns false if the function `point` returned false. */
static bool block_compute(struct worker *me, size_t from, FILE *out)
{
    const struct workers *job = me->pool->job;
    double begun = terminal_clock();
    bool goes_on = true;
    bool was_muted = progress_mute(true); /* a point must not show its own progress */
    for (size_t k = 0; k < me->points && goes_on && !dom_raised(job->interrupt); k++)
        goes_on = job->point(me->context, job->first + from + k, out);
    progress_mute(was_muted);
    me->seconds = terminal_clock() - begun;
    return goes_on;
}

/* ---- The pool; the caller of these functions holds the lock ---- */

/* Stops the computation. If it has already been stopped, keeps the earlier reason. */
static void pool_end(struct pool *p, struct workers_end end)
{
    p->end = p->is_over ? p->end : end;
    p->is_over = true;
    pthread_cond_broadcast(&p->room);
}

/* Writes the blocks in order, up to the first one that is still being computed. */
static void pool_write(struct pool *p)
{
    FILE *out = p->job->out;
    size_t before = p->written;
    struct block *b;
    while (!p->is_over && p->written < p->taken && (b = &p->waiting[p->written % p->window])->is_done) {
        if (out && ((b->size > 0 && fwrite(b->text, 1, b->size, out) != b->size) || ferror(out)))
            pool_end(p, (struct workers_end){WORKERS_WRITE_FAILED, errno});
        else if (b->is_last) {
            memcpy(p->job->context, b->context, p->job->size);
            pool_end(p, (struct workers_end){.how = WORKERS_ENDED});
        } else if (dom_raised(p->job->interrupt))
            pool_end(p, (struct workers_end){.how = WORKERS_INTERRUPTED});
        free(b->text);
        *b = (struct block){.text = NULL};
        p->written++;
    }
    if (p->written == before)
        return;
    if (out && fflush(out) != 0)
        pool_end(p, (struct workers_end){WORKERS_WRITE_FAILED, errno});
    pthread_cond_broadcast(&p->room);
}

/* Gives a worker the next block of points. If `waiting` has no room for another block, first waits until
 * blocks have been written. Sets *block to the number of the block, *from to the index of its first point,
 * and me->points to the number of its points. Returns false if there are no more points, or if the
 * computation has been stopped. */
static bool pool_take(struct pool *p, struct worker *me, size_t *from, size_t *block)
{
    while (!p->is_over && p->taken - p->written >= p->window)
        pthread_cond_wait(&p->room, &p->lock);
    size_t left = p->is_over ? 0 : p->job->points - p->next;
    if (left == 0)
        return false;
    me->points = block_points(p->job, me, left);
    *from = p->next;
    *block = p->taken++;
    p->next += me->points;
    return true;
}

/* ---- Workers; the caller of these functions does not hold the lock ---- */

/* The main function of a worker: computes blocks until pool_take has no more of them, or `point` returns
 * false. */
static void *worker_run(void *worker)
{
    struct worker *me = worker;
    struct pool *p = me->pool;
    size_t from, number;
    bool is_last = false;
    pthread_mutex_lock(&p->lock);
    while (!is_last && pool_take(p, me, &from, &number)) {
        pthread_mutex_unlock(&p->lock);
        struct block b = {.is_done = true, .context = me->context};
        FILE *out = io_memory(&b.text, &b.size);
        is_last = b.is_last = !out || !block_compute(me, from, out);
        bool has_text = out && !ferror(out);
        has_text = out && fclose(out) == 0 && has_text;
        /* only the caller's thread shows progress, because the other threads are muted */
        if (p->job->progress)
            progress_show((double)from / (double)p->job->points);
        pthread_mutex_lock(&p->lock);
        if (has_text) {
            p->waiting[number % p->window] = b;
            pool_write(p);
        } else {
            free(b.text);
            pool_end(p, (struct workers_end){.how = WORKERS_NO_MEMORY});
        }
    }
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

static void *thread_run(void *worker)
{
    progress_mute(true);
    return worker_run(worker);
}

/* Runs all workers, the first one in the caller's thread. */
static void pool_run(struct pool *p, struct worker *worker)
{
    unsigned begun = 1;
    /* New threads inherit the signal mask. Signals are blocked until all threads have begun, so that signal
     * handlers run only in the caller's thread. */
    sigset_t before = io_block();
    while (begun < p->job->count &&
           pthread_create(&worker[begun].thread, NULL, thread_run, &worker[begun]) == 0)
        begun++;
    io_unblock(&before);
    worker_run(&worker[0]);
    for (unsigned k = 1; k < begun; k++)
        pthread_join(worker[k].thread, NULL);
}

struct workers_end workers_run(const struct workers *job)
{
    struct pool pool = {.job = job,
                        .lock = PTHREAD_MUTEX_INITIALIZER,
                        .room = PTHREAD_COND_INITIALIZER,
                        .window = WINDOW * (size_t)job->count};
    struct worker *worker = calloc(job->count, sizeof *worker);
    char *contexts = malloc(job->count * job->size);
    pool.waiting = calloc(pool.window, sizeof *pool.waiting);
    if (worker && contexts && pool.waiting) {
        for (unsigned k = 0; k < job->count; k++) {
            worker[k] = (struct worker){.pool = &pool, .context = contexts + k * job->size};
            memcpy(worker[k].context, job->context, job->size);
        }
        pool_run(&pool, worker);
        for (size_t k = 0; k < pool.window; k++)
            free(pool.waiting[k].text);
        for (unsigned k = 0; k < job->count && pool.end.how == WORKERS_DONE && job->merge; k++)
            job->merge(job->context, worker[k].context);
    } else
        pool.end.how = WORKERS_NO_MEMORY;
    pthread_cond_destroy(&pool.room);
    pthread_mutex_destroy(&pool.lock);
    free(pool.waiting);
    free(contexts);
    free(worker);
    return pool.end;
}

unsigned workers_count(domq_real threads, size_t points)
{
    size_t n = (size_t)threads;
    if (n == 0)
        n = system_processors();
    n = n < points ? n : points;
    return n == 0 ? 1 : n < THREADS_MOST ? (unsigned)n : THREADS_MOST;
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
    static const enum dom_status status[] = {[WORKERS_DONE] = DOM_OK,
                                             [WORKERS_INTERRUPTED] = DOM_INTERRUPTED,
                                             [WORKERS_NO_MEMORY] = DOM_NO_MEMORY};
    const struct task_pool *p = pool;
    struct task task = {run, context};
    const struct workers job = {.points = count,
                                .point = task_run,
                                .context = &task,
                                .size = sizeof task,
                                .count = workers_count(p->threads, count),
                                .progress = p->progress,
                                .interrupt = p->interrupt};
    return status[workers_run(&job).how];
}
