/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'count': how many dominoes it takes to topple a domino of a given height. */
#include "commands/row_start.h"
#include "commands/tables.h"
#include "language/quad.h"
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
    {"push", "rad/s", "the weakest push with which such a row would fall", 0},
    {"r_start", "", "the largest growth at which such a row starts and keeps falling", 0},
    {NULL, NULL, NULL, 0},
};

/* Returns a name for the dominoes with mass exponent q, such as "hollow", "solid" or "q = 3.5". */
static struct words mass_name(domq_real q)
{
    const char *word = parameter_word(parameter_find("q"), q);
    struct words name;
    snprintf(name.text, sizeof name.text, "%s%s", word ? "" : "q = ", word ? word : quad_text(q, 6));
    return name;
}

/* Sets *why to the reason why the train stops, or to NULL if it keeps falling. Returns DOM_OK in both
 * cases. */
static enum dom_status count_feasible(const struct domq_train *train, const struct domq_compute *compute,
                                      const char **why)
{
    struct domq_barrier barrier;
    enum dom_status status = domq_barrier_find(train, compute, &barrier);
    *why = status == DOM_OUT_OF_REACH ? "each domino falls past the next one without touching it (r s > 1)"
           : status == DOM_STOPS      ? "the train has too little energy to keep falling"
           : status == DOM_NO_FUEL    ? "falling releases no energy"
           : status == DOM_LOCKS      ? "friction locks the train"
           : status == DOM_UNDERFLOW  ? "r is too large for the precision"
                                      : NULL;
    return *why ? DOM_OK : status;
}

/* The results for a row that is to topple a domino of a given height. */
struct tower {
    struct domq_limit limit; /* the largest growth of the endless train */
    const char *stops;       /* why the endless train stops, or NULL */
    struct start start;      /* the result of running the row, whose last domino is the one to topple */
    struct start_growths growths;
    bool falls;
};

/* Runs a row of `dominoes` dominoes, followed by the domino to topple. Also finds two limits: the largest
 * growth at which a moving train keeps falling, and the largest growth at which a row starts from rest. */
static bool tower_find(const struct query *query, const struct domq_train *train, domq_real dominoes,
                       struct tower *t, struct problem *problem)
{
    const struct domq_compute *compute = &query->scene->compute;
    enum dom_status status = count_feasible(train, compute, &t->stops);
    if (status == DOM_OK)
        status = domq_limit_rmax(train, compute, &t->limit);
    if (status != DOM_OK)
        return query_status(query, problem, status);
    t->growths = (struct start_growths){DOMQ_NAN, false};
    if (!start_find(query, train, dominoes + 1, &t->start, problem) ||
        (t->limit.ends != DOM_END_NONE &&
         !start_growths_find(query, train, t->limit.r_max, &t->growths, problem)))
        return false;
    t->falls = t->start.falls && (!t->stops || (domq_real)t->start.count > dominoes);
    return true;
}

/* Returns how many dominoes it takes to topple a domino of this height at growth r, as in "16 dominoes". */
static struct words enough_words(const struct query *query, domq_real height, domq_real r)
{
    struct domq_count count;
    struct words words = {"no number of dominoes is enough"};
    if (domq_count_find(query->scene->scale.h, height, r, &query->scene->compute, &count) == DOM_OK &&
        isfinite(count.dominoes))
        snprintf(words.text, sizeof words.text, "%s domino%s", quad_text(count.dominoes, WIDE_DIGITS),
                 count.dominoes == 1 ? "" : "es");
    return words;
}

/* Prints whether a row with mass exponent q falls. Also prints the largest growth for a moving train and for
 * a row that starts from rest, and how many dominoes are enough at these growths. */
static void kind_say(const struct query *query, struct answer *a, domq_real q, domq_real height,
                     const struct tower *t)
{
    char starts[256] = "";
    const struct words kind = mass_name(q);
    const char *by = query->scene->effect[DOM_EFFECT_push].on ? "with this push" : "by itself";
    if (t->limit.ends == DOM_END_NONE) {
        answer_say(a, "  %-7s no; not even equal dominoes keep falling", kind.text);
        return;
    }
    if (isnan(t->growths.r_max) && !t->start.engine)
        snprintf(starts, sizeof starts, "; but no such row starts %s", by);
    else if (t->growths.r_max < t->limit.r_max)
        snprintf(starts, sizeof starts, "; a row that starts %s can have a growth of up to %.6g: %s", by,
                 (double)t->growths.r_max, enough_words(query, height, t->growths.r_max).text);
    answer_say(a, "  %-7s %-4s growth up to %.6g is possible: %s%s", kind.text, t->falls ? "yes;" : "no;",
               (double)t->limit.r_max, enough_words(query, height, t->limit.r_max).text, starts);
}

