/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parallel/workers.h"
#include "io/io.h"
#include "io/terminal.h"
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

/* Long beside the lock and a write, short beside what a person notices. */
#define BLOCK_SECONDS 1e-3

enum {
    GROWTH = 4,  /* of a block over the one before: the next points may take longer */
    WINDOW = 16, /* blocks a worker that may wait to be written */
    MOST = 4096, /* points in a block */
    THREADS_MAX = 256
};

/* The rows of points that one worker has computed. */
struct block {
    char *text;
    size_t size;
    bool done, ended;
    const void *own;
};

struct crew {
    const struct workers *asked;
    pthread_mutex_t lock;
    pthread_cond_t room;           /* a block was written, or all is over */
    size_t next;                   /* the first point that no worker has taken */
    size_t taken, written, window; /* blocks; block k is waiting[k % window] */
    struct block *waiting;
    bool over;
    struct workers_end end;
};

/* The speed of a worker. */
struct pace {
    size_t points; /* of its last block */
    double seconds;
};

/* Returns how many points take the time of a block; fewer near the end, so that all workers end together. */
static size_t block_points(const struct workers *w, const struct pace *pace, size_t left)
{
    double fit = pace->points ? BLOCK_SECONDS * (double)pace->points / (pace->seconds + 1e-9) : 1;
    double most = pace->points ? (double)GROWTH * (double)pace->points : 1;
    size_t share = w->count > 1 ? left / (2 * (size_t)w->count) + 1 : left;
    size_t points = (size_t)(fit < most ? fit : most) + 1;
    points = points < MOST ? points : MOST;
    return points < share ? points : share;
}

/* Computes the points of one block with the worker `own`; returns false if a point ended the work. */
static bool block_run(const struct workers *w, void *own, size_t from, size_t points, struct pace *pace,
                      FILE *out)
{
    double begun = terminal_clock();
    bool goes_on = true;
    bool shown = progress_mute(true);
    for (size_t k = 0; k < points && goes_on && !dom_raised(w->interrupt); k++)
        goes_on = w->point(own, w->first + from + k, out);
    progress_mute(shown);
    *pace = (struct pace){points, terminal_clock() - begun};
    return goes_on;
}

/* ---- The crew ---- */

static void crew_end(struct crew *c, struct workers_end end)
{
    c->end = c->over ? c->end : end;
    c->over = true;
    pthread_cond_broadcast(&c->room);
}

/* Writes the blocks whose turn it is. */
static void crew_write(struct crew *c)
{
    FILE *out = c->asked->out;
    size_t before = c->written;
    struct block *b;
    while (!c->over && c->written < c->taken && (b = &c->waiting[c->written % c->window])->done) {
        if (out && ((b->size > 0 && fwrite(b->text, 1, b->size, out) != b->size) || ferror(out)))
            crew_end(c, (struct workers_end){.how = WORKERS_LOST, .error = errno});
        else if (b->ended) {
            memcpy(c->asked->own, b->own, c->asked->size);
            crew_end(c, (struct workers_end){.how = WORKERS_ENDED});
        } else if (dom_raised(c->asked->interrupt))
            crew_end(c, (struct workers_end){.how = WORKERS_INTERRUPTED});
        free(b->text);
        *b = (struct block){.text = NULL};
        c->written++;
    }
    if (c->written > before && out && fflush(out) != 0)
        crew_end(c, (struct workers_end){.how = WORKERS_LOST, .error = errno});
    if (c->written > before)
        pthread_cond_broadcast(&c->room);
}

/* Takes the next points, and the number of their block; returns 0 points if there are no more. */
static size_t crew_take(struct crew *c, const struct pace *pace, size_t *from, size_t *block)
{
    while (!c->over && c->taken - c->written >= c->window)
        pthread_cond_wait(&c->room, &c->lock);
    size_t left = c->over ? 0 : c->asked->points - c->next;
    size_t points = left ? block_points(c->asked, pace, left) : 0;
    *from = c->next;
    *block = c->taken;
    c->next += points;
    c->taken += points > 0;
    return points;
}

