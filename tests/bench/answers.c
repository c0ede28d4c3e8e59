/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes answers for `make guard`, and prints their names. Each answer is one call of answer(), and
 * callgrind counts the instructions of each call.
 *
 * usage: answers [NAME]     computes all answers, or one
 */
#include "domino_float.h"
#include "domino_study.h"
#include "shell/precision/any.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROW = 20, ROWS = 60, POINTS = 12 };

/* An answer, and the parameters for which it is computed. A parameter that is 0 has its default. */
struct counted {
    const char *name;
    /* The answer is that of `ask` or, if it is NULL, that of dom_trains_ask to `question`. */
    enum dom_status (*ask)(const struct dom_train *train, const struct dom_compute *compute);
    enum dom_question question;
    double s, r, q, mu, rho;
};

/* These two compute r_max of the default train in another precision. */
static enum dom_status ask_float(const struct dom_train *train, const struct dom_compute *compute)
{
    const struct domf_train in_float = domf_train_default();
    struct domf_limit limit;
    (void)train, (void)compute;
    return domf_limit_rmax(&in_float, NULL, &limit);
}

static enum dom_status ask_quad(const struct dom_train *train, const struct dom_compute *compute)
{
    const struct domq_train in_quad = domq_train_default();
    struct domq_limit limit;
    (void)train, (void)compute;
    return domq_limit_rmax(&in_quad, NULL, &limit);
}

/* Computes r_max for s from 0.02 to 0.9, with both values of q, as the benchmark does. */
static enum dom_status ask_curve(const struct dom_train *train, const struct dom_compute *compute)
{
    enum dom_status status = DOM_OK;
    struct dom_train at = *train;
    for (int i = 0; i < 2 * POINTS && status == DOM_OK; i++) {
        at.q = i < POINTS ? 3 : 4;
        at.s = 0.02 + 0.88 * (i % POINTS) / (POINTS - 1);
        struct dom_limit limit;
        status = dom_limit_rmax(&at, compute, &limit);
    }
    return status;
}

static enum dom_status ask_events(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_event events[DOM_EVENTS_MAX];
    int count;
    return dom_cycle_events(train, compute, events, &count);
}

static enum dom_status ask_floor(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_floor floor;
    return dom_cycle_floor(train, compute, &floor);
}

static bool visit_link(const struct dom_link *link, void *context)
{
    (void)link, (void)context;
    return true;
}

static enum dom_status ask_chain(const struct dom_train *train, const struct dom_compute *compute)
{
    return dom_chain_walk(train, compute, 0.1, visit_link, NULL);
}

static enum dom_status ask_count(const struct dom_train *train, const struct dom_compute *compute)
{
    (void)compute;
    struct dom_count count;
    return dom_count_find(0.048, 112, train->r, &count);
}

static struct dom_row row_of(const struct dom_train *train, struct dom_domino *domino)
{
    struct dom_scale scale = dom_scale_default();
    dom_row_of_train(train, &scale, 1, domino, ROW);
    return (struct dom_row){
        .domino = domino, .count = ROW, .g = scale.g, .push = 6, .mu = train->mu, .rho = train->rho};
}

static enum dom_status ask_verdict(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_domino domino[ROW];
    struct dom_verdict verdict;
    struct dom_row row = row_of(train, domino);
    return dom_row_run(&row, compute, false, NULL, NULL, &verdict);
}

static enum dom_status ask_row(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_domino domino[ROW];
    struct dom_verdict verdict;
    struct dom_row row = row_of(train, domino);
    return dom_row_run(&row, compute, true, NULL, NULL, &verdict);
}

static enum dom_status ask_study(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_domino domino[ROW];
    struct dom_study study;
    struct dom_row row = row_of(train, domino);
    struct dom_placement placement = {.error[DOM_ERROR_gap].size = 1e-3, .seed = 1, .rows = ROWS};
    struct dom_compute with = *compute;
    with.work = NULL;
    return dom_placement_study(&row, &with, &placement, &study, NULL);
}

static enum dom_status ask_windows(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_domino domino[ROW];
    struct dom_window windows[ROW];
    struct dom_row row = row_of(train, domino);
    return dom_row_windows(&row, compute, DOM_WINDOW_GAP, NULL, NULL, windows);
}

