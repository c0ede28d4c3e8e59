/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How much dominoes can grow from one to the next: rmax, pair and best. How many topple a given height:
 * count. Also the list of all commands about a train. */
#include "language/quad.h"
#include "train/train.h"
#include <ctype.h>
#include <math.h>

static domq_real argument_or(const struct arguments *call, int i, domq_real fallback)
{
    return i < call->count ? call->number[i] : fallback;
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
    {"r_max_paper", "", "r_max with the paper's closed form of the fuel, which knows no effects (25; c7)", 0},
    {"r_start", "", "the largest growth at which a row starts and keeps falling, to nine digits", 0},
    {NULL, NULL, NULL, 0},
};

/* A moving train can have a larger growth than a row that starts from rest. Finds the limit for a row, and
 * prints it if it is smaller. If there is none, returns the reason. */
static bool rmax_start(const struct query *query, struct answer *a, const struct domq_train *train,
                       domq_real r_max, struct start_growths *growths, char reason[START_TEXT],
                       struct problem *problem)
{
    if (!start_growths_find(query, train, r_max, growths, problem))
        return false;
    if (growths->is_too_slow)
        snprintf(reason, START_TEXT,
                 "r_start has no value, because with the rigid-body engine the search would take too long; "
                 "'rowmax' finds the largest growth of a row");
    else if (isnan(growths->r_max) && answer_for_people(a))
        answer_say(a, "This train is already moving: from rest, no row falls %s, whatever its growth.",
                   start_words(query).text);
    else if (isnan(growths->r_max))
        snprintf(reason, START_TEXT, "r_start has no value: from rest, no row falls %s, whatever its growth",
                 start_words(query).text);
    else if (growths->r_max < r_max)
        answer_say(a, "A row that starts from rest can have a growth of up to %s %s.",
                   limit_words(a, growths->r_max, 6).text, start_words(query).text);
    return true;
}

static bool run_rmax(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_train train = query->scene->train;
    struct domq_limit exact = {.r_max = DOMQ_NAN, .open = DOMQ_NAN}, paper = exact;
    train.s = argument_or(query->given, 0, train.s);
    const enum dom_status status = limits_find(train, query_compute(query), &exact, &paper);
    if (status != DOM_OK)
        return problem_limit(problem, query->scene, status, isnan(paper.open) ? &exact : &paper);
    const struct domq_limit used = train.fuel == DOM_FUEL_PAPER ? paper : exact;
    struct start_growths growths = {.r_max = DOMQ_NAN};
    char reason[START_TEXT] = "";
    if (used.ends == DOM_END_NONE) {
        answer_say(a, "No domino can be larger than the one before: not even equal dominoes keep falling.");
        snprintf(reason, START_TEXT, "no growth possible: even with equal dominoes (r = 1), %s%s",
                 verdict_reason(used.why),
                 used.why == DOM_OUT_OF_REACH ? ", because the edges are so round; use a smaller s" : "");
    } else
        answer_say(a,
                   "With gaps of %.6g times the height, %s can each be %s times as large as the one before. "
                   "With more growth %s.",
                   (double)train.s, dominoes_words(train.q, "dominoes").text,
                   limit_words(a, used.r_max, 6).text,
                   used.ends == DOM_END_REACH ? "a domino falls past the next one without touching it"
                                              : "the train has too little energy to keep falling");
    if (!*reason && a->out && !a->sink.take &&
        !rmax_start(query, a, &train, used.r_max, &growths, reason, problem))
        return false;
    return answer_row(a,
                      ROW(cell_real(train.s), cell_limit(cell_uncertain(used.r_max, used.uncertainty)),
                          cell_word(dom_end_text(used.ends)),
                          cell_limit(cell_uncertain(exact.r_max, exact.uncertainty)),
                          cell_limit(cell_uncertain(paper.r_max, paper.uncertainty)),
                          cell_limit(cell_within(growths.r_max, growths.uncertainty))),
                      *reason ? reason : NULL);
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
                   dominoes_words(train.q, "domino").text, limit_words(a, limit.r_max, 6).text,
                   (double)train.s);
    return answer_row(
        a,
        ROW(cell_real(train.s), cell_limit(cell_uncertain(limit.r_max, limit.uncertainty)),
            cell_word(dom_end_text(limit.ends))),
        limit.ends == DOM_END_NONE
            ? "no growth possible: at this s and d, a domino that just tips over does not topple the next one"
            : NULL);
}

