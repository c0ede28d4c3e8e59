/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const double scene_still = 1e-4, scene_finest = 3200, scene_allowed = 3, scene_bracket = 4e-5;

static const double coarsest = 100;     /* steps */
static const double march = 0.05;       /* r is raised by this step until a row stops */
static const double tolerance = 1e-7;   /* tolerance of the impulses in a step */
static const double stature = 7.0 / 48; /* thickness over height */

/* ---- The engine ---- */

struct engine_row scene_boxes(const struct scene *scene)
{
    static struct engine_box box[SCENE_MOST]; /* static, since each scene runs in a separate process */
    struct engine_row row = ENGINE_ROW(box, scene->count);

    row.push = scene->push;
    row.mu = scene->mu;
    row.bevel = scene->bevel;
    for (size_t k = 0; k < scene->count; k++) {
        double h = pow(scene->r, (double)k);

        box[k] = (struct engine_box){
            .height = h, .thickness = stature * h, .gap = scene->s * h, .mass = pow(h, scene->q - 1)};
    }
    return row;
}

static struct engine_hit hits[SCENE_MOST]; /* hits of the last run */

/* Runs the boxes with found->steps. Divides the tolerance of the impulses by `times`. */
static struct engine_fall run(const struct scene *scene, int times, struct found *found)
{
    struct engine_row row = scene_boxes(scene);
    struct engine_grain grain = {found->steps, tolerance / times};
    struct engine_fall fall;

    if (engine_run(&row, &grain, NULL, hits, NULL, NULL, &fall) != ENGINE_OK) {
        fprintf(stderr, "s %g, q %g, mu %g, r %.9g: the row does not come to rest in the engine\n", scene->s,
                scene->q, scene->mu, scene->r);
        exit(2);
    }
    found->depth = fmax(found->depth, fall.depth);
    found->drift = fmax(found->drift, fall.drift);
    found->other_contact |= fall.other_contact;
    return fall;
}

static bool boxes_fall(const struct scene *scene, double r, void *context)
{
    struct scene at = *scene;

    at.r = r;
    return run(&at, 1, context).all;
}

/* ---- The model ---- */

struct setup scene_train(const struct scene *scene)
{
    struct setup train = setup_default();

    train.s = scene->s;
    train.d = stature;
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
    struct scene at = *scene;
    struct domq_domino domino[SCENE_MOST];
    struct domq_scale unit = {.h = 1, .g = 1};
    struct domq_verdict verdict;

    at.r = r;
    struct setup train = scene_train(&at);
    struct row_setup row = {.domino = domino,
                            .count = scene->count,
                            .g = 1,
                            .push = scene->push,
                            .mu = scene->mu,
                            .tol = 1e-10,
                            .precision = IN_DOUBLE};
    ask_row_of_train(&train, &unit, 1, domino, scene->count);
    enum dom_status status = ask_row_run(&row, next, next ? hit : NULL, next, &verdict);

    if (status != DOM_OK || verdict.end == DOM_ROW_PARTS || verdict.end == DOM_ROW_PASSES) {
        fprintf(stderr, "s %g, q %g, mu %g, r %.9g: %s\n", scene->s, scene->q, scene->mu, r,
                status == DOM_OK ? dom_row_end_text(verdict.end) : dom_status_text(status));
        exit(2);
    }
    return verdict.end == DOM_ROW_FALLS;
}

/* ---- The growth, in the engine or in the model ---- */

typedef bool falls(const struct scene *scene, double r, void *context);

static double bisect(const struct scene *scene, falls *fall, void *context, double lo, double hi,
                     double width)
{
    while (hi - lo > width) {
        double middle = (lo + hi) / 2;

        *(fall(scene, middle, context) ? &lo : &hi) = middle;
    }
    return (lo + hi) / 2;
}

/*
 * Finds the largest r at which the row falls. r is raised from 1 until the row stops, in steps that become
 * small near r s = 1, beyond which the next box is out of reach. Larger growths at which the row falls again
 * do not count.
 */
static double largest(const struct scene *scene, falls *fall, void *context, double width)
{
    double r = 1, next = 1 + march;

    while (fall(scene, next, context)) {
        r = next;
        next += fmin(march, march / 50 + fmax(0, 1 / scene->s - r) / 10);
    }
    return bisect(scene, fall, context, r, next, width);
}

