/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command count: how many dominoes it takes to topple one of a given height. */
#include "commands/tables.h"
#include "language/quad.h"
#include <string.h>

const struct column count_columns[] = {
    {"height", "m", "the domino to topple is at least this tall", 0},
    {"r", "", "growth: how much larger each domino is than the one before", 0},
    {"dominoes", "", "how many it takes: the smallest n with first_height r^n >= height", 0},
    {"exact", "", "n before it is rounded up: ln(height / first_height) / ln r", 0},
    {"first_height", "m", "height of the first domino", 0},
    {"last_height", "m", "height of the toppled one, first_height r^n", 0},
    {"feasible", "", "whether such a train can fall, with this s, d, q and r", 8},
    {NULL, NULL, NULL, 0},
};

/* Returns a name for the dominoes with mass exponent q, such as "hollow", "solid" or "q = 3.5". */
static const char *mass_name(domq_real q, char name[32])
{
    const char *word = parameter_word(parameter_find("q"), q);
    if (word)
        return word;
    snprintf(name, 32, "q = %g", (double)q);
    return name;
}

/* Finds out whether a train keeps falling. If it does not, sets *why to the reason and returns DOM_OK.
 * Otherwise sets *why to NULL and returns the status of the computation. */
static enum dom_status count_feasible(const struct domq_train *train, const struct domq_compute *compute,
                                      const char **why)
{
    struct domq_barrier barrier;
    enum dom_status status = domq_barrier_find(train, compute, &barrier);
    *why = status == DOM_OUT_OF_REACH ? "each domino falls past the next one without touching it (r s > 1)"
           : status == DOM_STOPS      ? "the train has too little energy to go on"
           : status == DOM_NO_FUEL    ? "falling sets no energy free"
           : status == DOM_LOCKS      ? "friction locks the train"
           : status == DOM_UNDERFLOW  ? "r is so large that no energy is left"
                                      : NULL;
    return *why ? DOM_OK : status;
}

/* Prints whether a train of one kind of domino can fall with the growth train.r, and how many dominoes are
 * enough with the largest growth that this kind allows. */
static bool kind_say(const struct query *query, struct answer *a, struct problem *problem,
                     struct domq_train train, domq_real height)
{
    const struct domq_compute *compute = &query->scene->compute;
    struct domq_limit limit;
    struct domq_count count;
    char name[32], number[WIDE_TEXT], dominoes[96] = "no number of dominoes is enough";
    const char *why;
    enum dom_status status = count_feasible(&train, compute, &why);
    if (status == DOM_OK)
        status = domq_limit_rmax(&train, compute, &limit);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    if (limit.ends == DOM_END_NONE) {
        answer_say(a, "  %-7s no; not even equal dominoes go on", mass_name(train.q, name));
        return true;
    }
    if (domq_count_find(query->scene->scale.h, height, limit.r_max, compute, &count) == DOM_OK &&
        isfinite(count.dominoes))
        snprintf(dominoes, sizeof dominoes, "%s domino%s", quad_text(count.dominoes, WIDE_DIGITS, number),
                 count.dominoes == 1 ? "" : "es");
    answer_say(a, "  %-7s %-4s growth up to %.6g is possible: %s", mass_name(train.q, name),
               why ? "no;" : "yes;", (double)limit.r_max, dominoes);
    return true;
}

/* Formats a growth with this many digits, or with more if a growth other than 1 would be rounded to 1. */
static const char *growth_text(domq_real r, int digits, char text[WIDE_TEXT])
{
    while (strcmp(quad_text(r, digits, text), "1") == 0 && r != 1)
        digits++;
    return text;
}

/* Calls kind_say for each kind of domino that has a name. If the kind of the session has no name, calls
 * kind_say for this kind, too. */
