/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about the limits of growth, and the quiz: how many dominoes up to a given height? */
#include "command.h"
#include "value.h"
#include <math.h>

#define ROW(...) ((const struct cell[]){__VA_ARGS__})

/* The words of a parameter's range check, for an argument that stands for the parameter. */
static bool parameter_argument(struct session *session, const struct call *call, int i, const char *name,
                               double *value)
{
    const struct parameter *p = parameter_find(name);
    if (i > call->count) {
        *value = parameter_get(session, p);
        return true;
    }
    return parameter_parse(session, p, call->word[i], value);
}

static const char no_growth_fuel[] =
    "no growth possible: at this s and d even equal dominoes (r = 1) have no "
    "fuel, a fallen one lies no lower than it stood";
static const char no_growth_stops[] =
    "no growth possible: at this s and d even equal dominoes (r = 1) do not get over their barrier";

static const char *no_growth(struct dom_limit limit, enum dom_status why)
{
    if (limit.ends != DOM_END_NONE)
        return NULL;
    return why == DOM_NO_FUEL ? no_growth_fuel : no_growth_stops;
}

static enum dom_status limit_with(struct dom_train train, enum dom_fuel fuel, struct dom_limit *limit,
                                  enum dom_status *why)
{
    train.fuel = fuel;
    return dom_limit_rmax(&train, limit, why);
}

