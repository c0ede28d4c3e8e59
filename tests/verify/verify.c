/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compares rows in a rigid-body engine with the same rows in the model and with endless trains. With so many
 * dominoes and so strong a push, the last dominoes do not depend on the push. Slightly below the largest
 * growth of the train all dominoes of a row must fall, and slightly above it the row must stop. Below it, the
 * last cycles must take as long as a cycle of the train.
 */
#include "../hard/workers.h"
#include "../unit/ask.h"
#include "engine/engine.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 64, CYCLES = 4 };

#define STATURE  (7.0 / 48) /* thickness over height */
#define STEPS    3200.0     /* steps per sqrt(height / g) */
#define IMPULSES 1e-8       /* tolerance of the impulses in a step */
#define BEVEL    0.02
#define ALLOWED  3e-4 /* relative difference of growths and of durations */
/* Steps make the growths of the engine smaller. With s = 0.6 and solid dominoes, the boxes fall again with a
 * growth that is larger by 1.4e-4. */
#define ABOVE 1e-4

static const double separations[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, hollow = 3, solid = 4;

struct scene {
    double s, q, mu, r; /* r is 0 where the largest growth is compared */
    size_t count;       /* number of dominoes; the first has the height 1, and g is 1 */
    double push;
};

/* Fills in scene number `job`. Returns false after the last one. */
static bool scene_find(int job, struct scene *scene)
{
    const int growths = 4 * 6, k = job - growths;
    const double q = job % 2 ? solid : hollow, mu = job / 2 % 2 ? 0.2 : 0, s = separations[job / 4 % 6];
    if (job < growths)
        *scene =
            (struct scene){s, q, mu, 0, s < 0.15 ? 14 : s < 0.25 ? 10 : 9, s < 0.15 ? 32 : s < 0.25 ? 16 : 8};
    else
        *scene = (struct scene){separations[k % 3 == 2 ? 5 : 2 + k % 3],
                                k / 3 % 3 == 2 ? solid : hollow,
                                k / 9 ? 0.2 : 0,
                                k / 3 % 3 == 0 ? 1 : 1.2,
                                k / 3 % 3 == 0 ? 40 : 14,
                                1};
    return k < 18;
}

/* The end of a row: whether all dominoes fall, and the mean duration of the last cycles, from hit to hit,
 * each in tau of its head. */
struct end {
    bool all;
    double duration;
};

/* Finds the mean from the times of hits. tau (1; a1) is that of solid blocks. */
static void end_time(const struct scene *scene, const double *time, struct end *end)
{
    const size_t last = scene->count - 1;
    double taus = 0;
    for (size_t k = last - CYCLES; k < last; k++) {
        const struct domq_scale scale = {.h = pow(scene->r, (double)k), .g = 1};
        taus += (double)domq_scale_tau(&scale, &(struct domq_train){.d = STATURE});
    }
    end->duration = end->all ? (time[last] - time[last - CYCLES]) / taus : (double)NAN;
}

/*
 * Runs the boxes in the engine. A domino that slides off the domino that it leaned on may meet the lower edge
 * of that domino, and continue to push. The model does not have this contact. If the upper back edges are
 * bevelled, with the same mass and inertia, it does not occur.
 */
static struct end boxes_run(const struct scene *scene, double steps)
{
    struct dom_domino box[MOST];
    struct engine_row row = {.row = {.domino = box,
                                     .count = scene->count,
                                     .g = 1,
                                     .push = scene->push,
                                     .mu = scene->mu,
                                     .feet = (double)INFINITY}};
    const struct engine_grain grain = {steps, IMPULSES};
    struct engine_hit hits[MOST];
    struct engine_fall fall;
    struct end end;
    double time[MOST] = {0}, h = 1;
    for (size_t k = 0; k < scene->count; k++, h *= scene->r)
        box[k] = (struct dom_domino){
            .height = h, .thickness = STATURE * h, .gap = scene->s * h, .mass = pow(h, scene->q - 1)};
    do {
        if (engine_run(&row, &grain, NULL, hits, NULL, NULL, &fall) != DOM_OK)
            exit(2);
        if (row.bevel > 0)
            break;
        row.bevel = BEVEL;
    } while (fall.other_contact);
    end.all = fall.all;
    for (size_t k = 0; k < fall.hits; k++)
        time[k] = hits[k].time;
    end_time(scene, time, &end);
    return end;
}

static bool hit(const struct domq_fall *fall, void *context)
{
    double **next = context;
    *(*next)++ = (double)fall->time;
    return true;
}

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

/* Runs the row in the model. */
static struct end dominoes_run(const struct scene *scene)
{
    struct domq_domino domino[MOST];
    const struct domq_scale unit = {.h = 1, .g = 1};
    struct domq_verdict verdict;
    const struct setup train = train_of(scene);
    struct row_setup row = row_setup_default(domino, scene->count, scene->push);
    double time[MOST], *next = time;
    row.g = 1;
    row.mu = scene->mu;
    ask_row_of_train(&train, &unit, 1, domino, scene->count);
    if (ask_row_run(&row, true, hit, &next, &verdict) != DOM_OK)
        exit(2);
    struct end end = {.all = verdict.end == DOM_ROW_FALLS};
    end_time(scene, time, &end);
    return end;
}

/* Prints a scene. Returns 1 if it is wrong. */
static long compare(int job, void *context)
{
    struct scene scene;
    (void)context;
    scene_find(job, &scene);
    struct setup train = train_of(&scene);
    struct domq_limit limit;
    domq_real duration;
    bool right = true;
    if (scene.r == 0) {
        if (ask_limit_rmax(&train, &limit) != DOM_OK)
            exit(2);
        for (int side = 0; side < 2; side++) {
            scene.r = (double)limit.r_max * (side ? 1 + ABOVE : 1 - ALLOWED);
            right &= dominoes_run(&scene).all == !side && boxes_run(&scene, STEPS).all == !side;
        }
        printf("s %.1f  q %g  mu %.1f  largest growth %.6f%s\n", scene.s, scene.q, scene.mu,
               (double)limit.r_max, right ? "" : "  WRONG");
    } else {
        if (ask_cycle_duration(&train, &duration) != DOM_OK)
            exit(2);
        /* Halving the steps leaves half of a first-order error. */
        const double engine = 2 * boxes_run(&scene, STEPS).duration - boxes_run(&scene, STEPS / 2).duration,
                     off[] = {engine / (double)duration - 1,
                              dominoes_run(&scene).duration / (double)duration - 1};
        right = fabs(off[0]) <= ALLOWED && fabs(off[1]) <= ALLOWED;
        printf("s %.1f  q %g  mu %.1f  r %.1f  duration %.6f, engine %+.4f %%, row %+.4f %%%s\n", scene.s,
               scene.q, scene.mu, scene.r, (double)duration, 100 * off[0], 100 * off[1],
               right ? "" : "  WRONG");
    }
    fflush(stdout);
    return !right;
}

int main(void)
{
    struct scene scene;
    int count = 0;
    while (scene_find(count, &scene))
        count++;
    if (!engine_version()) {
        fprintf(stderr, "verify: Chipmunk 7 is not installed; 'make deps verify' installs it\n");
        return 2;
    }
    printf("Growths and durations that agree to %g in Chipmunk %s and in the model\n", ALLOWED,
           engine_version());
    fflush(stdout);
    const long wrong = workers_run(count, compare, NULL);
    if (wrong < 0)
        fprintf(stderr, "verify: a scene failed\n");
    printf("verify: %d scenes, %ld wrong\n", count, wrong);
    return wrong != 0;
}