static bool kinds_say(const struct query *query, struct answer *a, struct problem *problem,
                      const struct domq_train *train, domq_real height)
{
    bool has_name = false;
    char number[WIDE_TEXT];
    answer_say(a,
               "\nFalling with growth %s at s = %.6g, by kind of domino:", growth_text(train->r, 6, number),
               (double)train->s);
    for (const struct word *w = parameter_find("q")->words; w->name; w++) {
        struct domq_train kind = *train;
        kind.q = w->value;
        has_name = has_name || kind.q == train->q;
        /* Synonyms are neighbours in the list, and only the last one is printed. */
        if (!(w[1].name && w[1].value == w->value) && !kind_say(query, a, problem, kind, height))
            return false;
    }
    return has_name || kind_say(query, a, problem, *train, height);
}

/* Returns "the 20th domino" or "the first domino". */
static const char *ordinal(domq_real n, char text[WIDE_TEXT + 16])
{
    static const char *const ends[] = {"th", "st", "nd", "rd"};
    char number[WIDE_TEXT];
    int hundreds = (int)(n - 100 * quad(floor)(n / 100)), last = hundreds % 10;
    if (n == 1)
        return "the first domino";
    snprintf(text, WIDE_TEXT + 16, "the %s%s domino", quad_text(n, WIDE_DIGITS, number),
             last > 3 || hundreds / 10 == 1 ? "th" : ends[last]);
    return text;
}

/* Prints the answer to the quiz in three lines. */
static void count_say(struct answer *a, const struct domq_train *train, const struct domq_count *count,
                      domq_real height, domq_real first, bool feasible)
{
    char number[WIDE_TEXT], growth[WIDE_TEXT], nth[WIDE_TEXT + 16];
    if (count->dominoes == 0) {
        answer_say(a, "No domino is needed: the first is already %s tall.\n", measured(first, "m", 6).text);
        return;
    }
    answer_say(a, "%s domino%s, each %s times as large as the one before, %s one of %s.",
               quad_text(count->dominoes, WIDE_DIGITS, number), count->dominoes == 1 ? "" : "es",
               growth_text(train->r, (int)a->style.digits, growth),
               !feasible              ? "would be needed to topple"
               : count->dominoes == 1 ? "topples"
                                      : "topple",
               measured(height, "m", 6).text);
    answer_say(a, "toppled: %s; %s is %s tall", measured(count->last, "m", 4).text,
               ordinal(count->dominoes, nth), measured(count->last / train->r, "m", 4).text);
    answer_say(a, "can it fall? %s\n", feasible ? "yes" : "no");
}

bool run_count(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_compute compute = query_compute(query);
    domq_real height = query->given->number[0], first = query->scene->scale.h;
    struct domq_train train = query->scene->train;
    struct domq_count count;
    const char *why;
    char reason[160], name[32];
    train.r = query->given->count > 1 ? query->given->number[1] : train.r;
    if (domq_count_find(first, height, train.r, &compute, &count) != DOM_OK)
        return problem_no_answer(
            problem, "H = %s m, h = %s m, r = %s: the number of dominoes cannot be counted in %s precision",
            quad_shown(height).text, quad_shown(first).text, quad_shown(train.r).text,
            domq_arithmetic(compute.precision)->name);
    enum dom_status status = count_feasible(&train, &query->scene->compute, &why);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    bool feasible = !why, is_enough = isfinite(count.dominoes);
    if (why)
        snprintf(reason, sizeof reason, "not possible at s = %.6g with %s%s: %s", (double)train.s,
                 mass_name(train.q, name), parameter_word(parameter_find("q"), train.q) ? " dominoes" : "",
                 why);
    else if (!is_enough)
        snprintf(reason, sizeof reason, "r = 1: the dominoes do not grow, no number of them is enough");
    if (is_enough)
        count_say(a, &train, &count, height, first, feasible);
    answer_holds(a, feasible && is_enough);
    answer_row(a,
               ROW(cell_real(height), cell_real(train.r), cell_count(count.dominoes), CELL_OF(count, exact),
                   cell_real(first), CELL_OF(count, last), cell_flag(feasible)),
               feasible && is_enough ? NULL : reason);
    return !answer_for_people(a) || kinds_say(query, a, problem, &train, height);
}
