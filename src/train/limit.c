/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands that find how much dominoes can grow from one to the next: rmax, pair and best. */
#include "language/quad.h"
#include "train/falling.h"
#include "train/row_start.h"
#include "train/train.h"
#include <math.h>

static domq_real argument_or(const struct arguments *call, int i, domq_real fallback)
{
    return i < call->count ? call->number[i] : fallback;
}

static const char *no_growth(struct domq_limit limit)
{
    return limit.ends != DOM_END_NONE ? NULL
           : limit.why == DOM_NO_FUEL
               ? "no growth possible: at this s and d even equal dominoes (r = 1) "
                 "release no energy, because a fallen domino has as much potential energy as an upright one"
           : limit.why == DOM_LOCKS ? "no growth possible: friction locks even equal dominoes (r = 1)"
           : limit.why == DOM_OUT_OF_REACH
               ? "no growth possible: the edges are so round that even equal dominoes (r = 1) fall past each "
                 "other at this s; use a smaller s"
               : "no growth possible: at this s and d even equal dominoes (r = "
                 "1) have too little energy to keep falling";
}

enum dom_status limits_find(struct domq_train train, const struct any_compute *compute,
                            struct domq_limit *exact, struct domq_limit *paper)
{
    const struct domq_limit none = {.r_max = DOMQ_NAN, .ends = DOM_END_NONE, .open = DOMQ_NAN};
    *exact = *paper = none;
    train.fuel = DOM_FUEL_EXACT;
    const enum dom_status status = any_limit_rmax(&train, compute, exact);
    paper->why = exact->why;
    /* The paper's formula does not cover friction, slopes or rounded edges. */
    if ((status != DOM_OK && status != DOM_OPEN) || domq_first_effect(&train))
        return status;
    train.fuel = DOM_FUEL_PAPER;
    const enum dom_status of_paper = any_limit_rmax(&train, compute, paper);
    return of_paper == DOM_OK ? status : of_paper;
}

static const struct column rmax_columns[] = {
    {"s", "h", "separation: the gap divided by the height", 0},
    {"r_max", "", "largest growth at which the train keeps falling", 0},
    {"ends_by", "",
     "what limits the growth: barrier (too little energy), reach (misses the next domino) or none", 7},
    {"r_max_exact", "", "r_max if the fuel is computed from the energy balance", 0},
    {"r_max_paper", "", "r_max if the fuel is computed with the paper's closed form", 0},
    {"r_start", "", "the largest growth at which a row starts and keeps falling, to nine digits", 0},
    {NULL, NULL, NULL, 0},
};

static void rmax_fuels_detail(struct answer *a, const struct domq_train *train, const struct domq_limit *used,
                              const struct domq_limit *exact, const struct domq_limit *paper)
{
    if (domq_first_effect(train))
        answer_detail(a, "r_max_paper has no value: the paper's closed form of the fuel does not include %s.",
                      domq_first_effect(train)->name);
    else if (used->ends != DOM_END_NONE && exact->r_max == paper->r_max)
        answer_detail(a, "r_max_exact and r_max_paper are both limited by the reach, r = 1/s, which does not "
                         "depend on the fuel.");
    else if (used->ends != DOM_END_NONE)
        answer_detail(a, "r_max_exact and r_max_paper differ because the paper's closed form of the fuel "
                         "leaves out the weights r^(-q i) (25; c7).");
}

/* A moving train can have a larger growth than a row that starts from rest. If the limit for a row is
 * smaller, prints it. The growth of the session may lie between the two limits. Then the row needs a push,
 * which takes 100 times as long to find as both limits. */
static void rmax_start_say(const struct query *query, struct answer *a, const struct domq_train *train,
                           const struct domq_limit *used, const struct start_growths *growths)
{
    const domq_real r_start = growths->r_max;
    if (used->ends == DOM_END_NONE || growths->is_too_slow || r_start >= used->r_max)
        return;
    if (!isnan(r_start))
        answer_say(a, "A row that starts from rest can have a growth of up to %s %s.",
                   limit_words(r_start, 6).text, start_words(query).text);
    else
        answer_say(a, "This train is already moving: from rest, no row falls %s, whatever its growth.",
                   start_words(query).text);
    if (train->r <= used->r_max && !(train->r <= r_start))
        answer_detail(a,
                      "At a growth of %.6g, such a row does not fall; 'count' looks for a push that is "
                      "enough.",
                      (double)train->r);
}