/* Finds the growth again, near a first estimate. Moves the bracket if the estimate was wrong. */
static double again(const struct scene *scene, falls *fall, void *context, double r, double off, double width)
{
    double lo = r - off, hi = r + off;

    for (double far = off; !fall(scene, lo, context) && lo > 1; far *= 2) {
        hi = lo;
        lo = fmax(1, lo - far);
    }
    for (double far = off; fall(scene, hi, context); far *= 2) {
        lo = hi;
        hi += far;
    }
    return bisect(scene, fall, context, lo, hi, width);
}

double scene_growth_of_row(const struct scene *scene)
{
    return largest(scene, dominoes_fall, NULL, 1e-10);
}

/* ---- The engine, refined ---- */

/* Finds the engine's value with found->steps. On entry, found->value is the value with coarser steps, or 0 if
 * there is none, and found->change is its last change. */
typedef double answer(const struct scene *scene, struct found *found);

static double growth(const struct scene *scene, struct found *found)
{
    if (found->value == 0)
        return largest(scene, boxes_fall, found, march / 100);
    double reach = 1 / scene->s - found->value;
    double off = fmax(2 * scene_bracket, fmin(2 * found->change, fmin(march / 10, reach / 3)));

    return again(scene, boxes_fall, found, found->value, off, scene_bracket);
}

/* Returns the sum of tau (1; a1) of the boxes before the last one that was hit, for solid blocks. */
static double taus(const struct scene *scene)
{
    double sum = 0;

    for (size_t k = 2; k < 2 + SCENE_CYCLES; k++) {
        struct domq_scale scale = {.h = pow(scene->r, (double)(scene->count - k)), .g = 1};

        sum += (double)domq_scale_tau(&scale, &(struct domq_train){.d = stature});
    }
    return sum;
}

static double duration_of(const struct scene *scene, int times, struct found *found)
{
    struct engine_fall fall = run(scene, times, found);
    size_t last = scene->count - 1;

    if (fall.hits < scene->count)
        return (double)NAN;
    return (hits[last].time - hits[last - SCENE_CYCLES].time) / taus(scene);
}

static double duration(const struct scene *scene, struct found *found)
{
    return duration_of(scene, 1, found);
}

/* Halves the length of the steps until the value has settled. Each halving leaves half of a first-order
 * error. A single small change does not count, since it may be due to chance. */
static void refine(const struct scene *scene, answer *ask, bool extrapolate, struct found *found)
{
    double earlier = (double)INFINITY;

    *found = (struct found){.steps = coarsest};
    double value = ask(scene, found);

    found->value = value;
    do {
        double before = found->value, coarse = value;

        *found = (struct found){.value = value, .change = earlier, .steps = 2 * found->steps};
        value = ask(scene, found);
        found->value = extrapolate ? 2 * value - coarse : value;
        double change = fabs(found->value - before);

        found->change = fmax(change, earlier / 2);
        earlier = change;
    } while (!(found->change <= scene_still * found->value) && found->steps < scene_finest);
}

/* Returns the scene with two more dominoes. */
static struct scene more_of(const struct scene *scene)
{
    struct scene more = *scene;

    more.count += 2;
    return more;
}

double scene_uncertain(const struct found *found)
{
    return scene_allowed * fmax(scene_still, found->change / found->value);
}

void scene_growth(const struct scene *scene, struct found *found)
{
    struct scene more = more_of(scene);

    refine(scene, growth, false, found);
    found->same = true;
    for (int side = -1; side <= 1; side += 2) {
        more.r = found->value * (1 + side * scene_uncertain(found));
        found->same &= run(&more, 100, found).all == (side < 0);
    }
}

void scene_duration(const struct scene *scene, struct found *found)
{
    struct scene more = more_of(scene);

    refine(scene, duration, true, found);
    found->same = fabs(duration_of(&more, 100, found) / duration(scene, found) - 1) <= scene_uncertain(found);
}

double scene_duration_of_row(const struct scene *scene)
{
    double time[SCENE_MOST], *next = time;
    size_t last = scene->count - 1;

    if (!dominoes_fall(scene, scene->r, &next))
        return (double)NAN;
    return (time[last] - time[last - SCENE_CYCLES]) / taus(scene);
}
