/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compares rows in a rigid-body engine with the same rows in the model and with endless trains: the largest
 * growth at which all dominoes fall, and how long a cycle lasts. With so many dominoes and so strong a push,
 * the last dominoes do not depend on the push.
 *
 * Steps of the engine are halved until a halving changes the value by a fraction of less than STILL, or until
 * FINEST is reached. The remaining first-order error is as large as the last change. A difference of up to
 * ALLOWED times this change counts as agreement, because a verdict also depends on where in a step a hit
 * happens.
 */
#include "../hard/workers.h"
#include "../unit/ask.h"
#include "engine/engine.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 64, CYCLES = 4 };

#define STILL     1e-4
#define COARSEST  100.0 /* steps per sqrt(height / g) */
#define FINEST    3200.0
#define ALLOWED   3
#define UNSETTLED 5          /* a last change of more than this many times STILL is an error */
#define BRACKET   4e-5       /* relative width to which growths are bisected */
#define MARCH     0.05       /* r is raised by this step until a row stops */
#define IMPULSES  1e-7       /* tolerance of the impulses in a step */
#define STATURE   (7.0 / 48) /* thickness over height */
#define BEVEL     0.02

static const struct scene {
    double s, q, mu, r; /* r is 0 in a search for the largest growth */
    size_t count;       /* number of dominoes; the first has the height 1, and g is 1 */
    double push, bevel;
} scenes[] = {
#define GROWTHS(q, mu)                                                                                       \
    {0.1, q, mu, 0, 14, 32, 0}, {0.2, q, mu, 0, 10, 16, 0}, {0.3, q, mu, 0, 9, 8, 0},                        \
        {0.4, q, mu, 0, 9, 8, 0}, {0.5, q, mu, 0, 9, 8, 0},                                                  \
    {                                                                                                        \
        0.6, q, mu, 0, 9, 8, 0                                                                               \
    }
#define DURATIONS(q, mu, r, count)                                                                           \
    {0.3, q, mu, r, count, 1, 0}, {0.4, q, mu, r, count, 1, 0},                                              \
    {                                                                                                        \
        0.6, q, mu, r, count, 1, 0                                                                           \
    }
    GROWTHS(3, 0),
    GROWTHS(4, 0),
    GROWTHS(3, 0.2),
    GROWTHS(4, 0.2),
    DURATIONS(3, 0, 1, 40),
    DURATIONS(3, 0, 1.2, 14),
    DURATIONS(4, 0, 1.2, 14),
    DURATIONS(3, 0.2, 1, 40),
    DURATIONS(3, 0.2, 1.2, 14),
    DURATIONS(4, 0.2, 1.2, 14),
};
enum { SCENES = sizeof scenes / sizeof *scenes };

/* A value of the engine, and its uncertainty. */
struct found {
    double value;
    /* the change of the value when the steps were last halved, or half of the change before if that is larger
     */
    double change, steps;
    bool same;          /* true if neither two more dominoes nor more exact impulses change the value */
    bool other_contact; /* true if a run had a contact that the model does not have */
};

/* ---- The engine ---- */

static struct engine_hit hits[MOST]; /* hits of the last run; each scene runs in a separate process */

/* Runs the boxes with found->steps. Divides the tolerance of the impulses by `times`. */
static struct engine_fall run(const struct scene *scene, int times, struct found *found)
{
    struct dom_domino box[MOST];
    const struct engine_row row = {.row = {.domino = box,
                                           .count = scene->count,
                                           .g = 1,
                                           .push = scene->push,
                                           .mu = scene->mu,
                                           .feet = (double)INFINITY},
                                   .bevel = scene->bevel};
    const struct engine_grain grain = {found->steps, IMPULSES / times};
    struct engine_fall fall;
    for (size_t k = 0; k < scene->count; k++) {
        const double h = pow(scene->r, (double)k);
        box[k] = (struct dom_domino){
            .height = h, .thickness = STATURE * h, .gap = scene->s * h, .mass = pow(h, scene->q - 1)};
    }
    if (engine_run(&row, &grain, NULL, hits, NULL, NULL, &fall) != DOM_OK) {
        fprintf(stderr, "s %g, q %g, mu %g, r %.9g: the row does not come to rest in the engine\n", scene->s,
                scene->q, scene->mu, scene->r);
        exit(2);
    }
    found->other_contact |= fall.other_contact;
    return fall;
}

static bool boxes_fall(const struct scene *scene, double r, void *found)
{
    struct scene at = *scene;
    at.r = r;
    return run(&at, 1, found).all;
}

/* ---- The model ---- */