static const struct column best_columns[] = {
    {"s", "h", "separation at which r_max is largest", 0},
    {"r_max", "", "the largest growth", 0},
    {NULL, NULL, NULL, 0},
};

/* Returns true if the train with this separation has an r_max of at least `growth`. */
static bool allows_growth(const struct query *query, domq_real s, domq_real growth)
{
    struct domq_train train = query->scene->train;
    struct domq_limit limit;
    train.s = s;
    return any_limit_rmax(&train, query_compute(query), &limit) == DOM_OK && limit.r_max >= growth;
}

/* Returns the best separation for a sentence that also names the growth, rounded down. Where r_max(s) jumps,
 * a rounded separation can lie beyond the jump. So if neither of the two next to s allows the growth, both
 * get one more digit. */
static struct words best_gap_words(const struct query *query, const struct answer *a, domq_real s,
                                   const struct words *growth)
{
    struct words words;
    for (int digits = style_tol_digits(&a->style, 4);; digits++) {
        const domq_real unit = (domq_real)pow(10, floor(log10((double)s)) + 1 - digits),
                        nearest = quad_read(quad_text(s, digits), NULL),
                        other = nearest < s ? nearest + unit : nearest - unit;
        const bool is_last = !answer_for_people(a) || style_tol_digits(&a->style, digits + 1) == digits;
        for (int k = 0; k < 2; k++) {
            snprintf(words.text, sizeof words.text, "%s", quad_text(k == 0 ? nearest : other, digits));
            if (is_last || allows_growth(query, quad_read(words.text, NULL), quad_read(growth->text, NULL)))
                return words;
        }
    }
}

static bool run_best(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_best best = {.s = DOMQ_NAN, .r_max = DOMQ_NAN};
    enum dom_status status = any_limit_best(&query->scene->train, query_compute(query), &best);
    if (status != DOM_OK && status != DOM_NO_GROWTH)
        return query_status(query, problem, status);
    const struct words growth = limit_words(a, best.r_max, 4);
    if (status == DOM_OK)
        answer_say(
            a, "With the best gap, %s times the height, %s can each be %s times as large as the one before.",
            best_gap_words(query, a, best.s, &growth).text,
            dominoes_words(query->scene->train.q, "dominoes").text, growth.text);
    return answer_row(a,
                      ROW(cell_uncertain(best.s, best.s_uncertainty),
                          cell_limit(cell_uncertain(best.r_max, best.r_uncertainty))),
                      status == DOM_OK
                          ? NULL
                          : "no growth possible: these dominoes do not topple larger ones, whatever the gap");
}

/* ---- count ---- */

static const struct column count_columns[] = {
    {"height", "m", "the height H of the domino to topple", 0},
    {"r", "", "growth: the size of each domino relative to the one before", 0},
    {"dominoes", "", "the number of dominoes needed: the smallest n with first_height r^n >= height", 0},
    {"exact", "", "n before it is rounded up: ln(height / first_height) / ln r", 0},
    {"first_height", "m", "height of the first domino", 0},
    {"last_height", "m", "height of the tallest domino that this row can topple, first_height r^n", 0},
    {"feasible", "", "whether such a row falls when its first domino is let go or pushed", 8},
    {"goes_on", "", "whether an endless train with this growth keeps falling once it is moving", 7},
    {"stops_at", "", "the domino at which the fall ends, if not all dominoes fall", 8},
    {"push", "rad/s", "the weakest push with which such a row would fall, to four digits", 0},
    {"r_start", "", "the largest growth at which such a row starts and keeps falling, to nine digits", 0},
    {NULL, NULL, NULL, 0},
};

/* What is known about a row that is to topple a domino of a given height. */
struct tower {
    domq_real height, first; /* heights of the domino to topple and of the first domino, in m */
    struct domq_train train;
    struct domq_count count;
    const char *stops;           /* why the endless train stops, or NULL */
    struct domq_limit limit;     /* the largest growth of a moving train */
    struct start_growths growth; /* the largest growth at which a row starts from rest */
    struct start start;          /* the result of running the row, whose last domino is the one to topple */
    bool falls;
};

