/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'count': how many dominoes it takes to topple a domino of a given height. */
#include "language/quad.h"
#include "train/falling.h"
#include "train/row_start.h"
#include "train/train.h"
#include <ctype.h>
#include <string.h>

const struct column count_columns[] = {
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

/* How much dominoes of one kind can grow. */
struct growth {
    domq_real q;
    struct domq_limit limit; /* of the endless train */
    struct start_growths row;
};

/* Finds the largest growth at which a moving train keeps falling, and at which a row starts from rest. */
static bool growth_find(const struct query *query, const struct domq_train *train, struct growth *g,
                        struct problem *problem)
{
    const enum dom_status status = any_limit_rmax(train, &query->scene->compute, &g->limit);
    g->q = train->q;
    g->row = (struct start_growths){.r_max = DOMQ_NAN};
    if (status != DOM_OK)
        return problem_limit(problem, query->scene, status, &g->limit);
    return g->limit.ends == DOM_END_NONE ||
           start_growths_find(query, train, g->limit.r_max, &g->row, problem);
}

/* The results for a row that is to topple a domino of a given height. */
struct tower {
    struct growth growth;
    const char *stops;  /* why the endless train stops, or NULL */
    struct start start; /* the result of running the row, whose last domino is the one to topple */
    bool falls;
};

/* Runs a row of `dominoes` dominoes, followed by the domino to topple. */
static bool tower_find(const struct query *query, const struct domq_train *train, domq_real dominoes,
                       struct tower *t, struct problem *problem)
{
    struct domq_barrier barrier;
    const enum dom_status status = any_barrier_find(train, &query->scene->compute, &barrier);
    t->stops = status == DOM_OUT_OF_REACH
                   ? "each domino falls past the next one without touching it (r s > 1)"
               : status == DOM_STOPS     ? "the train has too little energy to keep falling"
               : status == DOM_NO_FUEL   ? "falling releases no energy"
               : status == DOM_LOCKS     ? "friction locks the train"
               : status == DOM_UNDERFLOW ? "r is too large for the precision"
                                         : NULL;
    if ((!t->stops && !query_status(query, problem, status)) ||
        !growth_find(query, train, &t->growth, problem) ||
        !start_find(query, train, dominoes + 1, &t->start, problem))
        return false;
    t->falls = t->start.falls && (!t->stops || (domq_real)t->start.count > dominoes);
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

/* Finds the kind of domino that has a name and can grow most. If the row of the session does not fall, takes
 * its kind. */
static bool best_kind(const struct query *query, const struct domq_train *train, const struct tower *t,
                      struct growth *best, struct problem *problem)
{
    domq_real kind[KINDS_MOST];
    const size_t kinds = t->falls ? kinds_find(query, train, kind) : 1;
    *best = t->growth;
    for (size_t k = 1; k < kinds; k++) {
        struct domq_train other = *train;
        struct growth growth;
        other.q = kind[k];
        if (!growth_find(query, &other, &growth, problem))
            return false;
        if (growth.row.r_max > best->row.r_max)
            *best = growth;
    }
    return true;
}

/* Prints how much dominoes of one kind can grow in a row that starts, and how many are then enough, unless
 * these are not fewer than `dominoes`. */
static void growth_say(const struct query *query, struct answer *a, const struct growth *g,
                       const struct tower *t, domq_real height, domq_real dominoes)
{
    struct words name = dominoes_words(g->q, "dominoes");
    struct domq_count count;
    /* The growth is rounded down to three digits, or to more if three would round it to 1. */
    domq_real most = 1;
    for (int digits = 3; digits <= 9 && g->row.r_max > 1 && most <= 1; digits++)
        most = round_digits(g->row.r_max, digits, false);
    const domq_real n =
        any_count_find(query->scene->scale.h, height, most, &query->scene->compute, &count) == DOM_OK
            ? count.dominoes
            : DOMQ_NAN;
    if (t->falls && !(n < dominoes))
        return;
    if (g->limit.ends == DOM_END_NONE)
        answer_say(a, "With these gaps not even equal dominoes keep falling.");
    else if (isnan(g->row.r_max) && !t->start.engine)
        answer_say(a, "With these gaps no row of such dominoes starts %s.",
                   query->scene->effect[DOM_EFFECT_release].on ? "from this tilt"
                   : query->scene->effect[DOM_EFFECT_push].on  ? "with this push"
                                                               : "by itself");
    else if (isfinite(n) && n > 0)
        answer_say(a, "%c%s can each be %s times as large as the one before: then %s %s enough.",
                   toupper((unsigned char)*name.text), name.text + 1, quad_growth(most, 9),
                   quad_text(n, WIDE_DIGITS), n == 1 ? "is" : "are");
}

/* Returns "The 20th domino" or "The first domino". */
static struct words ordinal(domq_real n)
{
    static const char *const ends[] = {"th", "st", "nd", "rd"};
    struct words words = {"The first domino"};
    int hundreds = (int)(n - 100 * quad(floor)(n / 100)), last = hundreds % 10;
    if (n != 1)
        snprintf(words.text, sizeof words.text, "The %s%s domino", quad_text(n, WIDE_DIGITS),
                 last > 3 || hundreds / 10 == 1 ? "th" : ends[last]);
    return words;
}

/* Prints the number of dominoes, what decides whether they fall, and whether they do. */
static void count_say(struct answer *a, const struct domq_train *train, const struct domq_count *count,
                      const struct tower *t, domq_real height, domq_real first)
{
    const bool is_one = count->dominoes == 1;
    if (count->dominoes == 0) {
        answer_say(a, "No other domino is needed: the first is already %s tall.",
                   measured(first, "m", 6).text);
        return;
    }
    answer_say(a,
               "%s %s, each %s times as large as the one before, with gaps of %.6g times the height, %s one "
               "that is %s tall. Such a row %s.",
               quad_text(count->dominoes, WIDE_DIGITS),
               dominoes_words(train->q, is_one ? "domino" : "dominoes").text,
               quad_growth(train->r, (int)a->style.digits), (double)train->s,
               !t->falls ? "would be needed to topple"
               : is_one  ? "topples"
                         : "topple",
               measured(height, "m", 6).text, t->falls ? "falls" : "does not fall");
}

static void count_detail(const struct query *query, struct answer *a, const struct domq_count *count,
                         const struct domq_train *train, const struct tower *t)
{
    char ends[START_TEXT];
    if (count->dominoes > 0)
        answer_detail(a, "\n%s is %s tall; it could topple a domino up to %s tall.",
                      ordinal(count->dominoes).text, measured(count->last / train->r, "m", 4).text,
                      measured(count->last, "m", 4).text);
    if (!t->start.falls) {
        start_problem(query, &t->start, ends);
        answer_detail(a, "%c%s.%s", toupper((unsigned char)*ends), ends + 1,
                      t->stops ? "" : " A train that is already moving keeps falling.");
    } else if (t->stops) {
        answer_detail(a, "The first %zu dominoes fall, but a longer row stops: %s.", t->start.count,
                      t->stops);
    }
    if (t->start.engine)
        answer_detail(a, "The rigid-body engine ran the row because %s.", t->start.engine);
}

/* Returns why the row does not topple the domino, or NULL if it does. */
static const char *count_reason(const struct query *query, domq_real dominoes, const struct tower *t,
                                const struct domq_train *train, char reason[START_TEXT])
{
    if (!isfinite(dominoes))
        snprintf(reason, START_TEXT,
                 "with r = 1 all dominoes are equally tall, so none of them reaches this height");
    else if (t->falls)
        return NULL;
    else if (t->stops)
        snprintf(reason, START_TEXT, "not possible at s = %.6g with %s: %s", (double)train->s,
                 dominoes_words(train->q, "dominoes").text, t->stops);
    else
        start_problem(query, &t->start, reason);
    return reason;
}

bool run_count(const struct query *query, struct answer *a, struct problem *problem)
{
    domq_real height = query->given->number[0], first = query->scene->scale.h;
    struct domq_train train = query->scene->train;
    struct domq_count count;
    struct tower t = {.falls = false};
    struct growth best;
    char reason[START_TEXT];
    train.r = query->given->count > 1 ? query->given->number[1] : train.r;
    if (any_count_find(first, height, train.r, query_compute(query), &count) != DOM_OK)
        return problem_no_answer(
            problem, "H = %s m, h = %s m, r = %s: the number of dominoes cannot be counted in %s precision",
            quad_text(height, 10), quad_text(first, 10), quad_text(train.r, 10),
            any_arithmetic(query->scene->compute.precision).name);
    if (!tower_find(query, &train, count.dominoes, &t, problem))
        return false;
    const bool people = answer_for_people(a), is_enough = isfinite(count.dominoes);
    if (people && !best_kind(query, &train, &t, &best, problem))
        return false;
    const char *why = count_reason(query, count.dominoes, &t, &train, reason);
    answer_set_verdict(a, t.falls && is_enough);
    if (is_enough)
        count_say(a, &train, &count, &t, height, first);
    answer_row(a,
               ROW(cell_real(height), cell_real(train.r), cell_count(count.dominoes),
                   cell_computed(count.exact), cell_real(first), cell_computed(count.last),
                   cell_flag(t.falls), cell_flag(!t.stops),
                   t.start.falls ? cell_real(DOMQ_NAN) : cell_count((domq_real)t.start.stops_at),
                   cell_within(t.start.push, t.start.push / 1000),
                   cell_limit(cell_within(t.growth.row.r_max, t.growth.row.uncertainty))),
               people && is_enough ? NULL : why);
    if (!people)
        return true;
    if (t.stops && why)
        answer_detail(a, "%s", why);
    if (is_enough)
        count_detail(query, a, &count, &train, &t);
    growth_say(query, a, &best, &t, height, is_enough ? count.dominoes : (domq_real)INFINITY);
    return true;
}