static struct setup train_of(const struct scene *scene)
{
    struct setup train = setup_default();
    train.s = scene->s;
    train.d = STATURE;
    train.q = scene->q;
    train.mu = scene->mu;
    train.r = scene->r;
    return train;
}

static bool hit(const struct domq_fall *fall, void *context)
{
    double **next = context;
    *(*next)++ = (double)fall->time;
    return true;
}

/* Returns true if the dominoes fall. `next` is NULL, or points to a pointer to an array that receives the
 * times of the hits. */
static bool dominoes_fall(const struct scene *scene, double r, void *next)
{
    struct domq_domino domino[MOST];
    const struct domq_scale unit = {.h = 1, .g = 1};
    struct domq_verdict verdict;
    struct setup train = train_of(scene);
    struct row_setup row = row_setup_default(domino, scene->count, scene->push);
    train.r = r;
    row.g = 1;
    row.mu = scene->mu;
    ask_row_of_train(&train, &unit, 1, domino, scene->count);
    const enum dom_status status = ask_row_run(&row, next, next ? hit : NULL, next, &verdict);
    if (status != DOM_OK || verdict.end == DOM_ROW_PARTS || verdict.end == DOM_ROW_PASSES) {
        fprintf(stderr, "s %g, q %g, mu %g, r %.9g: %s\n", scene->s, scene->q, scene->mu, r,
                status == DOM_OK ? dom_row_end_text(verdict.end) : dom_status_text(status));
        exit(2);
    }
    return verdict.end == DOM_ROW_FALLS;
}

/* ---- The growth, in the engine or in the model ---- */

typedef bool falls(const struct scene *scene, double r, void *context);

/*
 * Bisects to a relative width from a growth at which the row falls to one at which it stops. r is raised from
 * `lo` until the row stops, in steps that become small near r s = 1, beyond which the next box is out of
 * reach. Larger growths at which the row falls again do not count. If the row stops at `lo`, r is lowered
 * first.
 */
static double largest(const struct scene *scene, falls *fall, void *context, double lo, double step,
                      double width)
{
    for (; lo > 1 && !fall(scene, lo, context); step *= 2)
        lo = fmax(1, lo - step);
    double hi = lo + step;
    while (fall(scene, hi, context)) {
        lo = hi;
        hi += fmin(step, step / 50 + fmax(0, 1 / scene->s - lo) / 10);
    }
    while (hi - lo > width) {
        const double middle = (lo + hi) / 2;
        *(fall(scene, middle, context) ? &lo : &hi) = middle;
    }
    return (lo + hi) / 2;
}

/* Finds the engine's value with found->steps. On entry, found->value is the value with coarser steps, or 0 if
 * there is none, and found->change is its last change. */
static double growth(const struct scene *scene, struct found *found)
{
    if (found->value == 0)
        return largest(scene, boxes_fall, found, 1, MARCH, MARCH / 100);
    const double reach = 1 / scene->s - found->value,
                 off = fmax(2 * BRACKET, fmin(2 * found->change, fmin(MARCH / 10, reach / 3)));
    return largest(scene, boxes_fall, found, fmax(1, found->value - off), off, BRACKET);
}

/* ---- The mean duration of the last cycles, from hit to hit, each in tau of its head ---- */

/* Returns the sum of tau (1; a1) of the boxes before the last one that was hit, for solid blocks. */
static double taus(const struct scene *scene)
{
    double sum = 0;
    for (size_t k = 2; k < 2 + CYCLES; k++) {
        const struct domq_scale scale = {.h = pow(scene->r, (double)(scene->count - k)), .g = 1};
        sum += (double)domq_scale_tau(&scale, &(struct domq_train){.d = STATURE});
    }
    return sum;
}

static double duration_of(const struct scene *scene, int times, struct found *found)
{
    const struct engine_fall fall = run(scene, times, found);
    const size_t last = scene->count - 1;
    return fall.hits < scene->count ? (double)NAN
                                    : (hits[last].time - hits[last - CYCLES].time) / taus(scene);
}

static double duration(const struct scene *scene, struct found *found)
{
    return duration_of(scene, 1, found);
}

static double duration_of_row(const struct scene *scene)
{
    double time[MOST], *next = time;
    const size_t last = scene->count - 1;
    return dominoes_fall(scene, scene->r, &next) ? (time[last] - time[last - CYCLES]) / taus(scene)
                                                 : (double)NAN;
}

/* ---- The engine, refined ---- */

static double uncertain(const struct found *found)
{
    return ALLOWED * fmax(STILL, found->change / found->value);
}

/* Halves the length of the steps until the value has settled. Each halving leaves half of a first-order
 * error, so durations are extrapolated to steps of length 0. A single small change does not count, since it
 * may be due to chance. */