/* Finds the largest growth of a moving train, and of a row that starts from rest. */
static bool growth_find(const struct query *query, struct tower *t, struct problem *problem)
{
    const enum dom_status status = any_limit_rmax(&t->train, &query->scene->compute, &t->limit);
    t->growth = (struct start_growths){.r_max = DOMQ_NAN};
    if (status != DOM_OK)
        return problem_limit(problem, query->scene, status, &t->limit);
    return t->limit.ends == DOM_END_NONE ||
           start_growths_find(query, &t->train, t->limit.r_max, &t->growth, problem);
}

static bool tower_find(const struct query *query, struct tower *t, struct problem *problem)
{
    struct domq_barrier barrier;
    const enum dom_status status = any_barrier_find(&t->train, &query->scene->compute, &barrier);
    t->stops = verdict_reason(status);
    if ((!t->stops && !query_status(query, problem, status)) || !growth_find(query, t, problem) ||
        !start_run(query, &t->train, t->count.dominoes + 1, true, &t->start, problem))
        return false;
    t->falls = t->start.falls && (!t->stops || (domq_real)t->start.count > t->count.dominoes);
    return true;
}

size_t kinds_find(const struct query *query, const struct domq_train *train, domq_real kind[KINDS_MOST])
{
    size_t count = 0;
    struct domq_train other = *train;
    for (const struct word *w = parameter_find("q")->words;; other.q = w++->value) {
        /* Several words can have the same value, and trains in air may not be self-similar. */
        struct domq_angles angles;
        bool is_new = any_angles_find(&other, query_compute(query), &angles) != DOM_NO_AIR;
        for (size_t k = 0; k < count; k++)
            is_new = is_new && kind[k] != other.q;
        if (is_new && count < KINDS_MOST)
            kind[count++] = other.q;
        if (!w->name)
            return count;
    }
}

/* Replaces the dominoes by those of the kind that has a name and can grow most, with their growth. */
static bool kind_choose(const struct query *query, struct tower *best, struct problem *problem)
{
    const struct tower t = *best;
    domq_real kind[KINDS_MOST];
    const size_t kinds = kinds_find(query, &t.train, kind);
    for (size_t k = 0; k < kinds; k++) {
        struct tower other = t;
        other.train.q = kind[k];
        if (kind[k] == t.train.q)
            continue;
        if (!growth_find(query, &other, problem))
            return false;
        if (other.growth.r_max > best->growth.r_max)
            *best = other;
    }
    return true;
}

/* Prints how much the dominoes can grow in a row that starts, and how many are then enough, if that helps. */
static void growth_say(const struct query *query, struct answer *a, const struct tower *t)
{
    struct words name = dominoes_words(t->train.q, "dominoes");
    struct domq_count count = {.dominoes = DOMQ_NAN};
    /* The growth is rounded down to three digits, or to more if three would round it to 1. */
    domq_real most = 1;
    for (int digits = 3; digits <= 9 && t->growth.r_max > 1 && most <= 1; digits++)
        most = round_digits(t->growth.r_max, digits, false);
    (void)any_count_find(t->first, t->height, most, &query->scene->compute, &count);
    const domq_real n = count.dominoes;
    if (t->falls && !(n < t->count.dominoes) && isfinite(t->count.dominoes))
        return;
    if (t->limit.ends == DOM_END_NONE)
        answer_say(a, "With these gaps not even equal dominoes keep falling; 'why' says more.");
    else if (isnan(t->growth.r_max) && !t->start.engine)
        answer_say(a, "With these gaps no row of such dominoes starts %s.", start_words(query).text);
    else if (isfinite(n) && n > 0)
        answer_say(a, "%c%s can each be %s times as large as the one before: then %s %s enough.",
                   toupper((unsigned char)*name.text), name.text + 1, quad_growth(most, 9),
                   quad_text(n, WIDE_DIGITS), n == 1 ? "is" : "are");
}

