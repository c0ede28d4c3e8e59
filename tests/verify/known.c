/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compares the largest growths of rows of 12 hollow dominoes in the engine with known values.
 *
 * For feet that slip, and for bounces, the known values come from an earlier computation by other code with
 * the same engine. That code made 20 iterations for the impulses of a step, whereas here the impulses have
 * converged. For feet that slip, the largest difference is 0.015, at s = 0.2 with a floor friction of 1.
 * Twice as many steps reduce this difference to 0.012.
 *
 * For slopes and rounded edges, the known values are the growths of the endless train by the library's
 * equations. For the three radii at s = 0.3, the earlier computation found 1.877, 1.939 and 2.098. These are
 * up to 0.006 larger than the growths by the equations and in this engine. In both, rounded feet roll.
 *
 * At s = 0.4, dominoes that have fallen continue to push (verify.c). The known growths leave this push out.
 * This engine finds:
 *
 *   bounce   sharp upper edges   bevelled upper edges
 *   0        2.090               2.063
 *   0.3      2.099               2.063
 *   0.5      2.119               2.075 (bevel 0.01), 2.063 (bevel 0.02)
 *
 * The known growth for a bounce of 0.5 is 2.101. It lies between the growths with sharp and with bevelled
 * edges, and is not compared.
 */
#include "known.h"
#include "../hard/workers.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>

enum { DOMINOES = 12, FLOORS = 6, ROWS = 6 };
static const double push = 8; /* this push lifts the first domino off a floor without hinges */
static const struct engine_grain grain = {400, 2e-4};
static const double found_to = 0.0005;

/* ---- Feet ---- */

static const double floors[FLOORS] = {0.2, 0.3, 0.4, 0.5, 0.6, 1};

/* A growth of 0 is not compared, because the first domino is thrown so far that the answer depends on how it
 * starts. */
static const struct {
    double s, mu, growth[FLOORS];
} feet[ROWS] = {
    {0.2, 0, {0, 0, 0, 1.463, 1.483, 1.543}},
    {0.3, 0, {0, 1.567, 1.638, 1.768, 1.822, 1.819}},
    {0.4, 0, {0, 1.691, 1.852, 1.917, 1.991, 2.110}},
    {0.2, 0.2, {0, 0, 1.448, 1.454, 1.454, 1.448}},
    {0.3, 0.2, {1.543, 1.626, 1.685, 1.679, 1.682, 1.682}},
    {0.4, 0.2, {1.611, 1.709, 1.822, 1.872, 1.866, 1.840}},
};

/* ---- Slope, edges, bounce ---- */

#define DEGREE (M_PI / 180)
static const struct {
    struct scene scene;
    double growth, off;
} others[] = {
    {{.s = 0.2, .slope = -DEGREE}, 1.48052, 0.003},
    {{.s = 0.2, .slope = DEGREE}, 1.64507, 0.003},
    {{.s = 0.3, .slope = -DEGREE}, 1.71622, 0.003},
    {{.s = 0.3, .slope = DEGREE}, 1.93065, 0.003},
    {{.s = 0.4, .slope = -DEGREE}, 1.93981, 0.003},
    {{.s = 0.4, .slope = DEGREE}, 2.22126, 0.003},
    {{.s = 0.3, .radius = 0.005}, 1.87111, 0.003},
    {{.s = 0.3, .radius = 0.01}, 1.93580, 0.003},
    {{.s = 0.3, .radius = 0.02}, 2.09291, 0.003},
    {{.s = 0.3, .bounce = 0.2}, 1.8135, 0.004},
    {{.s = 0.2, .bounce = 0.3}, 1.529, 0.01},
    {{.s = 0.3, .bounce = 0.3}, 1.812, 0.01},
    {{.s = 0.2, .bounce = 0.5}, 1.407, 0.01},
    {{.s = 0.3, .bounce = 0.5}, 1.716, 0.01},
    {{.s = 0.4, .bounce = 0.3, .bevel = 0.02}, 2.063, 0.004},
};

enum { OTHERS = sizeof others / sizeof *others, JOBS = ROWS * FLOORS + OTHERS };