/* Computes blocks until there are no more.  The first worker, the caller's thread, shows the progress. */
static void worker_run(struct crew *c, void *own, bool shows)
{
    const struct workers *w = c->asked;
    struct pace pace = {0, 0};
    size_t from, points, number;
    pthread_mutex_lock(&c->lock);
    while ((points = crew_take(c, &pace, &from, &number)) > 0) {
        pthread_mutex_unlock(&c->lock);
        struct block b = {.text = NULL, .own = own};
        FILE *out = io_memory(&b.text, &b.size);
        b.ended = !out || !block_run(w, own, from, points, &pace, out);
        bool kept = out && !ferror(out);
        kept = out && fclose(out) == 0 && kept;
        if (shows)
            progress_show((double)from / (double)w->points);
        pthread_mutex_lock(&c->lock);
        if (kept) {
            b.done = true;
            c->waiting[number % c->window] = b;
            crew_write(c);
        } else
            crew_end(c, (struct workers_end){.how = WORKERS_NO_MEMORY});
        if (b.ended)
            break;
    }
    pthread_mutex_unlock(&c->lock);
}

struct hand {
    struct crew *crew;
    void *own;
    pthread_t thread;
};

static void *hand_run(void *context)
{
    struct hand *hand = context;
    worker_run(hand->crew, hand->own, false);
    return NULL;
}

/* Starts the threads with all signals blocked, so that signals still come to the caller's thread. */
static unsigned hands_begin(struct hand *hand, unsigned count)
{
    unsigned begun = 1;
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    while (begun < count && pthread_create(&hand[begun].thread, NULL, hand_run, &hand[begun]) == 0)
        begun++;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return begun;
}

struct workers_end workers_run(const struct workers *w)
{
    struct crew c = {.asked = w, .window = WINDOW * (size_t)w->count, .end = {.how = WORKERS_DONE}};
    struct hand *hand = calloc(w->count, sizeof *hand);
    char *own = malloc(w->count * w->size);
    c.waiting = calloc(c.window, sizeof *c.waiting);
    if (hand && own && c.waiting) {
        for (unsigned k = 0; k < w->count; k++) {
            hand[k] = (struct hand){.crew = &c, .own = own + k * w->size};
            memcpy(hand[k].own, w->own, w->size);
        }
        pthread_mutex_init(&c.lock, NULL);
        pthread_cond_init(&c.room, NULL);
        unsigned begun = hands_begin(hand, w->count);
        worker_run(&c, hand[0].own, w->progress);
        for (unsigned k = 1; k < begun; k++)
            pthread_join(hand[k].thread, NULL);
        for (size_t k = 0; k < c.window; k++)
            free(c.waiting[k].text);
        pthread_cond_destroy(&c.room);
        pthread_mutex_destroy(&c.lock);
        for (unsigned k = 0; k < w->count && c.end.how == WORKERS_DONE && w->gather; k++)
            w->gather(w->own, hand[k].own);
    } else
        c.end.how = WORKERS_NO_MEMORY;
    free(c.waiting);
    free(own);
    free(hand);
    return c.end;
}

unsigned workers_count(domq_real threads, size_t points)
{
    cpu_set_t ours;
    size_t n = (size_t)threads;
    if (n == 0)
        n = sched_getaffinity(0, sizeof ours, &ours) == 0 ? (size_t)CPU_COUNT(&ours) : 1;
    n = n < points ? n : points;
    return n == 0 ? 1 : n < THREADS_MAX ? (unsigned)n : THREADS_MAX;
}

/* ---- Tasks of the library ---- */

struct job {
    dom_task *task;
    void *context;
};

static bool job_point(void *own, size_t point, FILE *out)
{
    const struct job *job = own;
    (void)out;
    job->task(point, job->context);
    return true;
}

enum dom_status workers_tasks(size_t count, dom_task *task, void *context, void *pool)
{
    static const enum dom_status status[] = {[WORKERS_DONE] = DOM_OK,
                                             [WORKERS_INTERRUPTED] = DOM_INTERRUPTED,
                                             [WORKERS_NO_MEMORY] = DOM_NO_MEMORY};
    const struct task_pool *p = pool;
    struct job job = {task, context};
    const struct workers w = {.points = count,
                              .point = job_point,
                              .own = &job,
                              .size = sizeof job,
                              .count = workers_count(p->threads, count),
                              .progress = p->progress,
                              .interrupt = p->interrupt};
    return status[workers_run(&w).how];
}
