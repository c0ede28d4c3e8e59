/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compares the model with a rigid-body engine: the largest growth at which the same rows fall, and how long a
 * cycle lasts.
 */
#include "../hard/workers.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>

/* A value is wrong if the last halving still changed it by a fraction of more than this many times
 * scene_still. */
static const double unsettled = 5;

static const double masses[] = {3, 4}, frictions[] = {0, 0.2};

/* With so many dominoes and so strong a push, the last dominoes do not depend on the push, so that the row
 * and the train agree. */
static const struct {
    double s, push;
    size_t count;
} growths[] = {{0.1, 32, 14}, {0.2, 16, 10}, {0.3, 8, 9}, {0.4, 8, 9}, {0.5, 8, 9}, {0.6, 8, 9}};
static const struct {
    const char *blocks;
    double r, q;
    size_t count;
} cycles[] = {{"equal", 1, 3, 40}, {"hollow", 1.2, 3, 14}, {"massive", 1.2, 4, 14}};
static const double cycle_separations[] = {0.3, 0.4, 0.6}, cycle_push = 1;
static const double bevel = 0.02;

enum {
    SEPARATIONS = sizeof growths / sizeof *growths,
    CYCLES = sizeof cycles / sizeof *cycles,
    CYCLE_SEPARATIONS = sizeof cycle_separations / sizeof *cycle_separations,
    GROWTHS = SEPARATIONS * 4,
    DURATIONS = CYCLES * CYCLE_SEPARATIONS * 2,
    JOBS = GROWTHS + DURATIONS
};

struct answer {
    struct scene scene;
    struct found found;       /* the value of the engine */
    double row, exact, paper; /* the values of the model; `paper` is NaN if the paper's fuel gives no value */
    bool again;               /* true if the scene is run again with bevelled edges */
    struct found bevelled;
};

static struct scene scene_of(int job)
{
    int i = job % SEPARATIONS, j = (job - GROWTHS) / CYCLE_SEPARATIONS;

    if (job < GROWTHS)
        return (struct scene){.s = growths[i].s,
                              .q = masses[job / SEPARATIONS % 2],
                              .mu = frictions[job / SEPARATIONS / 2],
                              .count = growths[i].count,
                              .push = growths[i].push};
    return (struct scene){.s = cycle_separations[(job - GROWTHS) % CYCLE_SEPARATIONS],
                          .q = cycles[j % CYCLES].q,
                          .mu = frictions[j / CYCLES],
                          .r = cycles[j % CYCLES].r,
                          .count = cycles[j % CYCLES].count,
                          .push = cycle_push};
}

static double off(double engine, double model)
{
    return engine / model - 1;
}

static bool settled(const struct found *found)
{
    return found->change <= unsettled * scene_still * found->value;
}

static bool agrees(const struct found *found, double model)
{
    return fabs(off(found->value, model)) <= scene_uncertain(found);
}

static long solve(int job, void *context)
{
    struct answer *a = (struct answer *)context + job;
    const struct scene *scene = &a->scene;
    struct scene cut;
    struct domq_limit limit;
    domq_real duration;

    a->scene = scene_of(job);
    fprintf(stderr, "verify: scene %d of %d\n", job + 1, JOBS);
    struct setup train = scene_train(scene);
    a->paper = (double)NAN;
    if (job >= GROWTHS) {
        scene_duration(scene, &a->found);
        a->row = scene_duration_of_row(scene);
        a->exact = ask_cycle_duration(&train, &duration) == DOM_OK ? (double)duration : (double)NAN;
        return 0;
    }
    scene_growth(scene, &a->found);
    a->row = scene_growth_of_row(scene);
    a->exact = ask_limit_rmax(&train, &limit) == DOM_OK ? (double)limit.r_max : (double)NAN;
    train.fuel = DOM_FUEL_PAPER;
    if (ask_limit_rmax(&train, &limit) == DOM_OK)
        a->paper = (double)limit.r_max;
    a->again = a->found.other_contact && fabs(off(a->found.value, a->row)) > scene_still;
    if (a->again) {
        cut = *scene;
        cut.bevel = bevel;
        scene_growth(&cut, &a->bevelled);
    }
    return 0;
}

/* ---- What is printed ---- */

static const char *blocks(const struct scene *scene)
{
    return scene->r == 1 ? "equal" : scene->q == masses[0] ? "hollow" : "massive";
}

/* Returns the name of the fuel formula whose value is within the allowed difference. */
static const char *supports(const struct found *found, const struct answer *a)
{
    bool exact = agrees(found, a->exact), paper = agrees(found, a->paper);

    return exact && paper ? "both" : exact ? "exact" : paper ? "paper" : "neither";
}

static void print_scene(const struct answer *a, const struct found *found)
{
    printf("%.1f  %-7s  %3.1f", a->scene.s, blocks(&a->scene), a->scene.mu);
    if (a->scene.r > 0)
        printf("  %3.1f", a->scene.r);
    printf("  %8.6f  %6.4f  %5g", found->value, 100 * found->change / found->value, found->steps);
}

static void print_model(const struct found *found, double model)
{
    if (isfinite(model))
        printf("  %8.6f %+7.3f", model, 100 * off(found->value, model));
    else
        printf("  %8s %7s", "-", "");
}

