/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* sched_getaffinity */
#include "parallel/workers.h"
#include "interpreter/command.h"
#include "io/io.h"
#include "parallel/progress.h"
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
    const struct task_pool *how;
    FILE *out;             /* the stream for the rows, or NULL if the points have no rows */
    size_t points, blocks; /* the number of points in a block, and the number of blocks */
    pthread_mutex_t lock;
    pthread_cond_t room;   /* signalled when blocks have been written, and when the computation stops */
    size_t taken, written; /* the number of blocks taken, and the number of blocks written */
    size_t window;         /* the size of `waiting` */
    struct block *waiting; /* a ring buffer: block k is element k % window */
    bool is_over;          /* no more blocks are needed; `status` says why, or a write or a point failed */
    enum dom_status status;
};

struct worker {
    struct pool *pool;
    void *context;
    pthread_t thread;
    bool is_caller; /* runs in the caller's thread, which shows progress */
};

/* Writes the blocks in order, up to the first one that is still being computed. The caller holds the lock. */
static void pool_write(struct pool *p)
{
    struct block *b;
    while (!p->is_over && p->written < p->taken && (b = &p->waiting[p->written % p->window])->is_done) {
        const bool is_lost =
            p->out && ((b->size > 0 && fwrite(b->text, 1, b->size, p->out) != b->size) || ferror(p->out));
        if (!is_lost && b->last)
            memcpy(p->job->context, b->last, p->job->size);
        else if (!is_lost && dom_raised(p->how->interrupt))
            p->status = DOM_INTERRUPTED;
        p->is_over = is_lost || b->last || p->status != DOM_OK;
        free(b->text);
        *b = (struct block){.text = NULL};
        p->written++;
    }
    if (p->out)
        io_row(p->out);
    pthread_cond_broadcast(&p->room);
}

/* Computes a block without the lock. Returns false if memory runs out. */
static bool block_compute(const struct worker *me, size_t number, struct block *b)
{
    const struct pool *p = me->pool;
    const size_t from = number * p->points, left = p->job->points - from;
    const size_t end = from + (p->points < left ? p->points : left);
    FILE *out = p->out ? io_memory(&b->text, &b->size) : NULL;
    const bool was_worker = io_is_worker;
    io_is_worker = true;
    bool is_good = out || !p->out;
    for (size_t k = from; is_good && !b->last && k < end && !dom_raised(p->how->interrupt); k++)
        if (!p->job->point(me->context, k, out))
            b->last = me->context;
    io_is_worker = was_worker;
    if (p->how->progress && me->is_caller)
        progress_show((double)from / (double)p->job->points);
    is_good = is_good && !(out && ferror(out));
    return !(out && fclose(out) != 0) && is_good;
}

/* The main function of a worker: computes blocks until there are no more, or the computation stops. */
static void *worker_run(void *worker)
{
    const struct worker *me = worker;
    struct pool *p = me->pool;
    const void *last = NULL; /* the context stays as it is, until the block is written */
    pthread_mutex_lock(&p->lock);
    while (!last && !p->is_over && p->taken < p->blocks) {
        if (p->taken - p->written >= p->window) {
            pthread_cond_wait(&p->room, &p->lock);
            continue;
        }
        size_t number = p->taken++;
        pthread_mutex_unlock(&p->lock);
        struct block b = {.is_done = true};
        bool is_good = block_compute(me, number, &b);
        pthread_mutex_lock(&p->lock);
        p->waiting[number % p->window] = b;
        last = b.last;
        if (!is_good && !p->is_over) {
            p->status = DOM_NO_MEMORY;
            p->is_over = true;
        }
        pool_write(p);
    }
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

/* Computes all points of a job, with one worker for each processor that this process may use if
 * how->threads is 0. If some threads cannot be created, the other workers compute all. */
static enum dom_status workers_run(const struct workers *job, const struct task_pool *how, FILE *out)
{
    cpu_set_t allowed;
    size_t count = (size_t)how->threads;
    if (count == 0)
        count = sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? (size_t)CPU_COUNT(&allowed) : 1;
    count = count < THREADS_MOST ? count : THREADS_MOST;
    count = count < job->points ? count : job->points > 0 ? job->points : 1;
    /* With few points, the blocks are smaller, so that all workers finish together. */
    const size_t share = job->points / (8 * count) + 1;
    struct pool pool = {.job = job,
                        .how = how,
                        .out = out,
                        .points = share < BLOCK_MOST ? share : BLOCK_MOST,
                        .window = WINDOW * count};
    pool.blocks = (job->points + pool.points - 1) / pool.points;
    pthread_mutex_init(&pool.lock, NULL);
    pthread_cond_init(&pool.room, NULL);
    struct worker *worker = calloc(count, sizeof *worker);
    char *contexts = malloc(count * job->size);
    pool.waiting = calloc(pool.window, sizeof *pool.waiting);
    if (!io_is_worker) /* this may take a long time, and earlier answers must not wait for it */
        io_stdout_flush();
    if (worker && contexts && pool.waiting) {
        for (size_t k = 0; k < count; k++) {
            worker[k] =
                (struct worker){.pool = &pool, .context = contexts + k * job->size, .is_caller = k == 0};
            memcpy(worker[k].context, job->context, job->size);
        }
        /* New threads inherit the signal mask. Signals are blocked until all threads have begun, so that
         * signal handlers run only in the caller's thread. */
        size_t begun = 1;
        sigset_t before = io_block();
        while (begun < count && pthread_create(&worker[begun].thread, NULL, worker_run, &worker[begun]) == 0)
            begun++;
        io_unblock(&before);
        worker_run(&worker[0]);
        for (size_t k = 1; k < begun; k++)
            pthread_join(worker[k].thread, NULL);
        for (size_t k = 0; k < pool.window; k++)
            free(pool.waiting[k].text);
    } else
        pool.status = DOM_NO_MEMORY;
    pthread_cond_destroy(&pool.room);
    pthread_mutex_destroy(&pool.lock);
    free(pool.waiting);
    free(contexts);
    free(worker);
    return pool.status;
}

enum dom_status points_answer(const struct query *query, struct answer *a, const struct workers *workers)
{
    const struct task_pool how = {.threads = query->state->settings.threads,
                                  .progress = true,
                                  .interrupt = query->scene->compute.interrupt};
    const enum dom_status status = workers_run(workers, &how, a->out);
    a->progress.has_rows = a->progress.is_open = true;
    return status;
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
    struct task task = {run, context};
    const struct workers job = {.points = count, .point = task_run, .context = &task, .size = sizeof task};
    return workers_run(&job, pool, NULL);
}

static const struct parameter threads = {
    .name = "threads",
    .offset = offsetof(struct state, settings.threads),
    .meaning = "number of threads for curves, sweeps and studies; 0 means one for each processor",
    .value =
        (const struct domq_effect_argument[]){{.name = "threads", .unit = "", .highest = 256, .whole = true}},
    .synonyms = "parallel cores processors cpu fast",
    .setting = true};

const struct feature parallel_feature = {.name = "parallel",
                                         .progress = progress_line,
                                         .parameters = (const struct parameter *const[]){&threads, NULL}};