static const struct counted table[] = {
    {.name = "rmax 0.05 hollow", .question = DOM_ASK_RMAX, .s = 0.05, .q = 3},
    {.name = "rmax 0.2 hollow", .question = DOM_ASK_RMAX, .s = 0.2, .q = 3},
    {.name = "rmax 0.5 hollow", .question = DOM_ASK_RMAX, .s = 0.5, .q = 3},
    {.name = "rmax 0.05 massive", .question = DOM_ASK_RMAX, .s = 0.05},
    {.name = "rmax 0.2 massive", .question = DOM_ASK_RMAX, .s = 0.2},
    {.name = "rmax 0.5 massive", .question = DOM_ASK_RMAX, .s = 0.5},
    {.name = "rmax float", .ask = ask_float},
    {.name = "rmax quad", .ask = ask_quad},
    {.name = "rmax with edges", .question = DOM_ASK_RMAX, .rho = 0.01},
    {.name = "rmax with friction", .question = DOM_ASK_RMAX, .mu = 0.2},
    {.name = "curve", .ask = ask_curve},
    {.name = "pair", .question = DOM_ASK_PAIR},
    {.name = "best", .question = DOM_ASK_BEST},
    {.name = "barrier", .question = DOM_ASK_BARRIER},
    {.name = "duration", .question = DOM_ASK_DURATION},
    {.name = "duration hollow", .question = DOM_ASK_DURATION, .q = 3},
    {.name = "duration with friction", .question = DOM_ASK_DURATION, .r = 1.2, .mu = 0.2},
    {.name = "events", .ask = ask_events},
    {.name = "floor", .ask = ask_floor},
    {.name = "chain", .ask = ask_chain},
    {.name = "chain of a close train", .ask = ask_chain, .s = 0.1, .r = 1},
    {.name = "count", .ask = ask_count},
    {.name = "verdict", .ask = ask_verdict, .r = 1.1},
    {.name = "row", .ask = ask_row, .r = 1.1},
    {.name = "row with friction", .ask = ask_row, .r = 1.1, .mu = 0.2},
    {.name = "placement", .ask = ask_study, .r = 1.1},
    {.name = "placement with edges", .ask = ask_study, .r = 1.1, .rho = 0.02},
    {.name = "placement with friction", .ask = ask_study, .r = 1.1, .mu = 0.2},
    {.name = "placement with edges and friction", .ask = ask_study, .r = 1.1, .rho = 0.02, .mu = 0.2},
    {.name = "windows of equal dominoes", .ask = ask_windows, .r = 1},
};

/* Answers one question. Callgrind looks for calls of this function, so it must keep its name and must not be
 * inlined. */
__attribute__((noinline)) enum dom_status answer(const struct counted *counted, const struct dom_train *train,
                                                 const struct dom_compute *compute);

enum dom_status answer(const struct counted *counted, const struct dom_train *train,
                       const struct dom_compute *compute)
{
    union {
        struct dom_limit limit;
        struct dom_best best;
        struct dom_barrier barrier;
        dom_real number;
    } found;
    enum dom_status status;
    if (counted->ask)
        return counted->ask(train, compute);
    dom_trains_ask(counted->question, train, NULL, 1, compute, &found, &status);
    return status;
}

int main(int argc, char **argv)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const struct counted *counted = &table[i];
        struct dom_train train = dom_train_default();
        const struct dom_compute compute = dom_compute_default();
        if (argc > 1 && strcmp(argv[1], counted->name) != 0)
            continue;
        train.s = counted->s > 0 ? counted->s : train.s;
        train.r = counted->r > 0 ? counted->r : train.r;
        train.q = counted->q > 0 ? counted->q : train.q;
        train.mu = counted->mu;
        train.rho = counted->rho;
        enum dom_status status = answer(counted, &train, &compute);
        if (status != DOM_OK) {
            fprintf(stderr, "answers: %s: %s\n", counted->name, dom_status_text(status));
            return EXIT_FAILURE;
        }
        puts(counted->name);
    }
    return EXIT_SUCCESS;
}