struct job {
    struct scene scene;
    double known, off, found; /* `found` is NaN unless it is within 2 * off of `known` */
};

static struct job job_of(int k)
{
    struct job j;

    if (k < ROWS * FLOORS) {
        int row = k / FLOORS, floor = k % FLOORS;

        j = (struct job){.scene = {.s = feet[row].s, .mu = feet[row].mu, .feet = floors[floor]},
                         .known = feet[row].growth[floor],
                         .off = 0.016}; /* the largest difference is 0.015: see the comment above */
    } else {
        j = (struct job){.scene = others[k - ROWS * FLOORS].scene,
                         .known = others[k - ROWS * FLOORS].growth,
                         .off = others[k - ROWS * FLOORS].off};
    }
    j.scene.q = 3;
    j.scene.count = DOMINOES;
    j.scene.push = push;
    j.found = (double)NAN;
    return j;
}

static bool falls(struct scene *scene, double r)
{
    struct engine_fall fall;

    scene->r = r;
    const struct engine_row row = scene_boxes(scene);
    return engine_run(&row, &grain, NULL, NULL, NULL, NULL, &fall) == ENGINE_OK && fall.all;
}

/* Bisects between twice the allowed difference below and above the known growth. */
static long solve(int k, void *context)
{
    struct job *j = (struct job *)context + k;

    *j = job_of(k);
    fprintf(stderr, "verify: growth %d of %d on real floors\n", k + 1, JOBS);
    double lo = j->known - 2 * j->off, hi = j->known + 2 * j->off;
    if (j->known == 0 || !falls(&j->scene, lo) || falls(&j->scene, hi))
        return 0;
    while (hi - lo > found_to) {
        double middle = (lo + hi) / 2;

        *(falls(&j->scene, middle) ? &lo : &hi) = middle;
    }
    j->found = (lo + hi) / 2;
    return 0;
}

static bool agrees(const struct job *j)
{
    return j->known == 0 || fabs(j->found - j->known) <= j->off;
}

static void print_feet(const struct job *jobs)
{
    printf("\nFeet that slip: the largest growth of a row of %d hollow dominoes, by the friction of the "
           "floor, and\n"
           "in brackets what is known. The first domino gets a push of %g sqrt(g / h); - where the answer\n"
           "depends on the push.\n\ns    mu ",
           DOMINOES, push);
    for (int floor = 0; floor < FLOORS; floor++)
        printf("  floor %-7g", floors[floor]);
    for (int k = 0; k < ROWS * FLOORS; k++) {
        const struct job *j = &jobs[k];

        if (k % FLOORS == 0)
            printf("\n%.1f  %.1f", j->scene.s, j->scene.mu);
        if (j->known == 0)
            printf("  %-13s", "-");
        else
            printf("  %.3f (%.3f)%s", j->found, j->known, agrees(j) ? "" : "!");
    }
    printf("\n");
}

static void print_others(const struct job *jobs)
{
    printf("\nSlope in degrees, radius of edges over the height, bounce: the largest growth.\n\n"
           "s    slope  radius  bounce  engine  known\n");
    for (int k = 0; k < OTHERS; k++) {
        const struct scene *s = &jobs[k].scene;

        printf("%.1f  %5.0f  %6g  %6g  %.4f  %.4f%s\n", s->s, s->slope / DEGREE, s->radius, s->bounce,
               jobs[k].found, jobs[k].known, agrees(&jobs[k]) ? "" : " !");
    }
}

int known_compare(void)
{
    struct job *jobs = workers_share(JOBS * sizeof *jobs);
    int unlike = 0, compared = 0;

    if (workers_run(JOBS, solve, jobs) != 0)
        return JOBS;
    print_feet(jobs);
    print_others(jobs + ROWS * FLOORS);
    for (int k = 0; k < JOBS; k++) {
        compared += jobs[k].known > 0;
        unlike += !agrees(&jobs[k]);
    }
    printf(
        "\nknown: %d growths on real floors compared, %d differ; %d are not compared, since they depend on "
        "the push\n",
        compared, unlike, JOBS - compared);
    workers_unshare(jobs, JOBS * sizeof *jobs);
    return unlike;
}
