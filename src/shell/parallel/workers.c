/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parallel/workers.h"
#include "io/io.h"
#include "io/terminal.h"
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>

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
    void *own;
};

struct crew {
    const struct workers *asked;
    pthread_mutex_t lock;
    pthread_cond_t room;           /* a block was written, or all is over */
    size_t next;                   /* the first point that nobody has taken */
    size_t taken, written, window; /* blocks; block k is waiting[k % window] */
    struct block *waiting;
    bool over;
    struct workers_end end;
};

/* What a worker knows of its speed. */
struct kinematics {
    size_t points; /* of its last block */
    double seconds;
};

/* So many points that they take the time of a block; shorter near the end, so that all end together. */
static size_t block_points(const struct workers *w, const struct kinematics *kinematics, size_t left)
{
    double fit =
        kinematics->points ? BLOCK_SECONDS * (double)kinematics->points / (kinematics->seconds + 1e-9) : 1;
    double most = kinematics->points ? (double)GROWTH * (double)kinematics->points : 1;
    size_t share = w->count > 1 ? left / (2 * (size_t)w->count) + 1 : left;
    size_t points = (size_t)(fit < most ? fit : most) + 1;
    points = points < MOST ? points : MOST;
    return points < share ? points : share;
}

/* Points of one block, by the worker `own`; false where one of them ended it. */
static bool block_run(const struct workers *w, void *own, size_t from, size_t points,
                      struct kinematics *kinematics, FILE *out)
{
    double begun = terminal_clock();
    bool goes_on = true;
    bool shown = progress_mute(true);
    for (size_t k = 0; k < points && goes_on && !dom_raised(w->interrupt); k++)
        goes_on = w->point(own, w->first + from + k, out);
    progress_mute(shown);
    *kinematics = (struct kinematics){points, terminal_clock() - begun};
    return goes_on;
}

/* ---- One worker ---- */

static struct workers_end run_alone(const struct workers *w)
{
    struct progress progress = {0, 0};
    struct kinematics kinematics = {0, 0};
    struct workers_end end = {.how = WORKERS_DONE};
    for (size_t at = 0, points; at < w->points && end.how == WORKERS_DONE; at += points) {
        points = block_points(w, &kinematics, w->points - at);
        if (!block_run(w, w->own, at, points, &kinematics, w->out))
            end = (struct workers_end){.how = WORKERS_ENDED, .by = w->own};
        else if (dom_raised(w->interrupt))
            end.how = WORKERS_INTERRUPTED;
        else if (w->out && (fflush(w->out) != 0 || ferror(w->out)))
            end = (struct workers_end){.how = WORKERS_LOST, .error = errno};
        if (w->progress)
            progress_show(&progress, end.how == WORKERS_DONE ? (double)(at + points) / (double)w->points : 1);
    }
    return end;
}

/* ---- Many ---- */

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
        else if (b->ended)
            crew_end(c, (struct workers_end){.how = WORKERS_ENDED, .by = b->own});
        else if (dom_raised(c->asked->interrupt))
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

/* The next points, and the number of their block; 0 points: there are no more. */
static size_t crew_take(struct crew *c, const struct kinematics *kinematics, size_t *from, size_t *block)
{
    while (!c->over && c->taken - c->written >= c->window)
        pthread_cond_wait(&c->room, &c->lock);
    size_t left = c->over ? 0 : c->asked->points - c->next;
    size_t points = left ? block_points(c->asked, kinematics, left) : 0;
    *from = c->next;
    *block = c->taken;
    c->next += points;
    c->taken += points > 0;
    return points;
}

/* Its progress is shown by the first of them, whose thread is the caller's. */
static void worker_run(struct crew *c, void *own)
{
    const struct workers *w = c->asked;
    struct progress progress = {0, 0};
    struct kinematics kinematics = {0, 0};
    size_t from, points, number;
    pthread_mutex_lock(&c->lock);
    while ((points = crew_take(c, &kinematics, &from, &number)) > 0) {
        pthread_mutex_unlock(&c->lock);
        struct block b = {.text = NULL, .own = own};
        FILE *out = io_memory(&b.text, &b.size);
        b.ended = !out || !block_run(w, own, from, points, &kinematics, out);
        bool kept = out && !ferror(out);
        kept = out && fclose(out) == 0 && kept;
        if (w->progress && own == w->own)
            progress_show(&progress, (double)from / (double)w->points);
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
    if (w->progress && own == w->own)
        progress_show(&progress, 1);
}

struct hand {
    struct crew *crew;
    void *own;
    pthread_t thread;
};

static void *hand_run(void *context)
{
    struct hand *hand = context;
    worker_run(hand->crew, hand->own);
    return NULL;
}

/* Signals stay with the thread that they have always come to. */
static unsigned hands_begin(struct crew *c, struct hand *hand)
{
    const struct workers *w = c->asked;
    unsigned begun = 1;
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    for (bool more = true; more && begun < w->count; begun += more) {
        hand[begun] = (struct hand){.crew = c, .own = (char *)w->own + begun * w->size};
        more = pthread_create(&hand[begun].thread, NULL, hand_run, &hand[begun]) == 0;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return begun;
}

static struct workers_end run_together(const struct workers *w)
{
    struct crew c = {.asked = w, .window = WINDOW * (size_t)w->count, .end = {.how = WORKERS_DONE}};
    struct hand *hand = calloc(w->count, sizeof *hand);
    c.waiting = calloc(c.window, sizeof *c.waiting);
    if (!hand || !c.waiting) {
        free(hand);
        free(c.waiting);
        return (struct workers_end){.how = WORKERS_NO_MEMORY};
    }
    pthread_mutex_init(&c.lock, NULL);
    pthread_cond_init(&c.room, NULL);
    unsigned begun = hands_begin(&c, hand);
    worker_run(&c, w->own);
    for (unsigned k = 1; k < begun; k++)
        pthread_join(hand[k].thread, NULL);
    for (size_t k = 0; k < c.window; k++)
        free(c.waiting[k].text);
    pthread_cond_destroy(&c.room);
    pthread_mutex_destroy(&c.lock);
    free(c.waiting);
    free(hand);
    return c.end;
}

struct workers_end workers_run(const struct workers *w)
{
    if (w->points == 0)
        return (struct workers_end){.how = WORKERS_DONE};
    return w->count > 1 ? run_together(w) : run_alone(w);
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