/* Returns the reason why r_start has no value, or NULL if rmax_start_say will print the reason. */
static const char *start_missing(const struct query *query, const struct answer *a,
                                 const struct start_growths *growths, char reason[START_TEXT])
{
    if (growths->is_too_slow)
        return "r_start has no value, because with the rigid-body engine the search would take too long; "
               "'rowmax' finds the largest growth of a row";
    snprintf(reason, START_TEXT, "r_start has no value: no row falls %s, whatever its growth",
             start_words(query).text);
    return answer_for_people(a) ? NULL : reason;
}

static bool run_rmax(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_train train = query->scene->train;
    struct domq_limit exact = {.r_max = DOMQ_NAN, .open = DOMQ_NAN}, paper = exact;
    train.s = argument_or(query->given, 0, train.s);
    const enum dom_status status = limits_find(train, query_compute(query), &exact, &paper);
    if (status != DOM_OK)
        return problem_limit(problem, query->scene, status, isnan(paper.open) ? &exact : &paper);
    struct domq_limit used = train.fuel == DOM_FUEL_PAPER ? paper : exact;
    struct start_growths growths = {.r_max = DOMQ_NAN};
    const char *missing = no_growth(used);
    char reason[START_TEXT];
    if (a->out && !a->sink.take) {
        if (!missing && !start_growths_find(query, &train, used.r_max, &growths, problem))
            return false;
        if (!missing && isnan(growths.r_max))
            missing = start_missing(query, a, &growths, reason);
    }
    if (used.ends == DOM_END_NONE)
        answer_say(a, "No domino can be larger than the one before: not even equal dominoes keep falling.");
    else
        answer_say(a,
                   "With gaps of %.6g times the height, %s can each be %s times as large as the one before. "
                   "With more growth %s.",
                   (double)train.s, dominoes_words(train.q, "dominoes").text, limit_words(used.r_max, 6).text,
                   used.ends == DOM_END_REACH ? "a domino falls past the next one without touching it"
                                              : "the train has too little energy to keep falling");
    answer_row(a,
               ROW(cell_real(train.s), cell_limit(cell_uncertain(used.r_max, used.uncertainty)),
                   cell_word(dom_end_text(used.ends)),
                   cell_limit(cell_uncertain(exact.r_max, exact.uncertainty)),
                   cell_limit(cell_uncertain(paper.r_max, paper.uncertainty)),
                   cell_limit(cell_within(growths.r_max, growths.uncertainty))),
               missing);
    rmax_fuels_detail(a, &train, &used, &exact, &paper);
    if (answer_for_people(a))
        rmax_start_say(query, a, &train, &used, &growths);
    return true;
}

static const struct column pair_columns[] = {
    {"s", "h", "separation: the gap divided by the height", 0},
    {"r_max", "", "largest growth at which the first domino topples the second", 0},
    {"ends_by", "",
     "what limits the growth: barrier (too little energy), reach (misses the next domino) or none", 7},
    {NULL, NULL, NULL, 0},
};

static bool run_pair(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_train train = query->scene->train;
    struct domq_limit limit;
    train.s = argument_or(query->given, 0, train.s);
    const enum dom_status status = any_limit_pair(&train, query_compute(query), &limit);
    if (status != DOM_OK)
        return problem_limit(problem, query->scene, status, &limit);
    if (limit.ends != DOM_END_NONE)
        answer_say(a,
                   "A %s that just tips over can topple one %s times as large, across a gap of %.6g times "
                   "the larger height.",
                   dominoes_words(train.q, "domino").text, limit_words(limit.r_max, 6).text, (double)train.s);
    const bool good = answer_row(
        a,
        ROW(cell_real(train.s), cell_limit(cell_uncertain(limit.r_max, limit.uncertainty)),
            cell_word(dom_end_text(limit.ends))),
        limit.ends == DOM_END_NONE
            ? "no growth possible: at this s and d, a domino that just tips over does not topple the next one"
            : NULL);
    if (limit.ends != DOM_END_NONE)
        answer_detail(a, "%s.",
                      limit.ends == DOM_END_REACH ? "The domino falls past a larger one without touching it"
                                                  : "For a larger one the domino has too little energy");
    return good;
}