static void refine(const struct scene *scene, struct found *found)
{
    const bool grows = scene->r == 0;
    double earlier = (double)INFINITY, value;
    *found = (struct found){.steps = COARSEST};
    found->value = value = (grows ? growth : duration)(scene, found);
    do {
        const double before = found->value, coarse = value;
        *found = (struct found){.value = value, .change = earlier, .steps = 2 * found->steps};
        value = (grows ? growth : duration)(scene, found);
        found->value = grows ? value : 2 * value - coarse;
        const double change = fabs(found->value - before);
        found->change = fmax(change, earlier / 2);
        earlier = change;
    } while (!(found->change <= STILL * found->value) && found->steps < FINEST);

    struct scene more = *scene;
    more.count += 2;
    if (!grows) {
        found->same = fabs(duration_of(&more, 100, found) / duration(scene, found) - 1) <= uncertain(found);
        return;
    }
    found->same = true;
    for (int side = -1; side <= 1; side += 2) {
        more.r = found->value * (1 + side * uncertain(found));
        found->same &= run(&more, 100, found).all == (side < 0);
    }
}

/* ---- Each scene ---- */

/* A value of the engine beside those of the model, for the same row and for the endless train. */
struct answer {
    struct found found;
    double row, train;
    bool bevelled;
};

static double off(double engine, double model)
{
    return engine / model - 1;
}

static bool agrees(const struct answer *a)
{
    return a->found.same && a->found.change <= UNSETTLED * STILL * a->found.value &&
           fabs(off(a->found.value, a->row)) <= uncertain(&a->found) &&
           fabs(off(a->found.value, a->train)) <= uncertain(&a->found);
}

/*
 * A domino that slides off the domino that it leaned on may meet the lower edge of that domino, and continue
 * to push. The model does not have this contact. If the upper back edges are bevelled, with the same mass and
 * inertia, it does not occur.
 */
static long solve(int job, void *context)
{
    struct answer *a = (struct answer *)context + job;
    struct scene scene = scenes[job];
    const struct setup train = train_of(&scene);
    struct domq_limit limit;
    domq_real lasts;
    fprintf(stderr, "verify: scene %d of %d\n", job + 1, SCENES);
    a->train = (double)NAN;
    if (scene.r > 0 && ask_cycle_duration(&train, &lasts) == DOM_OK)
        a->train = (double)lasts;
    if (scene.r == 0 && ask_limit_rmax(&train, &limit) == DOM_OK)
        a->train = (double)limit.r_max;
    a->row = scene.r > 0 ? duration_of_row(&scene) : largest(&scene, dominoes_fall, NULL, 1, MARCH, 1e-10);
    refine(&scene, &a->found);
    a->bevelled = scene.r == 0 && a->found.other_contact && fabs(off(a->found.value, a->row)) > STILL;
    if (a->bevelled) {
        scene.bevel = BEVEL;
        refine(&scene, &a->found);
    }
    return 0;
}

int main(void)
{
    struct answer *answers = workers_share(SCENES * sizeof *answers);
    int wrong = 0;
    if (!engine_version()) {
        fprintf(stderr, "verify: Chipmunk 7 is not installed; 'make deps verify' installs it\n");
        return 2;
    }
    if (workers_run(SCENES, solve, answers) != 0) {
        fprintf(stderr, "verify: a scene failed\n");
        return 2;
    }
    printf(
        "The largest growth r, or the duration of a cycle of a given r, in Chipmunk %s and in the model.\n"
        "change: by the last halving of the steps; off: engine / model - 1; *: upper edges are bevelled\n\n"
        "s    q  mu   r      engine  change %%  steps       row   off %%     train   off %%\n",
        engine_version());
    for (int k = 0; k < SCENES; k++) {
        const struct scene *s = &scenes[k];
        const struct answer *a = &answers[k];
        printf("%.1f  %.0f  %3.1f  %3.1f  %9.6f  %7.4f  %6g  %8.6f  %+6.3f  %8.6f  %+6.3f%s%s\n", s->s, s->q,
               s->mu, s->r, a->found.value, 100 * a->found.change / a->found.value, a->found.steps, a->row,
               100 * off(a->found.value, a->row), a->train, 100 * off(a->found.value, a->train),
               a->bevelled ? " *" : "", agrees(a) ? "" : " WRONG");
        wrong += !agrees(a);
    }
    printf("\nverify: %d scenes, %d wrong\n", SCENES, wrong);
    workers_unshare(answers, SCENES * sizeof *answers);
    return wrong > 0;
}
