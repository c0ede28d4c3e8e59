/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "row/steady.h"

/* A motion can be repeated only if the head stands in a long sequence of equal dominoes. The number of equal
 * dominoes up to the head must exceed the length of the longest pass along a chain by at least
 * STEADY_MORE. */
enum { STEADY_MORE = 2 };

/* A row may end with a long sequence of equal dominoes. Only about the first STEADY_FIRST of them have their
 * geometry filled in before the run. */
enum { STEADY_FIRST = 256 };

/* The last motion is repeated for the next head only if omegasq hardly changes any more. The relative change
 * of omegasq over all further heads together must be at most this fraction of the tolerance. */
#define STEADY_SHARE ((real)1 / 64)

/* Returns true if domino k has the same sizes, mass, gap and lean as the domino before it. */
static bool equal(const struct row_request *row, size_t k)
{
    const struct dom_domino *a = &row->domino[k], *b = a - 1;
    return a->height == b->height && a->thickness == b->thickness && a->gap == b->gap && a->mass == b->mass &&
           a->radius == b->radius && a->lean == b->lean && a->width == b->width;
}

KERNEL enum dom_status row_ready(struct run *run, size_t k)
{
    enum dom_status status = DOM_OK;
    for (; run->made <= k && status == DOM_OK; run->made++)
        status = row_geometry(run->request, run->made, run->geometry);
    return status;
}

KERNEL size_t steady_made(const struct row_request *request)
{
    size_t k = request->count;
    while (k > 1 && equal(request, k - 1))
        k--;
    return k + STEADY_FIRST < request->count ? k + STEADY_FIRST : request->count;
}

KERNEL bool steady_repeats(struct steady *s, struct run *run, size_t k, struct dom_fall *fall)
{
    s->alike = k > 0 && equal(run->request, k) ? s->alike + 1 : 1;
    if (!s->found || s->alike == 1 || k + 1 == run->request->count || !equal(run->request, k + 1))
        return false;
    struct dom_fall *self = &s->fall;
    self->domino++;
    self->moving += s->more;
    self->floor_domino += self->floor_domino > 0;
    self->floor_hit_domino += self->floor_hit_domino > 0;
    self->time = run->time;
    run->time += (real)self->duration;
    run->moving += s->more;
    run->verdict.domino = self->domino;
    *fall = *self;
    return true;
}

KERNEL void steady_find(struct steady *s, const struct run *run, size_t k, real before,
                        const struct descent *d, const struct dom_fall *fall)
{
    const real after = run->omegasq, lambda = d->st.gain * after / d->st.start.omegasq,
               left = fabs(after - before) * lambda / (1 - lambda);
    const size_t more = run->moving - fall->moving;
    s->found = !run->watch && k > 0 && run->request->work->longest + STEADY_MORE <= s->alike && more <= 1 &&
               more == s->more && lambda < 1 && left <= STEADY_SHARE * (real)run->request->tol * after;
    s->more = more;
    s->fall = *fall;
}

KERNEL bool steady_last(const struct steady *s, struct run *run, size_t k, struct descent *d,
                        struct dom_fall *fall, enum dom_status *status)
{
    const size_t last = run->made - 1, shift = k - last;
    struct run shorter = *run;
    shorter.moving = run->moving - (s->more > 0 ? shift : 0);
    run->geometry[last].c = (struct tilt){1, 0, 1};
    *status = row_head(&shorter, last, d, fall);
    if (run->request->work->longest + STEADY_MORE + shift > s->alike) {
        *status = row_geometry(run->request, last, run->geometry);
        return false;
    }
    fall->domino += shift;
    fall->moving = run->moving;
    fall->floor_domino += fall->floor_domino > 0 ? shift : 0;
    fall->floor_hit_domino += fall->floor_hit_domino > 0 ? shift : 0;
    shorter.verdict.domino += shift;
    shorter.verdict.weakest += shorter.verdict.weakest == last + 1 ? shift : 0;
    *run = shorter;
    return true;
}