static const struct column best_columns[] = {
    {"s", "h", "separation at which r_max is largest", 0},
    {"r_max", "", "the largest growth", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_best(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_best best = {.s = DOMQ_NAN, .r_max = DOMQ_NAN};
    enum dom_status status = any_limit_best(&query->scene->train, query_compute(query), &best);
    if (status != DOM_OK && status != DOM_NO_GROWTH)
        return query_status(query, problem, status);
    if (status == DOM_OK)
        answer_say(
            a,
            "With the best gap, %.4g times the height, %s can each be %s times as large as the one before.",
            (double)best.s, dominoes_words(query->scene->train.q, "dominoes").text,
            limit_words(best.r_max, 4).text);
    return answer_row(a,
                      ROW(cell_uncertain(best.s, best.s_uncertainty),
                          cell_limit(cell_uncertain(best.r_max, best.r_uncertainty))),
                      status == DOM_OK
                          ? NULL
                          : "no growth possible: dominoes this thick do not topple larger ones at any s");
}

#define SEPARATION .name = "S", .kind = ARGUMENT_VALUE_OF, .parameter = "s", .optional = true

const struct command limit_commands[] = {
    {.name = "rmax",
     TRAIN_COMMAND,
     .synonyms = "maximum ratio factor larger",
     .argument = {{SEPARATION}},
     .summary = "the largest growth, with gaps S times the height (default: s)",
     .equation = "(26; c8)",
     .help =
         "The search raises the growth r from 1 until each domino has too little energy to topple the "
         "next one. It goes no further than r = 1/s (less with rounded edges), because beyond 1/s a "
         "domino falls past the next one without touching it. The limit r_max is for a train that is "
         "already moving. A row that starts from rest may need a smaller growth, which the answer shows "
         "as r_start. The first domino of this row just tips over, or starts as 'set push' and "
         "'set release' say. Because r_start takes much longer to compute than r_max, expressions cannot use "
         "'rmax.r_start', and a sweep of 'rmax' has no column r_start. In both, use 'count(112).r_start' "
         "instead.",
     .example = "set q hollow; rmax 0.3",
     .see = "why best curve pair count rowmax",
     .sweep.echo = "s",
     .sweep.slow_column = "r_start",
     .principal = "r_max",
     .brief = "",
     ANSWER(rmax)},
    {.name = "pair",
     TRAIN_COMMAND,
     .synonyms = "two maximum",
     .argument = {{SEPARATION}},
     .summary = "the largest growth at which one domino topples a second",
     .equation = "(9; b5) (15; b11) (17; b13)",
     .example = "pair 0.3",
     .see = "rmax curve",
     .sweep.echo = "s",
     .principal = "r_max",
     .brief = "",
     ANSWER(pair)},
    {.name = "best",
     TRAIN_COMMAND,
     .synonyms = "optimum optimal spacing distance maximum",
     .summary = "the gap that allows the largest growth",
     .example = "best",
     .see = "rmax curve",
     .principal = "s",
     .brief = "",
     ANSWER(best)},
    {.name = "count",
     .precision = PRECISION_AS_SET,
     .synonyms = "quiz tower building Domtoren height number tall",
     .argument = {{.name = "H", .kind = ARGUMENT_HEIGHT},
                  {.name = "R", .kind = ARGUMENT_VALUE_OF, .parameter = "r", .optional = true}},
     .summary = "how many dominoes it takes to topple one of height H (growth R; default: r)",
     .help = "The answer n is the smallest integer with h r^n >= H, where h is the height of the first "
             "domino. The last domino of the row is smaller than H, but it can topple one more, which is r "
             "times as tall. For example, if h = 5 cm, r = 1.5 and H = 20 cm, n is 4: dominoes of 5, 7.5, "
             "11.25 and 16.9 cm can topple one of up to 25.3 cm. The first domino of the row just tips over, "
             "or starts as 'set push' and 'set release' say. 'feasible' tells whether the row falls. If not, "
             "'stops_at' is the domino at which the fall ends, and 'push' is the weakest push with which the "
             "row would fall. 'goes_on' tells whether an endless train that is already moving keeps falling. "
             "'r_start' is the largest growth at which a "
             "row starts and keeps falling. Each gap of the row is s times the height, even if the session "
             "has another row. If an effect that needs the rigid-body engine is on, the engine runs the row.",
     .example = "count 112 m 2",
     .see = "fewest rmax best landmarks",
     .sweep.echo = "r",
     .typed.variant = "fewest",
     .principal = "dominoes",
     .holds = "such a row falls and reaches the height H",
     .sweep.needs_yes = true,
     .brief = "",
     ANSWER(count)},
    {.name = NULL},
};
