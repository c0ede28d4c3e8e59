/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions about rows of the kernel in narrow.c. */
#include "dispatch/narrow.h"
#include "dispatch/wide.h"
#include <stdlib.h>

NARROW(fall)
NARROW(verdict)

static void widen_domino(struct domq_domino *to, const struct dom_domino *from)
{
    DOM_MEMBERS_domino(TO_WIDE, AS_IT_IS, PART_OF)
}

/* The caller's callback, which is one of these two, and its context. */
struct visitor {
    dom_fall_visit *fall;
    dom_moment_visit *moment;
    void *context;
    size_t count;           /* number of dominoes in the row; used with `moment` */
    dom_real *tilt, *omega; /* room for `count` numbers each */
};

static bool visit_fall(const struct domq_fall *wide, void *context)
{
    const struct visitor *v = context;
    struct dom_fall fall;
    narrow_fall(&fall, wide);
    return v->fall(&fall, v->context);
}

static bool visit_moment(const struct domq_moment *wide, void *context)
{
    const struct visitor *v = context;
    for (size_t k = 0; k < v->count; k++) {
        v->tilt[k] = (dom_real)wide->tilt[k];
        v->omega[k] = (dom_real)wide->omega[k];
    }
    const struct dom_moment moment = {.time = (dom_real)wide->time,
                                      .head = wide->head,
                                      .moving = wide->moving,
                                      .tilt = v->tilt,
                                      .omega = v->omega};
    return v->moment(&moment, v->context);
}

static struct domq_row wide_row(const struct row_request *q, const struct domq_domino *domino)
{
    return (struct domq_row){.domino = domino,
                             .count = q->count,
                             .g = q->g,
                             .push = q->push,
                             .floor = q->floor,
                             DOM_DYNAMICS(EFFECT)};
}

static struct domq_compute wide_row_compute(const struct row_request *q)
{
    return (struct domq_compute){.tol = wide_tol(q->tol, q->precision),
                                 .precision = q->precision,
                                 .work = q->work,
                                 .interrupt = q->interrupt};
}

/* Returns the dominoes in an array that the caller frees, or NULL if memory runs out. */
static struct domq_domino *wide_dominoes(const struct row_request *q)
{
    struct domq_domino *wide = malloc((q->count + 1) * sizeof *wide);
    for (size_t k = 0; wide && k < q->count; k++)
        widen_domino(&wide[k], &q->domino[k]);
    return wide;
}

/* Writes the verdict on a row. If the row was not run, only the number of a domino with a bad value is
 * written. */
static enum dom_status verdict_written(enum dom_status status, const struct domq_verdict *wide,
                                       struct dom_verdict *verdict)
{
    if (status == DOM_OK)
        narrow_verdict(verdict, wide);
    else if (wide->domino > 0)
        verdict->domino = wide->domino;
    return status;
}

enum dom_status narrow_row_run(const struct row_request *q, bool times, dom_fall_visit *visit, void *context,
                               struct dom_verdict *verdict)
{
    struct domq_domino *domino = wide_dominoes(q);
    if (!domino)
        return DOM_NO_MEMORY;
    const struct domq_row row = wide_row(q, domino);
    const struct domq_compute compute = wide_row_compute(q);
    struct domq_verdict wide = {.domino = 0};
    enum dom_status status = domq_row_run(&row, &compute, times, visit ? visit_fall : NULL,
                                          &(struct visitor){.fall = visit, .context = context}, &wide);
    free(domino);
    return verdict_written(status, &wide, verdict);
}

enum dom_status narrow_row_watch(const struct row_request *q, const dom_real *times, size_t count,
                                 dom_moment_visit *visit, void *context, struct dom_verdict *verdict)
{
    struct visitor v = {.moment = visit,
                        .context = context,
                        .count = q->count,
                        .tilt = malloc((q->count + 1) * sizeof *v.tilt),
                        .omega = malloc((q->count + 1) * sizeof *v.omega)};
    struct domq_domino *domino = wide_dominoes(q);
    domq_real *wide_times = malloc((count + 1) * sizeof *wide_times);
    enum dom_status status = DOM_NO_MEMORY;
    if (v.tilt && v.omega && domino && wide_times) {
        const struct domq_row row = wide_row(q, domino);
        const struct domq_compute compute = wide_row_compute(q);
        struct domq_verdict wide = {.domino = 0};
        for (size_t k = 0; k < count; k++)
            wide_times[k] = times[k];
        status = domq_row_watch(&row, &compute, wide_times, count, visit_moment, &v, &wide);
        status = verdict_written(status, &wide, verdict);
    }
    free(v.tilt);
    free(v.omega);
    free(domino);
    free(wide_times);
    return status;
}