/* Prints the number of dominoes, what decides whether they fall, and whether they do. */
static void count_say(struct answer *a, const struct tower *t)
{
    const domq_real n = t->count.dominoes;
    if (n == 0)
        answer_say(a, "No other domino is needed: the first is already %s tall.",
                   measured(t->first, "m", 6).text);
    else
        answer_say(
            a,
            "%s %s, each %s times as large as the one before, with gaps of %.6g times the height, %s one "
            "that is %s tall. Such a row %s.",
            quad_text(n, WIDE_DIGITS), dominoes_words(t->train.q, n == 1 ? "domino" : "dominoes").text,
            quad_growth(t->train.r, (int)a->style.digits), (double)t->train.s,
            !t->falls ? "would be needed to topple"
            : n == 1  ? "topples"
                      : "topple",
            measured(t->height, "m", 6).text, t->falls ? "falls" : "does not fall");
}

/* Returns why the row does not topple the domino, or NULL if it does. */
static const char *count_reason(const struct query *query, const struct tower *t, char reason[START_TEXT])
{
    if (!isfinite(t->count.dominoes))
        snprintf(reason, START_TEXT,
                 "with r = 1 all dominoes are equally tall, so none of them reaches this height");
    else if (t->falls)
        return NULL;
    else if (t->stops)
        snprintf(reason, START_TEXT, "not possible at s = %.6g with %s: %s", (double)t->train.s,
                 dominoes_words(t->train.q, "dominoes").text, t->stops);
    else
        start_problem(query, &t->start, reason);
    return reason;
}

bool run_count(const struct query *query, struct answer *a, struct problem *problem)
{
    struct tower t = {
        .height = query->given->number[0], .first = query->scene->scale.h, .train = query->scene->train};
    char reason[START_TEXT];
    t.train.r = argument_or(query->given, 1, t.train.r);
    if (any_count_find(t.first, t.height, t.train.r, query_compute(query), &t.count) != DOM_OK)
        return problem_no_answer(
            problem, "H = %s m, h = %s m, r = %s: the number of dominoes cannot be counted in %s precision",
            quad_text(t.height, 10), quad_text(t.first, 10), quad_text(t.train.r, 10),
            any_arithmetic(query->scene->compute.precision).name);
    if (!tower_find(query, &t, problem))
        return false;
    const bool people = answer_for_people(a), is_enough = isfinite(t.count.dominoes);
    struct tower best = t;
    if (people && t.falls && is_enough && !kind_choose(query, &best, problem))
        return false;
    const char *why = count_reason(query, &t, reason);
    answer_set_verdict(a, t.falls && is_enough);
    if (is_enough)
        count_say(a, &t);
    answer_row(a,
               ROW(cell_real(t.height), cell_real(t.train.r), cell_count(t.count.dominoes),
                   cell_computed(t.count.exact), cell_real(t.first), cell_computed(t.count.last),
                   cell_flag(t.falls), cell_flag(!t.stops),
                   t.start.falls ? cell_real(DOMQ_NAN) : cell_count((domq_real)t.start.stops_at),
                   cell_within(t.start.push, t.start.push / 1000),
                   cell_limit(cell_within(t.growth.r_max, t.growth.uncertainty))),
               people ? NULL : why);
    if (!people)
        return true;
    if (why && is_enough)
        answer_detail(a, "\n%c%s.", toupper((unsigned char)*why), why + 1);
    else if (why)
        answer_say(a, "%c%s.", toupper((unsigned char)*why), why + 1);
    if (t.start.engine && is_enough)
        answer_detail(a, "The rigid-body engine ran the row because %s.", t.start.engine);
    growth_say(query, a, &best);
    return true;
}

#define SEPARATION .name = "S", .kind = ARGUMENT_VALUE_OF, .parameter = "s", .optional = true

static const struct command limit_commands[] = {
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

static const struct command_group groups[] = {
    {"One cycle of the train", "cycles", cycle_commands},
    {"The cycle, step by step", "cycles", walk_commands},
    {"How far it can grow", "limits", limit_commands},
    {"What accuracy costs", "limits", cost_commands},
    {NULL, NULL, NULL},
};

static const struct first_line first[] = {
    {1, "count 112 m", "the quiz: how many dominoes topple a tower of 112 m", true},
    {2, "rmax", "how much larger each domino can be than the one before it", false},
    {4, "rmax", "the answer for these gaps; 'details' has the rest of it", false},
    {0, NULL, NULL, false},
};

const struct feature train_feature = {.name = "train", .groups = groups, .first = first};