static void print_growth(const struct answer *a, const struct found *found, const char *note)
{
    print_scene(a, found);
    print_model(found, a->row);
    print_model(found, a->exact);
    print_model(found, a->paper);
    printf("  %s%s\n", supports(found, a), note);
}

static void print_growths(const struct answer *answers)
{
    printf("The largest growth r at which a row falls: in Chipmunk %s (engine), in the model for the\n"
           "same row (row), and for the endless train with the fuel from the energy balance (exact)\n"
           "and with the paper's closed form (paper; without friction).  off: engine / model - 1, in %%.\n\n"
           "s    blocks    mu    engine  last %%  steps       row     off     exact     off"
           "     paper     off  supports\n",
           engine_version());
    for (int k = 0; k < GROWTHS; k++) {
        print_growth(&answers[k], &answers[k].found, answers[k].again ? "*" : "");
        if (answers[k].again)
            print_growth(&answers[k], &answers[k].bevelled, ", bevelled");
    }
}

static void print_durations(const struct answer *answers)
{
    printf("\nHow long a cycle takes deep in a row, from hit to hit, in tau of its head: the mean of %d.\n\n"
           "s    blocks    mu    r    engine  last %%  steps       row     off     exact     off\n",
           SCENE_CYCLES);
    for (int k = 0; k < DURATIONS; k++) {
        print_scene(&answers[k], &answers[k].found);
        print_model(&answers[k].found, answers[k].row);
        print_model(&answers[k].found, answers[k].exact);
        printf("\n");
    }
}

/* ---- The verdict ---- */

struct tally {
    int wrong, again;
    /* number of scenes in which the two fuels differ, and how many of these agree with the paper's fuel */
    int differ, paper;
    double most;       /* the largest deviation of values that must agree */
    double again_most; /* the largest deviation where fallen dominoes continue to push */
    double depth, drift;
};

static double deviation(const struct found *found, const struct answer *a)
{
    return fmax(fabs(off(found->value, a->row)), fabs(off(found->value, a->exact)));
}

static void judge(struct tally *tally, const struct answer *a)
{
    const struct found *found = a->again ? &a->bevelled : &a->found;

    if (a->again) {
        tally->again++;
        tally->again_most = fmax(tally->again_most, deviation(&a->found, a));
    }
    tally->most = fmax(tally->most, deviation(found, a));
    tally->depth = fmax(tally->depth, found->depth);
    tally->drift = fmax(tally->drift, found->drift);
    if (fabs(off(a->paper, a->exact)) > scene_allowed * scene_still) {
        tally->differ++;
        tally->paper += agrees(found, a->paper) || agrees(&a->found, a->paper);
    }
    if (settled(found) && found->same && agrees(found, a->row) && agrees(found, a->exact))
        return;
    tally->wrong++;
    printf("wrong: s %g, %s, mu %g: %s\n", a->scene.s, blocks(&a->scene), a->scene.mu,
           !settled(found) ? "shorter steps still change the value"
           : !found->same  ? "two more dominoes, or more exact impulses, change the value"
                           : "the difference is larger than is allowed");
}

static void print_tally(const struct tally *tally)
{
    if (tally->again > 0)
        printf(
            "* A domino slides off the domino that it leaned on. Its upper end then meets the lower edge of\n"
            "  that domino, and continues to push. The model does not have this contact. If the upper\n"
            "  back edges are bevelled by %g %% of the height, with the same mass and inertia, it does not\n"
            "  occur.\n\n",
            100 * bevel);
    printf(
        "Steps per sqrt(h / g) are doubled until the value changes by less than %g %% (last %%), or up to\n"
        "%g; deviations of up to %g times this change are allowed. Growths are bisected to %g;\n"
        "durations are extrapolated to steps of 0. The foremost dominoes penetrate each other by up to\n"
        "%.0e of the height, and stray up to %.0e from their hinges. With two more dominoes and\n"
        "more exact impulses, the values change by no more than is allowed.\n",
        100 * scene_still, scene_finest, scene_allowed, scene_bracket, tally->depth, tally->drift);
    printf("In %d scenes the fuels differ by more than is allowed; %d of these support the paper's fuel.\n\n",
           tally->differ, tally->paper);
    printf("verify: %d scenes, %d wrong, largest deviation %.3f %%", JOBS, tally->wrong, 100 * tally->most);
    if (tally->again > 0)
        printf("; %.3f %% in %d (*)", 100 * tally->again_most, tally->again);
    printf("\n");
}

int main(void)
{
    struct answer *answers = workers_share(JOBS * sizeof *answers);
    struct tally tally = {0};

    if (!engine_version()) {
        fprintf(stderr, "verify: Chipmunk 7 is not installed; 'make deps verify' installs it\n");
        return 2;
    }
    if (workers_run(JOBS, solve, answers) != 0) {
        fprintf(stderr, "verify: a scene failed\n");
        return 2;
    }
    print_growths(answers);
    print_durations(answers + GROWTHS);
    printf("\n");
    for (int k = 0; k < JOBS; k++)
        judge(&tally, &answers[k]);
    print_tally(&tally);
    workers_unshare(answers, JOBS * sizeof *answers);
    return tally.wrong > 0;
}