/* ---- Rows that are run again and again ---- */

/* Callers of the kernel get pointers to a struct course or a struct random_row. In this file, such a pointer
 * points to a struct narrow_runs. */
struct narrow_runs {
    enum dom_precision precision;
    size_t count;
    struct domq_domino *domino;
    size_t first, last; /* the dominoes that the last trial changed */
    struct course *course;
    struct random_row *sample;
};

static struct narrow_runs *runs_begin(const struct row_request *q)
{
    struct narrow_runs *runs = malloc(sizeof *runs);
    if (runs)
        *runs =
            (struct narrow_runs){.precision = q->precision, .count = q->count, .domino = wide_dominoes(q)};
    if (runs && !runs->domino) {
        free(runs);
        return NULL;
    }
    return runs;
}

static void runs_end(struct narrow_runs *runs)
{
    if (runs)
        free(runs->domino);
    free(runs);
}

enum dom_status narrow_row_course(const struct row_request *q, struct course **course,
                                  struct dom_verdict *verdict)
{
    struct narrow_runs *runs = runs_begin(q);
    *course = (void *)runs;
    if (!runs)
        return DOM_NO_MEMORY;
    const struct domq_row row = wide_row(q, runs->domino);
    const struct domq_compute compute = wide_row_compute(q);
    struct domq_verdict wide = {.domino = 0};
    enum dom_status status = domq__course(&row, &compute, &runs->course, &wide);
    return verdict_written(status, &wide, verdict);
}

enum dom_status narrow_row_again(struct course *course, const struct dom_domino *domino, size_t first,
                                 size_t last, struct dom_verdict *verdict)
{
    struct narrow_runs *runs = (void *)course;
    struct domq_verdict wide;
    for (size_t k = runs->first; k <= runs->last; k++)
        widen_domino(&runs->domino[k], &domino[k]);
    for (size_t k = first; k <= last; k++)
        widen_domino(&runs->domino[k], &domino[k]);
    runs->first = first;
    runs->last = last;
    enum dom_status status = domq__again(runs->precision, runs->course, runs->domino, first, last, &wide);
    narrow_verdict(verdict, &wide);
    return status;
}

enum dom_status narrow_row_course_end(struct course *course)
{
    struct narrow_runs *runs = (void *)course;
    domq__course_end(runs->precision, runs->course);
    runs_end(runs);
    return DOM_OK;
}

enum dom_status narrow_row_sample(const struct row_request *q, struct random_row **sample)
{
    struct narrow_runs *runs = runs_begin(q);
    *sample = (void *)runs;
    if (!runs)
        return DOM_NO_MEMORY;
    const struct domq_row row = wide_row(q, runs->domino);
    const struct domq_compute compute = wide_row_compute(q);
    return domq__sample(&row, &compute, &runs->sample);
}

enum dom_status narrow_row_sampled(struct random_row *sample, const struct dom_row *row, bool gaps,
                                   struct dom_verdict *verdict)
{
    struct narrow_runs *runs = (void *)sample;
    struct domq_verdict wide;
    for (size_t k = 0; k < runs->count; k++)
        widen_domino(&runs->domino[k], &row->domino[k]);
#define SAME(effect, member, status) .member = row->member,
    const struct domq_row wide_row = {
        .domino = runs->domino, .count = runs->count, .push = row->push, DOM_DYNAMICS(SAME)};
#undef SAME
    enum dom_status status = domq__sampled(runs->precision, runs->sample, &wide_row, gaps, &wide);
    narrow_verdict(verdict, &wide);
    return status;
}

enum dom_status narrow_row_sample_end(struct random_row *sample)
{
    struct narrow_runs *runs = (void *)sample;
    domq__sample_end(runs->precision, runs->sample);
    runs_end(runs);
    return DOM_OK;
}