/* Prints a line for each named kind of domino, and for the kind of the session. */
static bool kinds_say(const struct query *query, struct answer *a, struct problem *problem,
                      const struct domq_train *train, domq_real height, domq_real dominoes,
                      const struct tower *session_tower)
{
    bool has_name = false;
    struct tower other = {.falls = false};
    answer_say(a, "\nWhich kinds of domino fall with growth %s at s = %.6g?", quad_growth(train->r, 6),
               (double)train->s);
    for (const struct word *w = parameter_find("q")->words; w->name; w++) {
        struct domq_train kind = *train;
        kind.q = w->value;
        const bool is_session_kind = kind.q == train->q;
        has_name = has_name || is_session_kind;
        /* If several words have the same value, only the last word is printed. */
        if (w[1].name && w[1].value == w->value)
            continue;
        if (!is_session_kind && !tower_find(query, &kind, dominoes, &other, problem))
            return false;
        kind_say(query, a, kind.q, height, is_session_kind ? session_tower : &other);
    }
    if (!has_name)
        kind_say(query, a, train->q, height, session_tower);
    return true;
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

static void count_say(struct answer *a, const struct domq_train *train, const struct domq_count *count,
                      const struct tower *t, domq_real height, domq_real first)
{
    if (count->dominoes == 0) {
        answer_say(a, "No other domino is needed: the first is already %s tall.",
                   measured(first, "m", 6).text);
        return;
    }
    answer_say(a, "%s domino%s, each %s times as large as the one before, %s one that is %s tall.",
               quad_text(count->dominoes, WIDE_DIGITS), count->dominoes == 1 ? "" : "es",
               quad_growth(train->r, (int)a->style.digits),
               !t->falls              ? "would be needed to topple"
               : count->dominoes == 1 ? "topples"
                                      : "topple",
               measured(height, "m", 6).text);
    answer_say(a, "%s is %s tall; it could topple a domino up to %s tall.", ordinal(count->dominoes).text,
               measured(count->last / train->r, "m", 4).text, measured(count->last, "m", 4).text);
    answer_say(a, "%s", t->falls ? "Such a row falls." : "Such a row does not fall.");
}

/* Prints why the row does not fall, and whether a train that is already moving would keep falling. */
static void start_say(const struct query *query, struct answer *a, const struct tower *t)
{
    char ends[START_TEXT];
    if (!t->start.falls) {
        start_problem(query, &t->start, ends);
        answer_say(a, "%c%s.%s", toupper((unsigned char)*ends), ends + 1,
                   t->stops ? "" : " A train that is already moving keeps falling.");
    } else if (t->stops) {
        answer_say(a, "The first %zu dominoes fall, but a longer row stops: %s.", t->start.count, t->stops);
    }
    if (t->start.engine)
        answer_say(a, "The rigid-body engine ran the row because %s.", t->start.engine);
    answer_say(a, "%s", "");
}

/* Returns why the row does not topple the domino. Returns NULL if the row topples it, or if start_say has
 * already printed the reason. */
static const char *count_reason(const struct query *query, const struct answer *a, domq_real dominoes,
                                const struct tower *t, const struct domq_train *train,
                                char reason[START_TEXT])
{
    if (!isfinite(dominoes))
        snprintf(reason, START_TEXT,
                 "with r = 1 all dominoes are equally tall, so none of them reaches this height");
    else if (t->falls || (!t->stops && answer_for_people(a)))
        return NULL;
    else if (t->stops)
        snprintf(reason, START_TEXT, "not possible at s = %.6g with %s%s: %s", (double)train->s,
                 mass_name(train->q).text, parameter_word(parameter_find("q"), train->q) ? " dominoes" : "",
                 t->stops);
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
    char reason[START_TEXT];
    train.r = query->given->count > 1 ? query->given->number[1] : train.r;
    if (domq_count_find(first, height, train.r, query_compute(query), &count) != DOM_OK)
        return problem_no_answer(
            problem, "H = %s m, h = %s m, r = %s: the number of dominoes cannot be counted in %s precision",
            quad_text(height, 10), quad_text(first, 10), quad_text(train.r, 10),
            domq_arithmetic(query->scene->compute.precision)->name);
    if (!tower_find(query, &train, count.dominoes, &t, problem))
        return false;
    bool is_enough = isfinite(count.dominoes), good = t.falls && is_enough;
    if (is_enough) {
        count_say(a, &train, &count, &t, height, first);
        start_say(query, a, &t);
    }
    answer_set_verdict(a, good);
    answer_row(a,
               ROW(cell_real(height), cell_real(train.r), cell_count(count.dominoes), CELL_OF(count, exact),
                   cell_real(first), CELL_OF(count, last), cell_flag(t.falls), cell_flag(!t.stops),
                   t.start.falls ? cell_real(DOMQ_NAN) : cell_count((domq_real)t.start.stops_at),
                   cell_without_bound(t.start.push), cell_without_bound(t.growths.r_max)),
               count_reason(query, a, count.dominoes, &t, &train, reason));
    return !answer_for_people(a) || kinds_say(query, a, problem, &train, height, count.dominoes, &t);
}