static const struct column rmax_columns[] = {
    {"s", "h", "separation", 0},
    {"r_max", "", "largest growth at which the train goes on, with the fuel in use", 0},
    {"ends_by", "", "barrier: too high to climb; reach: beyond it the next is missed", 0},
    {"r_max_exact", "", "with the fuel from the energy balance", 0},
    {"r_max_paper", "", "with the paper's closed form of the fuel", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_rmax(struct session *session, const struct call *call)
{
    struct dom_train train = session->train;
    struct dom_limit exact, paper;
    enum dom_status why = DOM_OK;
    if (!parameter_argument(session, call, 1, "s", &train.s))
        return false;
    enum dom_status status = limit_with(train, DOM_FUEL_EXACT, &exact, &why);
    if (status == DOM_OK)
        status = limit_with(train, DOM_FUEL_PAPER, &paper, &why);
    if (status != DOM_OK)
        return session_status(session, status);
    struct dom_limit used = train.fuel == DOM_FUEL_PAPER ? paper : exact;
    answer_row(call->answer,
               ROW(cell_real(train.s), cell_real(used.r_max), cell_word(dom_end_text(used.ends)),
                   cell_real(exact.r_max), cell_real(paper.r_max)),
               no_growth(used, why));
    if (used.ends != DOM_END_NONE)
        answer_say(call->answer,
                   "exact and paper differ because (c7)'s closed form of the fuel holds only for "
                   "r = 1; the energy balance gives exact");
    return true;
}

static const struct column pair_columns[] = {
    {"s", "h", "separation", 0},
    {"r_max", "", "largest growth at which a domino that just tips over topples the next", 0},
    {"ends_by", "", "barrier, reach or none", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_pair(struct session *session, const struct call *call)
{
    struct dom_train train = session->train;
    struct dom_limit limit;
    if (!parameter_argument(session, call, 1, "s", &train.s))
        return false;
    enum dom_status status = dom_limit_pair(&train, &limit);
    if (status != DOM_OK)
        return session_status(session, status);
    answer_row(
        call->answer, ROW(cell_real(train.s), cell_real(limit.r_max), cell_word(dom_end_text(limit.ends))),
        limit.ends == DOM_END_NONE ? "no growth possible: a domino that just tips over does not topple "
                                     "the next one at this s and d"
                                   : NULL);
    return true;
}

static const struct column best_columns[] = {
    {"s", "h", "the separation that allows the largest growth", 0},
    {"r_max", "", "that growth", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_best(struct session *session, const struct call *call)
{
    struct dom_best best = {DOM_NAN, DOM_NAN};
    enum dom_status status = dom_limit_best(&session->train, &best);
    if (status != DOM_OK && status != DOM_NO_GROWTH)
        return session_status(session, status);
    answer_row(call->answer, ROW(cell_real(best.s), cell_real(best.r_max)),
               status == DOM_OK
                   ? NULL
                   : "no growth possible: dominoes this thick do not topple larger ones at any s");
    return true;
}

static const struct column curve_columns[] = {
    {"s", "h", "separation", 0},
    {"exact", "", "r_max with the fuel from the energy balance", 0},
    {"paper", "", "r_max with the paper's closed form of the fuel", 0},
    {"pair", "", "r_max of the two-domino model", 0},
    {"reach", "", "1/s", 0},
    {NULL, NULL, NULL, 0},
};

#define CURVE_MAX 10000000

static bool run_curve(struct session *session, const struct call *call)
{
    char shown[VALUE_SHOWN];
    double from, to, n;
    if (!parameter_argument(session, call, 1, "s", &from) || !parameter_argument(session, call, 2, "s", &to))
        return false;
    const char *wrong = value_parse(call->word[3], &n);
    if (wrong || n != floor(n) || n < 1 || n > CURVE_MAX)
        return session_error(session, "N = '%s' %s; N, the number of rows, is an integer in 1 .. %d",
                             value_shown(call->word[3], shown), wrong ? wrong : "is no such number",
                             CURVE_MAX);
    if (n == 1 && from != to)
        return session_error(session, "one row cannot cover %g to %g; N is at least 2", from, to);
    struct dom_train train = session->train;
    for (double k = 0; k < n && !answer_lost(call->answer); k++) {
        struct dom_limit exact, paper, pair;
        double f = n > 1 ? k / (n - 1) : 0;
        train.s = (1 - f) * from + f * to;
        enum dom_status status = limit_with(train, DOM_FUEL_EXACT, &exact, NULL);
        if (status == DOM_OK)
            status = limit_with(train, DOM_FUEL_PAPER, &paper, NULL);
        if (status == DOM_OK)
            status = dom_limit_pair(&train, &pair);
        if (status != DOM_OK)
            return session_status(session, status);
        answer_row(call->answer,
                   ROW(cell_real(train.s), cell_real(exact.r_max), cell_real(paper.r_max),
                       cell_real(pair.r_max), cell_real(1 / train.s)),
                   NULL);
    }
    return true;
}

static const struct column count_columns[] = {
    {"height", "m", "the domino to topple is at least this tall", 0},
    {"r", "", "growth from domino to domino", 0},
    {"dominoes", "", "how many topple it: the smallest n with first r^n >= height", 0},
    {"exact", "", "ln(height / first) / ln r", 0},
    {"first_height", "m", "height of the first domino", 0},
    {"last_height", "m", "height of the toppled one, first r^n", 0},
    {"feasible", "", "does a train with this s, d, q and r go on?", 0},
    {NULL, NULL, NULL, 0},
};

static const char *mass_name(double q)
{
    const char *name = parameter_word(parameter_find("q"), q);
    return name ? name : "such";
}

/* What the largest growth of one kind of domino would make of the count. */
static bool count_largest(struct session *session, const struct call *call, struct dom_train train,
                          double height)
{
    struct dom_limit limit;
    struct dom_count count;
    enum dom_status why = DOM_OK, status = dom_limit_rmax(&train, &limit, &why);
    if (status != DOM_OK)
        return session_status(session, status);
    if (limit.ends == DOM_END_NONE)
        answer_say(call->answer, "  %-8s none: not even equal ones keep falling", mass_name(train.q));
    else if (dom_count_find(session->scale.h, height, limit.r_max, &count) == DOM_OK &&
             isfinite(count.dominoes))
        answer_say(call->answer, "  %-8s r = %.6g, ends by %s: %.0f domino%s", mass_name(train.q),
                   limit.r_max, dom_end_text(limit.ends), count.dominoes, count.dominoes == 1 ? "" : "es");
    else
        answer_say(call->answer, "  %-8s r = %.10g: no number of them gets there", mass_name(train.q),
                   limit.r_max);
    return true;
}

/* Whether the train goes on, as a sentence about why; NULL text where it does. */
static bool count_feasible(struct session *session, const struct dom_train *train, bool *feasible,
                           const char **why)
{
    struct dom_barrier barrier;
    enum dom_status status = dom_barrier_find(train, &barrier);
    *feasible = status == DOM_OK;
    *why = NULL;
    if (status == DOM_OUT_OF_REACH)
        *why = "r s > 1: each domino falls past the next one without touching it";
    else if (status == DOM_STOPS)
        *why = "the train stops below its barrier";
    else if (status == DOM_NO_FUEL)
        *why = "there is no fuel: a fallen domino lies no lower than it stood";
    else if (status != DOM_OK)
        return session_status(session, status);
    return true;
}

static bool run_count(struct session *session, const struct call *call)
{
    char shown[VALUE_SHOWN];
    double height, first = session->scale.h;
    struct dom_train train = session->train;
    struct dom_count count;
    const char *text = call->word[1], *wrong = value_parse(text, &height);
    if (wrong || !(height > 0))
        return session_error(session, "H = '%s' %s; H is a height in metres, larger than 0",
                             value_shown(text, shown), wrong ? wrong : "is no height");
    if (!parameter_argument(session, call, 2, "r", &train.r))
        return false;
    if (dom_count_find(first, height, train.r, &count) != DOM_OK)
        return session_error(session,
                             "H = %g m, h = %g m, r = %.17g: the number of dominoes cannot be counted "
                             "in double precision",
                             height, first, train.r);
    bool feasible;
    const char *why;
    if (!count_feasible(session, &train, &feasible, &why))
        return false;

    struct answer *a = call->answer;
    if (isfinite(count.dominoes))
        answer_say(a, "%.0f domino%s, each %.6g times as large as the one before, topple%s one of %.6g m.\n",
                   count.dominoes, count.dominoes == 1 ? "" : "es", train.r, count.dominoes == 1 ? "s" : "",
                   height);
    answer_row(a,
               ROW(cell_real(height), cell_real(train.r), cell_count(count.dominoes), cell_real(count.exact),
                   cell_real(first), cell_real(count.last), cell_flag(feasible)),
               isfinite(count.dominoes) ? NULL
                                        : "r = 1: the dominoes do not grow, no number of them is enough");
    answer_say(a, "\nPossible? %s at s = %.6g with %s dominoes (q = %g)%s%s.", feasible ? "Yes," : "No, not",
               train.s, mass_name(train.q), train.q, why ? ": " : "", why ? why : "");
    if (session->output != OUTPUT_TABLE)
        return true;
    answer_say(a, "The largest growth at s = %.6g:", train.s);
    for (const struct word *w = parameter_find("q")->words; w->name; w++) {
        struct dom_train kind = train;
        kind.q = w->value;
        if (!count_largest(session, call, kind, height))
            return false;
    }
    return parameter_word(parameter_find("q"), train.q) || count_largest(session, call, train, height);
}

const struct command limit_commands[] = {
    {"rmax", "[S]", "the largest growth r at separation S (or s)",
     "The first r, raised from 1, at which the kinetic energy no longer reaches the barrier; or 1/s, beyond\n"
     "which a domino falls past the next one.",
     0, 1, ARGUMENT_ANY, rmax_columns, false, run_rmax},
    {"pair", "[S]", "the same for two dominoes, of which the first just tips over", NULL, 0, 1, ARGUMENT_ANY,
     pair_columns, false, run_pair},
    {"best", "", "the separation that allows the largest growth", NULL, 0, 0, ARGUMENT_ANY, best_columns,
     false, run_best},
    {"curve", "FROM TO N", "the largest growth at N separations: the paper's figures", NULL, 3, 3,
     ARGUMENT_ANY, curve_columns, true, run_curve},
    {"count", "H [R]", "how many dominoes topple one H metres tall, at growth R (or r)", NULL, 1, 2,
     ARGUMENT_ANY, count_columns, false, run_count},
    {.name = NULL},
};
